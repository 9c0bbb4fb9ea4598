"""A body's motion as the columns of a motion curve: bones by name, so that a clip outlives a change of the skeleton.

Most bones turn less than half a turn against their parent and have their rotation vectors, as poses have them. Hips and
feet turn against the house, round and round in a pirouette, where a rotation vector jumps: they have the first two
columns of their matrix, which neither jump nor have two signs, less those of no rotation, so that rest is zero.

Y. Zhou, C. Barnes, J. Lu, J. Yang, H. Li: On the continuity of rotation representations in neural networks, 2019.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from omote.arrays import Values
from omote.model.body.pose import FARTHEST, LARGEST_TURN
from omote.perform.figures.pose_mix import MixedPose

BODY_COLUMN = "body"
"""What the names of these columns begin with."""
ROOT = "root"
FEET = ("foot.L", "foot.R")
WIDE = (ROOT, *FEET)
"""The bones that turn against the house."""
TRAVEL = "travel"
ANKLES = ("ankle.L", "ankle.R")
AXES = ("x", "y", "z")
SIX = ("xx", "xy", "xz", "yx", "yy", "yz")
"""Where the x and the y of a bone point, along x, y and z each."""
_NO_TURN = np.array([1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
_NOTHING = 1e-9
"""Radians: a bone that never turns farther has no column."""
TRAVEL_COLUMNS = tuple(f"{BODY_COLUMN}/{TRAVEL}/{axis}" for axis in AXES)
"""All motion of a body has these."""


def body_columns(bones: Sequence[str], poses: Sequence[MixedPose]) -> dict[str, Values]:
    """The columns of what a body did, (n,) each, by name.

    bones: J names, in the order of the poses; poses: of n frames.
    """
    turns = np.array([pose.turns for pose in poses])
    places = {bone: place for place, bone in enumerate(bones)}
    columns: dict[str, Values] = {}
    for bone in (each for each in bones if each not in WIDE):
        columns |= _named(bone, AXES, _without_jumps(turns[:, places[bone]]), needed=False)
    wide = {ROOT: turns[:, places[ROOT]]}
    wide |= {foot: np.array([pose.feet_turns[number] for pose in poses]) for number, foot in enumerate(FEET)}
    for bone, vectors in wide.items():
        matrices = _rotation().from_rotvec(vectors).as_matrix()
        six = matrices[:, :, :2].transpose(0, 2, 1).reshape(-1, 6) - _NO_TURN
        columns |= _named(bone, SIX, six, needed=False)
    for number, ankle in enumerate(ANKLES):
        columns |= _named(ankle, AXES, np.array([pose.feet[number] for pose in poses]), needed=False)
    return columns | _named(TRAVEL, AXES, np.array([pose.travel for pose in poses]), needed=True)


def range_of(name: str) -> float | None:
    """How far from 0 a column goes at most, by its name without the part; None for a name that none has.

    name: such as `spine05/x`.
    """
    of, _, axis = name.partition("/")
    if of in (TRAVEL, *ANKLES):
        return FARTHEST if axis in AXES else None
    if of in WIDE:
        return 2.0 if axis in SIX else None
    return LARGEST_TURN if of and axis in AXES else None


class BodyReader:
    """Reads the body of motion, where columns say it."""

    def __init__(self, columns: Sequence[str], bones: Sequence[str]) -> None:
        """columns: of a layout; bones: those of the cast's skeleton, in its order. Bones that only the columns have are
        left out."""
        self._count = len(bones)
        at = {column: place for place, column in enumerate(columns)}
        places = {bone: place for place, bone in enumerate(bones)}
        self.there = TRAVEL_COLUMNS[0] in at and bool(bones)
        told = [
            (at[f"{BODY_COLUMN}/{bone}/{axis}"], places[bone], number)
            for bone in bones
            if bone not in WIDE
            for number, axis in enumerate(AXES)
            if f"{BODY_COLUMN}/{bone}/{axis}" in at
        ]
        self._from, self._bones, self._axes = (np.array([each[part] for each in told], np.intp) for part in range(3))
        self._wide = [_places(at, bone, SIX) for bone in WIDE]
        self._spots = [_places(at, spot, AXES) for spot in (TRAVEL, *ANKLES)]
        self._root = places.get(ROOT, 0)

    def pose(self, values: Values) -> MixedPose:
        """The pose that numbers of all columns say; places and turns as far as poses have them."""
        turns = np.zeros((self._count, 3))
        turns[self._bones, self._axes] = np.clip(values[self._from], -LARGEST_TURN, LARGEST_TURN)
        root, left, right = (_turn(_read(values, places)) for places in self._wide)
        turns[self._root] = root
        travel, *feet = (np.clip(_read(values, places), -FARTHEST, FARTHEST) for places in self._spots)
        return MixedPose(turns, travel, np.array(feet), np.array([left, right]))


def _places(at: Mapping[str, int], of: str, axes: Sequence[str]) -> list[int | None]:
    return [at.get(f"{BODY_COLUMN}/{of}/{axis}") for axis in axes]


def _read(values: Values, places: Sequence[int | None]) -> Values:
    return np.array([0.0 if place is None else values[place] for place in places])


def _turn(six: Values) -> Values:
    """The rotation vector (3,) of six numbers, which a blend has made shorter, or not square: x stays where it points.
    Of two that are opposite halfway there is none: no rotation."""
    x, y = (six + _NO_TURN).reshape(2, 3)
    length = float(np.linalg.norm(x))
    if length < 1e-6:
        return np.zeros(3)
    x = x / length
    y = y - x * (x @ y)
    square = float(np.linalg.norm(y))
    if square < 1e-6:
        return np.zeros(3)
    y = y / square
    return np.asarray(_rotation().from_matrix(np.stack([x, y, np.cross(x, y)], axis=1)).as_rotvec())


def _rotation() -> Any:
    """SciPy's rotations: commands name clips and do not wait for it."""
    from scipy.spatial.transform import Rotation

    return Rotation


def _named(of: str, axes: Sequence[str], table: Values, *, needed: bool) -> dict[str, Values]:
    """The columns of a table (n, axes), those that say anything at all; needed: all."""
    return {
        f"{BODY_COLUMN}/{of}/{axis}": values
        for axis, values in zip(axes, table.T, strict=True)
        if needed or np.abs(values).max() > _NOTHING
    }


def _without_jumps(vectors: Values) -> Values:
    """Rotation vectors (n, 3) of one bone, each in that form which is nearest to the one before: an arm that passes
    half a turn goes on, as far as poses have it."""
    smooth = vectors.copy()
    for frame in range(1, len(smooth)):
        before = smooth[frame - 1]
        angle = float(np.linalg.norm(smooth[frame]))
        if angle < math.pi / 2.0:
            continue
        other = smooth[frame] * (1.0 - 2.0 * math.pi / angle)
        if np.abs(other).max() < LARGEST_TURN and np.linalg.norm(other - before) < np.linalg.norm(
            smooth[frame] - before
        ):
            smooth[frame] = other
    return smooth
