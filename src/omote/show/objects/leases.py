"""Leases: who holds which part of a character or of the scene."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec

from omote.show.declaration import CallId, CharacterName, ClientMessage, Outgoing, ServerMessage, Session
from omote.show.osc import PRESS, Osc, Value

LeasePart = Literal[
    "face", "expression", "brows", "eyes", "mouth", "channels", "head", "gaze", "pose", "place", "light", "framing",
    "black", "cues", "*",
]  # fmt: skip


SCENE_PART = Value("scene_lease", name="part")


def _addresses(path: str, tells: str, **fixed: object) -> tuple[Osc, Osc]:
    """The addresses of a part of a character, and of the scene. path: the one before the part; tells: what it does to a
    part {}; fixed: as of `Osc`."""
    of_it = tells.format("of it (face, head ..., or all)")
    of_scene = tells.format("of the scene (light, framing, black, cues, or all of all characters)")
    return (
        Osc(path + "/{part}", of_it, (PRESS,), fixed),
        Osc(path + "/{part}", of_scene, (SCENE_PART, PRESS), fixed, of_show=True),
    )


class Lease(ClientMessage, frozen=True):
    """Holds a part of a character: nobody else may play it until it is released; of one that the seat holds already,
    answers those who want it that it is kept. Rejected where another seat holds it, but for `take_over`; all parts of
    others are the stage manager's to take over. An `id` executes once, as of the messages below."""

    access = "operate"
    recorded = False
    osc = (
        *_addresses("lease", "holds a part {}: nobody else plays it, while leases are on"),
        *_addresses("take_over", "takes over a part {} that another holds", take_over=True),
    )

    id: CallId
    character: CharacterName
    part: Annotated[LeasePart, Value("lease")]
    take_over: bool = False

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Asks the leases of the session, and tells whom it is about. who: the client; now: seconds, monotonic."""
        answers: Sequence[Outgoing] = session.leasing.lease(who, self, tuple(session.scene))
        return answers


class ReleaseLease(ClientMessage, frozen=True):
    """Releases a part, or takes back the wish for one that another holds; "*": all of a character, or of all."""

    access = "operate"
    recorded = False
    osc = _addresses("release_lease", "releases a part {}, or wants no more what another holds")

    id: CallId
    character: CharacterName
    part: Annotated[LeasePart, Value("lease")]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Asks the leases of the session, and tells whom it is about. who: the client; now: seconds, monotonic."""
        answers: Sequence[Outgoing] = session.leasing.release(who, self, tuple(session.scene))
        return answers


class SetLeases(ClientMessage, frozen=True):
    """Switches leases on, which makes the sender's seat the stage manager, or off, which releases all; on again, while
    no stage manager is there, makes the sender the stage manager."""

    method = ""
    access = "admin"
    recorded = False

    id: CallId
    on: bool

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Asks the leases of the session, and tells whom it is about. who: the client; now: seconds, monotonic."""
        answers: Sequence[Outgoing] = session.leasing.switch(who, on=self.on)
        return answers


class AppointManager(ClientMessage, frozen=True):
    """Makes another seat the stage manager, by its number; the stage manager alone may."""

    method = ""
    access = "admin"
    recorded = False

    id: CallId
    seat: int

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Asks the leases of the session, and tells whom it is about. who: the client; now: seconds, monotonic."""
        answers: Sequence[Outgoing] = session.leasing.appoint(who, self.seat)
        return answers


class SeatState(msgspec.Struct, frozen=True):
    """An operator, or a source that holds something: its number, its name and its colour, `#rrggbb`. `manager`: the
    stage manager; `here`: a link of it is there."""

    number: int
    name: str
    colour: str
    manager: bool = False
    here: bool = True


class LeaseWish(msgspec.Struct, frozen=True):
    """A part that somebody holds, as in `Leases.held`, the number of the seat that wants it, and for how many seconds.
    It stands until the part is released or taken over, its holder holds it again (`lease`), or the seat takes the wish
    back (`release_lease`) or has gone."""

    part: str
    by: int
    seconds: int


class Leases(ServerMessage, frozen=True):
    """Who holds what, complete, to consoles once leases have been switched on: when it changes and once a second.
    `held`: by character and part (`one/face`; the character of light, framing and black is `*`); `seats`: all
    operators, and what else holds or wants something; `you`: the number of this console's own. While leases are not
    `on` the last touch wins.
    """

    on: bool
    held: dict[str, SeatState]
    seats: list[SeatState]
    you: int
    wishes: list[LeaseWish] = []


class LeaseClaim(ServerMessage, frozen=True):
    """To the consoles of a seat: another touched parts that it holds, or has `taken` them over, or, holding what it
    wanted, has `kept` them. `parts`: as in `Leases.held`."""

    parts: list[str]
    by: SeatState
    taken: bool
    kept: bool = False
