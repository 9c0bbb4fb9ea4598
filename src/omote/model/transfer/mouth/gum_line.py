"""Where the mouth bag meets gums and teeth, and a bag that does (docs/method.md, "Gums").

On the generic face a ray from each vertex of the teeth finds the place of the bag that belongs to it, once for all
faces. On a face at rest these places go to the gums' edges, and out of the crowns: least squares on the bag's mesh.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.geometry import mesh
from omote.geometry.proximity import cast_rays
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import Part
from omote.model.transfer.mouth_bag import MouthBag, find_mouth_bag

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Parts with gums by name, and the way from a tooth's edge to its gum.
GUMS = {"teeth_upper": 1.0, "teeth_lower": -1.0}
# The bag is found up to FAR metres from a vertex of the teeth along its ray, and up to BEHIND metres before it.
FAR, BEHIND = 0.03, 0.006
# A gum's edge that is so much nearer to the middle of the arch than the crown beside it is an inner one, metres.
INNER = 0.004
# An outer one lies OVER metres nearer to the jaw than the crowns within AROUND metres.
OVER, AROUND = 0.002, 0.01
# The bag lies this far outside of the crowns, and covers this much of the gums, metres.
CLEAR, COVERED = 0.0008, 0.0006
# How firmly it is held there, against the stiffness of the bag, and over which length a push dies out, metres.
FIRM, LENGTH = 15.0, 0.006
ROUNDS = 6


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
    corners: NDArray[np.int32]
    weights: Values
    places: sparse.csr_array
    stiffness: sparse.csr_array

    def gather(self, parts: Mapping[str, NDArray[np.floating]]) -> Values:
        """The teeth's vertices (n, 3) of placed parts."""
        found = [parts[str(name)][row] for name, row in zip(self.names, self.rows, strict=True)]
        return np.asarray(found, np.float64)


_lines: WeakKeyDictionary[ParameterSpace, tuple[GumLine, ...]] = WeakKeyDictionary()


def find_gum_line(space: ParameterSpace, /) -> GumLine | None:
    """The gum line of a space, remembered as long as it lives; None where it has no mouth bag or no teeth."""
    if space not in _lines:
        bag = find_mouth_bag(space)
        known = bag is not None and all(name in space.parts for name in GUMS)
        _lines[space] = (_search(space, bag),) if bag is not None and known else ()
    return next(iter(_lines[space]), None)


def _search(space: ParameterSpace, bag: MouthBag) -> GumLine:
    found = [_rays(space.parts[name], upward) for name, upward in GUMS.items()]
    ways, edge = np.concatenate([ways for ways, _ in found]), np.concatenate([edge for _, edge in found])
    counts = [len(space.parts[name].points) for name in GUMS]
    points = np.concatenate([space.parts[name].points for name in GUMS])
    names, rows = np.repeat(list(GUMS), counts), np.concatenate([np.arange(count) for count in counts])
    upward = np.repeat(list(GUMS.values()), counts)
    far, at, weights = cast_rays(np.ascontiguousarray(space.points[bag.triangles]), points, ways, BEHIND)
    places = _by_rows(space, bag, bag.triangles[at], weights)
    held = (far < FAR) & (places.sum(axis=1) > 0.3)
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
    radius, angle = np.linalg.norm(off, axis=1), np.arctan2(off[:, 0], off[:, 2])
    crowns = np.flatnonzero(~edge)
    beside = crowns[np.abs(angle[crowns] - angle[:, None]).argmin(axis=1)]
    inner = edge & (radius < radius[beside] - INNER)
    around = np.linalg.norm(points[crowns] - points[:, None], axis=2) < AROUND
    highest = np.where(around, upward * points[crowns, 1], -np.inf).max(axis=1)
    edge &= inner | (upward * points[:, 1] > highest + OVER)
    ways = off / radius[:, None] + np.where(edge, 0.5 * upward, 0.0)[:, None] * [0.0, 1.0, 0.0]
    ways[inner] = [0.0, upward, 0.0]
    return ways / np.linalg.norm(ways, axis=1, keepdims=True), edge


def _by_rows(space: ParameterSpace, bag: MouthBag, corners: NDArray[np.int32], weights: Values) -> sparse.csr_array:
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
    springs = np.full(len(bag.vertices), pull.mean() * (lengths.mean() / LENGTH) ** 2)
    return sparse.csr_array(slopes.T @ sparse.diags_array(pull) @ slopes + sparse.diags_array(springs))


def measure_gums(
    line: GumLine, positions: Values, parts: Mapping[str, NDArray[np.floating]], /
) -> tuple[Values, Values]:  # fmt: skip
    """How far gums' edges are from their places in the bag of positions (V, 3), and how far crowns are inside of
    theirs, negative where they are through the wall; metres."""
    apart = (line.weights[..., None] * positions[line.corners]).sum(axis=1) - line.gather(parts)
    return np.linalg.norm(apart[line.edge], axis=1), (apart * line.outward)[~line.edge].sum(axis=1)


def meet_gums(line: GumLine, positions: Values, parts: Mapping[str, NDArray[np.floating]], /) -> Values:
    """Where the bag of a face at rest (V, 3) goes, (m, 3), to meet the gums of its placed parts.

    Least squares against the bag's stiffness; crowns that lie in the bag's walls join as constraints, round by round
    (an active set).
    """
    teeth, start = line.gather(parts), positions[line.bag.vertices]
    goals = teeth - (COVERED * line.upward)[:, None] * [0.0, 1.0, 0.0]
    before = (line.weights[..., None] * positions[line.corners]).sum(axis=1)
    active, now = line.edge.copy(), before
    firm = FIRM * float(line.stiffness.diagonal().mean())
    result = start
    for _ in range(ROUNDS):
        depth = ((now - teeth) * line.outward).sum(axis=1)
        joining = ~line.edge & (depth < CLEAR - 1e-6)
        fresh = joining & ~active
        goals[fresh] = now[fresh] + (CLEAR - depth[fresh])[:, None] * line.outward[fresh]
        active |= joining
        places = line.places[np.flatnonzero(active)]
        matrix = sparse.csc_array(line.stiffness + firm * (places.T @ places))
        move = splu(matrix).solve(np.ascontiguousarray(firm * (places.T @ (goals - before)[active])))
        result, now = start + move, before + line.places @ move
        if not fresh.any():
            break
    return result
