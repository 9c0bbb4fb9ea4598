"""Every message on the wire, gathered from the nouns in `objects/`; `tools/messages.py` writes its TypeScript mirror.

Messages are MessagePack maps with a `type` tag. Numbers keep plain types: the session checks them in the ranges that
their fields declare, and the engine where it plays them (`perform/limits.py`). Documents (manifest, face asset,
compound) travel over HTTP, as MessagePack maps without a tag.
"""

from __future__ import annotations

import pkgutil
from importlib import import_module

import msgspec

from omote.show import cast_documents, objects
from omote.show.access.access_documents import ACCESS_DOCUMENTS
from omote.show.cast_documents import (
    BodyAsset,
    CompoundAsset,
    ContentAsset,
    FaceAsset,
    FigureAsset,
    HairAsset,
    Manifest,
)
from omote.show.declaration import ClientMessage, Declared, Message, ServerMessage, kinds_below, tag_of
from omote.show.objects.documents import Document

PROTOCOL_VERSION = 14
LINK_PATH = "/link"
STATE_RATE = 60.0
"""States per second."""

MODULES = tuple(
    import_module(module.name) for module in pkgutil.walk_packages(objects.__path__, f"{objects.__name__}.")
)
"""The nouns of a show; importing one declares it."""


def declared(base: type[Declared]) -> tuple[type[Declared], ...]:
    """The kinds of messages that the nouns declare below a base. base: of all of them."""
    return kinds_below(base, MODULES)


CLIENT_MESSAGES = declared(ClientMessage)
SERVER_MESSAGES = declared(ServerMessage)
BY_TAG = {tag_of(kind): kind for kind in CLIENT_MESSAGES}
DOCUMENTS: tuple[type[msgspec.Struct], ...] = (
    *(Manifest, FaceAsset, ContentAsset, HairAsset, FigureAsset, BodyAsset, CompoundAsset),
    *ACCESS_DOCUMENTS,
)
STRUCTS: tuple[type[msgspec.Struct], ...] = tuple(
    value
    for module in (*MODULES, cast_documents)
    for value in vars(module).values()
    if isinstance(value, type) and issubclass(value, msgspec.Struct) and value.__module__ == module.__name__
    if not issubclass(value, Document) and not (issubclass(value, Message) and value.__subclasses__())
)
"""All that travels, in the order of its declaration."""
