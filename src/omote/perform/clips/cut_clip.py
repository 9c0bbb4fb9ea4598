"""Cuts a motion curve out of what was on air of a character."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from omote.arrays import Values
from omote.model.body.pose import STAND, Pose
from omote.model.body.pose_regions import regions_of_bones
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.model.space.expression import Title
from omote.perform.channels import GAZE_UNITS
from omote.perform.clips.body_columns import BODY_COLUMN, body_columns
from omote.perform.clips.clip_parts import BODY
from omote.perform.clips.motion_curve import NEAR, MotionCurve
from omote.perform.clips.sample import AT_REST, CHANNEL, GAZE_COLUMNS, HEAD_COLUMNS, layout_of
from omote.perform.figures.packed_pose import unpack_pose
from omote.perform.figures.pose_mix import MixedPose, mix_poses
from omote.perform.figures.tracked_body import with_tracked
from omote.perform.frame import Frame
from omote.perform.layers.columns import GAZE_PART
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE, check_part, part_of_channel
from omote.perform.mix import mix_in
from omote.perform.springs.cast_springs import without_springs


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

    @property
    def figure(self) -> Any:
        """The mix of poses, those of regions that show another, and a body that is tracked; None while it stands."""

    @property
    def held(self) -> Any:
        """What hands hold, with channels; None where that is what shows."""


class HasTitles(Protocol):
    """A cast, or whatever says where expressions act."""

    @property
    def titles(self) -> Mapping[str, Title]:
        """The titles of expressions, by name."""


class HasPoses(HasTitles, Protocol):
    """One that says what poses are, too."""

    @property
    def poses(self) -> Mapping[str, object]:
        """The poses, by name."""

    @property
    def bones(self) -> tuple[str, ...]:
        """The bones that poses turn, in their order; none without figures."""


class Advances(Protocol):
    """A performer."""

    def advance(self, dt: float) -> Frame:
        """What is on air some time later."""


def cut_curve(shown: Iterable[tuple[float, Shown]], cast: HasPoses, *, start: float, stop: float) -> MotionCurve:
    """The motion of a character from one time to another.

    Parameters
    ----------
    shown : iterable of (float, Shown)
        What shows of the character (`Frame`, `CharacterState`), each with its time in seconds, rising.
    cast : Cast
        Which says on which part of a face each channel acts, and what poses are.
    start, stop : float
        Seconds; frames from the one to the other are in it.

    Returns
    -------
    MotionCurve
        Its times count from `start`. Expressions by region, channels without the eight that turn the eyes, which the
        gaze turns again, head and gaze; and the body, where a pose of a figure shows at all.

    Raises
    ------
    ValueError
        Where no frame lies between.
    """
    builder = CurveBuilder(cast)
    for time, each in shown:
        if start - NEAR <= time <= stop + NEAR:
            builder.add(time - start, each)
    if not builder.frames:
        raise ValueError(f"nothing was recorded between {start:g} s and {stop:g} s; choose other times")
    return builder.curve()


class CurveBuilder:
    """Collects what shows of a character, frame by frame, at no more cost a frame than the frame has numbers.

    cast: which says on which part of a face each channel acts, and what poses are; without its names in it.
    """

    def __init__(self, cast: HasPoses) -> None:
        self._cast = cast
        self._bodies: dict[int, MixedPose] = {}
        self._regions = regions_of_bones(cast.bones)
        self._poses = {name: pose for name, pose in cast.poses.items() if isinstance(pose, Pose)}
        self._times = array("d")
        self._columns: dict[str, array[float]] = {name: array("d") for name in (*HEAD_COLUMNS, *GAZE_COLUMNS, *AT_REST)}

    @property
    def frames(self) -> int:
        """How many it has."""
        return len(self._times)

    def add(self, time: float, shown: Shown) -> None:
        """Adds a frame. time: seconds, later than the last; shown: what shows of the character."""
        before = len(self._times)
        self._times.append(time)
        values = dict(
            zip((*HEAD_COLUMNS, *GAZE_COLUMNS), (*_turned(shown.head, 3), *_turned(shown.gaze, 2)), strict=True)
        )
        channels = without_springs(shown.channels, None if shown.held is None else shown.held.channels)
        values |= {f"{CHANNEL}/{name}": value for name, value in channels.items() if name not in GAZE_UNITS}
        for region in PLAY_REGIONS:
            mix = mix_in(region, shown.expressions, shown.regions)
            values |= {f"{region}/{name}": weight for name, weight in mix.items()}
        for name in values.keys() - self._columns.keys():
            self._columns[name] = array("d", bytes(8 * before))
        for name, column in self._columns.items():
            column.append(values.get(name, 0.0))
        if shown.figure is not None and STAND in self._poses:
            self._bodies[before] = self._body(shown.figure)

    def curve(self) -> MotionCurve:
        """The curve of all frames; ValueError where there are none, or too many."""
        names = tuple(sorted(self._columns))
        layout = layout_of(names, tuple(self._place(name) for name in names))
        table = np.column_stack([np.array(self._columns[name]) for name in names])
        face = MotionCurve(np.array(self._times), layout, table)
        return with_body(face, self._body_columns()) if self._bodies else face

    def _body(self, figure: Any) -> MixedPose:
        """What shows of a body, without what it does by itself: poses, of which those that the cast has not are left
        out, and a performer's or a clip's body over them."""
        poses = self._poses
        whole = known_weights(figure.poses, poses)
        own = {region: known_weights(weights, poses) for region, weights in figure.regions.items()}
        mixed = mix_poses(poses, whole, own, self._regions)
        if figure.tracked is None:
            return mixed
        numbers = unpack_pose(figure.tracked.pose, len(self._cast.bones))
        return with_tracked(mixed, tuple(figure.tracked.shares), numbers, tuple(self._regions.values()))

    def _body_columns(self) -> dict[str, Values]:
        """The body's columns; it stands where nothing was called of it."""
        bones = self._cast.bones
        still = MixedPose(np.zeros((len(bones), 3)), np.zeros(3), np.zeros((2, 3)), np.zeros((2, 3)))
        return body_columns(bones, [self._bodies.get(frame, still) for frame in range(self.frames)])

    def _place(self, column: str) -> int:
        part, _, name = column.partition("/")
        return place_of_channel(name, self._cast) if part == CHANNEL else LAYER_PARTS.index(check_part(part))


def known_weights(weights: Mapping[str, float], poses: Mapping[str, Pose]) -> dict[str, float]:
    """The weights of poses that there are; `STAND` alone where there are none. weights, poses: by name."""
    return {name: weight for name, weight in weights.items() if name in poses} or {STAND: 1.0}


def with_body(curve: MotionCurve, body: Mapping[str, Values]) -> MotionCurve:
    """A curve with the columns of a body, in place of those that it has. curve: of n frames; body: of
    `body_columns`, (n,) each."""
    before = zip(curve.layout.columns, curve.layout.parts, curve.table.T, strict=True)
    columns = {name: (place, values) for name, place, values in before if name.partition("/")[0] != BODY_COLUMN}
    columns |= {name: (BODY, values) for name, values in body.items()}
    names = tuple(sorted(columns))
    layout = layout_of(names, tuple(columns[name][0] for name in names))
    return MotionCurve(curve.times, layout, np.column_stack([columns[name][1] for name in names]))


def place_of_channel(name: str, cast: HasTitles) -> int:
    """The place of the part of a channel among `LAYER_PARTS`, `WHOLE` for the whole face. name: of it; cast: which
    knows."""
    if name in GAZE_UNITS:
        return GAZE_PART
    return part_of_channel(cast.titles[name].region) if name in cast.titles else WHOLE


def parts_by_channel(names: Iterable[str], cast: HasTitles) -> dict[str, int]:
    """The place of the part of each channel. names: of the channels; cast: which knows."""
    return {name: place_of_channel(name, cast) for name in names}


def record(performer: Advances, cast: HasPoses, *, seconds: float, rate: int = 60) -> MotionCurve:
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


def _turned(turn: Any, count: int) -> Sequence[float]:
    """The angles of a head or a gaze, however they come."""
    return turn if isinstance(turn, tuple | list) else [*vars(turn).values()][:count]
