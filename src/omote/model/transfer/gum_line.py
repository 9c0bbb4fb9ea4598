"""Where the mouth bag meets gums and teeth, and a bag that does (docs/method.md, "Gums").

On the generic face a ray from each vertex of the teeth finds the place of the bag that belongs to it, once for all
faces. On a face at rest these places go to the gums' edges, and out of the crowns: least squares on the bag's mesh.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Mask, Values
from omote.geometry import mesh
from omote.geometry.proximity import cast_rays, nearest_triangles
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.model.space.parameter_space import InnerSkin, ParameterSpace
from omote.model.space.parts import Part
from omote.model.transfer.mouth_bag import MouthBag, find_mouth_bag
from omote.model.weak_cache import weakly_cached

# Parts with gums by name, and the way from a tooth's edge to its gum.
GUMS = {"teeth_upper": 1.0, "teeth_lower": -1.0}
# The bag is found up to FAR_METRES from a vertex of the teeth along its ray, and up to BEHIND_METRES before it.
FAR_METRES = 0.03
BEHIND_METRES = 0.006
# A gum's edge that is so much nearer to the middle of the arch than the crown beside it is an inner one, metres.
INNER_METRES = 0.004
# An outer one lies OVER_METRES nearer to the jaw than the crowns within AROUND_METRES.
OVER_METRES = 0.002
AROUND_METRES = 0.01
# The bag lies this far outside of the crowns, and covers this much of the gums, metres.
CLEAR_METRES = 0.0008
COVERED_METRES = 0.0006
# How firmly it is held there, against the stiffness of the bag, and over which length a push dies out, metres.
FIRM = 15.0
LENGTH_METRES = 0.006
MEETING_ROUNDS = 6


@dataclass(frozen=True, eq=False)
class GumLine:
    """Each vertex of the gums' parts and the place of the bag that belongs to it.

    bag: the mouth bag; names (n,), rows (n,): part and vertex in it; upward (n,): the way to its gum, along y; outward
    (n, 3): the way to the bag; edge (n,): whether it is the gum's edge, where the bag is held; corners (n, 3), weights
    (n, 3): the place, vertices of the skin; places (n, m): the same by rows of the bag; stiffness (m, m) of the bag.
    """

    bag: MouthBag
    names: NDArray[np.str_]
    rows: NDArray[np.int64]
    upward: Values
    outward: Values
    edge: Mask
    corners: Indices
    weights: Values
    places: sparse.csr_array
    stiffness: sparse.csr_array

    def gather(self, parts: Mapping[str, NDArray[np.floating]]) -> Values:
        """The teeth's vertices (n, 3) of placed parts."""
        teeth = [parts[str(name)][row] for name, row in zip(self.names, self.rows, strict=True)]
        return np.asarray(teeth, np.float64)


@weakly_cached
def find_gum_line(space: ParameterSpace, /) -> GumLine | None:
    """The gum line of a space, remembered as long as it lives; None where it has no mouth bag or no teeth."""
    bag = find_mouth_bag(space)
    if bag is None or not all(name in space.parts for name in GUMS):
        return None
    rays = [_rays(space.parts[name], upward) for name, upward in GUMS.items()]
    ways = np.concatenate([ways for ways, _ in rays])
    edge = np.concatenate([edge for _, edge in rays])
    counts = [len(space.parts[name].points) for name in GUMS]
    points = np.concatenate([space.parts[name].points for name in GUMS])
    names = np.repeat(list(GUMS), counts)
    rows = np.concatenate([np.arange(count) for count in counts])
    upward = np.repeat(list(GUMS.values()), counts)
    far, at, weights = cast_rays(np.ascontiguousarray(space.points[bag.triangles]), points, ways, BEHIND_METRES)
    places = _by_rows(space, bag, bag.triangles[at], weights)
    held = (far < FAR_METRES) & (places.sum(axis=1) > 0.3)
    return GumLine(
        bag, names[held], rows[held], upward[held], ways[held], edge[held], bag.triangles[at][held], weights[held],
        sparse.csr_array(places[np.flatnonzero(held)]), _stiffness(space, bag),
    )  # fmt: skip


def _rays(part: Part, upward: float) -> tuple[Values, Mask]:
    """The way from each vertex of a gum's part to the bag (n, 3), and which lie on the gum's edge (n,).

    From the outer side outward, at its edge also toward the gum; from the inner edge straight to the gum. A row of
    teeth is open at its back too: what lies there on the height of the crowns is no gum.
    """
    points = part.points
    edge = np.zeros(len(points), np.bool_)
    edge[np.unique(mesh.boundary_edges(part.triangles))] = True
    off = (points - points.mean(axis=0) + [0.0, 0.0, 0.01]) * [1.0, 0.0, 1.0]
    radius = np.linalg.norm(off, axis=1)
    angle = np.arctan2(off[:, 0], off[:, 2])
    crowns = np.flatnonzero(~edge)
    beside = crowns[np.abs(angle[crowns] - angle[:, None]).argmin(axis=1)]
    inner = edge & (radius < radius[beside] - INNER_METRES)
    around = np.linalg.norm(points[crowns] - points[:, None], axis=2) < AROUND_METRES
    highest = np.where(around, upward * points[crowns, 1], -np.inf).max(axis=1)
    edge &= inner | (upward * points[:, 1] > highest + OVER_METRES)
    ways = off / radius[:, None] + np.where(edge, 0.5 * upward, 0.0)[:, None] * [0.0, 1.0, 0.0]
    ways[inner] = [0.0, upward, 0.0]
    return ways / np.linalg.norm(ways, axis=1, keepdims=True), edge


def _by_rows(space: ParameterSpace, bag: MouthBag, corners: Indices, weights: Values) -> sparse.csr_array:
    """Places on the mesh (n, 3) as weights of the bag's rows (n, m); corners on the sheet weigh nothing."""
    row = np.full(space.vertex_count, -1)
    row[bag.vertices] = np.arange(len(bag.vertices))
    which, corner = np.nonzero(row[corners] >= 0)
    columns = row[corners[which, corner]]
    shape = (len(corners), len(bag.vertices))
    return sparse.csr_array(sparse.coo_array((weights[which, corner], (which, columns)), shape=shape))


def _stiffness(space: ParameterSpace, bag: MouthBag) -> sparse.csr_array:
    """A membrane on springs: edges weigh the less the longer they are, the lips' rim is held."""
    ends = mesh.edges(bag.triangles)
    lengths = np.linalg.norm(space.points[ends[:, 0]] - space.points[ends[:, 1]], axis=1)
    slopes = _by_rows(space, bag, ends, np.tile([1.0, -1.0], (len(ends), 1)))
    pull = 1.0 / np.maximum(lengths, 0.001)
    springs = np.full(len(bag.vertices), pull.mean() * (lengths.mean() / LENGTH_METRES) ** 2)
    return sparse.csr_array(slopes.T @ sparse.diags_array(pull) @ slopes + sparse.diags_array(springs))


def measure_gums(
    line: GumLine, positions: Values, parts: Mapping[str, NDArray[np.floating]], /
) -> tuple[Values, Values]:
    """How far gums' edges are from their places in the bag of positions (V, 3), and how far crowns are inside of
    theirs, negative where they are through the wall; metres.

    line: the gums' line; parts: (n, 3) each, metres, placed on the face.
    """
    apart = (line.weights[..., None] * positions[line.corners]).sum(axis=1) - line.gather(parts)
    return np.linalg.norm(apart[line.edge], axis=1), (apart * line.outward)[~line.edge].sum(axis=1)


def meet_gums(line: GumLine, positions: Values, parts: Mapping[str, NDArray[np.floating]], /) -> Values:
    """Where the bag of a face at rest (V, 3) goes, (m, 3), to meet the gums of its placed parts.

    line: the gums' line; positions: (V, 3), metres.

    Least squares against the bag's stiffness; crowns that lie in the bag's walls join as constraints, round by round
    (an active set).
    """
    teeth = line.gather(parts)
    start = positions[line.bag.vertices]
    goals = teeth - (COVERED_METRES * line.upward)[:, None] * [0.0, 1.0, 0.0]
    before = (line.weights[..., None] * positions[line.corners]).sum(axis=1)
    active = line.edge.copy()
    now = before
    firm = FIRM * float(line.stiffness.diagonal().mean())
    result = start
    for _ in range(MEETING_ROUNDS):
        depth = ((now - teeth) * line.outward).sum(axis=1)
        joining = ~line.edge & (depth < CLEAR_METRES - 1e-6)
        fresh = joining & ~active
        goals[fresh] = now[fresh] + (CLEAR_METRES - depth[fresh])[:, None] * line.outward[fresh]
        active |= joining
        places = line.places[np.flatnonzero(active)]
        matrix = sparse.csc_array(line.stiffness + firm * (places.T @ places))
        move = splu(matrix).solve(np.ascontiguousarray(firm * (places.T @ (goals - before)[active])))
        result = start + move
        now = before + line.places @ move
        if not fresh.any():
            break
    return result


# Along the mesh from the sheet, metres: up to the first the bag goes with the lips, from the second on with the jaws;
# between them evenly: steeper anywhere, and walls that a raised lip pushes together would turn over.
LIPS_METRES = 0.001
JAWS_METRES = 0.028
# What holds a gum's edge by so much goes with its jaw, wherever it is.
HOLDS = 0.02


def bind_to_gums(space: ParameterSpace, /) -> ParameterSpace:
    """The space with its mouth bag bound to skull and jaw where gums are: their shares of a vertex no longer follow the
    sheet around the lips but stay, or move as the lower teeth do. Where it has no gum line it comes back as it is."""
    line = find_gum_line(space)
    if line is None:
        return space
    upper, lower = share_jaws(space, line)
    inner = space.inner
    jaw = space.parts["teeth_lower"]
    rows = line.bag.rows
    down, still = (np.where(rows >= 0, share[rows], 0.0) for share in (lower, upper))
    anchors = np.broadcast_to(jaw.anchors[0], (len(rows), jaw.anchors.shape[1]))
    own = inner.weights * (1.0 - down - still)[:, None]
    return replace(
        space,
        inner=InnerSkin(
            inner.vertices,
            np.ascontiguousarray(np.concatenate([inner.anchors, anchors], axis=1), np.int32),
            np.ascontiguousarray(np.concatenate([own, down[:, None] * jaw.weights[:1]], axis=1), np.float32),
        ),
    )


def share_jaws(space: ParameterSpace, line: GumLine, /) -> tuple[Values, Values]:
    """How much each vertex of the bag goes with the upper and with the lower jaw, (m,) each; the rest is the lips'.

    space: the space of the generic head; line: the gums' line.
    """
    bag = line.bag
    points = np.ascontiguousarray(space.points[bag.vertices])
    away = [_distance(space.parts[name], points) for name in GUMS]
    lower = smooth_ramp(0.0, 1.0, 0.5 + (away[0] - away[1]) / np.maximum(away[0] + away[1], 1e-6))
    whole = clamp_unit((bag.distance - LIPS_METRES) / (JAWS_METRES - LIPS_METRES))
    shares = [whole * (1.0 - lower), whole * lower]
    for number, name in enumerate(GUMS):
        edge = line.places[np.flatnonzero(line.edge & (line.names == name))]
        held = np.unique(edge.indices[edge.data > HOLDS])
        shares[number][held], shares[1 - number][held] = 1.0, 0.0
    return shares[0], shares[1]


def _distance(part: Part, points: Values) -> Values:
    return nearest_triangles(np.ascontiguousarray(part.points[part.triangles]), points)[0]
