"""Builds one cast of the built-in one and all items of a show file, for commands and for Python."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

import msgspec

from omote.builtin import load_cast
from omote.interchange.formats.error_reasons import explain_error
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.recipes.recipe import KEY, AnyRecipe, FaceRecipe, sources
from omote.model.space.expression import Title
from omote.model.space.face_fit import fit
from omote.perform.name_lookup import find_name
from omote.showfile.changes import Item, Stored
from omote.showfile.changes import playing_items as playing_items
from omote.showfile.contents import ContentError, read_albedo, unpack_expression, unpack_face
from omote.showfile.inspection import inspect_show
from omote.showfile.recovery import name_show
from omote.stage_data.playing_cast import Own, check_fit


def read_show(path: str | Path) -> Cast:
    """The built-in cast with the own faces and expressions of a show file; the file is only read.

    Parameters
    ----------
    path : str or Path
        A show file, `my.omote`, also one that a show plays at this moment; an ending that is left out is added.

    Returns
    -------
    Cast
        Built-in and own ones by their names (`omote file list` prints them), each own one in the revision that plays.
        One that does not fit this head is left out, with a warning that names it.

    Raises
    ------
    RuntimeError
        Where there is no show file, it is damaged or of a newer Omote; the message says what to do.
    TypeError
        For what is no path.

    Examples
    --------
    >>> mine = omote.read_show("evening.omote")  # doctest: +SKIP
    >>> on_dog = omote.compound(mine.space, mine.faces["dog"], mine.expressions["crooked_smile"])  # doctest: +SKIP

    References
    ----------
    docs/conventions.md for units and axes; docs/reference/show-file.md for the file.
    """
    if not isinstance(path, str | Path):
        raise TypeError(f"a show file is named by its path, not by {path!r}; write 'my.omote'")
    show = inspect_show(name_show(Path(path)))
    return build_full_cast(load_cast(), show.stored, show.contents, partial(warnings.warn, stacklevel=3))


def build_full_cast(
    base: Cast, stored: Stored, contents: Mapping[str, bytes], /, report: Callable[[str], None]
) -> Cast:
    """Adds every item that plays and fits the base's head, by name; each other one is left out and reported.

    base: the built-in cast; stored: what the show file lists; contents: bytes by key; report: is told a sentence of
    each item that is left out.
    """
    cast = base
    for item, content in playing_items(stored):
        try:
            cast = _with_item(cast, item, contents[content])
        except (ValueError, KeyError) as error:
            report(
                f"the own {item.kind} {item.name} cannot be played on the built-in head ({explain_error(error)}); it "
                "is left out. Use the Omote that it was made with, or delete it from the show on a console."
            )
    return cast


def _with_item(cast: Cast, item: Item, content: bytes) -> Cast:
    """The cast with one item more; ValueError where that does not fit the cast's head."""
    if item.kind == "face":
        face, look = unpack_face(content, item.name)
        fit(cast.space, face)
        return replace(cast, faces={**cast.faces, item.name: face}, looks={**cast.looks, item.name: look})
    expression = check_fit(cast.expressions[NEUTRAL], unpack_expression(content))
    return replace(
        cast,
        expressions={**cast.expressions, item.name: expression},
        titles={**cast.titles, item.name: Title(item.label)},
    )


def find_face(cast: Cast, stored: Stored | None, typed: str, /) -> str:
    """The face of a full cast that a person means by a name or, of own ones, a label; ValueError for none.

    stored: what the cast's own ones are of, None where it has none.

    typed: a name or a label, as a person writes it.
    """
    return find_name(typed, cast.faces, "face", {} if stored is None else face_labels(stored))


def face_labels(stored: Stored, /) -> dict[str, str]:
    """What the own faces that play are called, by their names."""
    return {item.name: item.label for item, _ in playing_items(stored) if item.kind == "face"}


def free_faces(stored: Stored, contents: Mapping[str, bytes], /) -> frozenset[str]:
    """The names of own faces that are CC0 as the built-in cast is: mixes, regions and caricatures of nothing but that,
    without handles that somebody moved and without a picture on the skin.

    stored, contents: of the show file.
    """
    recipes: dict[str, list[bytes]] = {}
    for revision in stored.revisions:
        recipes.setdefault(revision.content, []).append(revision.recipe)

    def is_free(content: str, above: frozenset[str]) -> bool:
        if content in above or read_albedo(contents.get(content, b"")) is not None:
            return False
        below = above | {content}
        made = [msgspec.json.decode(recipe, type=AnyRecipe) for recipe in recipes.get(content, ())]
        return bool(made) and all(
            isinstance(recipe, FaceRecipe)
            and not recipe.points
            and all(not source.startswith(KEY) or is_free(source[len(KEY) :], below) for source in sources(recipe))
            for recipe in made
        )

    free = set[str]()
    for item, content in playing_items(stored):
        with suppress(ContentError, msgspec.DecodeError):  # of a newer Omote: nobody knows
            if item.kind == "face" and is_free(content, frozenset()):
                free.add(item.name)
    return frozenset(free)


def own_items(stored: Stored, /) -> tuple[Own, ...]:
    """Every item that plays, as the pages get it."""
    return tuple(
        Own(item.kind, item.name, item.label, item.tags, item.place, content) for item, content in playing_items(stored)
    )
