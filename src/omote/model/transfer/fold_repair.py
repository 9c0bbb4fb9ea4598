"""Turns back the triangles that a displacement has turned over (method.md, section 3, step 3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]
Indices = NDArray[np.int32]
Mask = NDArray[np.bool_]

# Weight of a bad triangle's wanted gradient, and of the anchor that keeps vertices where they are, near and far.
BAD, NEAR, FAR = 3.0, 0.1, 0.02
_STEPS = 80


@dataclass(frozen=True, eq=False)
class Sheet:
    """A face's sheet ready to be unfolded.

    triangles (T, 3); starts (V + 1,), fans: the triangles around each vertex; normals (T, 3) at rest, not unit;
    gradients
    (T, 3, 2): the derivative of each corner's hat along two in-plane directions; plane (T, 3, 2): these directions;
    turns (T, 3, 3): from the generic face's triangle to this one's; source (T, 3, 3): inverse frames of the generic
    face.
    """

    triangles: Indices
    starts: Indices
    fans: Indices
    normals: Values
    gradients: Values
    plane: Values
    turns: Values
    source: Values


def sheet_of(generic: Values, positions: Values, triangles: Indices, /) -> Sheet:
    """The sheet of a face with positions (V, 3), for displacements of the generic face with positions (V, 3)."""
    order = np.argsort(triangles.ravel(), kind="stable")
    starts = np.concatenate([[0], np.cumsum(np.bincount(triangles.ravel(), minlength=len(positions)))])
    here, there = frames(generic, triangles), frames(positions, triangles)
    inverse = np.linalg.inv(here).astype(np.float64)
    gradients, plane = _gradients(positions, triangles)
    return Sheet(
        triangles, starts.astype(np.int32), (order // 3).astype(np.int32), _normals(positions, triangles), gradients,
        plane,
        nearest_turns(there @ inverse), inverse,
    )  # fmt: skip


def frames(positions: Values, triangles: Indices, /) -> Values:
    """Two edges and the scaled normal of each triangle as columns: (T, 3, 3) (Sumner & Popovic 2004, section 3)."""
    a, b, c = positions.T[:, triangles.T].transpose(1, 0, 2)
    first, second = b - a, c - a
    normal = np.stack([
        first[1] * second[2] - first[2] * second[1],
        first[2] * second[0] - first[0] * second[2],
        first[0] * second[1] - first[1] * second[0],
    ])  # fmt: skip
    normal /= np.sqrt(np.sqrt((normal * normal).sum(axis=0)))
    return np.stack([first, second, normal], axis=2).transpose(1, 0, 2)


def nearest_turns(matrices: Values, /) -> Values:
    """The rotation nearest to each matrix (T, 3, 3), by polar decomposition."""
    u, _, vt = np.linalg.svd(matrices)
    u[:, :, 2] *= np.sign(np.linalg.det(u @ vt))[:, None]
    result: Values = u @ vt
    return result


def _normals(positions: Values, triangles: Indices) -> Values:
    a, b, c = positions[triangles].transpose(1, 0, 2)
    result: Values = np.cross(b - a, c - a)
    return result


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
def turned_over(positions: Values, triangles: Indices, rest: Values, out: Mask) -> int:
    """Marks in out (T,) the triangles whose normal points against that at rest (T, 3); returns how many."""
    count = 0
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        ax, ay, az = (
            positions[j, 0] - positions[i, 0],
            positions[j, 1] - positions[i, 1],
            positions[j, 2] - positions[i, 2],
        )
        bx, by, bz = (
            positions[k, 0] - positions[i, 0],
            positions[k, 1] - positions[i, 1],
            positions[k, 2] - positions[i, 2],
        )
        along = (ay * bz - az * by) * rest[t, 0] + (az * bx - ax * bz) * rest[t, 1] + (ax * by - ay * bx) * rest[t, 2]
        out[t] = along < 0.0
        count += out[t]
    return count


@njit(cache=True)
def _grown(bad: Mask, rings: int, triangles: Indices, starts: Indices, fans: Indices) -> Mask:
    patch = bad.copy()
    for _ in range(rings):
        for t in np.flatnonzero(patch):
            for v in triangles[t]:
                patch[fans[starts[v] : starts[v + 1]]] = True
    return patch


@njit(cache=True)
def _free(
    patch: NDArray[np.int64], count: int, triangles: Indices, starts: Indices, fans: Indices, held: Mask
) -> Indices:  # fmt: skip
    """Each vertex's place among those, not held, all of whose triangles lie in the patch, or -1: (V,)."""
    inside, place = np.zeros(count, np.bool_), np.full(len(starts) - 1, -1, np.int32)
    inside[patch] = True
    found = 0
    for t in patch:
        for v in triangles[t]:
            if place[v] == -1 and not held[v] and inside[fans[starts[v] : starts[v + 1]]].all():
                place[v] = found
                found += 1
    return place


@njit(cache=True)
def _wanted(t: int, turns: Values, source: Values, plane: Values, moved: Values, corners: Indices, out: Values) -> None:
    """The source's deformation gradient of a triangle, turned to the face, along its in-plane directions: out (2,
    3)."""
    frame = np.empty((3, 3))
    for c in range(3):
        frame[c, 0] = moved[corners[1], c] - moved[corners[0], c]
        frame[c, 1] = moved[corners[2], c] - moved[corners[0], c]
    normal = np.cross(frame[:, 0].copy(), frame[:, 1].copy())
    size = np.sqrt(np.sqrt((normal * normal).sum()))
    frame[:, 2] = normal / max(size, 1e-12)
    gradient = turns[t] @ (frame @ source[t]) @ np.ascontiguousarray(turns[t].T)
    for k in range(2):
        for c in range(3):
            out[k, c] = (
                gradient[c, 0] * plane[t, 0, k] + gradient[c, 1] * plane[t, 1, k] + gradient[c, 2] * plane[t, 2, k]
            )


@njit(cache=True)
def relax(
    positions: Values, moved: Values, bad: Mask, held: Mask, rings: int, anchor: float, triangles: Indices, starts:
    Indices,
    fans: Indices, gradients: Values, plane: Values, turns: Values, source: Values,
) -> None:  # fmt: skip
    """One round: the bad triangles want the source's gradients, those around keep theirs; least squares, in place.

    positions (V, 3) of the face, moved (V, 3) of the generic face wearing the expression; held (V,) vertices stay.
    """
    patch = np.flatnonzero(_grown(bad, rings, triangles, starts, fans))
    place = _free(patch, len(triangles), triangles, starts, fans, held)
    pull, diagonal = np.zeros((place.max() + 1, 3)), np.zeros(place.max() + 1)
    if len(pull) == 0:
        return
    corners, slopes, weights = np.empty((len(patch), 3), np.int32), gradients[patch], np.ones(len(patch))
    want = np.empty((2, 3))
    for n in range(len(patch)):
        t = patch[n]
        for k in range(3):
            corners[n, k] = place[triangles[t, k]]
        if bad[t]:
            weights[n] = BAD
            # The others keep their gradients: only what the bad ones lack pulls.
            _wanted(t, turns, source, plane, moved, triangles[t], want)
            _pull(want, slopes[n], positions, triangles[t], corners[n], pull)
        _add_diagonal(weights[n], slopes[n], corners[n], diagonal)
    shift = anchor * diagonal.mean()
    step = _solved(pull, diagonal + shift, shift, corners, slopes, weights)
    for v in range(len(place)):
        if place[v] >= 0:
            positions[v] += step[place[v]]


@njit(cache=True)
def _pull(want: Values, slopes: Values, positions: Values, triangle: Indices, corners: Indices, pull: Values) -> None:
    for d in range(2):
        for k in range(3):
            want[d] -= slopes[k, d] * positions[triangle[k]]
    for k in range(3):
        if corners[k] >= 0:
            pull[corners[k]] += BAD * (slopes[k, 0] * want[0] + slopes[k, 1] * want[1])


@njit(cache=True)
def _add_diagonal(weight: float, slopes: Values, corners: Indices, diagonal: Values) -> None:
    for k in range(3):
        if corners[k] >= 0:
            diagonal[corners[k]] += weight * (slopes[k] ** 2).sum()


@njit(cache=True)
def _applied(x: Values, shift: float, corners: Indices, slopes: Values, weights: Values, out: Values) -> None:
    out[:] = shift * x
    slope = np.empty(3)
    for n in range(len(corners)):
        for d in range(2):
            slope[:] = 0.0
            for k in range(3):
                p = corners[n, k]
                if p >= 0:
                    for c in range(3):
                        slope[c] += slopes[n, k, d] * x[p, c]
            _spread(weights[n], slopes[n, :, d], slope, corners[n], out)


@njit(cache=True, inline="always")
def _spread(weight: float, slopes: Values, slope: Values, corners: Indices, out: Values) -> None:
    for k in range(3):
        p = corners[k]
        if p >= 0:
            for c in range(3):
                out[p, c] += weight * slopes[k] * slope[c]


@njit(cache=True)
def _solved(
    pull: Values, diagonal: Values, shift: float, corners: Indices, slopes: Values, weights: Values
) -> Values:  # fmt: skip
    """Conjugate gradients, preconditioned by the diagonal."""
    x, applied, rest = np.zeros_like(pull), np.empty_like(pull), pull.copy()
    scale = np.expand_dims(1.0 / diagonal, 1)
    scaled = rest * scale
    direction, energy = scaled.copy(), (rest * scaled).sum()
    goal = 1e-10 * energy
    for _ in range(_STEPS):
        if energy <= goal:
            break
        _applied(direction, shift, corners, slopes, weights, applied)
        share = energy / (direction * applied).sum()
        x += share * direction
        rest -= share * applied
        scaled = rest * scale
        after = (rest * scaled).sum()
        direction = scaled + (after / energy) * direction
        energy = after
    return x
