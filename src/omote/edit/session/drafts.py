"""Edits drafts: opens and begins them, adds steps, undoes and redoes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import clean_text
from omote.edit.protocol.orders import Baked, EditOrder, Flat, Renet, Solve
from omote.edit.protocol.validation import check_net, check_recipe, check_targets, check_vectors
from omote.edit.protocol.wire import read_recipe, write_recipe
from omote.edit.session.plan import Authored, Plan, Result
from omote.edit.store.authored_state import AuthoredState, DraftKey
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.recipes.recipe import KEY, AnyRecipe, FaceRecipe, Recipe
from omote.show.declaration import Message
from omote.show.validation import Refusal
from omote.showfile.changes import Draft, Edit, Item

Shown = AnyRecipe
MEANT: Mapping[type[Message], type[Shown]] = {wire.SetFace: FaceRecipe, wire.SetPose: PoseRecipe}
"""Of which kind of recipe a change is; of an expression's where it does not stand here."""
SAID: Mapping[type[Shown], str] = {FaceRecipe: "a face", PoseRecipe: "a pose", Recipe: "an expression"}
"""What people read of each."""


def open_item(authored: Authored, item: Item, editor: str) -> Plan:
    """Opens the editor's draft of an item, or makes one from the revision that plays.

    authored: what is there; item: what is opened; editor: whose draft.
    """
    state = authored.state
    key = (item.id, editor)
    head = state.head(item)
    if key in state.drafts and (head is None or not _is_outdated(state, key)):
        recipe = read_recipe(state.shown_edit(key).recipe)
        return Plan(authored.bake(recipe, with_net=True), lambda _: Result(draft=key, opened=item.id, whole=True))
    if head is None:
        return _open_unsaved(authored, item, editor)
    what = f"revision {head.number} of {head.editor}"
    return begin(authored, item, editor, read_recipe(head.recipe), what, base=item.head)


def begin(authored: Authored, item: Item, editor: str, recipe: Shown, what: str, *, base: int) -> Plan:
    """Begins a draft with a recipe; where the editor has one already, adds a step to it.

    authored: what is there; item, editor: of the draft; recipe: what it begins with; what: for the history; base:
    the revision that it is of.
    """
    key = item.id, editor

    def finish(baked: Baked) -> Result:
        number = authored.state.drafts[key].cursor + 1 if key in authored.state.drafts else 0
        changes = (
            *authored.changes_to_keep(baked.recipe),
            Draft(item.id, editor, base, number),
            Edit(item.id, editor, number, write_recipe(baked.recipe), what),
        )
        return Result(changes, draft=key, opened=item.id, whole=True)

    return Plan(authored.bake(recipe, with_net=True), finish)


def edit(authored: Authored, key: DraftKey, message: Message) -> Plan:
    """Adds a step to a draft, as the request says.

    authored: what is there; key: of the draft; message: the change of its recipe.
    """
    recipe = read_recipe(authored.state.shown_edit(key).recipe)
    meant = MEANT.get(type(message), Recipe)
    if not isinstance(recipe, meant):
        raise Refusal(f"item {key[0]} is {SAID[type(recipe)]}, but what came is for {SAID[meant]}.")
    order, what = EDITS[type(message)](authored, recipe, message)
    return Plan(order, lambda baked: _add_step(authored, key, baked, what))


def preview_layers(authored: Authored, key: DraftKey, wanted: wire.PreviewLayers) -> Plan:
    """Makes what a draft would be with other layers, without a step; the answer names its content.

    authored: what is there; key: of the draft; wanted: the request.
    """
    recipe = read_recipe(authored.state.shown_edit(key).recipe)
    if not isinstance(recipe, Recipe):
        raise Refusal(f"item {key[0]} is {SAID[type(recipe)]}: only expressions have layers.")
    if wanted.alone:
        recipe = Recipe(recipe.net, ((0.0, 0.0, 1.0),) * len(recipe.net))
    order = authored.bake(authored.resolve_and_check(replace(recipe, layers=tuple(wanted.layers))))
    return Plan(order, lambda baked: Result(reply=wire.Previewed(wanted.request, key[0], KEY + baked.key)))


def step(authored: Authored, key: DraftKey, steps: int) -> Plan:
    """Moves the draft's cursor: -1 undoes a step, 1 redoes one.

    authored: what is there; key: of the draft; steps: how far.
    """
    draft = authored.state.drafts[key]
    edits = authored.state.edits[key]
    cursor = draft.cursor + steps
    if not 0 <= cursor < len(edits):
        raise Refusal("there is nothing to undo: this is how the draft began." if steps < 0 else "nothing was undone.")
    now, then = (read_recipe(edits[place].recipe) for place in (draft.cursor, cursor))
    whole = _net(now) != _net(then)
    changes = (replace(draft, cursor=cursor),)
    return Plan(authored.bake(then, with_net=whole), lambda _: Result(changes, draft=key, whole=whole))


def bring_back(authored: Authored, key: DraftKey, number: int) -> Plan:
    """Adds a step to a draft that restores an old revision.

    authored: what is there; key: of the draft; number: of the revision.
    """
    revision = authored.state.revisions.get(key[0], {}).get(number)
    if revision is None:
        raise Refusal(f"there is no revision {number}: open the history again.")
    recipe = read_recipe(revision.recipe)
    what = f"revision {number} of {revision.editor}, brought back"
    return Plan(authored.bake(recipe, with_net=True), lambda baked: _add_step(authored, key, baked, what))


def is_dirty(state: AuthoredState, key: DraftKey) -> bool:
    """Whether a draft differs from the revision that it is based on.

    state: the authored work; key: of the draft.
    """
    base = state.revisions.get(key[0], {}).get(state.drafts[key].base)
    shown = state.shown_edit(key)
    if base is None or base.recipe == shown.recipe:
        return base is None
    try:  # what another program wrote may be the same recipe in other bytes, or none that can be read
        return read_recipe(base.recipe) != read_recipe(shown.recipe)
    except Refusal:
        return True


def find_unsaved(state: AuthoredState, editor: str) -> list[int]:
    """The items, not deleted, of which an editor has a draft that is not saved.

    state: the authored work; editor: whose drafts.
    """
    keys = sorted(key for key in state.drafts if key[1] == editor)
    return [key[0] for key in keys if not state.items[key[0]].deleted and is_dirty(state, key)]


def _is_outdated(state: AuthoredState, key: DraftKey) -> bool:
    """Whether a draft holds no unsaved changes and another revision plays by now."""
    draft = state.drafts[key]
    at_its_end = draft.cursor == len(state.edits[key]) - 1
    return draft.base != state.items[key[0]].head and at_its_end and not is_dirty(state, key)


def _open_unsaved(authored: Authored, item: Item, editor: str) -> Plan:
    """Begins a draft of an unsaved item from another editor's draft: the one with the most steps."""
    state = authored.state
    others = [key for key in state.drafts if key[0] == item.id]
    if not others:
        raise Refusal(f"nothing of {item.label!r} is kept: delete it and begin anew.")
    theirs = state.shown_edit(max(others, key=lambda key: (len(state.edits[key]), key[1])))
    return begin(authored, item, editor, read_recipe(theirs.recipe), "another editor's draft", base=0)


def _add_step(authored: Authored, key: DraftKey, baked: Baked, what: str) -> Result:
    draft = authored.state.drafts[key]
    shown = authored.state.shown_edit(key)
    check_recipe(baked.recipe, authored.bounds)
    data = write_recipe(baked.recipe)
    if data == shown.recipe:
        return Result(draft=key, miss=baked.miss)
    whole = _net(read_recipe(shown.recipe)) != _net(baked.recipe)
    number = draft.cursor + 1
    changes = (*authored.changes_to_keep(baked.recipe), Edit(*key, number, data, what), replace(draft, cursor=number))
    return Result(changes, draft=key, whole=whole, miss=baked.miss)


def _net(recipe: Shown) -> tuple[int, ...]:
    return recipe.net if isinstance(recipe, Recipe) else ()


# --- what each request makes of a recipe ------------------------------------------------------------------------------

Ordered = tuple[EditOrder, str]


def _drag(authored: Authored, recipe: Recipe, drag: wire.DragPoints) -> Ordered:
    if not drag.points:
        raise Refusal("no point was dragged: send at least one.")
    if len(drag.targets) != len(drag.points):
        raise Refusal(f"there are {len(drag.targets)} targets for {len(drag.points)} points: send one for each.")
    for place in drag.points:
        if not 0 <= place < len(recipe.net) or drag.points.count(place) > 1:
            raise Refusal(f"point {place} was dragged: points are 0 to {len(recipe.net) - 1}, each at most once.")
    check_targets(drag.targets)
    check_vectors(drag.vectors, recipe.net)
    face = authored.sources.resolve("face", drag.face)
    contents = authored.sources.contents(recipe, face)
    order = Solve(recipe, contents, face, tuple(drag.points), tuple(drag.targets), tuple(drag.vectors))
    count = len(drag.points)
    return order, f"drag of {count} points" if count > 1 else "drag of a point"


def _set_vectors(authored: Authored, recipe: Recipe, wanted: wire.SetVectors) -> Ordered:
    return _bake_changed(authored, replace(recipe, vectors=tuple(wanted.vectors)), clean_text(wanted.what))


def _set_net(authored: Authored, recipe: Recipe, wanted: wire.SetNet) -> Ordered:
    check_net(wanted.net, authored.bounds)
    net = tuple(wanted.net)
    if net == recipe.net:
        return authored.bake(recipe), ""
    added = len(net) - len(recipe.net)
    what = "control points moved" if not added else f"{abs(added)} control points {'added' if added > 0 else 'removed'}"
    return Renet(recipe, authored.sources.contents(recipe), net), what


def _set_layers(authored: Authored, recipe: Recipe, wanted: wire.SetLayers) -> Ordered:
    return _bake_changed(authored, replace(recipe, layers=tuple(wanted.layers)), "layers")


def _set_pulls(authored: Authored, recipe: Recipe, wanted: wire.SetPulls) -> Ordered:
    return _bake_changed(authored, replace(recipe, pulls=tuple(wanted.pulls)), "muscles")


def _set_eyes(authored: Authored, recipe: Recipe, wanted: wire.SetEyes) -> Ordered:
    return _bake_changed(authored, replace(recipe, eyes=wanted.eyes, pupil=wanted.pupil), "eyes")


def _set_complexion(authored: Authored, recipe: Recipe, wanted: wire.SetComplexion) -> Ordered:
    return _bake_changed(authored, replace(recipe, complexion=wanted.complexion), "blood, tears and sweat")


def _flatten(authored: Authored, recipe: Recipe, _: wire.Flatten) -> Ordered:
    return Flat(recipe, authored.sources.contents(recipe)), "all baked into one field"


def _set_face(authored: Authored, _: FaceRecipe, wanted: wire.SetFace) -> Ordered:
    return _bake_changed(authored, wanted.recipe, clean_text(wanted.what))


def _set_pose(authored: Authored, _: PoseRecipe, wanted: wire.SetPose) -> Ordered:
    return _bake_changed(authored, wanted.recipe, clean_text(wanted.what))


def _bake_changed(authored: Authored, recipe: Shown, what: str) -> Ordered:
    return authored.bake(authored.resolve_and_check(recipe)), what


EDITS: Mapping[type[Message], Callable[[Authored, Any, Any], Ordered]] = {
    wire.DragPoints: _drag,
    wire.SetVectors: _set_vectors,
    wire.SetNet: _set_net,
    wire.SetLayers: _set_layers,
    wire.SetPulls: _set_pulls,
    wire.SetEyes: _set_eyes,
    wire.SetComplexion: _set_complexion,
    wire.Flatten: _flatten,
    wire.SetFace: _set_face,
    wire.SetPose: _set_pose,
}
"""The order of each request that changes a recipe, and what the history says of it."""
