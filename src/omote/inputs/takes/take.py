"""A recording of a face: frames of a tracker with their times."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, limit_gaze, limit_head


@dataclass(frozen=True, eq=False)
class Take:
    """A recording. names: its channels; times: seconds from its beginning, never falling; values: the weights of each
    frame, in the order of names; heads, gazes: of each frame, none where the recording turns neither."""

    names: tuple[str, ...]
    times: Sequence[float]
    values: Sequence[tuple[float, ...]]
    heads: Sequence[HeadAngles] = ()
    gazes: Sequence[GazeAngles] = ()

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
