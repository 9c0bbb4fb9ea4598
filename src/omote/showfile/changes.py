"""The rows of authored work (items, revisions, drafts, edits) as plain data, and the changes to them."""

from __future__ import annotations

import hashlib
from typing import Literal

import msgspec

Kind = Literal["expression", "face"]


class Item(msgspec.Struct, frozen=True):
    """An own expression or face: its name (for ever, a key of the cast), what people read, its place in palettes.

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


class PutContent(msgspec.Struct, frozen=True, tag=True):
    """Stores bytes (`showfile.contents`) under the key of their content; ignored where it is there already."""

    key: str
    data: bytes


class PutItem(msgspec.Struct, frozen=True, tag=True):
    """Adds an item, or replaces the one of this id."""

    item: Item


class PutRevision(msgspec.Struct, frozen=True, tag=True):
    """Adds a revision; revisions are never replaced or removed."""

    revision: Revision


class PutDraft(msgspec.Struct, frozen=True, tag=True):
    """Adds a draft, or replaces that of this item and editor."""

    draft: Draft


class PutEdit(msgspec.Struct, frozen=True, tag=True):
    """Adds a step to a draft; the steps from its number on, undone before, go."""

    edit: Edit


class DropDraft(msgspec.Struct, frozen=True, tag=True):
    """Removes a draft with its steps."""

    item: int
    editor: str


class PutLayout(msgspec.Struct, frozen=True, tag=True):
    """Stores a document (JSON) of a page by name, such as the console's layout."""

    name: str
    document: bytes


class DropLayout(msgspec.Struct, frozen=True, tag=True):
    """Removes a page's document."""

    name: str


class PutBindings(msgspec.Struct, frozen=True, tag=True):
    """Stores what controls of devices play, as a document (JSON)."""

    document: bytes


class PutPerformer(msgspec.Struct, frozen=True, tag=True):
    """Stores how the landmarks of a performer's face are read, as a document (JSON) by the performer's name."""

    name: str
    document: bytes


class DropPerformer(msgspec.Struct, frozen=True, tag=True):
    """Removes a performer."""

    name: str


Change = (
    PutContent
    | PutItem
    | PutRevision
    | PutDraft
    | PutEdit
    | DropDraft
    | PutLayout
    | DropLayout
    | PutBindings
    | PutPerformer
    | DropPerformer
)


class Stored(msgspec.Struct, frozen=True):
    """All authored work of a show file but the contents' bytes."""

    items: tuple[Item, ...] = ()
    revisions: tuple[Revision, ...] = ()
    drafts: tuple[Draft, ...] = ()
    edits: tuple[Edit, ...] = ()
    layouts: dict[str, bytes] = {}
    bindings: bytes = b""
    performers: dict[str, bytes] = {}


def content_key(data: bytes, /) -> str:
    """The permanent key of these bytes (their hash): 24 hexadecimal digits."""
    return hashlib.blake2b(data, digest_size=12).hexdigest()
