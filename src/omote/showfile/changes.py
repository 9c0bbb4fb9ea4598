"""The rows of authored work (items with their history, documents) as plain data, and the changes to them."""

from __future__ import annotations

import hashlib
from typing import Literal

import msgspec

Kind = Literal["expression", "face", "pose"]


class Item(msgspec.Struct, frozen=True):
    """An own expression, face or pose: its name (for ever, a key of the cast), what people read, its place in palettes.

    head: the revision that plays, 0 for none yet; deleted items stay, and can come back.
    """

    id: int
    kind: Kind
    name: str
    label: str
    tags: tuple[str, ...] = ()
    place: float = 0.0
    head: int = 0
    deleted: bool = False


class Revision(msgspec.Struct, frozen=True):
    """A save: the recipe (JSON) and the key of what it makes; aside: kept beside another editor's, never played.

    parent: the revision it was made from, 0 for none; written: seconds since 1970, for people only.
    """

    item: int
    number: int
    parent: int
    recipe: bytes
    content: str
    written: float
    editor: str
    note: str = ""
    aside: bool = False


class BroughtItem(msgspec.Struct, frozen=True):
    """An item of another show file with the one revision that plays, and the bytes of its content."""

    item: Item
    revision: Revision
    content: bytes


class Draft(msgspec.Struct, frozen=True):
    """One editor's unsaved work at an item: the revision it began from, and which of its edits is shown."""

    item: int
    editor: str
    base: int
    cursor: int


class Edit(msgspec.Struct, frozen=True):
    """One step of a draft, numbered from 0: the whole recipe (JSON) after it, and what was done, for people."""

    item: int
    editor: str
    number: int
    recipe: bytes
    what: str


class Content(msgspec.Struct, frozen=True):
    """Bytes (`showfile.contents`) under the key of their content; one that is there already stays."""

    key: str
    data: bytes


class ContentRemoval(msgspec.Struct, frozen=True):
    """Removes the content of a key, which no revision needs; nothing where there is none."""

    key: str


class StoredDocument(msgspec.Struct, frozen=True):
    """A noun that the show file keeps by its kind and its name, such as a layout; body: JSON (`show.objects`)."""

    kind: str
    name: str
    body: bytes


class DocumentRemoval(msgspec.Struct, frozen=True):
    """Removes the document of a kind and a name; nothing where there is none."""

    kind: str
    name: str


Change = Content | ContentRemoval | Item | Revision | Draft | Edit | StoredDocument | DocumentRemoval
"""A row that is put, or a document or a content that is dropped.

An item, a draft and a document take the place of those of the same key; a revision is never replaced or removed; an
edit takes the place of the steps of its draft from its number on, which were undone before.
"""

Documents = dict[str, dict[str, bytes]]
"""The bodies of documents by kind, and by name."""


class Stored(msgspec.Struct, frozen=True):
    """All authored work of a show file but the contents' bytes; no kind is there without a document."""

    items: tuple[Item, ...] = ()
    revisions: tuple[Revision, ...] = ()
    drafts: tuple[Draft, ...] = ()
    edits: tuple[Edit, ...] = ()
    documents: Documents = {}


def playing_items(stored: Stored, /) -> list[tuple[Item, str]]:
    """Every item that plays, with the key of its content."""
    saved = {(revision.item, revision.number): revision.content for revision in stored.revisions}
    return [(item, saved[item.id, item.head]) for item in stored.items if item.head and not item.deleted]


def content_key(data: bytes, /) -> str:
    """The permanent key of these bytes (their hash): 24 hexadecimal digits."""
    return hashlib.blake2b(data, digest_size=12).hexdigest()
