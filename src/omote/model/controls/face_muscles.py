"""The facial muscles, placed on the generic head by its landmarks: corners of lids and lips, and the eyes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from omote.arrays import Values
from omote.geometry import mesh
from omote.model.controls.mirror import mirror_rows
from omote.model.controls.muscle import Lip, Muscle, metric_of, pull_field
from omote.model.space.head_regions import eye_frame
from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

Point = tuple[float, float]

_LINE_POINTS = 9


def muscles(space: ParameterSpace, /) -> Mapping[str, Muscle]:
    """The muscles of a head by name, pairs left and right; none where it has no lines of lids and lips."""
    return MappingProxyType({name: muscle for name, (muscle, _) in _muscles_of(space).items()})


def muscle_fields(space: ParameterSpace, /) -> Mapping[str, Values]:
    """The field of each muscle at full contraction, (V, 3): dtheta, dh, R - 1."""
    return MappingProxyType({name: field for name, (_, field) in _muscles_of(space).items()})


@weakly_cached
def _muscles_of(space: ParameterSpace) -> Mapping[str, tuple[Muscle, Values]]:
    return {muscle.name: (muscle, mesh.freeze(pull_field(space, muscle))) for muscle in _all(space)}


def _all(space: ParameterSpace) -> list[Muscle]:
    lines = {line.name: line for line in space.lines}
    if not {"lid_left", "lips"} <= lines.keys():
        return []
    head = _Head(space, lines["lid_left"], lines["lips"])
    pairs = list[Muscle]()
    for muscle in _left(head):
        pairs += [muscle, _mirror_muscle(space, muscle)]
    return [*pairs, head.mouth_ring(), head.mentalis()]


def _mirror_muscle(space: ParameterSpace, muscle: Muscle) -> Muscle:
    """The mirror image of a left muscle."""
    mirror = mirror_rows(space)
    return replace(
        muscle,
        name=muscle.name.replace("_left", "_right"),
        label=muscle.label.replace("left", "right"),
        rows=tuple(int(mirror[row]) for row in muscle.rows),
        bone=(-muscle.bone[0], muscle.bone[1]),
        skin=muscle.skin if muscle.kind == "sphincter" else (-muscle.skin[0], muscle.skin[1]),
        closes=muscle.closes.replace("_left", "_right"),
    )


class _Head:
    """Where muscles begin and end on a head: the left half, on S in metres, across and up."""

    def __init__(self, space: ParameterSpace, lid: Line, lips: Line) -> None:
        self.space = space
        self.metric = metric_of(space)
        self._middle, self.unit = eye_frame(space)
        self.lid = lid
        self.lips = lips
        self._front = space.on_sheet & (space.points[:, 2] > np.median(space.points[space.on_sheet, 2]))

    def on_s(self, row: int) -> Point:
        """A vertex on S, metres."""
        return float(self.space.theta[row] * self.metric), float(self.space.h[row])

    def at(self, x: float, y: float) -> int:
        """The vertex there in front view, in distances between the eyes from the point between them."""
        local = (self.space.points[:, :2] - self._middle[:2]) / self.unit
        return int(np.where(self._front, np.hypot(*(local - [x, y]).T), np.inf).argmin())

    def corner(self) -> int:
        """The left corner of the mouth."""
        return int(chains(self.space.points, self.lips.loop)[0][-1])

    def on_lip(self, half: int, share: float) -> int:
        """A vertex of the upper (0) or lower (1) lip's edge, at a share of its left half from the middle."""
        chain = chains(self.space.points, self.lips.loop)[half]
        x = self.space.points[chain, 0]
        return int(chain[np.abs(x - share * x.max()).argmin()])

    def line(self, bone: int, skin: int) -> tuple[int, ...]:
        """Vertices along the straight way on S from one to the other."""
        ends = np.array([self.on_s(bone), self.on_s(skin)])
        plane = np.stack([self.space.theta * self.metric, self.space.h], axis=1)
        ways = ends[0] + np.linspace(0.0, 1.0, _LINE_POINTS)[:, None] * (ends[1] - ends[0])
        distance = np.where(self.space.on_sheet, np.linalg.norm(plane[None] - ways[:, None], axis=2), np.inf)
        return tuple(dict.fromkeys(int(row) for row in distance.argmin(axis=1)))

    def linear(
        self, name: str, label: str, bone: int, skin: int, *, pull: float, spread: float, reach: float,
        lip: Lip = "both",
    ) -> Muscle:  # fmt: skip
        """A linear muscle between two vertices; pull and reach in distances between the eyes."""
        return Muscle(
            name, label, "linear", self.line(bone, skin), self.on_s(bone), self.on_s(skin), pull * self.unit,
            np.deg2rad(spread), reach * self.unit, lip,
        )  # fmt: skip

    def sheet(self, name: str, label: str, bone: int, skin: int, *, pull: float, width: float, reach: float) -> Muscle:
        """A sheet muscle whose fibres end at the skin around a vertex; lengths in distances between the eyes."""
        return Muscle(
            name, label, "sheet", self.line(bone, skin), self.on_s(bone), self.on_s(skin), pull * self.unit,
            width * self.unit, reach * self.unit,
        )  # fmt: skip

    def ring(self, line: Line, name: str, label: str, *, scale: float, pull: float, reach: float) -> Muscle:
        """A sphincter around a line, its half-axes `scale` times the line's."""
        rows = [int(row) for row in line.loop]
        across = self.space.theta[rows] * self.metric
        up = self.space.h[rows]
        axes = (scale * float(np.ptp(across)) / 2, scale * float(np.ptp(up)) / 2)
        middle = (float(across.max() + across.min()) / 2, float(up.max() + up.min()) / 2)
        middle = (0.0 if abs(middle[0]) < 1e-6 else middle[0], middle[1])
        closed = line.name if line.kind == "lids" else ""
        return Muscle(name, label, "sphincter", tuple(rows), middle, axes, pull * self.unit, 1.0, reach, closes=closed)

    def mouth_ring(self) -> Muscle:
        """Orbicularis oris: the mouth purses and comes forward; its ring is as high as the lips are thick."""
        ring = self.ring(self.lips, "orbicularis_oris", "Purse the lips", scale=1.0, pull=0.13, reach=2.8)
        return replace(ring, skin=(ring.skin[0], 0.45 * ring.skin[0]), swell=0.06)

    def mentalis(self) -> Muscle:
        """The chin's skin goes up and pushes the lower lip."""
        chin = self.at(0.0, -1.62)
        lip = self.on_lip(1, 0.0)
        up = self.sheet("mentalis", "Push the chin up", lip, chin, pull=0.1, width=0.42, reach=0.22)
        return replace(up, lip="lower")


def _left(head: _Head) -> tuple[Muscle, ...]:
    cheek = head.at(0.72, -0.45)
    return (
        head.linear("zygomaticus_left", "Smile, left", cheek, head.corner(), pull=0.18, spread=55.0, reach=0.65),
        head.linear("depressor_left", "Mouth corner down, left", head.at(0.5, -1.72), head.corner(), pull=0.11,
                    spread=60.0, reach=0.55),
        head.linear("levator_left", "Upper lip up, left", head.at(0.3, -0.3), head.on_lip(0, 0.45), pull=0.12,
                    spread=34.0, reach=0.2, lip="upper"),
        head.sheet("frontalis_inner_left", "Inner brow up, left", head.at(0.2, 1.0), head.at(0.2, 0.36), pull=0.16,
                   width=0.36, reach=0.3),
        head.sheet("frontalis_outer_left", "Outer brow up, left", head.at(0.72, 1.0), head.at(0.7, 0.4), pull=0.16,
                   width=0.42, reach=0.3),
        head.linear("corrugator_left", "Frown, left", head.at(0.06, 0.12), head.at(0.42, 0.36), pull=0.12, spread=40.0,
                    reach=0.3),
        head.ring(head.lid, "orbicularis_oculi_left", "Squeeze the eye, left", scale=1.5, pull=0.03, reach=2.4),
    )  # fmt: skip
