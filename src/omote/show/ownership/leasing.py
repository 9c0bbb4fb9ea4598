"""The leases of a session: what is rejected because others hold it, who is told what, and when."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.perform.scene.goals import Part
from omote.perform.scene.scene import Scene
from omote.show.crew.members import Members
from omote.show.declaration import ClientMessage, Outgoing
from omote.show.objects.leases import Lease, LeaseClaim, Leases, LeaseWish, ReleaseLease, SeatState
from omote.show.ownership.ownership_table import OwnershipTable
from omote.show.ownership.parts import describe_key, keys_of, keys_of_part, keys_played
from omote.show.ownership.seats import Seat, Seats
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
    """Who may command what. members: who is connected; scene: the one on air, whichever the session has now."""

    def __init__(self, members: Members, snapshot: LeaseSnapshot | None, scene: Callable[[], Scene]) -> None:
        before = snapshot or LeaseSnapshot()
        self.seats = Seats(before.seats)
        held = {key: seat for key, seat in before.held.items() if seat in self.seats}
        self.table = OwnershipTable(on=before.on, manager=before.manager, held=held)
        self._members = members
        self._scene = scene
        self._looked = -AGAIN_SECONDS
        self._changed = True
        self._told: dict[str, tuple[Leases, float]] = {}
        self._claimed: dict[tuple[str, str], float] = {}

    def snapshot(self) -> LeaseSnapshot:
        """The leases as they are."""
        table = self.table
        return LeaseSnapshot(table.on, table.manager, dict(table.held), dict(self.seats.by_token))

    def check(self, who: str, message: ClientMessage, characters: Collection[str]) -> None:
        """Refuses a message of a client (who) that plays what another seat holds, by HeldByOthersRefusal. characters:
        whom it is for."""
        keys = keys_played(message, characters, self._scene()) if self.table.on else ()
        if keys:
            self._refuse_foreign(who, keys)

    def check_parts(self, who: str, parts: Collection[Part]) -> None:
        """Refuses that a client (who) plays parts where another seat holds one, by HeldByOthersRefusal."""
        keys = [key for part in parts for key in keys_of_part(part)] if self.table.on else []
        if keys:
            self._refuse_foreign(who, keys)

    def note(self, who: str, message: ClientMessage, characters: Collection[str]) -> None:
        """Gives the sender of a message that was obeyed the free parts that it plays. characters: whom it is for. who:
        the sender."""
        keys = keys_played(message, characters, self._scene()) if self.table.on and message.holds else ()
        if keys:
            self._give(who, keys)

    def lease(self, who: str, message: Lease, characters: Sequence[str]) -> list[Outgoing]:
        """Gives parts to the seat of a client, or keeps them; returns who is told of it. characters: of the scene. who:
        the client; message: the parts."""
        if not self.table.on:
            raise Refusal(OFF)
        seat = self._begin(who)
        keys = self._keys_of(message, characters)
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

    def release(self, who: str, message: ReleaseLease, characters: Sequence[str]) -> list[Outgoing]:
        """Frees parts that the seat of a client holds, or takes back its wish for them. characters: of the scene. who:
        the client; message: the parts."""
        seat = self._begin(who)
        keys = self._keys_of(message, characters)
        held = self.table.foreign(seat, keys)
        wanted = self.table.withdraw(seat, keys)
        if ALL not in (message.part, message.character) and held and not wanted:
            raise HeldByOthersRefusal(self._explain(held), held)
        self.table.release(seat, keys)
        return []

    def switch(self, who: str, *, on: bool) -> list[Outgoing]:
        """Switches leases on or off, by the seat of a client (who)."""
        seat = self._begin(who)
        if self.table.has_manager() and self.table.manager != seat:
            what = "is the stage manager" if on else "is the stage manager, who alone switches leases off"
            raise Refusal(f"{self.seats[self.table.manager].name} {what}. Nothing has changed.")
        self.table.switch(on, seat)
        return []

    def appoint(self, who: str, number: int) -> list[Outgoing]:
        """Makes the seat of a number the stage manager, where that of a client (who) is."""
        seat = self._begin(who)
        if not self.table.on or self.table.manager != seat:
            raise Refusal(f"only the stage manager{self._manager()} can make another seat the stage manager.")
        token = self.seats.token_of(number)
        if token is None or token not in self._present():
            raise Refusal(f"there is no seat {number} here that could be the stage manager.")
        self.table.manager = token
        return []

    def _begin(self, who: str) -> str:
        """The seat of a client that asks for something of leases."""
        self._changed = True
        return self._seat_of(who)

    def claims(self, who: str, held: Mapping[str, str], now: float) -> list[Outgoing]:
        """What the holders of parts are told of a client that touched them, at most once a second. who: the client;
        held: by part, the seat of its holder; now: seconds."""
        seat = self._seat_of(who)
        self.table.want(seat, held, now)
        self._changed = True
        late = {
            holder
            for holder in held.values()
            if now - self._claimed.get((seat, holder), -AGAIN_SECONDS) >= AGAIN_SECONDS
        }
        self._claimed |= {(seat, holder): now for holder in late}
        return self._claims(seat, {key: holder for key, holder in held.items() if holder in late}, taken=False)

    def expire(self, characters: Collection[str], now: float) -> None:
        """Frees what those held who have been away for some seconds. characters: of the scene; now: seconds."""
        before = len(self.table.held), self.table.manager
        self.table.expire(self._present(), characters, now)
        ended = self.table.expire_wishes(self._present(), self._console_seats(), now)
        self._changed |= ended or before != (len(self.table.held), self.table.manager)

    def tell(self, now: float) -> dict[str, Leases]:
        """What consoles must be told now, by client."""
        if not self._changed and now - self._looked < LOOK_SECONDS:
            return {}
        self._looked = now
        self._changed = False
        consoles = self._members.consoles()
        self._told = {who: last for who, last in self._told.items() if who in consoles}
        self._meet_all()
        seats = {token: self._state_of(token) for token in self._listed()}
        wishes = [
            LeaseWish(wish.key, seats[wish.seat].number, int(now - wish.since))
            for wish in self.table.wishes()
            if wish.seat in seats
        ]
        news = {who: self._message(who, seats, wishes) for who in consoles}
        due = {who: message for who, message in news.items() if self._is_due(who, message, now)}
        self._told |= {who: (message, now) for who, message in due.items()}
        return due

    def _is_due(self, who: str, message: Leases, now: float) -> bool:
        if who not in self._told:
            return message.on  # off is what a console takes for granted
        before, told_at = self._told[who]
        return message != before or now - told_at >= AGAIN_SECONDS

    def _message(self, who: str, seats: Mapping[str, SeatState], wishes: Sequence[LeaseWish]) -> Leases:
        held = {key: seats[holder] for key, holder in self.table.held.items()}
        return Leases(self.table.on, held, [*seats.values()], seats[self._members[who].seat].number, [*wishes])

    def _listed(self) -> list[str]:
        """The seats of consoles, and those that hold or want something, in their order."""
        wanted = self._console_seats() | {*self.table.held.values(), *(wish.seat for wish in self.table.wishes())}
        return [token for token in self.seats.by_token if token in wanted]

    def _state_of(self, token: str) -> SeatState:
        seat = self.seats[token]
        here = token in self._present()
        return SeatState(seat.number, seat.name, seat.colour, token == self.table.manager, here)

    def _meet_all(self) -> None:
        """Notes the seats of consoles, and what all seats are called now."""
        names = self._names()
        consoles = self._console_seats()
        for token, name in names.items():
            if token in consoles or token in self.seats:
                self.seats.meet(token, name, self._needed())

    def _names(self) -> dict[str, str]:
        """What seats are called: as their first console, else as their source."""
        members = [member for member in self._members.present.values() if member.seat]
        sources = {member.seat: member.name for member in members if member.role == "source"}
        consoles = {member.seat: member.name for member in reversed(members) if member.role == "console"}
        return sources | consoles

    def _seat_of(self, who: str) -> str:
        """The seat of a client, which is known from then on."""
        seat = self._members[who].seat
        if seat not in self.seats:
            self.seats.meet(seat, self._names()[seat], self._needed())
        return seat

    def _present(self) -> set[str]:
        return {member.seat for member in self._members.present.values()}

    def _console_seats(self) -> set[str]:
        return {self._members[who].seat for who in self._members.consoles()}

    def _needed(self) -> set[str]:
        wishing = (wish.seat for wish in self.table.wishes())
        return {*self._present(), *self.table.held.values(), self.table.manager, *wishing}

    def _refuse_foreign(self, who: str, keys: Collection[str]) -> None:
        held = self.table.foreign(self._seat_of(who), keys)
        if held:
            raise HeldByOthersRefusal(self._explain(held), held)

    def _explain(self, held: Mapping[str, str]) -> str:
        """`Ana holds the face of one: take it over, or ask for it to be released.`"""
        labels = self._scene().labels
        words = {key: describe_key(key, labels) for key in held}
        parts = {seat: [words[key] for key, holder in held.items() if holder == seat] for seat in held.values()}
        said = [f"{self.seats[seat].name} holds {', '.join(names)}" for seat, names in parts.items()]
        them = "it" if len(held) == 1 else "them"
        return f"{'; '.join(said)}: take {them} over, or ask for {them} to be released. Nothing has changed."

    def _give(self, who: str, keys: Collection[str]) -> dict[str, str]:
        lost = self.table.take(self._seat_of(who), keys)
        self._changed = True
        return lost

    def _claims(self, seat: str, held: Mapping[str, str], *, taken: bool) -> list[Outgoing]:
        by = self._state_of(seat)
        consoles = {who: self._members[who].seat for who in self._members.consoles()}
        return [
            Outgoing(who, LeaseClaim([key for key, holder in held.items() if holder == console_seat], by, taken))
            for who, console_seat in consoles.items()
            if console_seat in held.values()
        ]

    def _keep(self, seat: str, keys: Collection[str]) -> list[Outgoing]:
        """The holder of parts holds them again: that answers those who want them."""
        by = self._state_of(seat)
        answered = self.table.answer(keys)
        return [
            Outgoing(who, LeaseClaim(answered[member], by, taken=False, kept=True))
            for who in self._members.consoles()
            if (member := self._members[who].seat) in answered
        ]

    def _keys_of(self, message: Lease | ReleaseLease, characters: Sequence[str]) -> tuple[str, ...]:
        every = message.character == ALL
        try:
            meant = characters if every else [check_known(message.character, characters, "character")]
            return keys_of(meant, message.part, whole_scene=every)
        except ValueError as error:
            raise Refusal(f"{error}. Nothing has changed.") from error

    def _manager(self) -> str:
        return f" ({self.seats[self.table.manager].name})" if self.table.has_manager() else ""
