"""A recording of a face: frames of a tracker with their times."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, limit_gaze, limit_head
from omote.inputs.trackers.tracker_frame import ANGLES, LeftOut

MOST_NOTES = 8
"""Of a recording, in sentences; of others their count."""


class TakeNotes:
    """What of a recording is not there as it was recorded: the first of each kind, with how often it was so."""

    def __init__(self) -> None:
        self._said: dict[str, str] = {}
        self._counts = Counter[str]()

    def add(self, kind: str, sentence: str) -> None:
        """Notes one more of a kind. sentence: what is said of the first."""
        self._counts[kind] += 1
        self._said.setdefault(kind, sentence)

    def add_values(self, left_out: Iterable[LeftOut]) -> None:
        """Notes what a frame has left out, as far as it is of a face."""
        for name, reason in left_out:
            if not name or name in ANGLES or ARKIT_CHANNELS.find(name):
                self.add(name, reason)

    def sentences(self) -> tuple[str, ...]:
        """All of it, as it is told."""
        told = [f"{said} ({self._counts[kind]} times)" for kind, said in self._said.items()]
        more = len(told) - MOST_NOTES
        return (*told[:MOST_NOTES], *([f"{more} more are left out or at their ends"] if more > 0 else []))


@dataclass(frozen=True, eq=False)
class Take:
    """A recording. names: its channels; times: seconds from its beginning, never falling; values: the weights of each
    frame, in the order of names; heads, gazes: of each frame, none where the recording turns neither; notes: sentences
    on what of it is not there as it was recorded."""

    names: tuple[str, ...]
    times: Sequence[float]
    values: Sequence[tuple[float, ...]]
    heads: Sequence[HeadAngles] = ()
    gazes: Sequence[GazeAngles] = ()
    notes: Sequence[str] = ()

    def __post_init__(self) -> None:
        """Rejects a recording without frames, and lists of other lengths."""
        count = len(self.times)
        if not count:
            raise ValueError("the recording has no frames")
        if {len(self.values), len(self.heads) or count, len(self.gazes) or count} != {count}:
            raise ValueError(f"the recording has {count} times, expected as many weights, heads and gazes")

    @property
    def seconds(self) -> float:
        """How long it is."""
        return self.times[-1]

    def frame_at(self, seconds: float) -> int:
        """The frame that is newest at a time from the beginning."""
        return max(0, bisect_right(self.times, seconds) - 1)

    def head(self, frame: int) -> HeadAngles | None:
        """The head of a frame, as far as ours turns."""
        return limit_head(self.heads[frame]) if self.heads else None

    def gaze(self, frame: int) -> GazeAngles | None:
        """The gaze of a frame, as far as ours turns."""
        return limit_gaze(self.gazes[frame]) if self.gazes else None
