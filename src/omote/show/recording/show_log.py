"""Who did what in a show, told from what was recorded: a line for each act, one for what a hand sends again and again.

GO is told with the cue that it called: the one that its presser saw, or that of the table of called cues, in which
stand those that followed by themselves too.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import msgspec

from omote.show.cues.cue_lists import RecordedCues
from omote.show.declaration import ClientMessage, tag_of
from omote.show.objects.cues import CuePlay, Go, GoToCue, SetStandby
from omote.show.recording.curves import CueCall
from omote.show.recording.entries import AnyEntry, ChannelsSet, CuesEdited, Joined, Sent, SnapshotTaken, Ticked

SILENT = ("drive", "drawing", "joined", "mark_moment")
"""What comes many times a second by itself, and who is there: a log of who did what leaves it out. Markers are read
where they can be changed."""
FOLLOWED = "follow_cue"
"""What is told of a cue that followed by itself."""
EDITED = "edit_cues"
"""What is told of an edit of cues."""
ONE_TIME = 0.02
"""Seconds between an act and the call of its cue: that is found in states, which have the time since then."""
FOUND_WITHIN = 0.5
"""Seconds in which a call is in the table of called cues, which is written from every sixth state."""


@dataclass(frozen=True)
class LogLine:
    """Something that somebody did. at: seconds of the machine's clock then; who: by name, "" for what came by itself;
    what: the tag of the message, `FOLLOWED` or `EDITED`; of: whom or what it names, of a GO the cue that it called;
    times: how often it came one after the other, as a hand sends it."""

    at: float
    who: str
    what: str
    of: str
    times: int = 1


def tell_log(entries: Iterable[AnyEntry], calls: Sequence[CueCall], first: float, last: float) -> list[LogLine]:
    """Who did what, in its order. entries: of one start of the show; calls: the cues that were called in it; first,
    last: seconds of the machine's clock, between which it is told."""
    teller = _Teller(calls, last)
    for entry in entries:
        teller.tell(entry, first, last)
    told = [*teller.lines, *(line for line in teller.followed() if first <= line.at <= last)]
    return sorted(told, key=lambda line: line.at)


class _Teller:
    """Tells entries in their order. calls: the cues that were called; last: seconds of the clock up to which."""

    def __init__(self, calls: Sequence[CueCall], last: float) -> None:
        self.lines: list[LogLine] = []
        self._calls = calls
        self._last = last
        self._pressed: set[CueCall] = set()
        self._names: dict[str, str] = {}
        self._numbers: dict[str, str] = {}
        self._has_lists = False
        self._standing: dict[str, str] | None = None
        self._began = 0.0
        self._now = 0.0

    def tell(self, entry: AnyEntry, first: float, last: float) -> None:
        """Notes the line of an entry between two times (first, last), seconds of the clock."""
        line = self._line_of(entry)
        if line is None or not first <= line.at <= last:
            return
        before = self.lines[-1] if self.lines else None
        is_act = isinstance(entry, Sent) and isinstance(entry.message, CuePlay)
        if before is not None and not is_act and replace(before, at=line.at, times=1) == line:
            self.lines[-1] = replace(before, times=before.times + 1)
        else:
            self.lines.append(line)

    def followed(self) -> list[LogLine]:
        """The cues that followed by themselves, those left out that stood when the show was started."""
        if self._standing is None:
            return []
        seen_first = self._began + FOUND_WITHIN
        return [
            LogLine(call.at, "", FOLLOWED, self._with_list(call.number, call.cue_list))
            for call in self._calls
            if call not in self._pressed
            if call.at > seen_first or self._standing.get(call.cue_list) != call.number
        ]

    def _line_of(self, entry: AnyEntry) -> LogLine | None:
        """What an entry is in a log; None where it is not told there."""
        match entry:
            case SnapshotTaken():
                self._begin(entry)
            case Ticked(now):
                self._now = now
            case Joined(who, client):
                self._names[who] = client.name
            case CuesEdited(shown, by, what):
                self._know(shown)
                return LogLine(self._now, by, EDITED, what) if what else None
            case Sent(who, now, message) if tag_of(type(message)) not in SILENT:
                is_cue = isinstance(message, CuePlay)
                of = self._cue_of(message, now) if is_cue else _subject_of(message)
                return LogLine(now, self._names.get(who, who), tag_of(type(message)), of)
            case ChannelsSet(who, now, character, values):
                return LogLine(now, self._names.get(who, who), "set_channel", f"{character} {' '.join(values)}")
        return None

    def _begin(self, entry: SnapshotTaken) -> None:
        self._names |= {who: client.name for who, client in entry.members.items()}
        self._now = self._now if entry.now is None else entry.now
        if entry.book is not None:
            self._know(entry.book)
        if self._standing is None:
            self._began = self._now
            states = entry.playing.states.items()
            self._standing = {name: self._numbers.get(state.current or "", "") for name, state in states}

    def _know(self, book: RecordedCues) -> None:
        self._numbers |= {cue.identity: cue.number for cue in book.cues}
        self._has_lists = len(book.orders) > 1

    def _cue_of(self, message: ClientMessage, now: float) -> str:
        """The cue that an act is of, with its list where there are several. now: when it came."""
        name = getattr(message, "cue_list", "")
        if not isinstance(message, Go | GoToCue):
            return self._with_list(message.cue, name) if isinstance(message, SetStandby) else _subject_of(message)
        called = [call for call in self._calls if abs(call.at - now) < ONE_TIME]
        seen = self._numbers.get(message.seen, "") if isinstance(message, Go) else ""
        number = message.cue or seen or (called[0].number if called else "")
        self._pressed |= {call for call in called if call.number == number}
        told = self._with_list(number, name or (called[0].cue_list if called else ""))
        if isinstance(message, GoToCue) and message.whole:
            return f"{told} whole"
        called_nothing = not called and bool(self._calls) and now + FOUND_WITHIN < self._last
        return f"{told} (nothing called)".strip() if called_nothing else told

    def _with_list(self, number: str, name: str) -> str:
        return f"{number} {name}".strip() if self._has_lists else number


def _subject_of(message: ClientMessage) -> str:
    """Whom or what a message names, in its own words: what a hand changes is left out."""
    fields = msgspec.structs.asdict(message)
    moved = message.hand is not None
    named = [
        str(value)
        for name, value in fields.items()
        if name not in ("id", "seen", "times", "marks", "easing") and value not in ("", None)
        if not (moved and isinstance(value, float))
    ]
    return " ".join(named)
