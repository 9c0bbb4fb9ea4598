"""A clip: lanes of recorded motion laid over one another, each a pass, as one motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, reduce

import numpy as np

from omote.arrays import Values
from omote.perform.clips.clip_parts import CLIP_PARTS, ClipPart, check_clip_part
from omote.perform.clips.motion_curve import LONGEST_CURVE, MotionCurve
from omote.perform.clips.sample import AT_REST_LAYOUT, Layout, Sample, empty_sample, join_layouts, lay_over, shares_of
from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.limits import check_known, check_switch, check_within

MOST_LANES = 16
MOST_SPANS = 32
LONGEST_SHIFT = 3600.0
LONGEST_SOUND_KEY = 64
LONGEST_BLEND = 10.0
LONGEST_LANE_NAME = 40
SLOWEST = 0.05
FASTEST = 20.0
USUAL_BLEND = 0.3
"""Seconds in which a clip comes and goes."""
SEAM_SECONDS = 0.15
"""In which a lane begins and ends within a clip, and goes over into a span that replaces it."""
_EASING = EASINGS[DEFAULT_EASING]


def blend_at(elapsed: float, seconds: float) -> float:
    """How much has come of what comes in `seconds`, 0 to 1, by the quintic: no jump of speed at its ends. elapsed:
    seconds so far."""
    if elapsed >= seconds:
        return 1.0
    return _EASING.value(elapsed / seconds) if elapsed > 0.0 else 0.0


@dataclass(frozen=True, eq=False)
class Span:
    """What replaces a lane from `start` to `stop`, seconds of its own time: another curve, in that time too."""

    start: float
    stop: float
    curve: MotionCurve

    def __post_init__(self) -> None:
        check_within(self.start, -LONGEST_SHIFT, LONGEST_SHIFT, "the start of a span (seconds)")
        check_within(self.stop, self.start, LONGEST_SHIFT, "the end of a span (seconds)")


@dataclass(frozen=True, eq=False)
class Lane:
    """A pass of one who played parts of a character.

    Parameters
    ----------
    curve : MotionCurve
        What was recorded.
    name : str
        For people, to 40 letters.
    parts : sequence of str
        Those of brows, eyes, mouth, rest, head, gaze and body that it gives.
    weight : float
        How much of it shows over the lanes below, 0 to 1.
    muted : bool
        Whether it is as if it were not there.
    shift : float
        Seconds by which it comes later.
    spans : sequence of Span
        What replaces it for a while; of two at one time the later one shows.

    Raises
    ------
    ValueError
        On parts that there are not and numbers out of range.
    TypeError
        On what is no number or no switch.

    Examples
    --------
    >>> from omote.perform.clips.cut_clip import record
    >>> lane = omote.Lane(record(omote.Performer(cast), cast, seconds=1.0), parts=("mouth", "brows"))
    >>> lane.parts, round(lane.stop, 3)
    (('brows', 'mouth'), 1.0)

    References
    ----------
    docs/method.md, "Clips".
    """

    curve: MotionCurve
    name: str = ""
    parts: tuple[ClipPart, ...] = CLIP_PARTS
    weight: float = 1.0
    muted: bool = False
    shift: float = 0.0
    spans: tuple[Span, ...] = ()

    def __post_init__(self) -> None:
        chosen = {check_clip_part(part) for part in self.parts}
        object.__setattr__(self, "parts", tuple(part for part in CLIP_PARTS if part in chosen))
        if not isinstance(self.name, str) or len(self.name) > LONGEST_LANE_NAME:
            raise ValueError(f"the name of a lane is {self.name!r:.60}; give {LONGEST_LANE_NAME} letters at most")
        check_within(self.weight, 0.0, 1.0, "the weight of a lane")
        check_switch(self.muted, "whether a lane is muted")
        check_within(self.shift, -LONGEST_SHIFT, LONGEST_SHIFT, "the shift of a lane (seconds)")
        if len(self.spans) > MOST_SPANS:
            raise ValueError(f"a lane has {len(self.spans)} spans; expected {MOST_SPANS} at most: record it whole anew")

    @property
    def start(self) -> float:
        """When it begins, seconds of the clip."""
        return self.curve.start + self.shift

    @property
    def stop(self) -> float:
        """When it ends, seconds of the clip."""
        return self.curve.stop + self.shift


@dataclass(frozen=True, eq=False)
class Clip:
    """A motion clip: lanes over one another, trimmed, with how it comes and goes.

    Parameters
    ----------
    lanes : sequence of Lane
        The lowest first: what is above shows over what is below, in its parts.
    start : float
        Where it begins, seconds of the lanes.
    stop : float, optional
        Where it ends; with its last lane where none is given.
    blend_in, blend_out : float
        Seconds in which it comes, and goes before its end, 0 to 10.
    loop : bool
        Whether it begins again at its end; it blends over in `blend_in`.
    speed : float
        0.05 to 20; 1 is as it was recorded.
    sound : str
        The key of a sound that is heard with it, as of `say`; "" for none.
    sound_at : float
        When that sound begins, seconds of the lanes.

    Raises
    ------
    ValueError
        On no lanes or too many, on an end before its start, and on numbers out of range.
    TypeError
        On what is no number or no switch.

    Examples
    --------
    >>> from omote.perform.clips.cut_clip import record
    >>> performer = omote.Performer(cast)
    >>> performer.call_expression("smile", seconds=1)
    >>> clip = omote.Clip([omote.Lane(record(performer, cast, seconds=1.0))])
    >>> round(clip.seconds, 3)
    1.0

    References
    ----------
    docs/method.md, "Clips".
    """

    lanes: Sequence[Lane]
    start: float = 0.0
    stop: float | None = None
    blend_in: float = USUAL_BLEND
    blend_out: float = USUAL_BLEND
    loop: bool = False
    speed: float = 1.0
    sound: str = ""
    sound_at: float = 0.0
    end: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "lanes", tuple(self.lanes))
        if not 0 < len(self.lanes) <= MOST_LANES:
            raise ValueError(f"a clip has {len(self.lanes)} lanes; expected 1 to {MOST_LANES}")
        check_within(self.start, -LONGEST_SHIFT, LONGEST_SHIFT, "the start of a clip (seconds)")
        end = max(lane.stop for lane in self.lanes) if self.stop is None else self.stop
        if not end > self.start:
            raise ValueError(f"a clip ends at {end:g} s, where it has not begun ({self.start:g} s); trim it otherwise")
        check_within(end, self.start, self.start + LONGEST_CURVE, "the end of a clip (seconds)")
        check_within(self.blend_in, 0.0, LONGEST_BLEND, "the seconds in which a clip comes")
        check_within(self.blend_out, 0.0, LONGEST_BLEND, "the seconds in which a clip goes")
        check_switch(self.loop, "whether a clip begins again")
        check_within(self.speed, SLOWEST, FASTEST, "the speed of a clip")
        if not isinstance(self.sound, str) or len(self.sound) > LONGEST_SOUND_KEY:
            raise ValueError(f"the sound of a clip is {self.sound!r:.80}; give the key of a sound of the show")
        check_within(self.sound_at, -LONGEST_SHIFT, LONGEST_SHIFT, "the begin of a clip's sound (seconds)")
        object.__setattr__(self, "end", float(end))

    @property
    def seconds(self) -> float:
        """How long it is, at the speed 1."""
        return self.end - self.start

    @cached_property
    def parts(self) -> tuple[ClipPart, ...]:
        """The parts that its lanes give which are not muted."""
        given = {part for lane in self.lanes if not lane.muted for part in lane.parts if part in lane.curve.parts}
        return tuple(part for part in CLIP_PARTS if part in given)

    @cached_property
    def layout(self) -> Layout:
        """The columns of all lanes that are not muted."""
        curves = [
            curve for lane in self.lanes if not lane.muted for curve in (lane.curve, *(s.curve for s in lane.spans))
        ]
        return reduce(join_layouts, (curve.layout for curve in curves), AT_REST_LAYOUT)

    def sample(self, position: float) -> Sample:
        """What it has at a time: all lanes that are not muted, laid over one another.

        Parameters
        ----------
        position : float
            Seconds from its start, at the speed 1.

        Returns
        -------
        Sample
            Of all its columns; where no lane plays it takes nothing. A single lane that gives all has the numbers of
            its curve to the bit.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> performer = omote.Performer(cast)
        >>> lane = omote.Lane(record(performer, cast, seconds=1.0), muted=True)
        >>> omote.Clip([lane]).sample(0.5).shares.tolist()
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        """
        time = self.start + position
        whole = empty_sample(self.layout)
        for lane in self.lanes:
            found = None if lane.muted else self._sample_lane(lane, time)
            whole = whole if found is None else lay_over(whole, found)
        return whole

    def _sample_lane(self, lane: Lane, time: float) -> Sample | None:
        """A lane at a time: it comes and goes at its own ends, but not at those of the clip."""
        come = blend_at(time - lane.start, SEAM_SECONDS) if lane.start > self.start else float(time >= lane.start)
        left = blend_at(lane.stop - time, SEAM_SECONDS) if lane.stop < self.end else 1.0
        share = lane.weight * come * left
        if not share:
            return None
        own = time - lane.shift
        shown = Sample(lane.curve.layout, lane.curve.values(own), _shares(lane, lane.curve, share))
        for span in lane.spans:
            replaced = _share_of_span(span, own)
            if replaced:
                shown = _replaced(shown, span, own, replaced)
        return shown

    def shifted(self, seconds: float) -> Clip:
        """The same in every way, with all its times later by some seconds.

        Parameters
        ----------
        seconds : float
            Which may be below 0.

        Returns
        -------
        Clip
            With the same motion at each position.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> clip.shifted(2.0).start, clip.shifted(2.0).seconds == clip.seconds
        (2.0, True)
        """
        lanes = [replace(lane, shift=lane.shift + seconds) for lane in self.lanes]
        stop = None if self.stop is None else self.stop + seconds
        sound_at = self.sound_at + seconds if self.sound else self.sound_at
        return replace(self, lanes=lanes, start=self.start + seconds, stop=stop, sound_at=sound_at)


def _shares(lane: Lane, curve: MotionCurve, share: float) -> Values:
    """How much a lane takes of each part at a share of all of it."""
    given = [share if part in lane.parts and part in curve.parts else 0.0 for part in CLIP_PARTS]
    return shares_of(np.array(given))


def _share_of_span(span: Span, time: float) -> float:
    """How much of a lane a span replaces at a time of the lane."""
    seam = min(SEAM_SECONDS, 0.5 * (span.stop - span.start))
    if not span.start < time < span.stop:
        return 0.0
    return blend_at(time - span.start, seam) * blend_at(span.stop - time, seam)


def _replaced(shown: Sample, span: Span, time: float, part: float) -> Sample:
    """A lane's sample with as much of a span in it as replaces it: its shares stay."""
    held = [part if each in span.curve.parts else 0.0 for each in CLIP_PARTS]
    above = Sample(span.curve.layout, span.curve.values(time), shares_of(np.array(held)))
    full = Sample(shown.layout, shown.values, np.ones(len(shown.shares)))
    mixed = lay_over(full, above)
    return Sample(mixed.layout, mixed.values, shown.shares)


def with_lane(clip: Clip, lane: Lane) -> Clip:
    """A clip with one more lane over all others: a pass that was recorded while these played.

    clip: as it is; lane: the new one. ValueError beyond sixteen.
    """
    return replace(clip, lanes=[*clip.lanes, lane])


def with_changed_lane(clip: Clip, name: str, lane: Lane | None) -> Clip:
    """A clip with another lane in the place of one, or without it.

    clip: as it is; name: of the lane, or its number from 1; lane: what takes its place, None for nothing. ValueError
    for a lane that there is not.
    """
    place = find_lane(clip, name)
    others = [*clip.lanes]
    others[place : place + 1] = [] if lane is None else [lane]
    return replace(clip, lanes=others)


def find_lane(clip: Clip, name: str) -> int:
    """The place of a lane of a clip, from 0. name: as people call it, or its number from 1; ValueError where there is
    none."""
    names = [lane.name or str(place) for place, lane in enumerate(clip.lanes, 1)]
    if name.isdecimal() and name not in names and 0 < int(name) <= len(names):
        return int(name) - 1
    return names.index(check_known(name, names, "lane of this clip"))


def replace_span(lane: Lane, start: float, stop: float, curve: MotionCurve) -> Lane:
    """A lane in which another curve shows from one time to another, with the seam's blend at both ends.

    lane: as it is; start, stop: seconds of the lane; curve: in the lane's time.
    """
    return replace(lane, spans=(*lane.spans, Span(start, stop, curve)))
