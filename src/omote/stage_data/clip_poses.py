"""The frames of motion clips, each at its second: what a picture of a clip shows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from omote.perform.clips.clip import Clip
from omote.perform.complexion import complexion_of
from omote.perform.frame import Frame
from omote.perform.limits import check_known
from omote.perform.performer import Performer
from omote.stage_data.playing_cast import PlayingCast

if TYPE_CHECKING:
    from omote.model.cast import Cast


MOST_FRAMES = 20_000


class ClipPoses:
    """Clips by name, to be drawn second by second, whole: without fades, and not begun again at their ends.

    cast: with the expressions that they move.
    """

    def __init__(self, cast: Cast | PlayingCast, clips: Mapping[str, Clip]) -> None:
        self.clips = clips
        self._performer = Performer(cast)
        self._expressions = cast.expressions

    def find(self, name: str) -> Clip:
        """The clip of a name; ValueError for none."""
        if not self.clips:
            raise ValueError(f"there is no clip {name!r}: name a show file that has clips with --show")
        return self.clips[check_known(name, self.clips, "clip")]

    def frame(self, name: str, at: float) -> Frame:
        """The frame of a clip; ValueError for a name or a second that it has not.

        at: seconds of its motion from its start, whatever its speed.
        """
        clip = self.find(name)
        if not 0.0 <= at < clip.seconds:
            raise ValueError(f"the clip {name} has no second {at:g}; give one from 0 on, before {clip.seconds:g}")
        self._performer.stop_clip(seconds=0.0)  # each begins at its own time, so that no sum of steps is off
        self._performer.advance(0.0)
        self._performer.play_clip(replace(clip, blend_out=0.0, loop=False), seconds=0.0, start=at)
        shown = self._performer.advance(0.0)
        return Frame(  # of all else, as how often something was played, a picture shows nothing
            faces=shown.faces, expressions=shown.expressions, channels=shown.channels, head=shown.head, gaze=shown.gaze,
            regions=shown.regions, figure=shown.figure, complexion=complexion_of(self._expressions, shown),
        )  # fmt: skip


def count_frames(clip: Clip, rate: float) -> int:
    """How many frames a clip has before its end, at its speed; ValueError for too many. rate: of a second."""
    count = math.ceil(clip.seconds / clip.speed * rate - 1e-6)
    if count > MOST_FRAMES:
        raise ValueError(f"the clip has {count} frames at {rate:g} a second; expected at most {MOST_FRAMES}")
    return count
