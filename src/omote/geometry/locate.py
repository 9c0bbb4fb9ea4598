"""Finds points in a triangulation by walking from triangle to triangle.

Two pictures of the same triangulation are walked: the flat one (S itself) and the one a horizontal ray sees from the axis
(a face in space). In both a walk leaves a triangle across the edge that the point lies farthest behind.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# Barycentric slack: points on an edge belong to both triangles, whatever the last bits say.
SLACK = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Landing:
    """Where points came down: triangles (N,), weights (N, 3) summing to one, inside (N,) False where a walk left the rim or gave up."""

    triangles: Indices
    weights: Values
    inside: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Strip:
    """A triangulation of a strip that is periodic in its first coordinate, ready to be walked.

    theta, h (F, 3) corners, each triangle unwrapped by itself; neighbours (F, 3) across the opposite edge or -1.
    """

    frames: Values
    neighbours: Indices

    @staticmethod
    def of(theta: Values, h: Values, neighbours: Indices) -> Strip:
        """The strip of corners theta, h (F, 3); triangles must have area (raises ValueError)."""
        ux, uy = theta[:, 1] - theta[:, 0], h[:, 1] - h[:, 0]
        vx, vy = theta[:, 2] - theta[:, 0], h[:, 2] - h[:, 0]
        det = ux * vy - uy * vx
        flat = np.flatnonzero(det <= 0)
        if len(flat):
            raise ValueError(f"triangle {flat[0]} has no positive area on S; expected a sheet without folds")
        frames = np.stack([theta[:, 0], h[:, 0], vy / det, -vx / det, -uy / det, ux / det, theta.mean(axis=1)], axis=1)
        return Strip(np.ascontiguousarray(frames), np.ascontiguousarray(neighbours))

    def locate(self, theta: Values, h: Values, start: Indices, /) -> Landing:
        """The triangles that hold the points (theta, h) (N,), walking from the triangles start (N,)."""
        count = len(theta)
        triangles, weights, inside = np.empty(count, np.int32), np.empty((count, 3)), np.empty(count, np.bool_)
        walk_strip(self.frames, self.neighbours, theta, h, start, triangles, weights, inside)
        return Landing(triangles, weights, inside)


@njit(cache=True, inline="always")
def _turn_to(theta: float, middle: float) -> float:
    turned = theta - middle
    return middle + turned - 2 * np.pi * np.round(turned / (2 * np.pi))


@njit(cache=True)
def _flat(frames: Values, t: int, theta: float, h: float, b: Values) -> None:
    x = _turn_to(theta, frames[t, 6]) - frames[t, 0]
    y = h - frames[t, 1]
    b[1] = frames[t, 2] * x + frames[t, 3] * y
    b[2] = frames[t, 4] * x + frames[t, 5] * y
    b[0] = 1.0 - b[1] - b[2]


@njit(cache=True, inline="always")
def _way_out(neighbours: Indices, t: int, b: Values) -> int:
    """The triangle across the edge that the point lies farthest behind; -1 at the rim."""
    onward, worst = -1, -SLACK
    for k in range(3):
        if b[k] < worst and neighbours[t, k] >= 0:
            onward, worst = neighbours[t, k], b[k]
    return onward


@njit(cache=True)
def _walk_flat(frames: Values, neighbours: Indices, theta: float, h: float, t: int, b: Values, budget: int) -> tuple[int, bool]:
    for _ in range(budget):
        _flat(frames, t, theta, h, b)
        if b[0] >= -SLACK and b[1] >= -SLACK and b[2] >= -SLACK:
            return t, True
        onward = _way_out(neighbours, t, b)
        if onward < 0:
            return t, False
        t = onward
    return -1, False


@njit(cache=True)
def _scan_flat(frames: Values, theta: float, h: float, b: Values) -> int:
    """The triangle that holds the point, by looking at all: S has one layer, so a walk that circles may be answered so."""
    for t in range(len(frames)):
        _flat(frames, t, theta, h, b)
        if b[0] >= -SLACK and b[1] >= -SLACK and b[2] >= -SLACK:
            return t
    return -1


@njit(cache=True)
def walk_strip(
    frames: Values, neighbours: Indices, theta: Values, h: Values, start: Indices,
    triangles: Indices, weights: Values, inside: NDArray[np.bool_],
) -> None:  # fmt: skip
    """Kernel of `Strip.locate`; writes triangles, weights and inside."""
    b = np.empty(3)
    budget = 200 + 4 * int(np.sqrt(len(frames)))
    for i in range(len(theta)):
        t, found = _walk_flat(frames, neighbours, theta[i], h[i], start[i], b, budget)
        if t < 0:
            t = _scan_flat(frames, theta[i], h[i], b)
            found = t >= 0
            if not found:
                t = start[i]
                _flat(frames, t, theta[i], h[i], b)
        triangles[i] = t
        inside[i] = found
        for k in range(3):
            weights[i, k] = b[k]


@njit(cache=True)
def _seen(corners: Values, axis_x: float, axis_z: float, sine: float, cosine: float, h: float, b: Values) -> bool:
    """Barycentric coordinates where the horizontal ray from the axis meets the triangle's plane; False where it does not."""
    u, w = np.empty(3), np.empty(3)
    depth = 0.0
    for k in range(3):
        dx, dz = corners[k, 0] - axis_x, corners[k, 2] - axis_z
        u[k] = dx * cosine - dz * sine
        w[k] = corners[k, 1] - h
        b[k] = dx * sine + dz * cosine
    e0, e1, e2 = u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]
    total = e0 + e1 + e2
    if abs(total) < 1e-30:
        return False
    depth = (e0 * b[0] + e1 * b[1] + e2 * b[2]) / total
    b[0], b[1], b[2] = e0 / total, e1 / total, e2 / total
    return depth > 0.0


@njit(cache=True)
def _walk_seen(
    points: Values, triangles: Indices, neighbours: Indices, axis_x: float, axis_z: float,
    sine: float, cosine: float, h: float, t: int, budget: int, b: Values, best: Values,
) -> tuple[int, bool]:  # fmt: skip
    """Walks until the ray meets a triangle; else returns the one it missed least (weights in best)."""
    corners = np.empty((3, 3))
    nearest, miss, before = -1, -1e300, -1
    for _ in range(budget):
        for k in range(3):
            for c in range(3):
                corners[k, c] = points[triangles[t, k], c]
        ahead = _seen(corners, axis_x, axis_z, sine, cosine, h, b)
        low = min(b[0], min(b[1], b[2]))
        if ahead and low > miss:
            nearest, miss = t, low
            best[:] = b
        if ahead and low >= -SLACK:
            return t, True
        onward, worst = -1, -SLACK
        for k in range(3):
            if neighbours[t, k] >= 0 and neighbours[t, k] != before and b[k] < worst:
                onward, worst = neighbours[t, k], b[k]
        if onward < 0:
            break
        before, t = t, onward
    return nearest, False


@njit(cache=True)
def walk_face(
    points: Values, corners: Indices, neighbours: Indices, axis_x: float, axis_z: float, targets: Values,
    fan_start: Indices, fan: Indices, triangles: Indices, weights: Values, inside: NDArray[np.bool_],
) -> None:  # fmt: skip
    """Slides targets (N, 3) along their cylinder radius onto the face with points (V, 3) (method.md, section 3, step 1).

    fan[fan_start[i]:fan_start[i + 1]] are the triangles around the vertex that target i belongs to; where a fold stops the
    walk from the first, the others are tried. Writes triangles (N,), weights (N, 3), inside (N,).
    """
    b, best, kept = np.empty(3), np.empty(3), np.empty(3)
    budget = 200 + 4 * int(np.sqrt(len(corners)))
    for i in range(len(targets)):
        dx, dz = targets[i, 0] - axis_x, targets[i, 2] - axis_z
        r = np.sqrt(dx * dx + dz * dz)
        sine, cosine = dx / r, dz / r
        answer, miss, found = -1, -1e300, False
        for f in range(fan_start[i], fan_start[i + 1]):
            t, found = _walk_seen(
                points, corners, neighbours, axis_x, axis_z, sine, cosine, targets[i, 1], fan[f], budget, b, best
            )
            low = min(best[0], min(best[1], best[2]))
            if t >= 0 and (found or low > miss):
                answer, miss = t, low
                kept[:] = best
            if found:
                break
        triangles[i], inside[i] = answer, found
        weights[i] = kept if answer >= 0 else np.array([1.0, 0.0, 0.0])


@njit(cache=True)
def one_layer(theta: Values, h: Values, radius: Values, width: float, height: float, keep: NDArray[np.bool_]) -> None:
    """Clears keep where a triangle of a periodic strip lies under one nearer to the eye that looks in along the radius.

    theta, h (F, 3) unwrapped corners scaled to metres, period width; radius (F,) of each triangle; height: a cell's size.
    """
    columns = max(1, int(width / height))
    lowest, highest = h.min(), h.max()
    rows = max(1, int((highest - lowest) / height) + 1)
    first = np.full((columns, rows), -1, np.int64)
    links = np.empty((len(theta) * 16, 2), np.int64)
    used = 0
    order = np.argsort(-radius)
    for t in order:
        if not keep[t]:
            continue
        left, right = theta[t].min(), theta[t].max()
        c0, c1 = int(np.floor(left / width * columns)), int(np.floor(right / width * columns))
        r0, r1 = int((h[t].min() - lowest) / height), int((h[t].max() - lowest) / height)
        covered = False
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                link = first[c % columns, r]
                while link >= 0 and not covered:
                    covered = _overlap(theta, h, t, links[link, 0], width)
                    link = links[link, 1]
        if covered:
            keep[t] = False
            continue
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                if used == len(links):
                    links = np.concatenate((links, np.empty_like(links)))
                links[used, 0], links[used, 1] = t, first[c % columns, r]
                first[c % columns, r] = used
                used += 1


@njit(cache=True)
def _overlap(theta: Values, h: Values, t: int, other: int, width: float) -> bool:
    shift = np.round((theta[t].mean() - theta[other].mean()) / width) * width
    return not (_apart(theta, h, t, other, shift) or _apart(theta, h, other, t, -shift))


@njit(cache=True)
def _apart(theta: Values, h: Values, t: int, other: int, shift: float) -> bool:
    """Whether an edge of t has all of the other triangle on its outer side (touching counts as apart)."""
    for k in range(3):
        x0, y0 = theta[t, k], h[t, k]
        x1, y1 = theta[t, (k + 1) % 3] - x0, h[t, (k + 1) % 3] - y0
        length = np.sqrt(x1 * x1 + y1 * y1)
        apart = True
        for c in range(3):
            x, y = theta[other, c] + shift - x0, h[other, c] - y0
            if x1 * y - y1 * x > 1e-9 * length:
                apart = False
        if apart:
            return True
    return False
