"""Builds one cast of the built-in one and all items of a show file, for commands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from omote.model.cast import Cast, Title
from omote.showfile.changes import Item, Stored
from omote.showfile.contents import unpack_expression, unpack_face
from omote.stage_data.playing_cast import Own


def build_full_cast(base: Cast, stored: Stored, contents: Mapping[str, bytes], /) -> Cast:
    """Adds every item that plays to the base, by name; KeyError where a content is missing."""
    faces, looks, expressions, titles = dict(base.faces), dict(base.looks), dict(base.expressions), dict(base.titles)
    for item, content in playing_items(stored):
        data = contents[content]
        if item.kind == "face":
            faces[item.name], looks[item.name] = unpack_face(data, item.name)
        else:
            expressions[item.name], titles[item.name] = unpack_expression(data), Title(item.label)
    return replace(base, faces=faces, looks=looks, expressions=expressions, titles=titles)


def playing_items(stored: Stored, /) -> list[tuple[Item, str]]:
    """Every item that plays, with the key of its content."""
    saved = {(revision.item, revision.number): revision.content for revision in stored.revisions}
    return [(item, saved[item.id, item.head]) for item in stored.items if item.head and not item.deleted]


def own_items(stored: Stored, /) -> tuple[Own, ...]:
    """Every item that plays, as the pages get it."""
    return tuple(
        Own(item.kind, item.name, item.label, item.tags, item.place, content) for item, content in playing_items(stored)
    )
