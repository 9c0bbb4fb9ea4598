"""What the crew notes of the evening: a line of words, and when the show began."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.perform.limits import FOREVER
from omote.show.declaration import CallId, ClientMessage, Outgoing, Session
from omote.show.osc import PRESS, Value, osc

LONGEST_NOTE = 200
"""Characters."""


class ShowNotes(msgspec.Struct, frozen=True):
    """The line of notes, and when the show began: seconds of its clock (`State.time`)."""

    note: Annotated[str, msgspec.Meta(max_length=LONGEST_NOTE)] = ""
    began: Annotated[float, msgspec.Meta(ge=0.0, le=FOREVER)] = 0.0


class SetNote(ClientMessage, frozen=True):
    """Writes the line of notes that every console shows; it is kept with the show. An `id` executes once, as of the one
    below."""

    access = "operate"
    method = ""
    osc = (osc("note", "writes the line of notes on every console", "text", of_show=True),)

    id: CallId
    text: Annotated[str, msgspec.Meta(max_length=LONGEST_NOTE), Value("text")]

    def act(self, session: Session, who: str, now: float) -> tuple[Outgoing, ...]:
        """Notes it. session: the show; who: the client; now: seconds, monotonic."""
        session.notes = msgspec.structs.replace(session.notes, note=" ".join(self.text.split()))
        return ()


class BeginShow(ClientMessage, frozen=True):
    """The show begins: the time that consoles show counts from now, or from `at` (seconds of `State.time`) where that
    is given."""

    access = "operate"
    method = ""
    osc = (osc("begin_show", "starts the time of the show that consoles show", PRESS, of_show=True),)

    id: CallId
    at: float | None = None

    def act(self, session: Session, who: str, now: float) -> tuple[Outgoing, ...]:
        """Notes it. session: the show; who: the client; now: seconds, monotonic."""
        clock = session.clock(now)
        if self.at is not None and not 0.0 <= self.at <= clock:
            raise ValueError(f"the show cannot have begun at {self.at:g} seconds; give 0 to {clock:.0f}")
        session.notes = msgspec.structs.replace(session.notes, began=clock if self.at is None else self.at)
        return ()
