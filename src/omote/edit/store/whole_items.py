"""Items of one show file as they are, with their recipes, drafts and history, for another."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import msgspec
from msgspec import structs

from omote.edit.protocol.names import clean_label, clean_tags, free_label, new_name
from omote.edit.protocol.wire import read_recipe
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, FaceRecipe, sources
from omote.show.objects.documents import contents_of
from omote.showfile.changes import (
    Change,
    Content,
    Draft,
    Edit,
    Item,
    Kind,
    Revision,
    Stored,
    StoredDocument,
)
from omote.showfile.inspection import revisions_of

_NAME = re.compile("[a-z0-9_]{1,80}")
"""As `new_name` makes them; a file of somebody else may have others."""


@dataclass
class Merged:
    """What another show file brings: the changes that add it, the labels of its items, and sentences about what was
    there already, is called otherwise, or stayed out."""

    changes: list[Change] = field(default_factory=list)
    labels: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def item_sources(stored: Stored, item: int, /) -> set[str]:
    """All that an item's revisions and drafts are made of, and what they made, as sources.

    stored: of the show file; item: its number.
    """
    recipes = [revision.recipe for revision in stored.revisions if revision.item == item]
    recipes += [edit.recipe for edit in stored.edits if edit.item == item]
    names = {KEY + revision.content for revision in stored.revisions if revision.item == item}
    for recipe in recipes:
        try:
            names |= sources(read_recipe(recipe))
        except (ValueError, msgspec.MsgspecError):  # of a newer Omote: its text is looked through
            text = recipe.decode("utf-8", "replace")
            names |= {source for revision in stored.revisions if (source := KEY + revision.content) in text}
    return names


def whole_item(stored: Stored, contents: Mapping[str, bytes], item: Item, /) -> list[Change]:
    """The changes that make an item in an empty show file: all of its revisions and drafts, and every content that
    they name.

    stored, contents: of its show file; item: one of its items.
    """
    return list(_rows_of(stored, contents, item, item))


def merge_show(cast: Cast, ours: Stored, theirs: Stored, contents: Mapping[str, bytes], /) -> Merged:
    """What adds all items and documents of another show file to ours; nothing of ours is replaced.

    An item that is there with the same history is not added again. One whose name is taken by another gets a free one,
    one whose label is taken a number. A document whose name is taken stays out. Refusal for a label that nobody can
    read.

    cast: the built-in one; ours: what our file holds; theirs, contents: all of the other.
    """
    merged = Merged()
    items = list(ours.items)
    labels = _taken_labels(cast, items)
    for item in theirs.items:
        there = _find_same(ours, theirs, item)
        if there is not None:
            merged.notes.append(
                f"{item.label!r} is there already, with the same history, as {there.name} ({there.label})"
            )
            continue
        ours_now = _place_item(cast, items, item, labels[item.kind])
        merged.notes += _explain(theirs, item, ours_now)
        merged.changes += _rows_of(theirs, contents, item, ours_now)
        merged.labels.append(ours_now.label)
        labels[item.kind].append(ours_now.label)
        items.append(ours_now)
    _add_documents(merged, ours, theirs, contents)
    return merged


def _rows_of(stored: Stored, contents: Mapping[str, bytes], item: Item, placed: Item) -> Iterator[Change]:
    """An item under another number and name, and all that belongs to it."""
    for source in sorted(item_sources(stored, item.id)):
        if (key := source.removeprefix(KEY)) != source and key in contents:
            yield Content(key, contents[key])
    yield placed
    rows: Iterable[Revision | Draft | Edit] = (*stored.revisions, *stored.drafts, *stored.edits)
    for row in rows:
        if row.item == item.id:
            yield structs.replace(row, item=placed.id)


def _find_same(ours: Stored, theirs: Stored, item: Item) -> Item | None:
    """The item of ours that has the same history and plays the same revision of it."""
    history = _history(theirs, item)
    for other in ours.items:
        same = (other.kind, other.head, other.deleted) == (item.kind, item.head, item.deleted)
        if same and history[0] and _history(ours, other) == history:
            return other
    return None


def _history(stored: Stored, item: Item) -> tuple[list[Revision], list[Draft], list[Edit]]:
    """All rows of an item, whatever its number."""
    drafts = [structs.replace(draft, item=0) for draft in stored.drafts if draft.item == item.id]
    edits = [structs.replace(edit, item=0) for edit in stored.edits if edit.item == item.id]
    return [structs.replace(revision, item=0) for revision in revisions_of(stored, item)], drafts, edits


def _taken_labels(cast: Cast, items: Sequence[Item]) -> dict[Kind, list[str]]:
    labels: dict[Kind, list[str]] = {
        "face": [*cast.faces],
        "expression": [title.label for title in cast.titles.values()],
        "pose": [pose.label for pose in cast.poses.values()],
    }
    for item in items:
        if not item.deleted:
            labels[item.kind].append(item.label)
    return labels


def _place_item(cast: Cast, items: Sequence[Item], item: Item, labels: Sequence[str]) -> Item:
    """An item as ours: behind all others, under its own name and label where they are free."""
    built_in = {*cast.faces, *cast.expressions, *cast.poses}
    taken = {other.name for other in items if other.kind == item.kind} | built_in
    free = _NAME.fullmatch(item.name) and item.name not in {name.casefold() for name in taken}
    name = item.name if free else new_name(item.label, item.kind, built_in.union(other.name for other in items))
    number = max((other.id for other in items), default=0) + 1
    place = max((other.place for other in items), default=0.0) + 1.0
    label = clean_label(item.label) if item.deleted else free_label(clean_label(item.label), labels)
    return structs.replace(item, id=number, name=name, label=label, tags=clean_tags(item.tags), place=place)


def _explain(theirs: Stored, item: Item, placed: Item) -> Iterator[str]:
    """What is to be known of an item that is called otherwise than it was."""
    if placed.name != item.name:
        yield f"another {item.kind} is named {item.name} here: {item.label!r} is {placed.name} ({placed.label})"
        for face in theirs.items:
            if item.kind == "expression" and item.name in _gained(theirs, face):
                yield f"the face {face.label!r} has a gain for {item.name}, which is {placed.name} here: set it anew"
    elif placed.label != item.label:
        yield f"there is a {item.label!r} already, so {item.name} is called {placed.label!r}"


def _gained(stored: Stored, face: Item) -> set[str]:
    """The expressions that the face which plays has gains of its own for."""
    for revision in revisions_of(stored, face):
        if revision.number == face.head and isinstance(recipe := read_recipe(revision.recipe), FaceRecipe):
            return {gain.expression for gain in recipe.gains if gain.expression is not None}
    return set()


def _add_documents(merged: Merged, ours: Stored, theirs: Stored, contents: Mapping[str, bytes]) -> None:
    for kind, named in theirs.documents.items():
        there = ours.documents.get(kind, {})
        for name, body in named.items():
            if name not in there:
                needed = [key for key in contents_of(kind, body) if key in contents]
                merged.changes += [Content(key, contents[key]) for key in needed]
                merged.changes.append(StoredDocument(kind, name, body))
                merged.labels.append(f"{kind} {name}".strip())
            elif there[name] != body:
                merged.notes.append(
                    f"the {kind} {name!r} is another one here, and stays; rename it and import again to have both"
                )
