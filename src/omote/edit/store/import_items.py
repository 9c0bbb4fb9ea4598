"""Imports expressions and faces as items of a show file, and exports items as JSON documents (`expression_json`)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from omote.edit.protocol.names import clean_label, clean_tags, free_label, new_name
from omote.edit.protocol.wire import read_recipe, write_recipe
from omote.interchange.formats.expression_json import Control, ExpressionFile, from_dense, space_digest, to_dense
from omote.model.cast import Cast, Look
from omote.model.controls.default_net import default_net
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import KEY, FaceRecipe, Recipe, Vector
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.showfile.changes import Change, Content, Item, Kind, Revision, Stored, content_key
from omote.showfile.contents import pack_expression, pack_face, unpack_expression
from omote.stage_data.cast_names import find_exported

EDITOR = "import"
"""The author of imported revisions."""
EXACT = 1e-12
"""Tolerance within which control points reproduce the dense field, so that the recipe needs only them."""


@dataclass(frozen=True, eq=False)
class ImportedItem:
    """An imported expression or face with its look, and the recipe where it is known."""

    label: str
    made: Expression | tuple[Face, Look]
    tags: tuple[str, ...] = ()
    note: str = ""
    recipe: Recipe | None = None


def changes_to_import(cast: Cast, stored: Stored, arrivals: Iterable[ImportedItem], /, *, wall: float) -> list[Change]:
    """The changes that add imported expressions and faces to a show file as new items; wall: seconds since 1970.

    cast: the built-in one; stored: what the file holds; arrivals: what comes.
    """
    taken = {*cast.faces, *cast.expressions, *(item.name for item in stored.items)}
    number = max((item.id for item in stored.items), default=0)
    place = max((item.place for item in stored.items), default=0.0)
    changes: list[Change] = []
    for step, arrival in enumerate(arrivals, start=1):
        kind = _kind_of(arrival)
        label = clean_label(arrival.label)
        name = new_name(label, kind, taken)
        taken.add(name)
        item = Item(number + step, kind, name, label, clean_tags(arrival.tags), place + step, head=1)
        changes += _changes_to_save(cast.space, item, arrival, wall)
    return changes


def find_known(stored: Stored, arrivals: Iterable[ImportedItem], /) -> list[Item | None]:
    """For each arrival the item of its kind that plays exactly its content, or an earlier arrival of it would; None
    where it is new.

    stored: what the file holds; arrivals: what comes.
    """
    heads = {(revision.item, revision.number): revision.content for revision in stored.revisions}
    by_content = {(item.kind, heads.get((item.id, item.head), "")): item for item in stored.items if not item.deleted}
    twins = []
    for arrival in arrivals:
        kind = _kind_of(arrival)
        content = _content_of(arrival)[0]
        twins.append(by_content.get((kind, content)))
        by_content.setdefault((kind, content), Item(0, kind, "", arrival.label))
    return twins


def distinguish(cast: Cast, stored: Stored, arrivals: Iterable[ImportedItem], /) -> list[tuple[ImportedItem, str]]:
    """Gives arrivals labels that nothing else of their kind has; with each, why it has another one, or "".

    cast: the built-in one; stored: what the file holds; arrivals: what comes.
    """
    last = {revision.item: revision.content for revision in stored.revisions}
    items = [item for item in stored.items if not item.deleted]
    labels: dict[Kind, list[str]] = {
        "face": [*cast.faces],
        "expression": [title.label for title in cast.titles.values()],
        "pose": [pose.label for pose in cast.poses.values()],
    }
    for item in items:
        labels[item.kind].append(item.label)
    distinct = []
    for arrival in arrivals:
        kind = _kind_of(arrival)
        label = free_label(clean_label(arrival.label), labels[kind])
        twins = {last.get(item.id) for item in items if item.label.casefold() == arrival.label.strip().casefold()}
        same = ", exactly the same" if _content_of(arrival)[0] in twins else ""
        why = f"there is a {arrival.label!r} already{same}, so this one is called {label!r}"
        labels[kind].append(label)
        distinct.append((replace(arrival, label=label), "" if label == arrival.label.strip() else why))
    return distinct


def import_document(space: ParameterSpace, document: ExpressionFile, /, *, note: str = "") -> ImportedItem:
    """Imports a document: by its dense field on the same head, else by its control points on this head.

    ValueError where it fits this head in neither way.

    space: of the cast; document: as a file holds it; note: for the history.
    """
    recipe = None if document.control is None else _recipe_of_control(space, document.control)
    at_home = document.space == space_digest(space)
    if document.dense is not None and at_home:
        expression = from_dense(space, document.dense)
        recipe = recipe if recipe is not None and _same(compose_expression(space, recipe, {}), expression) else None
    elif recipe is not None:
        expression = compose_expression(space, recipe, {})
    else:
        raise ValueError(
            f"{document.label!r} was made on another head ({document.space}) and not by control points alone; "
            f"expected {space_digest(space)}: have it exported from the same version of Omote"
        )
    return ImportedItem(document.label, expression, tuple(document.tags), note, recipe)


def make_document(
    space: ParameterSpace, label: str, tags: Iterable[str], expression: Expression, recipe: Recipe | None = None
) -> ExpressionFile:  # fmt: skip
    """Makes the document of an expression; with its control points where it consists of nothing else.

    space: of the cast; label, tags: for people; expression: the whole of it; recipe: what it was made by, where
    that is known.
    """
    alone = recipe is not None and recipe == Recipe(recipe.net, recipe.vectors) and _fits_head(space, recipe)
    layers = () if recipe is None else tuple(layer for layer in recipe.layers if not layer.muted)
    made_of = [f"{layer.label} x {layer.weight:g}" for layer in layers]
    made_of += [] if recipe is None else [f"{pull.muscle} x {pull.contraction:g}" for pull in recipe.pulls]
    return ExpressionFile(
        omote="expression",
        version=1,
        label=label,
        tags=list(tags),
        space=space_digest(space),
        control=_control(space, recipe) if recipe is not None and alone else None,
        dense=to_dense(expression),
        made_of=made_of,
    )


def export_document(cast: Cast, stored: Stored, contents: Mapping[str, bytes], name: str, /) -> ExpressionFile:
    """Makes the document of an authored expression, else of one of the cast, by its name or label; ValueError for
    neither, and for a face.

    cast: the built-in one; stored, contents: of the show file; name: what the person typed.
    """
    name = find_exported(cast, stored, name)
    revisions = {(revision.item, revision.number): revision for revision in stored.revisions}
    for item in stored.items:
        if (item.kind, item.name) == ("expression", name) and (item.id, item.head) in revisions:
            head = revisions[item.id, item.head]
            recipe = read_recipe(head.recipe)
            expression = unpack_expression(contents[head.content])
            return make_document(
                cast.space, item.label, item.tags, expression, recipe if isinstance(recipe, Recipe) else None
            )
    return make_document(cast.space, cast.titles[name].label, (), cast.expressions[name])


def _changes_to_save(space: ParameterSpace, item: Item, arrival: ImportedItem, wall: float) -> list[Change]:
    key, content = _content_of(arrival)
    recipe = arrival.recipe or (
        _dense_recipe(space, key) if item.kind == "expression" else FaceRecipe({KEY + key: 1.0})
    )
    revision = Revision(item.id, 1, 0, write_recipe(recipe), key, wall, EDITOR, arrival.note)
    return [Content(key, content), item, revision]


def _kind_of(arrival: ImportedItem) -> Kind:
    return "expression" if isinstance(arrival.made, Expression) else "face"


def _content_of(arrival: ImportedItem) -> tuple[str, bytes]:
    made = arrival.made
    content = pack_expression(made) if isinstance(made, Expression) else pack_face(*made)
    return content_key(content), content


def _dense_recipe(space: ParameterSpace, key: str) -> Recipe:
    """The recipe of a dense field as ground, under control points at rest."""
    net = default_net(space)
    return Recipe(net, ((0.0, 0.0, 1.0),) * len(net), ground=KEY + key)


def _fits_head(space: ParameterSpace, recipe: Recipe) -> bool:
    """Whether each control point lies on this head and has a vector: files are untrusted."""
    there = all(0 <= row < space.vertex_count and space.on_sheet[row] for row in recipe.net)
    return there and len(recipe.net) == len(recipe.vectors)


def _control(space: ParameterSpace, recipe: Recipe) -> Control:
    rows = list(recipe.net)
    places = zip(space.theta[rows].tolist(), space.h[rows].tolist(), strict=True)
    return Control(points=list(places), vectors=list(recipe.vectors))


def _recipe_of_control(space: ParameterSpace, control: Control) -> Recipe:
    """The recipe of control points, each on the vertex nearest to its place on S."""
    if len(control.points) != len(control.vectors):
        raise ValueError(f"{len(control.points)} control points have {len(control.vectors)} vectors; export anew")
    sheet = np.flatnonzero(space.on_sheet & (space.welded == np.arange(space.vertex_count)))
    radius = float(np.mean(space.cylinder.unroll(space.points[sheet])[2]))
    rows = dict[int, None]()
    vectors = list[Vector]()
    for (theta, h), vector in zip(control.points, control.vectors, strict=True):
        turn = np.angle(np.exp(1j * (space.theta[sheet] - theta)))
        row = int(sheet[np.hypot(radius * turn, space.h[sheet] - h).argmin()])
        if row not in rows:  # on a coarser head two places may be one
            rows[row] = None
            vectors.append(vector)
    return Recipe(tuple(rows), tuple(vectors))


def _same(one: Expression, other: Expression) -> bool:
    fields = ("dtheta", "dh", "ratio", "residual", "eyes", "ears", "head")
    off = [np.abs(getattr(one, name) - getattr(other, name)).max(initial=0.0) for name in fields]
    still = not any(rest.any() for expression in (one, other) for rest in expression.parts.values())
    return max(off) <= EXACT and still and (one.pupil, one.complexion) == (other.pupil, other.complexion)
