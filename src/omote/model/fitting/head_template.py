"""The template: the mean head of people and what people differ by, as few points of its outer skin with normals."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.model.fitting.depth_maps import CELL, DepthMaps, make_maps
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import sample_surface, thin_out
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached_with

MODES = 50
"""So many modes say where a head is; the fit uses more."""
# The face in shares of the mouth's and the eyes' place: what lies in this box about the nose's tip, metres.
_FACE = np.array([(-0.062, -0.068, -0.083), (0.062, 0.093, 0.01)])
# What lies lower than this below the tip is neck.
_NECK = -0.073
_FINE = 0.0035
_COARSE = 0.0055
_SKULL = 0.014
# A point of the skull counts as so much of one of the face.
_LESS = 0.5


@dataclass(frozen=True, eq=False)
class HeadTemplate:
    """points (n, 3), metres, normals (n, 3), moves (m, n, 3) one standard deviation of each mode.

    face: rows that measure; matched: rows that are brought to the scan, weights of them; marks: rows of the seven
    landmarks; skin: all rows of the outer skin; nose: the depth map of the nose's tip.
    """

    points: Values
    normals: Values
    moves: Values
    face: Rows
    front: Rows
    matched: Rows
    weights: Values
    marks: Rows
    skin: Rows
    nose: DepthMaps

    def shape(self, rows: Rows, weights: Values, /) -> Values:
        """The points of some rows (k, 3) of the head with weights (j,) of the first modes."""
        return self.points[rows] + np.tensordot(weights, self.moves[: len(weights), rows], 1)


@weakly_cached_with
def make_template(space: ParameterSpace, modes: IdentityModes, /) -> HeadTemplate:
    """The template of a space's head, made once; ValueError where modes or landmarks are of another head."""
    refuse_other_topology(space, modes)
    mean = modes.skin
    marks = find_landmarks(space)
    tip = mean[marks["nose_tip"]]
    outer = np.flatnonzero(space.on_sheet & (space.welded == np.arange(space.vertex_count)))
    off = mean[outer] - tip
    in_face = ((off > _FACE[0]) & (off < _FACE[1])).all(axis=1)
    face = outer[in_face]
    front = _spread(mean, face, _COARSE)
    skull = _spread(mean, outer[~in_face & (off[:, 1] > _NECK)], _SKULL)
    surface = sample_surface(Scan(mean, space.skin_triangles))
    return HeadTemplate(
        points=mean, normals=mesh.normals(mean, space.triangles), moves=modes.moves[:MODES],
        face=_spread(mean, face, _FINE), front=front, matched=np.concatenate([front, skull]),
        weights=np.concatenate([np.ones(len(front)), np.full(len(skull), _LESS)]),
        marks=np.array([marks[name] for name in SEVEN]), skin=outer,
        nose=make_maps(thin_out(surface, CELL), tip[None]),
    )  # fmt: skip


def _spread(points: Values, rows: Rows, cell: float) -> Rows:
    """One of the rows in each cube of a lattice."""
    _, first = np.unique(np.floor(points[rows] / cell), axis=0, return_index=True)
    return rows[np.sort(first)]
