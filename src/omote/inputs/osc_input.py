"""Senders and surfaces of OSC at a show session: packets and times in, packets for surfaces out."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from omote.inputs.osc_addresses import VMC_ROOT
from omote.inputs.osc_feedback import Feedback, tell_state
from omote.inputs.osc_hands import OscHands
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import Argument, OscError, OscMessage, decode_packet, encode_message
from omote.inputs.rejection import Rejection
from omote.inputs.trackers.packet_format import explain_format, recognize_format
from omote.show.declaration import ClientMessage
from omote.show.objects.link import Refused
from omote.show.objects.state import State
from omote.show.osc import ROOT
from omote.show.session import ShowSession
from omote.show.sources.sources_snapshot import SurfaceSubscription

MOST_SENDERS = 64
"""Senders that are known at a time; the one that was silent longest makes room."""
MOST_SURFACES = 32
"""Surfaces that are told what is on air; beyond, the one that was silent longest is told no more."""
SURFACE_SECONDS = 600.0
"""Seconds of silence after which a surface that had asked for it is told no more."""
SUBSCRIBE = f"/{ROOT}/subscribe"
UNSUBSCRIBE = f"/{ROOT}/unsubscribe"
ERROR = f"/{ROOT}/error"
HIGHEST_PORT = 65535

Endpoint = tuple[str, int]
"""Where a packet comes from or goes to: a host and a port; of a TCP connection, its own name and 0."""


@dataclass
class Surface:
    """Who is told what is on air; `lasting`: until the show ends, however silent it is."""

    feedback: Feedback = field(default_factory=Feedback)
    heard: float = 0.0
    lasting: bool = False


class OscInput:
    """Carries out on a session what packets ask for, and tells surfaces that subscribed what is on air.

    hands: what hands it heard, until they are taken. heard, rejected: counts of messages; last_rejection: the newest of
    these; newest: the last message; alike: how many in a row had its address. kind: sets its senders apart from others
    in the session; title: stands before a sender's host where consoles show it; seat_of: the seat for which a host
    plays, "" for its own; port_of: where a tracker's protocol is heard, None where it is not.
    """

    def __init__(self, session: Callable[[], ShowSession], *, kind: str = "osc", title: str = "OSC ") -> None:
        self._session = session
        self._kind = kind
        self._title = title
        self._senders: dict[str, None] = {}
        self._surfaces: dict[Endpoint, Surface] = {}
        self._numbers = itertools.count(1)
        self.seat_of: Callable[[str], str] = lambda _: ""
        self.port_of: Callable[[str], int | None] = lambda _: None
        self._reader: OrderReader | None = None
        self.hands = OscHands()
        self.heard = self.rejected = 0
        self.last_rejection: Rejection | None = None
        self.newest: tuple[Endpoint, OscMessage] | None = None
        self.alike = 0

    def receive(self, place: Endpoint, packet: bytes, now: float) -> list[tuple[Endpoint, bytes]]:
        """Obeys the messages of a packet; returns what is answered: the reasons of rejections, to surfaces alone.

        place: where it came from; now: seconds of the show's clock.
        """
        messages, answers = self.read(place, packet, now)
        return answers + [answer for message in messages for answer in self.obey(place, message, now)]

    def read(self, place: Endpoint, packet: bytes, now: float) -> tuple[list[OscMessage], list[tuple[Endpoint, bytes]]]:
        """The messages of a packet, and what is answered; what of it is no message is rejected by itself.

        place: where it came from; now: seconds of the show's clock.
        """
        for other in self._heard_by(place):
            self._surfaces[other].heard = now
        faults: list[OscError] = []
        try:
            messages = decode_packet(packet, faults)
        except OscError as error:
            messages = []
            faults.append(error)
        if not faults:
            return messages, []
        name = "" if messages else recognize_format(packet)
        more = f"; {len(faults) - 1} more of its elements are left out too" if len(faults) > 1 else ""
        return messages, self._reject(place, self._explain_tracker(name) if name else f"{faults[0]}{more}", now)

    def news(self, state: State, now: float) -> list[tuple[Endpoint, bytes]]:
        """What surfaces are to be told of a state, each what is new to it. now: seconds of the show's clock."""
        for place, surface in list(self._surfaces.items()):
            if not surface.lasting and now - surface.heard > SURFACE_SECONDS:
                del self._surfaces[place]
        self._keep()  # once a tick: senders are heard a thousand times a second
        answers = self._tell_not_spoken(now)
        if not self._surfaces:
            return answers
        values = tell_state(state)
        return answers + [
            (place, encode_message(address, *arguments))
            for place, surface in self._surfaces.items()
            for address, arguments in surface.feedback.news(values, now).items()
        ]

    def _tell_not_spoken(self, now: float) -> list[tuple[Endpoint, bytes]]:
        """Rejects, a moment later, what senders asked a voice to say that it could not."""
        mine = f"{self._kind} "
        refused = self._session().texts.take_refused(lambda who: who.startswith(mine))
        pairs = [(text.who.removeprefix(mine), reason) for text, reason in refused]
        return [answer for host, reason in pairs for answer in self._reject((host, 0), reason, now)]

    def subscribe(self, place: Endpoint, now: float, *, lasting: bool = False) -> None:
        """Tells a surface from now on what is on air, beginning with all of it.

        place: where it hears; now: seconds of the show's clock; lasting: until the show ends, however silent it is.
        """
        others = {other: surface for other, surface in self._surfaces.items() if other != place}
        while len(others) >= MOST_SURFACES:
            del others[min(others, key=lambda other: (others[other].lasting, others[other].heard))]
        self._surfaces = {**others, place: Surface(heard=now, lasting=lasting)}
        self._keep()

    def resume(self, now: float, allows: Callable[[str], bool] = lambda _: True) -> None:
        """Tells the surfaces on that subscribed before a restart and were not silent too long, from all that is on air.

        now: seconds of the show's clock; allows: whether a host may send.
        """
        for kept in self._session().surfaces:
            if 0.0 <= now - kept.heard <= SURFACE_SECONDS and allows(kept.host):
                self._surfaces[kept.host, kept.port] = Surface(heard=kept.heard)
        self._keep()

    def _keep(self) -> None:
        """Notes with the show which surfaces subscribed themselves: those of connections end with the process, and the
        lasting ones are the operator's."""
        self._session().surfaces = tuple(
            SurfaceSubscription(host, port, surface.heard)
            for (host, port), surface in self._surfaces.items()
            if port and not surface.lasting
        )

    def leave(self, place: Endpoint) -> None:
        """Forgets a surface, and a sender: its connection is gone."""
        if self._surfaces.pop(place, None) is not None:
            self._keep()
        if place[1] == 0:
            self._forget_sender(place[0])

    def obey(self, place: Endpoint, message: OscMessage, now: float) -> list[tuple[Endpoint, bytes]]:
        """Obeys a message; returns what is answered. One that cannot be obeyed is rejected by itself.

        place: where it came from; now: seconds of the show's clock.
        """
        self.heard += 1
        self._note_newest(place, message)
        try:
            if message.address in (SUBSCRIBE, UNSUBSCRIBE):
                self._follow(place, message, now)
                return []
            return self._order(place, message, now)
        except OscError as error:
            return self._reject(place, str(error), now)

    def next_call(self) -> str:
        """An id of its own for a message of the show."""
        return f"{self._kind} {self._session().epoch} {next(self._numbers)}"

    def play(self, place: Endpoint, order: ClientMessage, now: float) -> None:
        """Has a message of the show obeyed that came by another language than OSC; what is rejected is counted.

        place: where it came from; order: the message; now: seconds of the show's clock.
        """
        self.heard += 1
        for answer in self._session().receive(self._sender(place[0]), order, now):
            if isinstance(answer.message, Refused):
                self._reject(place, answer.message.reason, now)

    def obey_all(self, place: Endpoint, messages: Iterable[OscMessage], now: float) -> list[tuple[Endpoint, bytes]]:
        """Obeys messages of one place in their order, as `obey` each. Of channels that are set between two others the
        newest weight of each is set alone, and all at once: what no tick would show is not played.

        now: seconds of the show's clock.
        """
        answers = list[tuple[Endpoint, bytes]]()
        waiting = list[OscMessage]()
        reader = self._reader_of(self._session())
        levels = dict[str, dict[str, float]]()
        for message in messages:
            level = reader.channel_set(message)
            if level is not None:
                waiting.append(message)
                for who in level.meant:
                    levels.setdefault(who, {})[level.channel] = message.arguments[0]  # type: ignore[assignment]
                continue
            answers += self._set_channels(place, levels, waiting, now)
            waiting = []
            levels = {}
            answers += self.obey(place, message, now)
            reader = self._reader_of(self._session())
        return answers + self._set_channels(place, levels, waiting, now)

    def _set_channels(
        self, place: Endpoint, levels: dict[str, dict[str, float]], messages: list[OscMessage], now: float
    ) -> list[tuple[Endpoint, bytes]]:
        """Sets channels by character; if that is rejected the messages are obeyed one by one, each with an answer."""
        if len(messages) < 2:
            return [answer for message in messages for answer in self.obey(place, message, now)]
        who = self._sender(place[0])
        if not all(self._session().set_channels(who, name, values, now) for name, values in levels.items()):
            return [answer for message in messages for answer in self.obey(place, message, now)]
        self.heard += len(messages)
        for message in messages:
            self._note_newest(place, message)
        self._note_heard(place, messages, now)
        return []

    def _note_newest(self, place: Endpoint, message: OscMessage) -> None:
        before = self.newest
        self.alike = self.alike + 1 if before is not None and before[1].address == message.address else 1
        self.newest = place, message

    def _note_heard(self, place: Endpoint, messages: Iterable[OscMessage], now: float) -> None:
        """A surface is not told for a moment what it has just sent itself."""
        for other in self._heard_by(place) if self._surfaces else ():
            for message in messages:
                self._surfaces[other].feedback.note(message.address, now)

    def _order(self, place: Endpoint, message: OscMessage, now: float) -> list[tuple[Endpoint, bytes]]:
        if message.address.startswith(VMC_ROOT):
            raise OscError(self._explain_tracker("vmc"))
        if self.hands.hear(message, place[0], self._session().scene.labels):
            return []
        orders = self._reader_of(self._session()).read(message, self.next_call())
        if not orders:
            return []
        session = self._session()
        who = self._sender(place[0])
        answers = [answer.message for order in orders for answer in session.receive(who, order, now)]
        reasons = [answer.reason for answer in answers if isinstance(answer, Refused)] if answers else []
        if not reasons:
            self._note_heard(place, [message], now)
        return [
            answer for reason in reasons for answer in self._reject(place, f"{message.address[:80]}: {reason}", now)
        ]

    def _explain_tracker(self, name: str) -> str:
        return explain_format(name, self.port_of(name))

    def _reader_of(self, session: ShowSession) -> OrderReader:
        characters = session.scene.labels
        if self._reader is None or not self._reader.fits(session.cast, characters):
            self._reader = OrderReader(session.cast, characters)
        return self._reader

    def _follow(self, place: Endpoint, message: OscMessage, now: float) -> None:
        """Subscribes or unsubscribes the sender, at the port that it names, else at the one it sends from."""
        host, port = place
        named: Argument = message.arguments[0] if message.arguments else port
        number = int(named) if isinstance(named, int | float) and named == named // 1 else -1
        if len(message.arguments) > 1 or not 0 <= number <= HIGHEST_PORT or (number == 0) != (port == 0):
            raise OscError(f"{message.address} {named!r}: expected a port from 1 to {HIGHEST_PORT}, or nothing")
        if message.address == SUBSCRIBE:
            self.subscribe((host, number), now)
        elif self._surfaces.pop((host, number), None) is not None:
            self._keep()

    def _heard_by(self, place: Endpoint) -> list[Endpoint]:
        """Where the surface hears that sends from a place: over UDP mostly at another port of its host."""
        return [other for other in self._surfaces if other[0] == place[0]]

    def _sender(self, host: str) -> str:
        """The sender's name in the session, which it joins at its first message."""
        who = f"{self._kind} {host}"
        if host in self._senders:
            del self._senders[host]  # to the end: who was silent longest stands first
        else:
            self._session().join(who, f"{self._title}{host}"[:24], self.seat_of(host))
        self._senders[host] = None
        if len(self._senders) > MOST_SENDERS:
            self._forget_sender(next(iter(self._senders)))
        return who

    def _forget_sender(self, host: str) -> None:
        if host in self._senders:
            del self._senders[host]
            self._session().leave(f"{self._kind} {host}")

    def _reject(self, place: Endpoint, reason: str, now: float) -> list[tuple[Endpoint, bytes]]:
        self.rejected += 1
        self.last_rejection = Rejection(now, place[0], reason)
        hearing = self._heard_by(place)
        answer = encode_message(ERROR, reason[:400].replace("\0", " ")) if hearing else b""
        return [(other, answer) for other in hearing]
