"""Plays a recording as players do: pause, seek, rate, loop. It owns no clock: whoever has one advances it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

import msgspec

from omote.perform.limits import check_within
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.show.objects.state import State
from omote.show.recording.replay import ReplayedTick, ReplayError

LOWEST_RATE = 0.1
HIGHEST_RATE = 2.0
SHORTEST_LOOP = 0.5
"""Seconds."""
CATCH_UP = 0.5
"""Seconds of the recording that are replayed at once at most: on a slow machine it plays slower then."""

Seconds = Annotated[float, msgspec.Meta(ge=0.0)]


class TransportRequest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a page asks of a player; what is left out stays. position, loop: seconds from the beginning, loop an empty
    list for none; rate: 1 as it was. start, at: a moment of any start of the show, seconds of its clock: what is
    recorded of that start is played from there on."""

    playing: bool | None = None
    position: Seconds | None = None
    rate: float | None = None
    loop: Annotated[list[Seconds], msgspec.Meta(max_length=2)] | None = None
    start: int | None = None
    at: float = 0.0


class Transport(msgspec.Struct, frozen=True):
    """How far a player is. seconds: how long the recording is; jumps: how often it went elsewhere than on; different:
    the first moment whose state is not the one that was sent, None for none so far; failure: why it goes on no
    further, "" where it does; start, first: of the show, and seconds of its clock where the recording begins."""

    playing: bool
    position: float
    seconds: float
    rate: float
    loop: list[float]
    jumps: int
    different: float | None
    failure: str
    start: int
    first: float


class ReplayPlayer:
    """Plays a span of a recording from its beginning, until it is sent to another start of the show; it loops where it
    is told to, and pauses at its end."""

    def __init__(self, show: RecordedShow, span: Span) -> None:
        self._show = show
        self.span = span
        self._playing = True
        self._rate = 1.0
        self._loop: tuple[float, float] | None = None
        self._position = 0.0
        self._jumps = 0
        self._different: float | None = None
        self._failure = ""
        self._ticks: Iterator[ReplayedTick] = iter(())
        self._next: ReplayedTick | None = None
        self._shown: State | None = None
        self.digest = ""
        self._jump(0.0)

    def transport(self) -> Transport:
        """How far it is."""
        loop = [] if self._loop is None else [*self._loop]
        return Transport(
            self._playing, self._position, self.span.seconds, self._rate, loop, self._jumps, self._different,
            self._failure, self.span.start, self.span.first,
        )  # fmt: skip

    def obey(self, asked: TransportRequest) -> None:
        """Does what a page asks for; ValueError for what is out of range, and nothing has changed then."""
        rate = self._rate if asked.rate is None else check_within(asked.rate, LOWEST_RATE, HIGHEST_RATE, "the rate")
        loop = self._loop if asked.loop is None else self._check_loop(asked.loop)
        if asked.start is not None:
            loop = self._seek(asked.start, asked.at, loop)
        elif asked.position is not None:
            check_within(asked.position, 0.0, self.span.seconds, "the position (seconds)")
            self._jump(asked.position)
        elif asked.playing and self._position >= self.span.seconds:
            self._jump(0.0)
        self._rate = rate
        self._loop = loop
        self._playing = self._playing if asked.playing is None else asked.playing

    def advance(self, dt: float) -> State | None:
        """The state some time later, at the rate; None where there is none. dt: seconds."""
        if not self._playing:
            return self._shown
        self._position += min(dt * self._rate, CATCH_UP)
        if self._loop is not None and self._position >= self._loop[1]:
            self._jump(self._loop[0])
        now = self.span.first + self._position
        while self._next is not None and self._next.now <= now:
            self._take(self._next)
        if self._next is None:
            self._position = min(self._position, self.span.seconds)
            self._playing = self._failure == "" and self._loop is not None
            if self._playing and self._loop is not None:
                self._jump(self._loop[0])
        return self._shown

    def _seek(self, start: int, at: float, loop: tuple[float, float] | None) -> tuple[float, float] | None:
        """Goes to a moment of any start of the show, and returns the loop that is left. ValueError where it is not
        recorded. start, at: as of `TransportRequest`; loop: that it has."""
        inside = start == self.span.start and self.span.first <= at <= self.span.last
        span = self.span if inside else self._show.find_played(start)
        check_within(at, span.first, span.last, "the moment (seconds of its clock)")
        if not inside:
            self.span = span
            self._different = None
        self._jump(at - span.first)
        return loop if inside else None

    def _check_loop(self, loop: list[float]) -> tuple[float, float] | None:
        if not loop:
            return None
        begin, end = (*loop, self.span.seconds)[:2]
        if not 0.0 <= begin <= end - SHORTEST_LOOP or end > self.span.seconds:
            raise ValueError(
                f"a loop from {begin:g} to {end:g} s cannot be played; give two times {SHORTEST_LOOP} s apart or more, "
                f"up to {self.span.seconds:.1f}"
            )
        return begin, end

    def _jump(self, position: float) -> None:
        """Goes elsewhere: the first state there shows at once."""
        self._position = position
        self._jumps += 1
        self._failure = ""
        self._ticks = self._show.replay(self.span, after=self.span.first + position - 1.0 / 60.0)
        self._fetch()
        if self._next is not None:
            self._take(self._next)

    def _take(self, tick: ReplayedTick) -> None:
        self._shown = tick.state
        self.digest = tick.digest
        if tick.same is False and self._different is None:
            self._different = tick.now - self.span.first
        self._fetch()

    def _fetch(self) -> None:
        try:
            self._next = next(self._ticks, None)
        except ReplayError as error:
            self._next = None
            self._failure = str(error)
