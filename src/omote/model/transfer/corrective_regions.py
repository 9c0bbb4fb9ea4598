"""Where combinations of compounds are corrected: the skin around eyes and mouth and the throat, found once per space.

Each compound alone folds and pierces nothing that the generic face does not. Combinations do: a blink and a squint push
one lid through the other, two lip shapes turn small triangles over. `omote.perform.blending.correctives` corrects that
(docs/method.md, "Correctives of combinations"); here is what it needs of the topology, in places of `rows`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import dijkstra
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from omote.arrays import Floats, Indices, Mask, Rows, Values
from omote.model.space.lid_lip_lines import RUNGS, Kind, chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import Part
from omote.model.transfer.eyeball_clearance import PUSHED_RADII as BALL_REACH
from omote.model.transfer.fold_repair import build_sheet_geometry
from omote.model.weak_cache import weakly_cached

# The skin within so many widths of the widest line is corrected; from the neck to CORNERS widths above the lips, within
# THROAT of their widths: an open jaw and the neck's muscle fold the throat, a wide open mouth the jaw's corners.
REACH = 1.0
THROAT = 2.0
CORNERS = 1.0
# What separates two lids dies out over this share of their line's width; below LEAST of it, it is zero.
FADE = 0.2
LEAST = 0.03
# So many patches, whose sums are damped as wholes; each counts triangles within so many edges of it, and its share
# of a vertex fades by so many averages over neighbours; so many patches a vertex belongs to at most.
PATCHES = 64
EDGES = 2
FADED = 16
SHARED = 8


@dataclass(frozen=True, eq=False)
class Crossing:
    """One line of lids or lips: its rungs, and how the skin around it moves where they cross.

    vertices, weights (RUNGS, 4): the rungs, as in Line; near (p,): the vertices that move; side (p,): how far up (+) or
    down (-), one at the line; share (p,): at which share of the line, 0 at its right corner.
    """

    kind: Kind
    vertices: Indices
    weights: Values
    near: Indices
    side: Values
    share: Values


@dataclass(frozen=True, eq=False)
class Patches:
    """Overlapping patches of skin, within each of which a sum that folds is damped as a whole.

    triangles (n,): those that a patch listens to, patch after patch; ends (p,): where each patch's end among them.
    members, shares (m, SHARED): to which patches each of the rows belongs, and how much; shares add up to one, to less
    near the jaw's skin, to none on it.
    """

    triangles: Indices
    ends: Indices
    members: Indices
    shares: Floats


@dataclass(frozen=True, eq=False)
class CorrectiveRegions:
    """The skin that combinations of compounds can fold or pierce.

    rows (m,): its vertices; all else counts in them: crossings of lids and lips; triangles (t, 3); lids (r,) around
    eyeballs and which of `eyes`, part names, it is (r,); patches: in which sums are damped. followers (f,): inner skin
    that moves with rows, by anchors and weights (f, k). attached_parts: names of parts that move with the skin.
    """

    rows: Indices
    crossings: tuple[Crossing, ...]
    triangles: Indices
    lids: Indices
    eye: Indices
    eyes: tuple[str, ...]
    patches: Patches
    followers: Indices
    anchors: Indices
    weights: Floats
    attached_parts: tuple[str, ...]

    @property
    def size(self) -> int:
        """How many numbers say what one compound is allowed: of triangles, then of rungs, then of lids."""
        return len(self.triangles) + RUNGS * len(self.crossings) + len(self.lids)


@weakly_cached
def find_corrective_regions(space: ParameterSpace, /) -> CorrectiveRegions | None:
    """The corrective regions of a space, found once; None where no line is named or under the paper's map."""
    if not space.lines or space.transfer == "paper":
        return None
    rows = _around(space)
    place = np.full(space.vertex_count, -1, np.int32)
    place[rows] = np.arange(len(rows))
    corners = place[space.sheet_triangles]
    eye = _nearest_eye(space.points[rows], list(space.eyes.values()))
    anchors, weights, followers = _followers(space, place)
    triangles = np.ascontiguousarray(corners[(corners >= 0).all(axis=1)])
    return CorrectiveRegions(
        rows=rows,
        crossings=_crossings(space, place),
        triangles=triangles, patches=_find_patches(space.points[rows], triangles, _chin(space)),
        lids=np.flatnonzero(eye >= 0).astype(np.int32), eye=eye[eye >= 0], eyes=tuple(space.eyes),
        followers=followers, anchors=anchors, weights=weights,
        attached_parts=tuple(name for name, part in space.parts.items() if part.follows_skin),
    )  # fmt: skip


def _around(space: ParameterSpace) -> Indices:
    """The sheet's vertices within REACH of the lines, or within THROAT of the lips and not above CORNERS."""
    used = np.unique(space.sheet_triangles).astype(np.int32)
    points = space.points[used]
    loops = [(line.kind, space.points[line.loop]) for line in space.lines]
    far = REACH * max(float(np.ptp(loop[:, 0])) for _, loop in loops)
    inside = np.zeros(len(used), np.bool_)
    for kind, loop in loops:
        distance, _ = cKDTree(loop).query(points)
        inside |= distance < far
        if kind == "lips":
            width = float(np.ptp(loop[:, 0]))
            inside |= (distance < THROAT * width) & (points[:, 1] < loop[:, 1].min() + CORNERS * width)
    return used[inside]


def _nearest_eye(points: Values, eyes: list[Part]) -> Indices:
    """Which eyeball each point (m, 3) lies around, -1 around none."""
    result = np.full(len(points), -1, np.int32)
    closest = np.full(len(points), np.inf)
    for number, part in enumerate(eyes):
        centre = part.points.mean(axis=0)
        radius = float(np.linalg.norm(part.points - centre, axis=1).mean())
        distance = np.linalg.norm(points - centre, axis=1)
        result[(distance < BALL_REACH * radius) & (distance < closest)] = number
        closest = np.minimum(closest, distance)
    return result


def _followers(space: ParameterSpace, place: Indices) -> tuple[Indices, Floats, Indices]:
    """Anchors, weights and vertices of the inner skin that hangs on rows; anchors elsewhere weigh nothing, nor do the
    jaw's: gums stay with the teeth, which no corrective moves."""
    inner = space.inner
    jaw = [part.anchors[0] for part in space.parts.values() if part.follows_jaw]
    anchors = np.where(np.isin(inner.anchors, jaw), -1, place[inner.anchors])
    weights = np.where(anchors >= 0, inner.weights, np.float32(0.0)).astype(np.float32)
    hangs = weights.any(axis=1)
    used = weights.any(axis=0)
    return np.maximum(anchors, 0)[hangs][:, used], weights[hangs][:, used], inner.vertices[hangs]


# ---- how far skin moves around a line


def _crossings(space: ParameterSpace, place: Indices) -> tuple[Crossing, ...]:
    points = space.points.astype(np.float64)
    matrices = _membrane(space.points, space.sheet_triangles)
    fields = [_falloff(points, line.loop, place >= 0, matrices) for line in space.lines]
    strongest = np.abs([side for side, _ in fields]).argmax(axis=0)  # each vertex gives way to one line
    crossings = []
    for number, (line, (side, share)) in enumerate(zip(space.lines, fields, strict=True)):
        near = np.flatnonzero((side != 0) & (strongest == number))
        crossings.append(Crossing(line.kind, place[line.vertices], line.weights, place[near], side[near], share[near]))
    return tuple(crossings)


def _falloff(
    points: Values, loop: Indices, within: Mask, matrices: tuple[sparse.csr_array, Values]
) -> tuple[Values, Values]:
    """Side and share (V,) around one line, zero beyond its reach: a screened harmonic extension from the line."""
    fixed, side, share = _on_line(points, loop)
    stiffness, mass = matrices
    length = FADE * float(np.ptp(points[loop, 0]))
    free = within.copy()
    free[fixed] = False
    matrix = sparse.csr_array(stiffness + sparse.diags_array(mass / length**2))
    spread = _extend(matrix, np.flatnonzero(free), fixed, np.stack([side, np.ones(len(fixed)), share], axis=1))
    sides = np.sign(spread[:, 0]) * np.maximum(np.abs(spread[:, 0]) - LEAST, 0.0) / (1.0 - LEAST)
    return sides, np.minimum(np.maximum(spread[:, 2] / np.maximum(spread[:, 1], LEAST), 0.0), 1.0)


def _membrane(points: Values, triangles: Indices) -> tuple[sparse.csr_array, Values]:
    """Stiffness (V, V) and lumped mass (V,) of a sheet, linear elements."""
    sheet = build_sheet_geometry(points, points, triangles)
    area = 0.5 * np.linalg.norm(sheet.normals, axis=1)
    energy = np.einsum("tkd,tld,t->tkl", sheet.gradients, sheet.gradients, area)
    rows = np.repeat(triangles, 3, axis=1).ravel()
    cols = np.tile(triangles, (1, 3)).ravel()
    shape = (len(points), len(points))
    mass: Values = np.bincount(triangles.ravel(), np.repeat(area / 3.0, 3), minlength=len(points)).astype(np.float64)
    return sparse.coo_array((energy.ravel(), (rows, cols)), shape=shape).tocsr(), mass


def _on_line(points: Values, loop: Indices) -> tuple[Indices, Values, Values]:
    """The vertices of a loop, which side they are on (corners on none), and their share of its half."""
    names = []
    sides = []
    shares = []
    for chain, side in zip(chains(points, loop), (1.0, -1.0), strict=True):
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points[chain], axis=0), axis=1))])
        inside = slice(0, None) if side > 0 else slice(1, -1)  # the corners once
        names.append(chain[inside])
        sides.append(np.where((length == 0) | (length == length[-1]), 0.0, side)[inside])
        shares.append((length / length[-1])[inside])
    return np.concatenate(names), np.concatenate(sides), np.concatenate(shares)


def _extend(matrix: sparse.csr_array, free: Rows, fixed: Indices, values: Values) -> Values:
    """Values (n, k) given on fixed vertices, extended over free ones (Dirichlet problem); zero elsewhere: (V, k)."""
    result = np.zeros((matrix.shape[0], values.shape[1]))
    rows = matrix[free]
    result[free] = splu(sparse.csc_array(rows[:, free])).solve(-(rows[:, fixed] @ values))
    result[fixed] = values
    return result


# ---- patches in which sums are damped


def _chin(space: ParameterSpace) -> float:
    """Where the lips end below, metres: what is lower goes with the jaw and its teeth, which no sum damps."""
    return min(
        (float(space.points[line.loop, 1].min()) for line in space.lines if line.kind == "lips"), default=-np.inf
    )


def _find_patches(points: Values, triangles: Indices, chin: float) -> Patches:
    """Cells around vertices far from each other, blurred over their neighbours, none below the chin's height (metres):
    a smooth partition of unity that fades there."""
    count = len(points)
    ends = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    beside = sparse.coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    beside = (sparse.csr_array(beside + beside.T) != 0).astype(np.float64) + sparse.eye_array(count)
    cells = _scatter_cells(points, sparse.csr_array(beside)) * (points[:, 1:2] >= chin)
    mean = sparse.diags_array(1.0 / beside.sum(axis=1)) @ beside
    shares = cells
    reached = cells
    for _ in range(FADED):
        shares = mean @ shares
    for _ in range(EDGES):
        reached = beside @ reached
    inside = cells.any(axis=0)  # a cell below the chin is none
    shares = shares[:, inside]
    reached = reached[:, inside]
    listed = [np.flatnonzero((of_cell > 0.0)[triangles].any(axis=1)) for of_cell in reached.T]
    members = np.argsort(-shares, axis=1, kind="stable")[:, :SHARED]
    weights = np.take_along_axis(shares, members, axis=1)
    weights *= shares.sum(axis=1, keepdims=True) / np.maximum(weights.sum(axis=1, keepdims=True), 1e-9)
    return Patches(
        np.concatenate(listed).astype(np.int32), np.cumsum([len(rows) for rows in listed]).astype(np.int32),
        members.astype(np.int32), weights.astype(np.float32),
    )  # fmt: skip


def _scatter_cells(points: Values, beside: sparse.csr_array) -> Values:
    """Which of PATCHES cells each point (m, 3) is in, (m, PATCHES) of zeros and ones: farthest point sampling by edges
    (Gonzalez 1985), a point and its mirror image at a time, so that both halves of a face are damped alike."""
    _, mirrors = cKDTree(points).query(points * [-1.0, 1.0, 1.0])
    right = points[:, 0] <= 0.0
    seed = int(points[:, 2].argmax())
    steps = np.empty((0, len(points)))
    while len(steps) < PATCHES:
        fresh = list({seed: None, int(mirrors[seed]): None})[: PATCHES - len(steps)]
        steps = np.concatenate([steps, dijkstra(beside, unweighted=True, indices=fresh)])
        reached = steps.min(axis=0)
        seed = int(np.where(right & np.isfinite(reached), reached, -1.0).argmax())
    return np.eye(PATCHES)[steps.argmin(axis=0)]
