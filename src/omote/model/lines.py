"""Lines: where two lids, or two lips, meet; named once on the generic face (method.md, section 3)."""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import Cylinder, wrap

Kind = Literal["lids", "lips"]
Indices = NDArray[np.int32]
Values = NDArray[np.float64]

RUNGS = 32


@dataclass(frozen=True, eq=False)
class Line:
    """A closed line on the sheet around an opening, and the rungs across it.

    loop (n,): its vertices; vertices (RUNGS, 4), weights (RUNGS, 4): rung i is the weighted sum of its four
    vertices, the
    upper point minus the lower one, both at the same share of the arc from corner to corner.
    """

    name: str
    kind: Kind
    loop: Indices
    vertices: Indices
    weights: Values

    def rungs(self, positions: Values, /) -> Values:
        """Upper minus lower point of each rung, (RUNGS, 3) metres, for positions (V, 3)."""
        result: Values = np.einsum("rk,rkc->rc", self.weights, positions[self.vertices])
        return result


def find_line(
    name: str, kind: Kind, points: Values, sheet: Indices, membranes: Indices, cylinder: Cylinder, near: Values, /
) -> Line:
    """The line around the opening of the sheet whose membrane is nearest to a point.

    points (V, 3) generic, sheet (F, 3), membranes (m, 3), near (3,) metres. The line is the shortest closed path along
    edges of the sheet that goes once around the opening. Raises ValueError where there is no such path.
    """
    theta, h, r = cylinder.unroll(points)
    metric = float(r[sheet].mean())
    goal = cylinder.unroll(near)
    plane = np.stack([wrap(theta - goal[0]) * metric, h - goal[1]], axis=1)
    loop = np.array(_shortest_around(points, sheet, plane, _inside(plane, membranes)), np.int32)
    if len(loop) < 8:
        raise ValueError(
            f"no line {name!r} goes around the opening nearest to {near}; expected an opening of the sheet"
        )
    vertices, weights = _rungs(points, loop)
    return Line(name, kind, loop, vertices, weights)


def _inside(plane: Values, membranes: Indices) -> Values:
    """A point well inside the opening nearest to the plane's origin: the middle of its largest membrane triangle
    there."""
    labels = mesh.components(membranes, len(plane))[membranes[:, 0]]
    middles = plane[membranes].mean(axis=1)
    mine = labels == labels[np.hypot(*middles.T).argmin()]
    a, b = plane[membranes[:, 1]] - plane[membranes[:, 0]], plane[membranes[:, 2]] - plane[membranes[:, 0]]
    area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    result: Values = middles[np.where(mine, area, 0.0).argmax()]
    return result


def _shortest_around(points: Values, sheet: Indices, plane: Values, centre: Values) -> list[int]:
    """The shortest closed edge path that crosses a ray from the centre an odd number of times."""
    edges = np.unique(np.sort(np.stack([sheet, np.roll(sheet, -1, 1)], axis=2).reshape(-1, 2), axis=1), axis=0)
    # An opening of a face is narrower than a third of the sheet's height.
    reach = 0.2 * float(np.ptp(plane[sheet, 1]))
    edges = edges[(np.linalg.norm(plane - centre, axis=1) < reach)[edges].all(axis=1)]
    a, b = plane[edges[:, 0]] - centre, plane[edges[:, 1]] - centre
    crossing = (a[:, 1] > 0) != (b[:, 1] > 0)
    rise = np.where(crossing, b[:, 1] - a[:, 1], 1.0)
    crossing &= a[:, 0] - (b[:, 0] - a[:, 0]) * a[:, 1] / rise > 0
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    ways: dict[int, list[tuple[int, float, bool]]] = {}
    for (one, other), length, crosses in zip(edges.tolist(), lengths.tolist(), crossing.tolist(), strict=True):
        ways.setdefault(one, []).append((other, length, crosses))
        ways.setdefault(other, []).append((one, length, crosses))
    best, path = np.inf, list[int]()
    for start in np.unique(edges[crossing]).tolist():
        length, found = _around(ways, start, best)
        if length < best:
            best, path = length, found
    return path


def _around(ways: dict[int, list[tuple[int, float, bool]]], start: int, limit: float) -> tuple[float, list[int]]:
    """Dijkstra's shortest path from a vertex back to itself on the other side of the ray."""
    distance, before = {(start, False): 0.0}, dict[tuple[int, bool], tuple[int, bool]]()
    queue = [(0.0, start, False)]
    while queue:
        length, here, side = heapq.heappop(queue)
        if (here, side) == (start, True):
            return length, _back(before, (start, True), (start, False))
        if length > distance[here, side] or length >= limit:
            continue
        for other, step, crosses in ways[here]:
            key = (other, side != crosses)
            if length + step < distance.get(key, np.inf):
                distance[key], before[key] = length + step, (here, side)
                heapq.heappush(queue, (length + step, *key))
    return np.inf, []


def _back(
    before: dict[tuple[int, bool], tuple[int, bool]], end: tuple[int, bool], start: tuple[int, bool]
) -> list[int]:
    path, here = list[int](), end
    while here != start:
        path.append(here[0])
        here = before[here]
    return path


def _rungs(points: Values, loop: Indices) -> tuple[Indices, Values]:
    across = points[loop, 0]
    right, left, count = int(across.argmin()), int(across.argmax()), len(loop)
    one = loop[(right + np.arange((left - right) % count + 1)) % count]
    other = loop[(right - np.arange((right - left) % count + 1)) % count]
    upper, lower = (one, other) if points[one, 1].mean() > points[other, 1].mean() else (other, one)
    (a, wa), (b, wb) = _at_shares(points, upper), _at_shares(points, lower)
    return np.concatenate([a, b], axis=1).astype(np.int32), np.concatenate([wa, -wb], axis=1)


def _at_shares(points: Values, chain: Indices) -> tuple[Indices, Values]:
    """The two vertices around, and their weights at, the middles of RUNGS equal shares of a chain's length."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points[chain], axis=0), axis=1))])
    shares = (np.arange(RUNGS) + 0.5) / RUNGS * length[-1]
    first = np.clip(np.searchsorted(length, shares) - 1, 0, len(chain) - 2)
    after = (shares - length[first]) / (length[first + 1] - length[first])
    return np.stack([chain[first], chain[first + 1]], axis=1), np.stack([1.0 - after, after], axis=1)
