"""Muscles (Waters 1987) defined once on S: linear, sheet and sphincter muscles, independent of identity.

K. Waters, "A muscle model for animating three-dimensional facial expression", SIGGRAPH 1987, in the metric of S: across
mean radius times theta, up h, both in metres.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Values
from omote.geometry.cylinder import wrap
from omote.geometry.laplacian import cotangents, smoothing_matrix
from omote.model.controls.upper_lower import sides
from omote.model.space.eye_socket import fall_off, radius_of
from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace

MuscleKind = Literal["linear", "sheet", "sphincter"]
Lip = Literal["both", "upper", "lower"]

# Rings over which the head's radius is smoothed before the skin slides along it: a lip's edge is no slope of the face.
_SLOPE_ROUNDS = 20
# Lids meet so far up from the lower one; beyond them the skin follows within so many of the ring's half-heights.
_MEETING = 0.17
_LID_REACH = 1.2
# How steep a way over the head's slope may be, and how far from the eyeball, in radii, skin keeps its distance from it.
_STEEPEST = 0.8
_NEAR = 1.1
_FAR = 1.4
# A ring draws together so much less upwards than across: the skin gathers.
_FLATTER = 0.3
# Near its corner, within this share of the mouth's half width, a lip stays with the other.
_CORNER = 0.8


@dataclass(frozen=True)
class Muscle:
    """A muscle at full contraction.

    rows: vertices under its line, from the bone to the skin (a sphincter: its ring); bone, skin: its ends on S, across
    and up, metres (a sphincter: its middle, and its half-axes); pull: how far the skin goes, metres; spread: a linear
    muscle's half angle, radians, a sheet's half width, metres; reach: how far the pull is felt beyond the skin end,
    metres (a sphincter: in half-axes); lip: the lip that goes with it; swell: R - 1 in the middle of a sphincter;
    closes: the line whose lids a sphincter brings together. ValueError on numbers that make no muscle.
    """

    name: str
    label: str
    kind: MuscleKind
    rows: tuple[int, ...]
    bone: tuple[float, float]
    skin: tuple[float, float]
    pull: float
    spread: float
    reach: float
    lip: Lip = "both"
    swell: float = 0.0
    closes: str = ""

    def __post_init__(self) -> None:
        numbers = (*self.bone, *self.skin, self.pull, self.spread, self.reach, self.swell)
        if not np.isfinite(numbers).all():
            raise ValueError(f"muscle {self.name!r} has numbers {numbers}; expected finite ones")
        if self.spread <= 0 or self.reach <= 0:
            raise ValueError(
                f"muscle {self.name!r} has spread {self.spread:g} and reach {self.reach:g}; expected positive ones"
            )
        if self.kind == "sphincter" and min(self.skin) <= 0:
            raise ValueError(
                f"sphincter {self.name!r} has half-axes {self.skin}; expected two positive lengths, metres"
            )
        if self.kind != "sphincter" and np.hypot(*np.subtract(self.bone, self.skin)) < 1e-6:
            raise ValueError(f"muscle {self.name!r} begins where it ends, at {self.bone}; expected a line")


def pull_field(space: ParameterSpace, muscle: Muscle, /) -> Values:
    """The field of a muscle at full contraction: dtheta (radians), dh (metres), R - 1 of each vertex, (V, 3), zero off
    the sheet. The skin slides along the head's slope, smoothed; half a contraction is half the field.

    space: the space of the generic head.
    """
    metric = metric_of(space)
    across = wrap(space.theta - muscle.bone[0] / metric) * metric
    place = np.stack([across, space.h - muscle.bone[1]], axis=1)
    move = {"linear": _linear, "sheet": _sheet, "sphincter": _sphincter}[muscle.kind](muscle, place)
    if muscle.closes:
        move += _close_lids(space, muscle)
    share = _share(space, muscle.lip) * space.on_sheet
    dtheta = move[:, 0] * share / metric
    dh = move[:, 1] * share
    over = slide_radius(space, dtheta, dh)
    if muscle.swell:
        over += muscle.swell * _bell(_ring_distance(muscle, place) / muscle.reach) * share
    return np.where(space.on_sheet[:, None], np.stack([dtheta, dh, over], axis=1), 0.0)


def metric_of(space: ParameterSpace, /) -> float:
    """The mean radius of the sheet, metres: what a radian of S counts for."""
    return float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())


def slide_radius(space: ParameterSpace, dtheta: Values, dh: Values, /) -> Values:
    """R - 1 (V,) with which the generic head's skin stays on its smoothed surface while it goes by dtheta, dh (V,).

    space: the space of the generic head.
    """
    average = smoothing_matrix(space.sheet_triangles, space.vertex_count)
    radius = space.cylinder.unroll(space.points)[2]
    smooth = radius
    for _ in range(_SLOPE_ROUNDS):
        smooth = average @ smooth
    rows = np.flatnonzero(space.on_sheet & ((dtheta != 0) | (dh != 0))).astype(np.int32)
    landing = space.locate(space.theta[rows] + dtheta[rows], space.h[rows] + dh[rows], rows)
    there = (landing.weights * smooth[space.location_triangles[landing.triangles]]).sum(axis=1)
    most = _STEEPEST * np.hypot(dtheta[rows] * smooth[rows], dh[rows])
    further = most * np.tanh((there - smooth[rows]) / np.maximum(most, 1e-12))
    over = np.zeros(space.vertex_count)
    over[rows] = _around_balls(space, rows, dtheta[rows], dh[rows], further) / radius[rows]
    return over


def _around_balls(space: ParameterSpace, rows: Indices, dtheta: Values, dh: Values, further: Values) -> Values:
    """How much farther from the axis (n,) vertices go, metres: by `further`, lids so that they keep their distance from
    the middle of the eyeball."""
    result = further.copy()
    theta = space.theta[rows] + dtheta
    ahead = np.stack([np.sin(theta), np.zeros(len(rows)), np.cos(theta)], axis=1)
    axis = np.stack([np.full(len(rows), space.cylinder.x), space.h[rows] + dh, np.full(len(rows), space.cylinder.z)], 1)
    for part in space.parts.values():
        if part.eye:
            distance = np.linalg.norm(space.points[rows] - part.points.mean(axis=0), axis=1)
            to_ball = part.points.mean(axis=0) - axis
            along = (ahead * to_ball).sum(axis=1)
            left = distance**2 - (to_ball**2).sum(axis=1) + along**2
            radius = along + np.sqrt(np.maximum(left, 0.0)) - space.cylinder.unroll(space.points[rows])[2]
            hold = fall_off((distance / radius_of(part.points) - _NEAR) / (_FAR - _NEAR)) * (left > 0)
            result += hold * (radius - result)
    return result


def _linear(muscle: Muscle, place: Values) -> Values:
    """Towards the bone: as the cosine of the angle off its line, from nothing at the bone to most at the skin end."""
    line = np.subtract(muscle.skin, muscle.bone)
    length = float(np.hypot(*line))
    distance = np.maximum(np.hypot(place[:, 0], place[:, 1]), 1e-9)
    angle = np.arccos(np.clip(place @ line / (distance * length), -1.0, 1.0))
    strength = _bell(angle / muscle.spread) * _along(distance, length, muscle.reach)
    return -muscle.pull * (strength / distance)[:, None] * place


def _sheet(muscle: Muscle, place: Values) -> Values:
    """Parallel fibres towards the bone, most along the skin end."""
    line = np.subtract(muscle.skin, muscle.bone)
    length = float(np.hypot(*line))
    way = line / length
    beside = place @ np.array([-way[1], way[0]])
    strength = _bell(beside / muscle.spread) * _along(place @ way, length, muscle.reach)
    return -muscle.pull * strength[:, None] * way


def _sphincter(muscle: Muscle, place: Values) -> Values:
    """Towards the middle across, as far as a vertex is from it within the ring."""
    strength = _ring(muscle, place)
    inward = np.clip(place / np.array(muscle.skin), -1.5, 1.5)
    inward[:, 1] *= _FLATTER * muscle.skin[1] / muscle.skin[0]
    return -muscle.pull * strength[:, None] * inward


def _ring(muscle: Muscle, place: Values) -> Values:
    """1 in the ring, falling to 0 at reach half-axes."""
    return _bell(np.maximum(_ring_distance(muscle, place) - 1.0, 0.0) / max(muscle.reach - 1.0, 1e-9))


def _ring_distance(muscle: Muscle, place: Values) -> Values:
    """How far from a sphincter's middle, in half-axes."""
    return np.hypot(*(place / np.array(muscle.skin)).T)


def _close_lids(space: ParameterSpace, muscle: Muscle) -> Values:
    """The lids of a line brought to where they meet; what lies farther from them follows less and less."""
    move = np.zeros((space.vertex_count, 2))
    for line in space.lines:
        if line.name == muscle.closes:
            upper, lower = (_height(space, chain) for chain in chains(space.points, line.loop))
            meeting = lower + _MEETING * (upper - lower)
            side = sides(space)[space.lines.index(line)]
            for sign, lid in ((1, upper), (-1, lower)):
                fall = _bell(np.maximum(sign * (space.h - lid), 0.0) / (_LID_REACH * muscle.skin[1]))
                move[:, 1] += np.where(side == sign, (meeting - lid) * fall, 0.0)
    return move


def _height(space: ParameterSpace, chain: Indices) -> Values:
    """How high a lid's edge is at each vertex' theta, (V,) metres, its corners' heights beside it."""
    order = np.argsort(space.theta[chain], kind="stable")
    return np.interp(space.theta, space.theta[chain][order], space.h[chain][order])


def _along(distance: Values, length: float, reach: float) -> Values:
    """Along a muscle: a sine from the bone to the skin end at `length`, a bell from there on."""
    rising = np.sin(np.clip(distance / length, 0.0, 1.0) * np.pi / 2)
    return np.where(distance < length, rising**2, _bell((distance - length) / reach))


def _bell(share: Values) -> Values:
    """1 at zero, 0 from one on either way, without a corner: the square of the cosine."""
    return np.where(np.abs(share) < 1.0, np.cos(share * np.pi / 2) ** 2, 0.0)


def _share(space: ParameterSpace, lip: Lip) -> Values:
    return np.ones(space.vertex_count) if lip == "both" else lip_share(space, lip)


def lip_share(space: ParameterSpace, lip: Lip, /) -> Values:
    """How much each vertex goes with the upper (lower) lip, (V,) from 0 to 1: all above (below) the mouth, less
    towards its corners, and what is harmonic between beside it. Ones where the head has no lips.

    space: the space of the generic head.
    """
    rows = [row for row, line in enumerate(space.lines) if line.kind == "lips"]
    if not rows:
        return np.ones(space.vertex_count)
    side = sides(space)[rows[0]]
    free = np.flatnonzero(space.on_sheet & (side == 0) & (space.welded == np.arange(space.vertex_count)))
    weights = cotangents(space.points, space.sheet_triangles)[free]
    inner = sparse.diags_array(weights.sum(axis=1) + 1e-9) - weights[:, free]
    share = (side == (1 if lip == "upper" else -1)) * _off_corners(space, space.lines[rows[0]])
    share[free] = splu(sparse.csc_array(inner)).solve(weights @ share)
    return share[space.welded]


def _off_corners(space: ParameterSpace, line: Line) -> Values:
    """0 at the corners of a mouth, 1 away from them, (V,)."""
    upper, _ = chains(space.points, line.loop)
    corners = space.points[upper[[0, -1]]]
    half = float(np.linalg.norm(corners[1] - corners[0])) / 2
    distance = np.linalg.norm(space.points[:, None] - corners, axis=2).min(axis=1)
    return 1.0 - fall_off(distance / (_CORNER * half))
