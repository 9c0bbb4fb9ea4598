"""Point location in a triangulation by a visibility walk from triangle to triangle.

Two views of the same triangulation are walked: the flat one (S itself) and the one that a horizontal ray from the axis
sees (a face in space). In both a walk leaves a triangle across the edge that the point lies farthest behind.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit

from omote.arrays import Indices, Mask, Values

# Barycentric slack: points on an edge belong to both triangles, whatever the last bits say.
SLACK = 1e-9
# Triangles searched around a vertex whose walk a fold has stopped: a patch the size of a cheek on the built-in head.
SEARCHED_TRIANGLES = 4000
# Barycentric reach beyond a rim's last triangle.
FARTHEST = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Landing:
    """Where points came down: triangles (N,), weights (N, 3) summing to one, inside (N,) False where a walk left the
    rim or gave up."""

    triangles: Indices
    weights: Values
    inside: Mask


@dataclass(frozen=True, slots=True, eq=False)
class Strip:
    """A triangulation of a strip that is periodic in its first coordinate, ready to be walked.

    theta, h (F, 3) corners, each triangle unwrapped by itself; neighbours (F, 3) across the opposite edge or -1.
    """

    frames: Values
    neighbours: Indices

    @staticmethod
    def of(theta: Values, h: Values, neighbours: Indices) -> Strip:
        """The strip of corners theta, h (F, 3); triangles must have area (raises ValueError).

        neighbours: (F, 3): the triangle across the edge opposite to each corner, -1 for none.
        """
        ux, uy = theta[:, 1] - theta[:, 0], h[:, 1] - h[:, 0]
        vx, vy = theta[:, 2] - theta[:, 0], h[:, 2] - h[:, 0]
        det = ux * vy - uy * vx
        flat = np.flatnonzero(det <= 0)
        if len(flat):
            raise ValueError(f"triangle {flat[0]} has no positive area on S; expected a sheet without folds")
        frames = np.stack([theta[:, 0], h[:, 0], vy / det, -vx / det, -uy / det, ux / det, theta.mean(axis=1)], axis=1)
        return Strip(np.ascontiguousarray(frames), np.ascontiguousarray(neighbours))

    def locate(self, theta: Values, h: Values, start: Indices, /, *, leaders: Indices | None = None) -> Landing:
        """The triangles that hold the points (theta, h) (N,), walking from the triangles start (N,).

        leaders (N,): an earlier point that comes down nearby, or -1; it shortens the walk.
        """
        count = len(theta)
        leaders = np.full(count, -1, np.int32) if leaders is None else leaders
        triangles = np.empty(count, np.int32)
        weights = np.empty((count, 3))
        inside = np.empty(count, np.bool_)
        walk_strip(self.frames, self.neighbours, theta, h, start, leaders, triangles, weights, inside)
        return Landing(triangles, weights, inside)


@njit(cache=True, inline="always")
def _turn_to(theta: float, middle: float) -> float:
    turns: float = np.round((theta - middle) / (2 * np.pi))
    return theta - 2 * np.pi * turns


@njit(cache=True)
def _flat(frames: Values, t: int, theta: float, h: float, b: Values) -> None:
    x = _turn_to(theta, frames[t, 6]) - frames[t, 0]
    y = h - frames[t, 1]
    b[1] = frames[t, 2] * x + frames[t, 3] * y
    b[2] = frames[t, 4] * x + frames[t, 5] * y
    b[0] = 1.0 - b[1] - b[2]


@njit(cache=True, inline="always")
def _way_on(neighbours: Indices, t: int, before: int, b: Values) -> int:
    """The triangle across the edge that the point lies farthest behind, -1 at the rim; never the one before, if any:
    over a fold a walk would go to and fro for ever."""
    onward = -1
    worst = -SLACK
    for k in range(3):
        if neighbours[t, k] >= 0 and neighbours[t, k] != before and b[k] < worst:
            onward = neighbours[t, k]
            worst = b[k]
    return onward


@njit(cache=True)
def _walk_flat(
    frames: Values, neighbours: Indices, theta: float, h: float, t: int, b: Values, budget: int
) -> tuple[int, bool]:
    for _ in range(budget):
        _flat(frames, t, theta, h, b)
        if b[0] >= -SLACK and b[1] >= -SLACK and b[2] >= -SLACK:
            return t, True
        onward = _way_on(neighbours, t, -1, b)
        if onward < 0:
            return t, False
        t = onward
    return -1, False


@njit(cache=True)
def _scan_flat(frames: Values, theta: float, h: float, b: Values) -> int:
    """The triangle that holds the point, by looking at all: S has one layer, so a walk that circles may be answered
    so."""
    for t in range(len(frames)):
        _flat(frames, t, theta, h, b)
        if b[0] >= -SLACK and b[1] >= -SLACK and b[2] >= -SLACK:
            return t
    return -1


@njit(cache=True, inline="always")
def _copy(b: Values, out: Values) -> None:
    """Copies three weights; an array assignment takes numba seconds to compile."""
    for k in range(3):
        out[k] = b[k]


@njit(cache=True)
def _rein_in(weights: Values) -> None:
    """Pulls the weights (3,) of a missed triangle toward its centroid until none is below -FARTHEST: slivers shoot
    far."""
    low = min(weights[0], min(weights[1], weights[2]))
    if low < -FARTHEST:
        share = (FARTHEST + 1.0 / 3.0) / (1.0 / 3.0 - low)
        for k in range(3):
            weights[k] = 1.0 / 3.0 + share * (weights[k] - 1.0 / 3.0)


@njit(cache=True)
def walk_strip(
    frames: Values, neighbours: Indices, theta: Values, h: Values, start: Indices, leaders: Indices,
    triangles: Indices, weights: Values, inside: Mask,
) -> None:  # fmt: skip
    """Writes triangles, weights and inside: the kernel of `Strip.locate`.

    frames: (F, 7), of `Strip`; neighbours: (F, 3): the triangle across the edge opposite to each corner, -1 for none;
    theta: of the targets (N,), radians; h: of the targets (N,), metres; leaders: (N,) the point whose triangle is tried
    first, -1 for none.

    A leader's triangle is tried before the start, so that a walk is as short on a fine mesh as on a coarse one; S has
    one layer, so the point found is the same.
    """
    b = np.empty(3)
    budget = 200 + 4 * int(np.sqrt(len(frames)))
    for i in range(len(theta)):
        led = leaders[i] >= 0 and inside[leaders[i]]
        first = triangles[leaders[i]] if led else start[i]
        t, inside_it = _walk_flat(frames, neighbours, theta[i], h[i], first, b, budget)
        if led and not inside_it:
            t, inside_it = _walk_flat(frames, neighbours, theta[i], h[i], start[i], b, budget)
        if t < 0:
            t = _scan_flat(frames, theta[i], h[i], b)
            inside_it = t >= 0
            if not inside_it:
                t = start[i]
                _flat(frames, t, theta[i], h[i], b)
        triangles[i] = t
        inside[i] = inside_it
        _copy(b, weights[i])
        if not inside_it:
            _rein_in(weights[i])


@njit(cache=True)
def _hit_by_ray(points: Values, corners: Indices, ray: Values, b: Values) -> bool:
    """Barycentric coordinates where a ray from the axis meets the triangle's plane; False where it does not.

    ray: axis x, axis z, sine and cosine of theta, height.
    """
    u0, w0, depth0 = _by_ray(points, corners[0], ray)
    u1, w1, depth1 = _by_ray(points, corners[1], ray)
    u2, w2, depth2 = _by_ray(points, corners[2], ray)
    b[0], b[1], b[2] = u1 * w2 - u2 * w1, u2 * w0 - u0 * w2, u0 * w1 - u1 * w0
    total = b[0] + b[1] + b[2]
    if abs(total) < 1e-30:
        return False
    for k in range(3):
        b[k] /= total
    return bool(b[0] * depth0 + b[1] * depth1 + b[2] * depth2 > 0.0)


@njit(cache=True, inline="always")
def _by_ray(points: Values, corner: int, ray: Values) -> tuple[float, float, float]:
    """A corner beside a ray, above it, and along it: numbers, for arrays would be allocated for each triangle."""
    dx, dz = points[corner, 0] - ray[0], points[corner, 2] - ray[1]
    return dx * ray[3] - dz * ray[2], points[corner, 1] - ray[4], dx * ray[2] + dz * ray[3]


@njit(cache=True, inline="always")
def _lowest(b: Values) -> float:
    return float(min(b[0], min(b[1], b[2])))


@njit(cache=True)
def _walk_by_ray(
    points: Values, triangles: Indices, neighbours: Indices, ray: Values, t: int, budget: int, best: Values
) -> tuple[int, bool]:
    """Walks until the ray meets a triangle; else returns the one it missed least (weights in best)."""
    b = np.empty(3)
    nearest = -1
    miss = -1e300
    before = -1
    for _ in range(budget):
        ahead = _hit_by_ray(points, triangles[t], ray, b)
        if ahead and _lowest(b) > miss:
            nearest = t
            miss = _lowest(b)
            _copy(b, best)
        if ahead and miss >= -SLACK:
            return t, True
        onward = _way_on(neighbours, t, before, b)
        if onward < 0:
            break
        before = t
        t = onward
    return nearest, False


@njit(cache=True)
def _search_by_ray(
    points: Values, triangles: Indices, neighbours: Indices, ray: Values, start: int, stamp: int,
    seen: Indices, queue: Indices, best: Values,
) -> tuple[int, bool]:  # fmt: skip
    """The triangle that the ray meets fewest steps across edges from start; else the one it missed least."""
    b = np.empty(3)
    nearest = -1
    miss = -1e300
    head = 0
    tail = 1
    queue[0] = start
    seen[start] = stamp
    while head < tail and miss < -SLACK:
        t = queue[head]
        head += 1
        if _hit_by_ray(points, triangles[t], ray, b) and _lowest(b) > miss:
            nearest = t
            miss = _lowest(b)
            _copy(b, best)
        for k in range(3):
            other = neighbours[t, k]
            if other >= 0 and seen[other] != stamp and tail < len(queue):
                seen[other] = stamp
                queue[tail] = other
                tail += 1
    return nearest, miss >= -SLACK


@njit(cache=True)
def walk_face(
    points: Values, corners: Indices, neighbours: Indices, axis_x: float, axis_z: float, targets: Values,
    start: Indices, triangles: Indices, weights: Values, inside: Mask,
) -> None:  # fmt: skip
    """Slides targets (N, 3) along their cylinder radius onto a face with points (V, 3) (docs/method.md, "Extract").

    corners: (F, 3) rows of the triangles; neighbours: (F, 3): the triangle across the edge opposite to each corner, -1
    for none; axis_x, axis_z: of the cylinder, metres.

    start (N,): a triangle around the vertex that each target belongs to. Where folds stop the walk, triangles around it
    are searched in order of their steps from the start, so that a neighbouring layer of skin never answers before the
    vertex's own. Writes triangles (N,), weights (N, 3), inside (N,).
    """
    best = np.empty(3)
    ray = np.empty(5)
    budget = 200 + 4 * int(np.sqrt(len(corners)))
    seen = np.full(len(corners), -1, np.int32)
    queue = np.empty(min(len(corners), SEARCHED_TRIANGLES), np.int32)
    for i in range(len(targets)):
        dx, dz = targets[i, 0] - axis_x, targets[i, 2] - axis_z
        r = np.sqrt(dx * dx + dz * dz)
        ray[0], ray[1], ray[2], ray[3], ray[4] = axis_x, axis_z, dx / r, dz / r, targets[i, 1]
        t, met = _walk_by_ray(points, corners, neighbours, ray, start[i], budget, best)
        if not met:
            t, met = _search_by_ray(points, corners, neighbours, ray, start[i], i, seen, queue, best)
        if t < 0:
            t = start[i]
            best[0] = best[1] = best[2] = 1.0 / 3.0
        triangles[i] = t
        inside[i] = met
        _copy(best, weights[i])
        if not met:
            _rein_in(weights[i])
