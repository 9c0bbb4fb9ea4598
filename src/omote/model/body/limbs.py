"""Limbs unrolled: where the rows of figures lie on cylinders of arms, legs and trunk, and rows moved along these.

What S is to the head's skin, the unrolled cylinders of limbs are to the body's: fields are made on them once, and worn
by all bodies.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np

from omote.arrays import Floats, Indices, Points, Values
from omote.geometry.cylinder import Cylinder, wrap
from omote.geometry.mesh import freeze
from omote.geometry.ramp import smooth_ramp
from omote.model.body.body import Body
from omote.model.body.figure_space import FigureSpace
from omote.model.body.skeleton import SIDES, Skeleton
from omote.model.body.stand import stand_turns

AHEAD = np.array([0.0, 0.0, 1.0])
"""Where the angle is 0 in the stand."""
INSIDE = (0.5, 0.95)
"""Of the weights of a row, how much are of a limb's bones where the limb begins to have it, and where it has all of it:
at the first, two limbs meet, and fields of both end there."""


class Limb(NamedTuple):
    """A limb of one side or the trunk: its axis goes from where one bone begins to where another does; bones: whose
    weights say what belongs to it; outward: 1 where angles grow with the turn about its axis, -1 where against it, so
    that they grow to the character's left on the trunk and outward on both sides."""

    name: str
    begin: str
    end: str
    bones: tuple[str, ...]
    outward: float


_OF_A_SIDE = {
    "upperarm": ("upperarm01", "lowerarm01"),
    "lowerarm": ("lowerarm01", "wrist"),
    "upperleg": ("upperleg01", "lowerleg01"),
    "lowerleg": ("lowerleg01", "foot"),
}
_TRUNK_BONES = ("root", "spine", "pelvis", "clavicle", "shoulder")
LIMBS: tuple[Limb, ...] = (
    Limb("trunk", "spine05", "neck01", _TRUNK_BONES, 1.0),
    *(
        Limb(f"{name}.{side}", f"{begin}.{side}", f"{end}.{side}", (name,), -1.0 if side == "L" else 1.0)
        for name, (begin, end) in _OF_A_SIDE.items()
        for side in SIDES
    ),
)
"""The trunk from the hips to the neck, then arms and legs, the left before the right. The trunk's axis does not begin
at the root, which lies farther back: from there it would leave the body at the small of the back."""
LIMB_PLACES = {limb.name: place for place, limb in enumerate(LIMBS)}


@dataclass(frozen=True, eq=False)
class LimbSpace:
    """The rows of figures that lie on limbs, n of them, and where: the same on all bodies.

    Parameters
    ----------
    rows : (n,) of int
        Of the figure.
    limbs : (n,) of int
        Places in `LIMBS`.
    ways : (n,) of float
        How far along, 0 where the limb begins, 1 where it ends.
    angles : (n,) of float
        About the axis, radians in [-pi, pi): 0 ahead in the stand, + outward (on the trunk to the character's left).
    shares : (n,) of float
        How much of a field is worn there, 0 where two limbs meet.
    """

    rows: Indices
    limbs: Indices
    ways: Values
    angles: Values
    shares: Values

    def __post_init__(self) -> None:
        for each in fields(self):
            shape = freeze(getattr(self, each.name)).shape
            if shape != self.rows.shape:
                raise ValueError(f"{each.name} of limbs are {shape}; expected {self.rows.shape}, one for each row")


NO_LIMBS = LimbSpace(*(np.zeros(0, np.int32),) * 2, *(np.zeros(0),) * 3)
"""Of figures whose rows lie on none."""


def unroll_limbs(space: FigureSpace, generic: Body) -> LimbSpace:
    """Where the rows of figures lie on limbs, found once, on one body.

    space: of figures; generic: the body that others are shaped from.

    Returns
    -------
    LimbSpace
        Of the body's rows, the skirt's among them; the head is S's.

    References
    ----------
    docs/method.md, "Limbs"; K. Arai (1993), section 5.3.
    """
    names = space.skeleton.names
    weights = space.weights[space.head_rows :].astype(np.float64)
    bones = space.bones[space.head_rows :]
    of_limbs = [np.array([name.startswith(limb.bones) and _on_side(name, limb) for name in names]) for limb in LIMBS]
    held = np.stack([(weights * chosen[bones]).sum(axis=1) for chosen in of_limbs])
    found = held.argmax(axis=0)
    shares = smooth_ramp(*INSIDE, held.max(axis=0))
    body_rows = np.flatnonzero(shares > 0.0)
    limbs = found[body_rows].astype(np.int32)
    joints = generic.joints.astype(np.float64)
    stand = stand_turns(space.skeleton, joints, generic.ends.astype(np.float64))
    points = generic.positions[body_rows].astype(np.float64)
    ways = np.zeros(len(limbs))
    angles = np.zeros(len(limbs))
    for place in range(len(LIMBS)):
        own = limbs == place
        ways[own], angles[own] = _unroll(LIMBS[place], space.skeleton, joints, stand, points[own])
    rows = (space.head_rows + body_rows).astype(np.int32)
    return LimbSpace(rows, limbs, ways, angles, shares[body_rows])


def _on_side(bone: str, limb: Limb) -> bool:
    return "." not in limb.name or bone.endswith(limb.name[-2:])


def _unroll(
    limb: Limb, skeleton: Skeleton, joints: Points, stand: Values, points: Points
) -> tuple[Values, Values]:  # fmt: skip
    """How far along a limb points (n, 3) lie, and their angles about it. stand (J, 3, 3): turns to the stand."""
    begin, end = (joints[skeleton.places[bone]] for bone in (limb.begin, limb.end))
    way = end - begin
    length = float(np.linalg.norm(way))
    up = way / length * (1.0 if way[1] > 0.0 else -1.0)
    ahead = stand[skeleton.places[limb.begin]].T @ AHEAD
    ahead -= up * (up @ ahead)
    ahead /= np.linalg.norm(ahead)
    left = np.cross(up, ahead)
    theta, height, _ = Cylinder(0.0, 0.0).unroll((points - begin) @ np.stack([left, up, ahead], axis=1))
    mirrored = -1.0 if limb.name.endswith(".R") else 1.0
    return height / length * np.sign(way @ up), wrap(mirrored * theta)


@dataclass(frozen=True, eq=False)
class LimbAxes:
    """The axes of the limbs of a body or a mix, (limbs, 3) each, metres: where they begin, from there to where they
    end, and their directions, about which angles grow."""

    begins: Points
    ways: Points
    abouts: Values


def limb_axes(skeleton: Skeleton, joints: Points) -> LimbAxes:
    """The axes of the limbs. skeleton: of the figure; joints (J, 3): where bones begin as modelled, metres."""
    begins, ends = (
        joints[[skeleton.places[getattr(limb, what)] for limb in LIMBS]].astype(np.float64) for what in ("begin", "end")
    )
    ways = ends - begins
    outward = np.array([limb.outward for limb in LIMBS])[:, None]
    return LimbAxes(begins, ways, outward * ways / np.linalg.norm(ways, axis=1, keepdims=True))


def limb_moves(space: LimbSpace, axes: LimbAxes, rows: Points, values: Values | Floats) -> Points:
    """How far a field moves the rows of a figure that lie on limbs, (n, 3) metres.

    A row at `p` lies off the axis by `q = p - begin - way (end - begin)`, the way being that of all bodies; the field's
    three numbers move it by `out q + round (about x q) + along (end - begin)`. So what a field does is linear in the
    field, and but for the second number in the body: half a mix of bodies wears half of what each wears.

    space: of limbs; axes: of the body; rows (V + B, 3): of the figure as modelled, metres; values (n, 3): out, a ratio
    of the row's own radius; round, radians; along, a ratio of the limb's length.
    """
    way = axes.ways[space.limbs]
    off = rows[space.rows] - axes.begins[space.limbs] - space.ways[:, None] * way
    out, turned, along = values.astype(np.float64).T[:, :, None]
    return np.asarray(out * off + turned * np.cross(axes.abouts[space.limbs], off) + along * way)
