"""A recording of a tracker as a clip of a show."""

from __future__ import annotations

import numpy as np

from omote.inputs.takes.take import Take
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.cut_clip import HasTitles, parts_by_channel
from omote.perform.clips.motion_curve import NEAR, make_curve
from omote.perform.clips.packed_motion import rounded
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST


def clip_of_take(take: Take, cast: HasTitles, *, lane: str = "") -> Clip:
    """The clip of a recording.

    Parameters
    ----------
    take : Take
        Its frames with their times; of two at one time the first is left out.
    cast : Cast
        Which says on which part of a face each channel acts.
    lane : str
        What to call its lane.

    Returns
    -------
    Clip
        Of one lane, whole; numbers beyond what channels, head and gaze take are at their ends.

    Raises
    ------
    ValueError
        Where the recording is one frame alone, or longer than an hour.
    """
    times = np.asarray(take.times, np.float64)
    kept = np.flatnonzero(np.append(np.diff(times) > NEAR, [True]))
    values = np.clip(np.array(take.values, np.float64).reshape(len(times), -1), CHANNEL_LOWEST, CHANNEL_HIGHEST)
    curve = make_curve(
        times[kept],
        {name: values[kept, place] for place, name in enumerate(take.names)},
        parts_by_channel(take.names, cast),
        head=[take.head(frame) or (0.0, 0.0, 0.0) for frame in kept.tolist()] if take.heads else None,
        gaze=[take.gaze(frame) or (0.0, 0.0) for frame in kept.tolist()] if take.gazes else None,
    )
    return Clip([Lane(rounded(curve), lane)], start=curve.start)
