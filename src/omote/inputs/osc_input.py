"""Senders and surfaces of OSC at a show session: packets and times in, packets for surfaces out."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

from omote.inputs.osc_addresses import ROOT, Order, read_order
from omote.inputs.osc_feedback import Feedback, tell_state
from omote.inputs.osc_packet import Argument, OscError, OscMessage, decode_packet, encode_message
from omote.show.messages import Refused, State
from omote.show.session import ShowSession

FIRST_CHARACTER = "one"
"""The name of the only character that a show has so far."""
MOST_SENDERS = 64
"""Senders that are known at a time; the one that was silent longest makes room."""
MOST_SURFACES = 32
"""Surfaces that are told what is on air; beyond, the one that was silent longest is told no more."""
SURFACE_SECONDS = 600.0
"""Seconds of silence after which a surface that had asked for it is told no more."""
SUBSCRIBE, UNSUBSCRIBE, ERROR = f"/{ROOT}/subscribe", f"/{ROOT}/unsubscribe", f"/{ROOT}/error"
HIGHEST_PORT = 65535

Place = tuple[str, int]
"""Where a packet comes from or goes to: a host and a port; of a TCP connection, its own name and 0."""


@dataclass
class Surface:
    """Who is told what is on air; `lasting`: until the show ends, however silent it is."""

    feedback: Feedback = field(default_factory=Feedback)
    heard: float = 0.0
    lasting: bool = False


@dataclass(frozen=True)
class Rejection:
    """A message or packet that was not obeyed: when, whose it was, and why."""

    time: float
    sender: str
    reason: str


class OscInput:
    """Carries out on a session what packets ask for, and tells surfaces that subscribed what is on air.

    heard, rejected: counts of messages; last_rejection: the newest of these.
    """

    def __init__(self, session: Callable[[], ShowSession]) -> None:
        self._session = session
        self._senders: dict[str, None] = {}
        self._surfaces: dict[Place, Surface] = {}
        self._numbers = itertools.count(1)
        self.heard = self.rejected = 0
        self.last_rejection: Rejection | None = None

    def receive(self, place: Place, packet: bytes, now: float) -> list[tuple[Place, bytes]]:
        """Obeys the messages of a packet; returns what is answered: the reasons of rejections, to surfaces alone.

        A packet that is none is rejected whole, a message that cannot be obeyed by itself.
        """
        for other in self._heard_by(place):
            self._surfaces[other].heard = now
        try:
            messages = decode_packet(packet)
        except OscError as error:
            return self._reject(place, str(error), now)
        return [answer for message in messages for answer in self._obey(place, message, now)]

    def news(self, state: State, now: float) -> list[tuple[Place, bytes]]:
        """What surfaces are to be told of a state, each what is new to it."""
        for place, surface in list(self._surfaces.items()):
            if not surface.lasting and now - surface.heard > SURFACE_SECONDS:
                del self._surfaces[place]
        if not self._surfaces:
            return []
        values = tell_state(state, FIRST_CHARACTER)
        return [
            (place, encode_message(address, *told))
            for place, surface in self._surfaces.items()
            for address, told in surface.feedback.news(values, now).items()
        ]

    def subscribe(self, place: Place, now: float, *, lasting: bool = False) -> None:
        """Tells a surface from now on what is on air, beginning with all of it."""
        others = {other: each for other, each in self._surfaces.items() if other != place}
        while len(others) >= MOST_SURFACES:
            del others[min(others, key=lambda other: (others[other].lasting, others[other].heard))]
        self._surfaces = {**others, place: Surface(heard=now, lasting=lasting)}

    def leave(self, place: Place) -> None:
        """Forgets a surface, and a sender: its connection is gone."""
        self._surfaces.pop(place, None)
        if place[1] == 0:
            self._forget_sender(place[0])

    def _obey(self, place: Place, message: OscMessage, now: float) -> list[tuple[Place, bytes]]:
        self.heard += 1
        try:
            if message.address in (SUBSCRIBE, UNSUBSCRIBE):
                self._follow(place, message, now)
                return []
            return self._order(place, message, now)
        except OscError as error:
            return self._reject(place, str(error), now)

    def _order(self, place: Place, message: OscMessage, now: float) -> list[tuple[Place, bytes]]:
        session = self._session()
        order = read_order(message, session.cast, f"osc {session.epoch} {next(self._numbers)}")
        if order is None:
            return []
        check_character(order)
        reasons = [
            answer.message.reason
            for answer in session.receive(self._sender(place[0]), order.message, now)
            if isinstance(answer.message, Refused)
        ]
        for other in self._heard_by(place) if not reasons else ():
            self._surfaces[other].feedback.note(message.address, now)
        return [answer for reason in reasons for answer in self._reject(place, reason, now)]

    def _follow(self, place: Place, message: OscMessage, now: float) -> None:
        """Subscribes or unsubscribes the sender, at the port that it names, else at the one it sends from."""
        host, port = place
        named: Argument = message.arguments[0] if message.arguments else port
        number = int(named) if isinstance(named, int | float) and named == named // 1 else -1
        if len(message.arguments) > 1 or not 0 <= number <= HIGHEST_PORT or (number == 0) != (port == 0):
            raise OscError(f"{message.address} {named!r}: expected a port from 1 to {HIGHEST_PORT}, or nothing")
        if message.address == SUBSCRIBE:
            self.subscribe((host, number), now)
        else:
            self._surfaces.pop((host, number), None)

    def _heard_by(self, place: Place) -> list[Place]:
        """Where the surface hears that sends from a place: over UDP mostly at another port of its host."""
        return [other for other in self._surfaces if other[0] == place[0]]

    def _sender(self, host: str) -> str:
        """The sender's name in the session, which it joins at its first message."""
        who = f"osc {host}"
        if host in self._senders:
            del self._senders[host]  # to the end: who was silent longest stands first
        else:
            self._session().join(who, f"OSC {host}"[:24])
        self._senders[host] = None
        if len(self._senders) > MOST_SENDERS:
            self._forget_sender(next(iter(self._senders)))
        return who

    def _forget_sender(self, host: str) -> None:
        if host in self._senders:
            del self._senders[host]
            self._session().leave(f"osc {host}")

    def _reject(self, place: Place, reason: str, now: float) -> list[tuple[Place, bytes]]:
        self.rejected += 1
        self.last_rejection = Rejection(now, place[0], reason)
        answer = encode_message(ERROR, reason[:400].replace("\0", " "))
        return [(other, answer) for other in self._heard_by(place)]


def check_character(order: Order, names: Mapping[str, object] | tuple[str, ...] = (FIRST_CHARACTER,)) -> None:
    """Raises OscError where no character has the name that an order is for; "*" and the like are patterns of OSC."""
    if order.character and not any(matches(order.character, name) for name in names):
        raise OscError(f"there is no character {order.character[:80]!r}; there is {', '.join(names)}, and * for all")


def matches(pattern: str, name: str) -> bool:
    """Whether a name is one that a pattern of OSC means: `*`, `?`, `[a-c]`, `[!a]`, `{one,two}`."""
    head, brace, rest = pattern.partition("{")
    choices, closed, tail = rest.partition("}")
    if not (brace and closed):
        return fnmatchcase(name, pattern)
    return any(fnmatchcase(name, f"{head}{choice}{tail}") for choice in choices.split(","))
