"""A recording of a tracker as a clip of a show."""

from __future__ import annotations

import numpy as np

from omote.inputs.takes.take import Take
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.cut_clip import HasTitles, parts_by_channel
from omote.perform.clips.motion_curve import NEAR, make_curve
from omote.perform.clips.packed_motion import rounded
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST

AROUND = 2
"""Frames that a cut keeps on either side, so that the curve within is that of the whole recording."""


def clip_of_take(take: Take, cast: HasTitles, *, lane: str = "", start: float = 0.0, stop: float | None = None) -> Clip:
    """The clip of a recording.

    Parameters
    ----------
    take : Take
        Its frames with their times; of two at one time the first is left out.
    cast : Cast
        Which says on which part of a face each channel acts.
    lane : str
        What to call its lane.
    start, stop : float
        What is cut out of it, seconds from its beginning; to its end where no end is given.

    Returns
    -------
    Clip
        Of one lane, whole; numbers beyond what channels, head and gaze take are at their ends.

    Raises
    ------
    ValueError
        Where the recording is one frame alone, or longer than an hour, and on a cut that is not in it.
    """
    times = np.asarray(take.times, np.float64)
    end = _check_cut(take, start, stop)
    kept = np.flatnonzero(np.append(np.diff(times) > NEAR, [True]))
    first, last = np.searchsorted(times[kept], [start, end])
    kept = kept[max(0, first - AROUND) : last + AROUND]
    values = np.clip(np.array(take.values, np.float64).reshape(len(times), -1), CHANNEL_LOWEST, CHANNEL_HIGHEST)
    curve = make_curve(
        times[kept] - start,
        {name: values[kept, place] for place, name in enumerate(take.names)},
        parts_by_channel(take.names, cast),
        head=[take.head(frame) or (0.0, 0.0, 0.0) for frame in kept.tolist()] if take.heads else None,
        gaze=[take.gaze(frame) or (0.0, 0.0) for frame in kept.tolist()] if take.gazes else None,
    )
    return Clip([Lane(rounded(curve), lane)], start=max(0.0, curve.start), stop=None if stop is None else end - start)


def _check_cut(take: Take, start: float, stop: float | None) -> float:
    """Where a cut ends, seconds of the recording; ValueError where it is not within it."""
    end = take.seconds if stop is None else stop
    if (start or stop is not None) and not 0.0 <= start < end <= take.seconds:
        raise ValueError(f"{start:g} s to {end:g} s is no part of the recording, which is {take.seconds:.3f} s long")
    return end
