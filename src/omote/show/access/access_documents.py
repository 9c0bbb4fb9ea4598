"""The documents about people and tokens that the web server sends and reads, as MessagePack."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.show.access.access_role import AccessRole
from omote.show.access.people_list import LONGEST_NAME


class AccessDocument(msgspec.Struct, frozen=True):
    """Who a page is to the show: a role, and a name where the token is somebody's own. `asked`: whether the show asks
    for tokens at all."""

    role: AccessRole
    name: str
    asked: bool


class PersonDocument(msgspec.Struct, frozen=True):
    """Somebody who has a token: `made` and `until` in seconds since 1970, `until` `None` for ever. `links`: how many of
    their pages and programs are connected; `own`: it is who asks."""

    id: str
    name: str
    role: AccessRole
    made: float
    until: float | None
    links: int
    own: bool


class PeopleDocument(msgspec.Struct, frozen=True):
    """Everybody who has a token."""

    people: list[PersonDocument]


class NewPerson(msgspec.Struct, frozen=True):
    """Asks for a token: for a name, with a role, and for how many hours (`None`: for ever)."""

    name: Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_NAME)]
    role: AccessRole
    hours: float | None


class CodeDocument(msgspec.Struct, frozen=True):
    """The address by which somebody enters, with their token, and a QR code of it: a picture in a `data:` address."""

    id: str
    address: str
    picture: str


REVOKED_CODE = 4401
"""How a link is closed whose token is not valid any more: pages then ask for another."""
ACCESS_STRUCTS: tuple[type[msgspec.Struct], ...] = (
    *(AccessDocument, PersonDocument, PeopleDocument, NewPerson, CodeDocument),
)
ACCESS_DOCUMENTS: tuple[type[msgspec.Struct], ...] = (AccessDocument, PeopleDocument, NewPerson, CodeDocument)
