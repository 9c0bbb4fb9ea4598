"""Extrapolates the form of a face in gradient space (rotations and stretches), so that nothing turns inside out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation

from omote.geometry import mesh
from omote.geometry.laplacian import smoothing_matrix

Values = NDArray[np.float64]
Triangles = NDArray[np.int32]

# Stretches stay within these factors of one in their logarithm per unit of growth: a wrinkle is no form.
_MOST = np.log(3.0)
# How hard the middle of the head holds its place, so that the sum of all gradients has one solution.
_HOLD = 1e-9
# Edge of a cell in which triangles are averaged together, in bells.
_CELL = 0.5
# Rounds of pulling at most.
_ROUNDS = 30


def extrapolate(generic: Values, face: Values, triangles: Triangles, amount: float, bell: float, /) -> Values:
    """Extrapolates a face (V, 3): what turns and stretches it from the generic one (V, 3) is applied again, times
    amount.

    Each triangle's deformation gradient (Sumner and Popovic 2004) is a rotation and a stretch; the logarithms of both,
    averaged over a bell of that width in metres, times amount are its growth, and the positions whose gradients come
    nearest to all grown ones follow (Yu et al. 2004). Amount zero gives the face. Its middle goes on straight ahead.
    """
    rotation, stretch = _turn_and_stretch(generic, face, triangles)
    turn = _average(generic, triangles, Rotation.from_matrix(rotation).as_rotvec(), bell)
    stretch = _average(generic, triangles, stretch, bell)
    # The stretch is known in the generic face's frame; the face's own rotation brings it to where it acts.
    acting = rotation @ _exponential(amount * stretch) @ rotation.transpose(0, 2, 1)
    wanted = Rotation.from_rotvec(amount * turn).as_matrix() @ acting @ _frames(face, triangles)[:, :, :2]
    result = _integrate_edges(face, triangles, wanted)
    middle = _middle(face, triangles) + amount * (_middle(face, triangles) - _middle(generic, triangles))
    return result + middle - _middle(result, triangles)


def find_folds(face: Values, positions: Values, triangles: Triangles, /) -> NDArray[np.bool_]:
    """The triangles (T,) whose normals look against those that they have on the face."""
    normals = (np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) for p in (face[triangles], positions[triangles]))
    here, there = normals
    result: NDArray[np.bool_] = (here * there).sum(axis=1) < 0.0
    return result


def repair_folds(face: Values, positions: Values, triangles: Triangles, /) -> Values:
    """Smooths positions (V, 3) where triangles are turned over against the face, by the mean of their one-rings, as
    little as repairs them, in a limited number of rounds; unchanged where nothing is folded."""
    result, mean = positions.copy(), smoothing_matrix(triangles, len(positions))
    for _ in range(_ROUNDS):
        bad = find_folds(face, result, triangles)
        if not bad.any():
            break
        rows = np.unique(triangles[bad])
        result[rows] += 0.5 * ((mean @ result)[rows] - result[rows])
    return result


def _frames(points: Values, triangles: Triangles) -> Values:
    """Two edges and a normal as long as they are: (T, 3, 3), in columns."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    normal /= np.sqrt(np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30))
    return np.stack([b - a, c - a, normal], axis=2)


def _turn_and_stretch(generic: Values, face: Values, triangles: Triangles) -> tuple[Values, Values]:
    """Rotations and the logarithms of the stretches that come before them, (T, 3, 3) both."""
    there, here = _frames(generic, triangles), _frames(face, triangles)
    left, sizes, right = np.linalg.svd(here @ np.linalg.inv(there))
    sizes = np.clip(np.log(np.maximum(sizes, 1e-9)), -_MOST, _MOST)
    stretch: Values = (right.transpose(0, 2, 1) * sizes[:, None]) @ right
    return left @ right, stretch


def _exponential(logs: Values) -> Values:
    sizes, axes = np.linalg.eigh(logs)
    result: Values = (axes * np.exp(sizes)[:, None]) @ axes.transpose(0, 2, 1)
    return result


def _average(points: Values, triangles: Triangles, values: Values, bell: float) -> Values:
    """The mean of what triangles have, (T, ...), under a bell around each; they count in cells of half a bell."""
    middles, area = points[triangles].mean(axis=1), mesh.areas(points, triangles)
    _, cell = np.unique(np.floor(middles / (_CELL * bell)), axis=0, return_inverse=True)
    cell = cell.reshape(-1)
    total = sparse.csr_array((area, (cell, np.arange(len(cell)))), shape=(int(cell.max()) + 1, len(cell)))
    sums = np.asarray(total.sum(axis=1))[:, None]
    square = cdist(middles, total @ middles / sums, "sqeuclidean") / (2.0 * bell * bell)
    weight = np.exp(square.min(axis=1, keepdims=True) - square)
    mean: Values = weight @ (total @ values.reshape(len(values), -1)) / (weight @ sums)
    return mean.reshape(values.shape)


def _integrate_edges(face: Values, triangles: Triangles, wanted: Values) -> Values:
    """The positions (V, 3) whose edges come nearest to the wanted ones (T, 3, 2), least squares in the face's areas."""
    a, b, c = face[triangles].transpose(1, 0, 2)
    edges = np.stack([b - a, c - a], axis=2)
    inverse = np.linalg.pinv(edges)  # (T, 2, 3): slopes of the two corners' shares over the face
    slopes = np.concatenate([-inverse.sum(axis=1, keepdims=True), inverse], axis=1)
    area = mesh.areas(face, triangles)
    rows = np.repeat(triangles, 3, axis=1).ravel()
    columns = np.tile(triangles, 3).ravel()
    stiff = area[:, None, None] * slopes @ slopes.transpose(0, 2, 1)
    matrix = sparse.csc_array((stiff.ravel(), (rows, columns)), shape=(len(face), len(face)))
    pull = area[:, None, None] * slopes @ (inverse.transpose(0, 2, 1) @ wanted.transpose(0, 2, 1))
    right = np.zeros_like(face)
    np.add.at(right, triangles.ravel(), pull.reshape(-1, 3))
    held = _HOLD * matrix.diagonal().mean()
    solver = splu(matrix + held * sparse.eye_array(len(face), format="csc"))
    result: Values = solver.solve(right + held * face)
    return result


def _middle(points: Values, triangles: Triangles) -> Values:
    area = mesh.areas(points, triangles)
    result: Values = (area[:, None] * points[triangles].mean(axis=1)).sum(axis=0) / area.sum()
    return result
