"""Stored documents: nouns that the show file keeps by kind and name; a kind is one class, and nothing elsewhere."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterable, Mapping
from typing import Annotated, Any, ClassVar, TypeVar

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.show import objects
from omote.show.access.access_role import HIGHEST, AccessRole
from omote.show.declaration import FileRequest, Name, RequestId, ServerMessage

DocumentText = Annotated[str, msgspec.Meta(max_length=3600)]

KINDS: dict[str, type[Document]] = {}
"""Every kind of document that has been declared so far; `declared_kinds` declares those of `show/objects` first."""


class Document(msgspec.Struct, frozen=True):
    """A stored noun; a subclass declares a kind, and its fields are the schema of the JSON that the file keeps.

    kind: the key of the kind in files, messages and addresses, for ever, and its noun for people; read_by, written_by:
    the role that reads and lists, or puts, renames and drops, such documents over a page's link; None: the server
    alone; most: how many of the kind are kept.
    """

    kind: ClassVar[str]
    read_by: ClassVar[AccessRole | None] = None
    written_by: ClassVar[AccessRole | None] = None
    most: ClassVar[int] = 64

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        KINDS[cls.kind] = cls

    def names(self) -> Iterable[str]:
        """The faces, expressions and characters that the document names."""
        return ()

    def contents(self) -> Iterable[str]:
        """The keys of the contents (bytes) of the show file that the document needs."""
        return ()

    def encode(self) -> bytes:
        """The document as the file keeps it (JSON)."""
        return msgspec.json.encode(self)


Kept = TypeVar("Kept", bound=Document)


def declared_kinds() -> Mapping[str, type[Document]]:
    """Every kind of document, by its key."""
    for module in pkgutil.walk_packages(objects.__path__, f"{objects.__name__}."):
        importlib.import_module(module.name)
    return KINDS


def read_document(kind: type[Kept], body: bytes) -> Kept:
    """The document in the JSON of a file or a message; ValueError, as a clause, where it is none of its kind.

    kind: the class of the document; body: the JSON.
    """
    try:
        return msgspec.json.decode(body, type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"this is no {kind.kind} ({explain_error(error)})") from error


def names_in(kind: str, body: bytes, names: Iterable[str]) -> list[str]:
    """Those of some names that a stored document holds.

    kind: the key of its kind, body: its JSON; of one that this Omote does not know or cannot read the bytes are looked
    through. names: of faces, expressions or characters.
    """
    declared = declared_kinds().get(kind)
    try:
        held = set(read_document(declared, body).names()) if declared is not None else None
    except ValueError:
        held = None
    return [name for name in names if (name.encode() in body if held is None else name in held)]


def contents_of(kind: str, body: bytes) -> Iterable[str]:
    """The keys of the contents that a stored document needs; none of one that this Omote does not know or cannot read.

    kind: the key of its kind; body: its JSON.
    """
    declared = declared_kinds().get(kind)
    try:
        return () if declared is None else tuple(read_document(declared, body).contents())
    except ValueError:
        return ()


# --- the messages of a kind that pages keep ---


class DocumentRequest(FileRequest, frozen=True):
    """What a console asks of a document of a kind. of: the kind; name: of the document."""

    access = "admin"
    of: ClassVar[type[Document]]

    name: Name


class SetDocument(DocumentRequest, frozen=True):
    """Stores a page's {kind} (JSON) in the show file under a name; `/{kind}s/NAME` returns it. Answered, as the two
    below, with `{kind}s`; `id`: named where it is rejected."""

    document: DocumentText
    id: RequestId = ""


class RenameDocument(DocumentRequest, frozen=True):
    """Gives a {kind} of the show file another name, which none has yet."""

    to: Name
    id: RequestId = ""


class DropDocument(DocumentRequest, frozen=True):
    """Takes a {kind} out of the show file."""

    id: RequestId = ""


class DocumentNames(ServerMessage, frozen=True):
    """The names of all {kind}s in the show file, sorted: complete, to consoles after the welcome and with each
    change."""

    of: ClassVar[type[Document]]

    names: list[str]


Messages = tuple[type[SetDocument], type[RenameDocument], type[DropDocument], type[DocumentNames]]
NAMES_OF: dict[str, type[DocumentNames]] = {}
"""What tells consoles of the documents of a kind that they may read and write."""
READ_ROUTES: dict[str, AccessRole] = {}
"""The addresses of the documents of such kinds, as the web server's router writes them, and who may read there."""


def address_of(kind: str) -> str:
    """The address of the documents of a kind, as the web server's router writes it."""
    return f"/{kind}s/{{name}}"


def messages_of(kind: type[Document]) -> Messages:
    """The messages by which pages keep documents of a kind: they set, rename and drop one, and hear which there are.

    They stand in the module of the kind, under the names that they have here: `SetLayout`, `RenameLayout`,
    `DropLayout`, `Layouts`.
    """
    name = kind.__name__
    NAMES_OF[kind.kind] = _message(f"{name}s", DocumentNames, kind)
    READ_ROUTES[address_of(kind.kind)] = kind.read_by or HIGHEST
    return (
        _message(f"Set{name}", SetDocument, kind),
        _message(f"Rename{name}", RenameDocument, kind),
        _message(f"Drop{name}", DropDocument, kind),
        NAMES_OF[kind.kind],
    )


Made = TypeVar("Made", bound=msgspec.Struct)


def _message(name: str, base: type[Made], kind: type[Document]) -> type[Made]:
    said = {"of": kind, "access": kind.written_by, "__doc__": (base.__doc__ or "").format(kind=kind.kind)}
    message: Any = msgspec.defstruct(name, [], bases=(base,), namespace=said, module=kind.__module__, frozen=True)
    return message  # type: ignore[no-any-return]
