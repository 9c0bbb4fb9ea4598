"""Layouts: how a console is laid out, saved under a name for every console of the show."""

from __future__ import annotations

from typing import ClassVar

import msgspec

from omote.show.access.access_role import AccessRole
from omote.show.objects.documents import Document, messages_of


class Layout(Document, frozen=True, rename="camel"):
    """How an operator has laid out a console; a page checks the names of what it shows, which change with it."""

    kind: ClassVar[str] = "layout"
    read_by: ClassVar[AccessRole | None] = "view"
    written_by: ClassVar[AccessRole | None] = "operate"

    version: int
    timing: dict[str, dict[str, float | str | bool | None]]
    palette: str = msgspec.field(name="kind")
    tab: str
    linked: bool
    own_faces: bool = False
    springs: dict[str, bool] = msgspec.field(default_factory=dict)
    view: str = ""
    mixer: str = ""
    alone: bool = False


SetLayout, RenameLayout, DropLayout, Layouts = messages_of(Layout)
