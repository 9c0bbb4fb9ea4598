"""Lines: where two lids, or two lips, meet; named once on the generic face
(docs/method.md, "Lines of lids and lips")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from omote.arrays import Indices, Mask, Values
from omote.geometry import mesh
from omote.geometry.cylinder import Cylinder, wrap

Kind = Literal["lids", "lips"]

RUNGS = 32
# Lips open as the mouth is wide, but for this share: so far a face's opening may differ from the generic one's.
LIPS_ALIKE = 0.055
# The jaw, the skin on it and the lower teeth keep their way up to this share: people's amplitudes do not grow with
# their heads, and artists' own units for narrow mouths drop the jaw as far.
JAW_ALIKE = 0.2


@dataclass(frozen=True, eq=False)
class Line:
    """A closed line on the sheet around an opening, and the rungs across it.

    loop (n,): its vertices; vertices (RUNGS, 4), weights (RUNGS, 4): rung i is the weighted sum of its four
    vertices, the upper point minus the lower one, both at the same share of the arc from corner to corner.
    """

    name: str
    kind: Kind
    loop: Indices
    vertices: Indices
    weights: Values

    def rungs(self, positions: Values, /) -> Values:
        """Upper minus lower point of each rung, (RUNGS, 3) metres, for positions (V, 3)."""
        return np.einsum("rk,rkc->rc", self.weights, positions[self.vertices])


def lip_amplitude(line: Line, generic: NDArray[np.floating], positions: NDArray[np.floating], /) -> float:
    """How much larger lips with this line open on a face with positions (V, 3) than on the generic face (V, 3)."""
    return _amplitude(line, generic, positions, LIPS_ALIKE)


def jaw_amplitude(
    lines: Sequence[Line], generic: NDArray[np.floating], positions: NDArray[np.floating], /
) -> float | None:
    """How much larger the jaw's motion is on a face with positions (V, 3) than on the generic face (V, 3): it goes with
    lips that open less, and no farther than there; None where no lips are named.

    lines: of lids and lips.
    """
    return min(
        (min(_amplitude(line, generic, positions, JAW_ALIKE), 1.0) for line in lines if line.kind == "lips"),
        default=None,
    )


def _amplitude(line: Line, generic: NDArray[np.floating], positions: NDArray[np.floating], alike: float) -> float:
    """The ratio of the mouths' widths, a share of it taken as no difference."""
    far = np.log(np.ptp(positions[line.loop, 0]) / np.ptp(generic[line.loop, 0]))
    return float(np.exp(np.sign(far) * max(abs(far) - alike, 0.0)))


def find_line(
    name: str, kind: Kind, points: Values, sheet: Indices, membranes: Indices, cylinder: Cylinder, near: Values, /
) -> Line:
    """Finds the line around the opening of the sheet whose membrane is nearest to a point.

    name: of the line; kind: lids or lips; cylinder: the axis of S.

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
    return middles[np.where(mine, area, 0.0).argmax()]


def _shortest_around(points: Values, sheet: Indices, plane: Values, centre: Values) -> list[int]:
    """The shortest closed edge path that crosses a ray from the centre an odd number of times."""
    edges = np.unique(np.sort(np.stack([sheet, np.roll(sheet, -1, 1)], axis=2).reshape(-1, 2), axis=1), axis=0)
    # An opening of a face is narrower than a third of the sheet's height.
    reach = 0.2 * float(np.ptp(plane[sheet, 1]))
    edges = edges[(np.linalg.norm(plane - centre, axis=1) < reach)[edges].all(axis=1)]
    near, numbered = np.unique(edges, return_inverse=True)
    one, other = numbered.reshape(-1, 2).T
    crosses = _crossing(plane[edges] - centre)
    if not crosses.any():
        return []
    # Every vertex twice, before and after the ray: a way around leads from a vertex to its other self.
    count = len(near)
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    rows = np.concatenate([one, one + count])
    cols = np.concatenate([other + count * crosses, other + count * ~crosses])
    graph = coo_array((np.tile(lengths, 2), (rows, cols)), shape=(2 * count, 2 * count)).tocsr()
    starts = np.unique(one[crosses])
    distance, before = dijkstra(graph, directed=False, indices=starts, return_predecessors=True)
    best = int(distance[np.arange(len(starts)), starts + count].argmin())
    return [int(near[v % count]) for v in _trace_back(before[best], starts[best] + count, starts[best])]


def _crossing(ends: Values) -> Mask:
    """Which edges with ends (E, 2, 2) cross the ray from the origin along the first axis."""
    a, b = ends[:, 0], ends[:, 1]
    across = (a[:, 1] > 0) != (b[:, 1] > 0)
    rise = np.where(across, b[:, 1] - a[:, 1], 1.0)
    return across & (a[:, 0] - (b[:, 0] - a[:, 0]) * a[:, 1] / rise > 0)


def _trace_back(before: Indices, end: int, start: int) -> list[int]:
    path = list[int]()
    here = end
    while here != start and here >= 0:
        path.append(here)
        here = int(before[here])
    return path if here == start else []


def _rungs(points: Values, loop: Indices) -> tuple[Indices, Values]:
    (a, wa), (b, wb) = (_at_shares(points, chain) for chain in chains(points, loop))
    return np.concatenate([a, b], axis=1).astype(np.int32), np.concatenate([wa, -wb], axis=1)


def chains(points: Values, loop: Indices, /) -> tuple[Indices, Indices]:
    """The upper and the lower half of a loop, each from its right corner (least x) to its left one, corners
    included.

    points: (V, 3), metres.
    """
    across = points[loop, 0]
    right = int(across.argmin())
    left = int(across.argmax())
    count = len(loop)
    one = loop[(right + np.arange((left - right) % count + 1)) % count]
    other = loop[(right - np.arange((right - left) % count + 1)) % count]
    return (one, other) if points[one, 1].mean() > points[other, 1].mean() else (other, one)


def _at_shares(points: Values, chain: Indices) -> tuple[Indices, Values]:
    """The two vertices around, and their weights at, the middles of RUNGS equal shares of a chain's length."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points[chain], axis=0), axis=1))])
    shares = (np.arange(RUNGS) + 0.5) / RUNGS * length[-1]
    first = np.clip(np.searchsorted(length, shares) - 1, 0, len(chain) - 2)
    after = (shares - length[first]) / (length[first + 1] - length[first])
    return np.stack([chain[first], chain[first + 1]], axis=1), np.stack([1.0 - after, after], axis=1)
