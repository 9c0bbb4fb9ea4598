"""The leases of a session: what is rejected because others hold it, who is told what, and when."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.show import messages as wire
from omote.show.crew.members import Members
from omote.show.leases.lease_table import LeaseTable
from omote.show.leases.lease_wishes import LeaseWishes
from omote.show.leases.leased_parts import describe_key, keys_of, keys_played
from omote.show.leases.seats import Seat, Seats
from omote.show.validation import Refusal

LOOK_SECONDS = 0.1
"""Seconds between two looks at who is here, where nobody took or released anything."""
AGAIN_SECONDS = 1.0
"""Seconds after which a console is told the same again, and a holder of the same touch: a message may be lost."""
OFF = "leases are off: whoever touches a control last has it; switch them on first."


class HeldByOthersRefusal(Refusal):
    """A part is another's. held: by part, the seat that holds it."""

    def __init__(self, reason: str, held: Mapping[str, str]) -> None:
        super().__init__(reason)
        self.held = dict(held)


@dataclass(frozen=True)
class LeaseSnapshot:
    """The leases of a show: the switch, the stage manager, who holds what, and the seats, by their tokens."""

    on: bool = False
    manager: str = ""
    held: dict[str, str] = field(default_factory=dict)
    seats: dict[str, Seat] = field(default_factory=dict)


class Leasing:
    """Who may command what. members: who is connected; labels: what people call the characters now, by name."""

    def __init__(
        self,
        members: Members,
        snapshot: LeaseSnapshot | None = None,
        labels: Callable[[], Mapping[str, str]] = dict,
    ) -> None:
        before = snapshot or LeaseSnapshot()
        self.seats = Seats(before.seats)
        held = {key: seat for key, seat in before.held.items() if seat in self.seats}
        self.table = LeaseTable(on=before.on, manager=before.manager, held=held)
        self._wishes = LeaseWishes()
        self._members, self._labels = members, labels
        self._looked = -AGAIN_SECONDS
        self._changed = True
        self._told: dict[str, tuple[wire.Leases, float]] = {}
        self._claimed: dict[tuple[str, str], float] = {}

    def snapshot(self) -> LeaseSnapshot:
        """The leases as they are."""
        table = self.table
        return LeaseSnapshot(table.on, table.manager, dict(table.held), dict(self.seats.known))

    def check(self, who: str, message: wire.Message, characters: Collection[str]) -> None:
        """HeldByOthersRefusal where a message plays what another seat holds."""
        if self.table.on:
            self._refuse_foreign(who, keys_played(message, characters))

    def note(self, who: str, message: wire.Message, characters: Collection[str]) -> None:
        """Gives the sender of a message that was obeyed the free parts that it plays."""
        if self.table.on and not isinstance(message, wire.RemoveCharacter):
            self._give(who, keys_played(message, characters))

    def obey(
        self, who: str, message: wire.LeaseMessage, characters: Sequence[str]
    ) -> list[tuple[str, wire.LeaseClaim]]:
        """Does what a message about leases asks for; returns who is told of it. characters: of the scene."""
        seat = self._seat_of(who)
        self._changed = True
        match message:
            case wire.Lease():
                return self._lease(who, message, characters)
            case wire.ReleaseLease():
                self._release(seat, message, characters)
            case wire.SetLeases(on=on):
                self._switch(seat, on=on)
            case wire.AppointManager(seat=number):
                self._appoint(seat, number)
        return []

    def claims(self, who: str, held: Mapping[str, str], now: float) -> list[tuple[str, wire.LeaseClaim]]:
        """What the holders of parts are told of a client that touched them, at most once a second."""
        seat = self._seat_of(who)
        self._wishes.note(seat, held, now)
        self._changed = True
        late = {
            each for each in held.values() if now - self._claimed.get((seat, each), -AGAIN_SECONDS) >= AGAIN_SECONDS
        }
        self._claimed |= {(seat, each): now for each in late}
        return self._claims(seat, {key: each for key, each in held.items() if each in late}, taken=False)

    def expire(self, characters: Collection[str], now: float) -> None:
        """Frees what those held who have been away for some seconds."""
        before = len(self.table.held), self.table.manager
        self.table.expire(self._present(), characters, now)
        ended = self._wishes.expire(self._is_foreign, self._present(), self._console_seats(), now)
        self._changed |= ended or before != (len(self.table.held), self.table.manager)

    def tell(self, now: float) -> dict[str, wire.Leases]:
        """What consoles must be told now, by client."""
        if not self._changed and now - self._looked < LOOK_SECONDS:
            return {}
        self._looked, self._changed = now, False
        consoles = self._members.consoles()
        self._told = {who: told for who, told in self._told.items() if who in consoles}
        self._meet_all()
        seats = {token: self._state_of(token) for token in self._listed()}
        wishes = [
            wire.LeaseWish(each.key, seats[each.seat].number, int(now - each.since))
            for each in self._wishes
            if each.seat in seats
        ]
        news = {who: self._message(who, seats, wishes) for who in consoles}
        told = {who: message for who, message in news.items() if self._is_due(who, message, now)}
        self._told |= {who: (message, now) for who, message in told.items()}
        return told

    def _is_due(self, who: str, message: wire.Leases, now: float) -> bool:
        if who not in self._told:
            return message.on  # off is what a console takes for granted
        before, told = self._told[who]
        return message != before or now - told >= AGAIN_SECONDS

    def _message(self, who: str, seats: Mapping[str, wire.SeatState], wishes: Sequence[wire.LeaseWish]) -> wire.Leases:
        held = {key: seats[holder] for key, holder in self.table.held.items()}
        return wire.Leases(self.table.on, held, [*seats.values()], seats[self._members[who].seat].number, [*wishes])

    def _listed(self) -> list[str]:
        """The seats of consoles, and those that hold or want something, in their order."""
        wanted = self._console_seats() | {*self.table.held.values(), *(each.seat for each in self._wishes)}
        return [token for token in self.seats.known if token in wanted]

    def _state_of(self, token: str) -> wire.SeatState:
        seat, here = self.seats[token], token in self._present()
        return wire.SeatState(seat.number, seat.name, seat.colour, token == self.table.manager, here)

    def _meet_all(self) -> None:
        """Notes the seats of consoles, and what all seats are called now."""
        names, consoles = self._names(), self._console_seats()
        for token, name in names.items():
            if token in consoles or token in self.seats:
                self.seats.meet(token, name, self._needed())

    def _names(self) -> dict[str, str]:
        """What seats are called: as their first console, else as their source."""
        members = [each for each in self._members.present.values() if each.seat]
        sources = {each.seat: each.name for each in members if each.role == "source"}
        consoles = {each.seat: each.name for each in reversed(members) if each.role == "console"}
        return sources | consoles

    def _seat_of(self, who: str) -> str:
        """The seat of a client, which is known from then on."""
        seat = self._members[who].seat
        if seat not in self.seats:
            self.seats.meet(seat, self._names()[seat], self._needed())
        return seat

    def _present(self) -> set[str]:
        return {each.seat for each in self._members.present.values()}

    def _console_seats(self) -> set[str]:
        return {self._members[who].seat for who in self._members.consoles()}

    def _is_foreign(self, seat: str, key: str) -> bool:
        return key in self.table.foreign(seat, (key,))

    def _needed(self) -> set[str]:
        wishing = (each.seat for each in self._wishes)
        return {*self._present(), *self.table.held.values(), self.table.manager, *wishing}

    def _refuse_foreign(self, who: str, keys: Collection[str]) -> None:
        held = self.table.foreign(self._seat_of(who), keys)
        if held:
            raise HeldByOthersRefusal(self._explain(held), held)

    def _explain(self, held: Mapping[str, str]) -> str:
        """`Ana holds the face of one: take it over, or ask for it to be released.`"""
        labels = self._labels()
        words = {key: describe_key(key, labels) for key in held}
        parts = {seat: [words[key] for key, each in held.items() if each == seat] for seat in held.values()}
        said = [f"{self.seats[seat].name} holds {', '.join(each)}" for seat, each in parts.items()]
        them = "it" if len(held) == 1 else "them"
        return f"{'; '.join(said)}: take {them} over, or ask for {them} to be released. Nothing has changed."

    def _give(self, who: str, keys: Collection[str]) -> dict[str, str]:
        lost = self.table.take(self._seat_of(who), keys)
        self._changed = True
        return lost

    def _claims(self, seat: str, held: Mapping[str, str], *, taken: bool) -> list[tuple[str, wire.LeaseClaim]]:
        by = self._state_of(seat)
        consoles = {who: self._members[who].seat for who in self._members.consoles()}
        return [
            (who, wire.LeaseClaim([key for key, holder in held.items() if holder == each], by, taken))
            for who, each in consoles.items()
            if each in held.values()
        ]

    def _lease(self, who: str, message: wire.Lease, characters: Sequence[str]) -> list[tuple[str, wire.LeaseClaim]]:
        if not self.table.on:
            raise Refusal(OFF)
        keys, seat = self._keys_of(message, characters), self._seat_of(who)
        if not message.take_over:
            self._refuse_foreign(who, keys)
            kept = self._keep(seat, keys)
            self._give(who, keys)
            return kept
        if ALL in (message.part, message.character) and self.table.foreign(seat, keys) and seat != self.table.manager:
            raise Refusal(
                f"only the stage manager{self._manager()} takes over everything; take over one part at a time."
            )
        return self._claims(seat, self._give(who, keys), taken=True)

    def _keep(self, seat: str, keys: Collection[str]) -> list[tuple[str, wire.LeaseClaim]]:
        """The holder of parts holds them again: that answers those who want them."""
        by, answered = self._state_of(seat), self._wishes.answer(keys)
        return [
            (who, wire.LeaseClaim(answered[member], by, taken=False, kept=True))
            for who in self._members.consoles()
            if (member := self._members[who].seat) in answered
        ]

    def _release(self, seat: str, message: wire.ReleaseLease, characters: Sequence[str]) -> None:
        keys = self._keys_of(message, characters)
        held, wanted = self.table.foreign(seat, keys), self._wishes.withdraw(seat, keys)
        if ALL not in (message.part, message.character) and held and not wanted:
            raise HeldByOthersRefusal(self._explain(held), held)
        self.table.release(seat, keys)

    def _keys_of(self, message: wire.Lease | wire.ReleaseLease, characters: Sequence[str]) -> tuple[str, ...]:
        every = message.character == ALL
        try:
            meant = characters if every else [check_known(message.character, characters, "character")]
            return keys_of(meant, message.part, whole_scene=every)
        except ValueError as error:
            raise Refusal(f"{error}. Nothing has changed.") from error

    def _switch(self, seat: str, *, on: bool) -> None:
        if self.table.has_manager() and self.table.manager != seat:
            what = "is the stage manager" if on else "is the stage manager, who alone switches leases off"
            raise Refusal(f"{self.seats[self.table.manager].name} {what}. Nothing has changed.")
        self.table.switch(on, seat)
        if not on:
            self._wishes.clear()

    def _appoint(self, seat: str, number: int) -> None:
        if not self.table.on or self.table.manager != seat:
            raise Refusal(f"only the stage manager{self._manager()} can make another seat the stage manager.")
        token = self.seats.token_of(number)
        if token is None or token not in self._present():
            raise Refusal(f"there is no seat {number} here that could be the stage manager.")
        self.table.manager = token

    def _manager(self) -> str:
        return f" ({self.seats[self.table.manager].name})" if self.table.has_manager() else ""
