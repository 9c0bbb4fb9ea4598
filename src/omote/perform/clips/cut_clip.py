"""Cuts a motion curve out of what was on air of a character."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol

from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.model.space.expression import Title
from omote.perform.channels import GAZE_UNITS
from omote.perform.clips.motion_curve import NEAR, MotionCurve, make_curve
from omote.perform.frame import Frame
from omote.perform.layers.columns import GAZE_PART
from omote.perform.layers.layer_names import part_of_channel
from omote.perform.mix import mix_in


class Shown(Protocol):
    """What shows of a character at one instant: a frame of the engine, or its state on the wire."""

    @property
    def expressions(self) -> Mapping[str, float]:
        """The mix of the face."""

    @property
    def regions(self) -> Mapping[PlayRegion, Mapping[str, float]]:
        """The mixes of the regions that show another."""

    @property
    def channels(self) -> Mapping[str, float]:
        """Weights by channel."""

    @property
    def head(self) -> Any:
        """Yaw, pitch and roll, radians: numbers in this order, or by these names."""

    @property
    def gaze(self) -> Any:
        """Yaw and pitch, radians."""


class HasTitles(Protocol):
    """A cast, or whatever says where expressions act."""

    @property
    def titles(self) -> Mapping[str, Title]:
        """The titles of expressions, by name."""


class Advances(Protocol):
    """A performer."""

    def advance(self, dt: float) -> Frame:
        """What is on air some time later."""


def cut_curve(shown: Iterable[tuple[float, Shown]], cast: HasTitles, *, start: float, stop: float) -> MotionCurve:
    """The motion of a character from one time to another.

    Parameters
    ----------
    shown : iterable of (float, Shown)
        What shows of the character (`Frame`, `CharacterState`), each with its time in seconds, rising.
    cast : Cast
        Which says on which part of a face each channel acts.
    start, stop : float
        Seconds; frames from the one to the other are in it.

    Returns
    -------
    MotionCurve
        Its times count from `start`. Expressions by region, channels without the eight that turn the eyes, which the
        gaze turns again, head and gaze.

    Raises
    ------
    ValueError
        Where no frame lies between.
    """
    frames = [(time - start, each) for time, each in shown if start - NEAR <= time <= stop + NEAR]
    if not frames:
        raise ValueError(f"nothing was recorded between {start:g} s and {stop:g} s; choose other times")
    names = sorted({name for _, each in frames for name in each.channels if name not in GAZE_UNITS})
    return make_curve(
        [time for time, _ in frames],
        {name: [each.channels.get(name, 0.0) for _, each in frames] for name in names},
        parts_by_channel(names, cast),
        mixes={region: _mixes_in(region, [each for _, each in frames]) for region in PLAY_REGIONS},
        head=[_angles(each.head, "yaw", "pitch", "roll") for _, each in frames],
        gaze=[_angles(each.gaze, "yaw", "pitch") for _, each in frames],
    )


def parts_by_channel(names: Iterable[str], cast: HasTitles) -> dict[str, int]:
    """The place of the part of each channel that a cast knows the part of. names: of the channels; cast: it."""
    known = {name: part_of_channel(cast.titles[name].region) for name in names if name in cast.titles}
    return known | {name: GAZE_PART for name in names if name in GAZE_UNITS}


def record(performer: Advances, cast: HasTitles, *, seconds: float, rate: int = 60) -> MotionCurve:
    """Lets a performer play and records it.

    Parameters
    ----------
    performer : Performer
        Which is that much further afterwards.
    cast : Cast
        What it plays.
    seconds : float
        How long.
    rate : int
        Frames of a second.

    Returns
    -------
    MotionCurve
        Of the frames from the first, at 0 s, to the last, at `seconds`.
    """
    count = round(seconds * rate)
    shown = [(0.0, performer.advance(0.0))]
    shown += [(place / rate, performer.advance(1.0 / rate)) for place in range(1, count + 1)]
    return cut_curve(shown, cast, start=0.0, stop=seconds)


def _mixes_in(region: PlayRegion, shown: Sequence[Shown]) -> dict[str, list[float]]:
    mixes = [mix_in(region, each.expressions, each.regions) for each in shown]
    names = sorted({NEUTRAL, *(name for mix in mixes for name in mix)})
    return {name: [mix.get(name, 0.0) for mix in mixes] for name in names}


def _angles(turn: Any, *names: str) -> tuple[float, ...]:
    return tuple(turn) if isinstance(turn, tuple | list) else tuple(getattr(turn, name) for name in names)
