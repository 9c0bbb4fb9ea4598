"""Repairs folds: turns back the triangles that a displacement has turned over (docs/method.md, "Fold repair").

Gradient-domain editing of small patches: weighted least squares on deformation gradients (Sumner & Popovic 2004),
solved by conjugate gradients. A patch changes with every compound, so nothing is factorised. What that leaves folded,
position based dynamics turn back triangle by triangle (Mueller et al. 2007).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from omote.arrays import Indices, Mask, Values
from omote.geometry.conjugate_gradients import solve_conjugate_gradients
from omote.geometry.orientation import area_shares, repair_triangles

# Weight of a folded triangle's target gradient.
FOLDED = 3.0
# Rounds with the lines held, and then with the lines free: how many, how many rings of triangles around a fold are free
# to move, and the weight of the anchor that keeps vertices where they are.
HELD_ROUNDS = 6
NEAR_RINGS = 2
NEAR = 0.1
FREE_ROUNDS = 8
FAR_RINGS = 3
FAR = 0.02
# Then what is still folded: how many rounds, of how many steps, on how many rings; a triangle gets this share of its
# area.
LAST_ROUNDS = 12
STEPS = 10
LAST_RINGS = 3
REPAIRED_AREA = 0.05
# What is repaired keeps more than this share of its area: single precision, in which skin is kept, would turn it over.
ROUNDED = 1e-4


@dataclass(frozen=True, eq=False)
class SheetGeometry:
    """The triangles of a face's sheet, and how they differ from the generic face's.

    triangles (T, 3); starts (V + 1,), fans: the triangles around each vertex; normals, generic_normals (T, 3): at rest,
    twice the areas long; gradients (T, 3, 2): the derivative of each corner's hat function along two in-plane
    directions, plane (T, 3, 2); rotations (T, 3, 3): from the generic face's triangle to this one's; inverse_frames
    (T, 3, 3): of the generic face.
    """

    triangles: Indices
    starts: Indices
    fans: Indices
    normals: Values
    generic_normals: Values
    gradients: Values
    plane: Values
    rotations: Values
    inverse_frames: Values


def build_sheet_geometry(generic: Values, positions: Values, triangles: Indices, /) -> SheetGeometry:
    """The sheet of a face with positions (V, 3), for displacements of the generic face with positions (V, 3).

    triangles: rows (F, 3) of vertices.
    """
    order = np.argsort(triangles.ravel(), kind="stable")
    starts = np.concatenate([[0], np.cumsum(np.bincount(triangles.ravel(), minlength=len(positions)))])
    here = triangle_frames(generic, triangles)
    there = triangle_frames(positions, triangles)
    inverse = np.linalg.inv(here).astype(np.float64)
    gradients, plane = _gradients(positions, triangles)
    return SheetGeometry(
        triangles, starts.astype(np.int32), (order // 3).astype(np.int32), _normals(positions, triangles),
        _normals(generic, triangles), gradients, plane, nearest_rotations(there @ inverse), inverse,
    )  # fmt: skip


def repair(
    geometry: SheetGeometry, positions: Values, source: Values, on_line: Mask, close: Callable[[Values], None], /
) -> Values:
    """Positions (V, 3) with fewer folded triangles, or the same array where none is folded.

    geometry: the sheet of the face; positions: (V, 3), metres.

    source (V, 3): the generic face wearing the expression; on_line (V,): the vertices of lids' and lips' lines, held in
    the first rounds; close: brings them into contact again, in place, once they move too. The best round counts.
    """
    free = np.zeros_like(on_line)
    folded = find_folds(geometry, positions, source, ROUNDED)
    best = positions
    fewest = int(folded.sum())
    for number in range(HELD_ROUNDS + FREE_ROUNDS + LAST_ROUNDS):
        if fewest == 0:
            break
        if number == HELD_ROUNDS + FREE_ROUNDS:
            positions = best
            folded = find_folds(geometry, best, source, ROUNDED)
        positions = positions.copy()
        if number < HELD_ROUNDS:
            relax_patches(geometry, positions, source, folded, on_line, NEAR_RINGS, NEAR)
        else:
            if number < HELD_ROUNDS + FREE_ROUNDS:
                relax_patches(geometry, positions, source, folded, free, FAR_RINGS, FAR)
            else:
                repair_patch(geometry, positions, source, folded)
            close(positions)
        folded = find_folds(geometry, positions, source, ROUNDED)
        if folded.sum() < fewest:
            best = positions
            fewest = int(folded.sum())
    return best


def find_folds(geometry: SheetGeometry, positions: Values, source: Values, least: float = 0.0, /) -> Mask:
    """The sheet triangles (T,) turned over on the face (V, 3) but not on the source (V, 3), the generic face; or that
    keep less than the least share of their area along the normal at rest.

    geometry: the sheet of the face; positions: (V, 3), metres.
    """
    here = np.empty(len(geometry.triangles), np.bool_)
    mark_folds(positions, geometry.triangles, geometry.normals, least, here)
    return here & ~_find_source_folds(geometry, source)


def _find_source_folds(geometry: SheetGeometry, source: Values) -> Mask:
    folded = np.empty(len(geometry.triangles), np.bool_)
    mark_folds(source, geometry.triangles, geometry.generic_normals, 0.0, folded)
    return folded


def relax_patches(
    geometry: SheetGeometry, positions: Values, source: Values, folded: Mask, held: Mask, rings: int, anchor: float, /
) -> None:
    """Relaxes once, in place, patches of so many rings around folded (T,) triangles, least squares.

    geometry: the sheet of the face; positions: (V, 3), metres; anchor: how firmly vertices stay where they are, a share
    of the mean diagonal.

    Folded triangles take the source's gradients, those around keep theirs; vertices that are held (V,) stay.
    """
    place, pull, diagonal, corners, slopes, weights, mean = _gather_system(
        positions, source, folded, held, rings, geometry.triangles, geometry.starts, geometry.fans,
        geometry.gradients, geometry.plane, geometry.rotations, geometry.inverse_frames,
    )  # fmt: skip
    if len(pull) == 0:
        return
    step = solve_conjugate_gradients(pull, diagonal + anchor * mean, anchor * mean, corners, slopes, weights)
    inside = place >= 0
    positions[inside] += step[place[inside]]


def repair_patch(geometry: SheetGeometry, positions: Values, source: Values, folded: Mask, /) -> None:
    """Repairs once, in place, folded (T,) triangles up to REPAIRED_AREA, along their normal at rest; those around
    keep as much where they have it; what is folded on the source (V, 3) may stay (position based dynamics).

    geometry: the sheet of the face; positions: (V, 3), metres.
    """
    grown = _grow_patch(folded, LAST_RINGS, geometry.triangles, geometry.starts, geometry.fans)
    patch = np.flatnonzero(grown & ~_find_source_folds(geometry, source))
    corners = geometry.triangles[patch]
    normals = geometry.normals[patch]
    sizes = (normals**2).sum(axis=1)
    shares = area_shares(positions, normals, sizes, corners)
    goals = np.where(folded[patch], REPAIRED_AREA, np.minimum(REPAIRED_AREA, shares))
    repair_triangles(positions, normals, sizes, corners, goals, STEPS)


def warm_repair() -> None:
    """Runs on a square what only compounds with folds go through, so that its kernels are compiled or loaded: the first
    fold of a show would wait for them."""
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0]])
    fan = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], np.int32)
    fan.flags.writeable = False  # as of a space: numba compiles for each of both
    geometry = build_sheet_geometry(square, square, fan)
    moved = square + np.array([[0.0], [0], [0], [0], [1]]) * [1.0, 0, 0]
    folded = find_folds(geometry, moved, square)
    repair_patch(geometry, moved.copy(), square, folded)
    relax_patches(geometry, moved, square, folded, np.zeros(len(square), np.bool_), NEAR_RINGS, NEAR)


def triangle_frames(positions: Values, triangles: Indices, /) -> Values:
    """Two edges and the scaled normal of each triangle as columns: (T, 3, 3) (Sumner & Popovic 2004, section 3).

    positions: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    a, b, c = positions.T[:, triangles.T].transpose(1, 0, 2)
    first = b - a
    second = c - a
    normal = np.stack([
        first[1] * second[2] - first[2] * second[1],
        first[2] * second[0] - first[0] * second[2],
        first[0] * second[1] - first[1] * second[0],
    ])  # fmt: skip
    normal /= np.sqrt(np.sqrt((normal * normal).sum(axis=0)))
    return np.stack([first, second, normal], axis=2).transpose(1, 0, 2)


def nearest_rotations(matrices: Values, /) -> Values:
    """The rotation nearest to each matrix (T, 3, 3), by polar decomposition."""
    u, _, vt = np.linalg.svd(matrices)
    u[:, :, 2] *= np.sign(np.linalg.det(u @ vt))[:, None]
    return u @ vt


def _normals(positions: Values, triangles: Indices) -> Values:
    a, b, c = positions[triangles].transpose(1, 0, 2)
    return np.cross(b - a, c - a)


def _gradients(positions: Values, triangles: Indices) -> tuple[Values, Values]:
    a, b, c = positions[triangles].transpose(1, 0, 2)
    first = (b - a) / np.linalg.norm(b - a, axis=1, keepdims=True)
    normal = np.cross(b - a, c - a)
    second = np.cross(normal / np.linalg.norm(normal, axis=1, keepdims=True), first)
    bx, cx, cy = ((b - a) * first).sum(axis=1), ((c - a) * first).sum(axis=1), ((c - a) * second).sum(axis=1)
    of_b = np.stack([1.0 / bx, -cx / (bx * cy)], axis=1)
    of_c = np.stack([np.zeros_like(cy), 1.0 / cy], axis=1)
    return np.stack([-of_b - of_c, of_b, of_c], axis=1), np.stack([first, second], axis=2)


@njit(cache=True)
def mark_folds(positions: Values, triangles: Indices, rest: Values, least: float, out: Mask) -> None:
    """Marks in out (T,) the triangles that keep less than this share of their area along the normal at rest (T, 3).

    positions: (V, 3), metres; least: the share of the area.
    """
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        a, b, c = positions[i], positions[j], positions[k]
        ax, ay, az = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        bx, by, bz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
        along = (ay * bz - az * by) * rest[t, 0] + (az * bx - ax * bz) * rest[t, 1] + (ax * by - ay * bx) * rest[t, 2]
        size = rest[t, 0] * rest[t, 0] + rest[t, 1] * rest[t, 1] + rest[t, 2] * rest[t, 2]
        out[t] = along < least * size


@njit(cache=True)
def _grow_patch(folded: Mask, rings: int, triangles: Indices, starts: Indices, fans: Indices) -> Mask:
    patch = folded.copy()
    for _ in range(rings):
        for t in np.flatnonzero(patch):
            for v in triangles[t]:
                patch[fans[starts[v] : starts[v + 1]]] = True
    return patch


@njit(cache=True)
def _number_unknowns(
    patch: NDArray[np.int64], count: int, triangles: Indices, starts: Indices, fans: Indices, held: Mask
) -> Indices:
    """Each vertex's place among those, not held, all of whose triangles lie in the patch, or -1: (V,)."""
    inside = np.zeros(count, np.bool_)
    place = np.full(len(starts) - 1, -1, np.int32)
    inside[patch] = True
    count_unknowns = 0
    for t in patch:
        for v in triangles[t]:
            if place[v] == -1 and not held[v] and inside[fans[starts[v] : starts[v + 1]]].all():
                place[v] = count_unknowns
                count_unknowns += 1
    return place


@njit(cache=True)
def _target_gradient(
    t: int, rotations: Values, inverse_frames: Values, plane: Values, moved: Values, corners: Indices, out: Values
) -> None:
    """Writes the source's deformation gradient of a triangle, rotated to the face, along its plane: out (2, 3)."""
    frame = np.empty((3, 3))
    for c in range(3):
        frame[c, 0] = moved[corners[1], c] - moved[corners[0], c]
        frame[c, 1] = moved[corners[2], c] - moved[corners[0], c]
    normal = np.cross(frame[:, 0].copy(), frame[:, 1].copy())
    size = np.sqrt(np.sqrt((normal * normal).sum()))
    frame[:, 2] = normal / max(size, 1e-12)
    gradient = rotations[t] @ (frame @ inverse_frames[t]) @ np.ascontiguousarray(rotations[t].T)
    p = plane[t]
    for k in range(2):
        for c in range(3):
            out[k, c] = gradient[c, 0] * p[0, k] + gradient[c, 1] * p[1, k] + gradient[c, 2] * p[2, k]


@njit(cache=True)
def _gather_system(
    positions: Values, moved: Values, folded: Mask, held: Mask, rings: int, triangles: Indices, starts: Indices,
    fans: Indices, gradients: Values, plane: Values, rotations: Values, inverse_frames: Values,
) -> tuple[Indices, Values, Values, Indices, Values, Values, float]:  # fmt: skip
    """The least squares of `relax_patches`: each vertex's unknown (V,), right side and diagonal, the patch's triangles.

    moved (V, 3): the source; of the triangles: their unknowns (P, 3), gradients (P, 3, 2) and weights (P,).
    """
    patch = np.flatnonzero(_grow_patch(folded, rings, triangles, starts, fans))
    place = _number_unknowns(patch, len(triangles), triangles, starts, fans, held)
    pull = np.zeros((place.max() + 1, 3))
    diagonal = np.zeros(place.max() + 1)
    corners = np.empty((len(patch), 3), np.int32)
    slopes = gradients[patch]
    weights = np.ones(len(patch))
    target = np.empty((2, 3))
    for n in range(len(patch)):
        t = patch[n]
        for k in range(3):
            corners[n, k] = place[triangles[t, k]]
        if folded[t]:
            weights[n] = FOLDED
            # The others keep their gradients: only the residual of the folded ones pulls.
            _target_gradient(t, rotations, inverse_frames, plane, moved, triangles[t], target)
            _add_residual(target, slopes[n], positions, triangles[t], corners[n], pull)
        _add_diagonal(weights[n], slopes[n], corners[n], diagonal)
    return place, pull, diagonal, corners, slopes, weights, diagonal.sum() / max(len(diagonal), 1)


@njit(cache=True)
def _add_residual(
    target: Values, slopes: Values, positions: Values, triangle: Indices, corners: Indices, pull: Values
) -> None:
    for d in range(2):
        for k in range(3):
            target[d] -= slopes[k, d] * positions[triangle[k]]
    for k in range(3):
        if corners[k] >= 0:
            pull[corners[k]] += FOLDED * (slopes[k, 0] * target[0] + slopes[k, 1] * target[1])


@njit(cache=True)
def _add_diagonal(weight: float, slopes: Values, corners: Indices, diagonal: Values) -> None:
    for k in range(3):
        if corners[k] >= 0:
            diagonal[corners[k]] += weight * (slopes[k] ** 2).sum()
