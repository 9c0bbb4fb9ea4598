"""Fits identity modes and the pose of a scan to each other: Gauss-Newton, point to plane (Chen and Medioni 1992)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.model.fitting.alignment import normal_equations
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity

MODE_ROUNDS = 14
# How far a match may be, metres, in the first round and in the last.
REACH = (0.025, 0.008)
# Normals of a match lie within 60 degrees.
ALIKE = 0.5
# A weight of one standard deviation counts as so many metres at every vertex.
PRIOR = 0.0001
# A landmark counts as so many vertices.
LANDMARK = 6.0


@dataclass(frozen=True, eq=False)
class ModeFit:
    """Weights (m,) of the modes, and the similarity from the modes' frame to the scan's."""

    weights: Values
    pose: Similarity


@dataclass(frozen=True, eq=False)
class Marks:
    """Landmarks: rows (k,) of the head, points (k, 3) of the scan, metres."""

    rows: Rows
    points: Values


def fit_modes(
    space: ParameterSpace, modes: IdentityModes, surface: ScanSurface, marks: Marks, weights: Values, /
) -> ModeFit:
    """The weights of modes and the pose that bring the head nearest to a surface and landmarks in its frame.

    weights (V,): how much the match of each vertex counts.

    space, modes: the head and what heads differ by; surface: the scan's; marks: landmarks, metres.
    """
    fit = ModeFit(np.zeros(len(modes.moves)), Similarity(1.0, np.eye(3), np.zeros(3)))
    rows = np.flatnonzero(weights > 0.0)
    for number in range(MODE_ROUNDS):
        reach = REACH[0] * (REACH[1] / REACH[0]) ** (number / (MODE_ROUNDS - 1))
        fit = _step(space, modes, surface, marks, (rows, weights[rows]), reach, fit)
    return fit


def _step(
    space: ParameterSpace, modes: IdentityModes, surface: ScanSurface, marks: Marks,
    counted: tuple[Rows, Values], reach: float, last: ModeFit,
) -> ModeFit:  # fmt: skip
    rows, weights = counted
    shape = modes.shape_skin(last.weights)
    skin = last.pose(shape)
    normals = mesh.normals(skin, space.triangles)[rows]
    at = surface.find_nearest(skin[rows], normals)
    off = skin[rows] - surface.points[at]
    away = np.linalg.norm(off, axis=1)
    good = (away < reach) & ((normals * surface.normals[at]).sum(axis=1) > ALIKE) & ~surface.border[at]
    share = weights * good * (1.0 - np.minimum(away / reach, 1.0) ** 2) ** 2
    turned = last.pose.scale * last.pose.rotation
    plane = surface.normals[at]
    slopes = _slopes(modes, rows, turned, skin[rows], plane)
    matrix, pull = normal_equations(slopes, (off * plane).sum(axis=1), share)
    for axis in np.eye(3):
        away_along = (skin[marks.rows] - marks.points) @ axis
        along = _slopes(modes, marks.rows, turned, skin[marks.rows], np.broadcast_to(axis, (len(marks.rows), 3)))
        more = normal_equations(along, away_along, np.full(len(marks.rows), LANDMARK))
        matrix = matrix + more[0]
        pull = pull + more[1]
    count = len(modes.moves)
    prior = share.sum() * PRIOR**2
    pull[:count] += prior * last.weights
    stiff = np.concatenate([np.full(count, prior), np.full(7, 1e-9)])
    step = np.asarray(-np.linalg.solve(matrix + np.diag(stiff), pull), np.float64)
    return ModeFit(last.weights + step[:count], _moved(last.pose, step[count:]))


def _slopes(modes: IdentityModes, rows: Rows, turned: Values, skin: Values, plane: Values) -> Values:
    """How the heights (k,) over planes change with weights, turn, shift and logarithm of the size: (k, m + 7)."""
    local = plane @ turned
    by_modes = np.einsum("mkc,kc->km", modes.moves[:, rows], local)
    return np.hstack([by_modes, np.cross(skin, plane), plane, (skin * plane).sum(axis=1, keepdims=True)])


def _moved(pose: Similarity, step: Values) -> Similarity:
    """The pose after a small turn (3,), shift (3,) and growth about the origin."""
    angle = float(np.linalg.norm(step[:3]))
    axis = step[:3] / max(angle, 1e-30)
    cross = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    turn = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    size = float(np.exp(step[6]))
    return Similarity(pose.scale * size, turn @ pose.rotation, size * turn @ pose.shift + step[3:6])
