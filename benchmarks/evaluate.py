"""What a frame costs, on one core, against named peers in the same run, on the built-in head and on finer ones.

* four compounds blended, against a copy that moves as many bytes (five arrays: bytes read and bytes written);
* the bare gather of a compiled expression, and a whole compound with inner skin, against SciPy's CSR product;
* the exact evaluator with sixty expressions on air, against the product that sums their sixty fields.

A figure is the fastest of many rounds in which both sides take turns. Blend and copy repeat inside compiled code, so
that the price of a call from Python (about a microsecond on either side) is in neither.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np
from numba import njit
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table
from scipy.sparse import csr_array

import omote
from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.geometry.locate import Strip
from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import Fans, InnerSkin, ParameterSpace
from omote.model.space.skin_sheet import unwrap_corners
from omote.model.transfer.paper_map import Compiled, apply_paper_map, compile_expression
from omote.perform.blending.evaluate import evaluate
from omote.perform.blending.expression_tables import tables_of
from omote.perform.blending.weighted_sum import blend_four
from omote.perform.frame import Frame

SIZES = (4_278, 50_000, 500_000)
FACES = ("generic", "kaori")
ACTIVE = 60
BARS = {"blend": 1.4, "gather": 0.5, "compound": 4.0, "exact": 20.0}
NAMES = {
    "blend": "blend of four compounds / copy of equal traffic",
    "gather": "bare gather / CSR product",
    "compound": "compound with inner skin / CSR product",
    "exact": f"exact evaluator, {ACTIVE} expressions / product of their fields",
}
LINEAR = 2.0
"""How much more a vertex may cost against its peer on the finest head than on the built-in one."""
SECONDS = 0.6
"""Spent on each pair at each size, at least."""
ROUNDS = 25
"""Looked at, at least, of each pair at each size."""

Floats = NDArray[np.float32]
Values = NDArray[np.float64]
Indices = NDArray[np.int32]


# --- a finer head -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Cut:
    """Finer triangles (F, 3) out of coarse ones: a vertex is weights (V, 3) of the coarse vertices corners (V, 3)."""

    corners: Indices
    weights: Values
    triangles: Indices
    parents: Indices

    def at(self, values: Values) -> Values:
        """Values of the coarse vertices, at the fine ones."""
        result: Values = np.einsum("vk,vk...->v...", self.weights, values[self.corners])
        return result


def cut(triangles: Indices, count: int) -> Cut:
    """Triangles cut into a lattice, then some of those at their centroids, until there are `count` vertices."""
    side = max(n for n in range(1, 50) if _lattice_size(triangles, n) <= count)
    local, small = _lattice(side)
    corners = np.repeat(triangles, len(local), axis=0)
    weights = np.tile(local, (len(triangles), 1))
    used = np.where(weights > 0, corners, -1)
    order = np.argsort(used, axis=1)  # the same point of an edge has the same key from both sides
    key = np.concatenate([np.take_along_axis(used, order, 1), np.take_along_axis(weights, order, 1)], axis=1)
    _, first, name = np.unique(key, axis=0, return_index=True, return_inverse=True)
    fine = name.reshape(len(triangles), len(local))[:, small].reshape(-1, 3)
    chosen = np.linspace(0, len(fine) - 1, count - len(first)).astype(np.int64)
    middle = len(first) + np.arange(len(chosen))
    fans = [np.stack([fine[chosen, a], fine[chosen, b], middle], axis=1) for a, b in ((0, 1), (1, 2), (2, 0))]
    kept = np.delete(np.arange(len(fine)), chosen)
    parents = np.concatenate([kept, chosen, chosen, chosen]) // len(small)
    return Cut(
        np.concatenate([corners[first], triangles[chosen // len(small)]]),
        np.concatenate([weights[first], local[small].mean(axis=1)[chosen % len(small)]]) / side,
        np.concatenate([fine[kept], *fans]).astype(np.int32),
        parents.astype(np.int32),
    )


def _lattice_size(triangles: Indices, side: int) -> int:
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    inner = (side - 1) * (side - 2) // 2
    return len(np.unique(triangles)) + len(np.unique(edges, axis=0)) * (side - 1) + len(triangles) * inner


def _lattice(side: int) -> tuple[Values, Indices]:
    """Points (L, 3) of a triangle in barycentric steps of one, and its side^2 small triangles."""
    steps = [(i, j) for i in range(side + 1) for j in range(side + 1 - i)]
    row = {step: n for n, step in enumerate(steps)}
    upward = [(row[i, j], row[i + 1, j], row[i, j + 1]) for i, j in steps if i + j < side]
    downward = [(row[i + 1, j], row[i + 1, j + 1], row[i, j + 1]) for i, j in steps if i + j < side - 1]
    return np.array([(side - i - j, i, j) for i, j in steps], float), np.array(upward + downward, np.int32)


def finer(cast: Cast, count: int) -> Cast:
    """The cast on a head of `count` vertices: two faces and sixty expressions, cut out of the coarse ones."""
    names = ["neutral", *sorted(set(cast.expressions) - {"neutral"})][:ACTIVE]
    chosen = {name: replace(cast.expressions[name], parts={}, transfer="paper") for name in names}
    space = cast.space
    if count == space.vertex_count:
        return Cast(
            replace(space, parts={}, transfer="paper"),
            {name: Face(name, cast.faces[name].positions) for name in FACES},
            chosen,
        )
    # Sheet, membranes and the rest are cut as one mesh, so that they still share their edges.
    rest = space.triangles[~_rows_in(space.triangles, space.skin_triangles)]
    fine = cut(np.concatenate([space.skin_triangles, space.membranes, rest]).astype(np.int32), count)
    made = _finer_space(space, fine)
    faces = {
        name: Face(name, fine.at(cast.faces[name].positions.astype(np.float64)).astype(np.float32)) for name in FACES
    }
    return Cast(made, faces, {name: _finer_expression(worn, fine, made) for name, worn in chosen.items()})


def _rows_in(rows: Indices, others: Indices) -> NDArray[np.bool_]:
    known = {tuple(row) for row in others.tolist()}
    return np.array([tuple(row) in known for row in rows.tolist()])


def _finer_space(space: ParameterSpace, fine: Cut) -> ParameterSpace:
    skins = len(space.skin_triangles)
    holes = len(space.membranes)
    points = fine.at(space.points)
    around = space.theta[fine.corners]
    theta = wrap(around[:, 0] + (fine.weights * wrap(around - around[:, :1])).sum(axis=1))
    h = points[:, 1].copy()
    located = fine.triangles[fine.parents < skins + holes]
    on_sheet = np.zeros(len(points), np.bool_)
    on_sheet[located] = True
    return ParameterSpace(
        points=points,
        triangles=fine.triangles[(fine.parents < skins) | (fine.parents >= skins + holes)],
        skin_triangles=fine.triangles[fine.parents < skins],
        membranes=fine.triangles[(fine.parents >= skins) & (fine.parents < skins + holes)],
        cylinder=space.cylinder,
        radius=space.radius,
        transfer="paper",
        theta=theta,
        h=h,
        strip=Strip.of(unwrap_corners(theta, located), h[located], mesh.neighbours(located)),
        fans=_first_triangles(located, len(points)),
        inner=_finer_inner(space, fine, np.flatnonzero(~on_sheet)),
        on_sheet=on_sheet,
    )


def _first_triangles(located: Indices, count: int) -> Fans:
    """One triangle at each vertex to start its walk from."""
    first = np.zeros(count, np.int32)
    first[located[::-1]] = np.arange(len(located), dtype=np.int32)[::-1, None]
    return Fans(np.arange(count + 1, dtype=np.int32), first)


def _finer_inner(space: ParameterSpace, fine: Cut, vertices: NDArray[np.int64]) -> InnerSkin:
    """Inner skin follows the anchors of the nearest coarse vertex that has any."""
    row = np.full(space.vertex_count, -1)
    row[space.inner.vertices] = np.arange(len(space.inner.vertices))
    corners = fine.corners[vertices]
    nearest = np.where(row[corners] >= 0, fine.weights[vertices], -1.0).argmax(axis=1)
    source = row[corners[np.arange(len(vertices)), nearest]]
    names = np.full(space.vertex_count, -1, np.int64)
    whole = np.flatnonzero(fine.weights.max(axis=1) == 1.0)
    names[fine.corners[whole, fine.weights[whole].argmax(axis=1)]] = whole
    anchors = names[space.inner.anchors[source]].astype(np.int32)
    return InnerSkin(vertices.astype(np.int32), anchors, np.ascontiguousarray(space.inner.weights[source]))


def _finer_expression(worn: Expression, fine: Cut, space: ParameterSpace) -> Expression:
    still = ~space.on_sheet
    dtheta, dh, ratio = (fine.at(values) for values in (worn.dtheta, worn.dh, worn.ratio))
    dtheta[still] = 0.0
    dh[still] = 0.0
    ratio[still] = 1.0
    return Expression(
        dtheta, dh, ratio, np.zeros((len(space.inner.vertices), 3)), radius=space.radius, transfer="paper"
    )


# --- the pairs --------------------------------------------------------------------------------------------------------


@njit()
def _blend_again(a: Floats, b: Floats, c: Floats, d: Floats, out: Floats, times: int) -> None:
    for time in range(times):
        blend_four(a, b, c, d, 0.1 * time, 0.2, 0.3, 0.4, out)


@njit(fastmath={"contract"})
def _gather_rows(points: Floats, indices: NDArray[np.int32], weights: Floats, out: Floats) -> None:
    """Writes into row v of out (V, 3) the weights[v] (V, 3) of the three rows indices[v] (V, 3) of points (n, 3)."""
    for v in range(len(indices)):
        i, j, k = indices[v, 0], indices[v, 1], indices[v, 2]
        a, b, c = weights[v, 0], weights[v, 1], weights[v, 2]
        out[v, 0] = a * points[i, 0] + b * points[j, 0] + c * points[k, 0]
        out[v, 1] = a * points[i, 1] + b * points[j, 1] + c * points[k, 1]
        out[v, 2] = a * points[i, 2] + b * points[j, 2] + c * points[k, 2]


@njit()
def _copy_again(source: Floats, out: Floats, times: int) -> None:
    for time in range(times):
        source[0] = time  # so that no repetition can be left out
        for i in range(len(source)):
            out[i] = source[i]


def _fastest(ours: Callable[[], object], peer: Callable[[], object]) -> tuple[float, float]:
    """The shortest times of both in seconds, taken in turns: other programs on the machine only ever lengthen them."""
    best = [np.inf, np.inf]
    rounds = 0
    end = perf_counter() + SECONDS
    while rounds < ROUNDS or perf_counter() < end:
        for side, function in enumerate((ours, peer)):
            start = perf_counter()
            function()
            best[side] = min(best[side], perf_counter() - start)
        rounds += 1
    return best[0], best[1]


def blend_and_copy(cast: Cast) -> tuple[float, float]:
    """Four compounds blended; a copy of two and a half of them reads and writes as much."""
    worn = [compile_expression(cast.space, cast.expressions[name]) for name in sorted(cast.expressions)[:2]]
    four = [
        apply_paper_map(cast.space, fit(cast.space, face), one).ravel() for face in cast.faces.values() for one in worn
    ]
    out = np.empty_like(four[0])
    times = max(1, 200_000 // cast.space.vertex_count)
    source = np.zeros(len(out) * 5 // 2, np.float32)
    target = np.empty_like(source)
    a, b, c, d = four
    ours, peer = _fastest(lambda: _blend_again(a, b, c, d, out, times), lambda: _copy_again(source, target, times))
    return ours / times, peer / times


def gather_and_product(cast: Cast) -> tuple[float, float]:
    """The points where the vertices of a compiled expression come down on a face; the same as a sparse product."""
    positions, compiled, product = _worn(cast)
    out = np.empty_like(positions)
    ours = _fastest(
        lambda: _gather_rows(positions, compiled.indices, compiled.weights, out), lambda: product @ positions
    )
    np.testing.assert_allclose(out, product @ positions, atol=1e-6)
    return ours


def compound_and_product(cast: Cast) -> tuple[float, float]:
    """A whole compound, radii and inner skin with it; the bare product."""
    positions, compiled, product = _worn(cast)
    face = fit(cast.space, cast.faces[FACES[1]])
    out = np.empty_like(positions)
    return _fastest(lambda: apply_paper_map(cast.space, face, compiled, out), lambda: product @ positions)


def _worn(cast: Cast) -> tuple[Floats, Compiled, csr_array]:
    """A face, all sixty expressions on it at once (so that every vertex of the sheet moves), and that as a matrix."""
    compiled = tables_of(cast).mix(dict.fromkeys(cast.expressions, 1.0 / ACTIVE))
    count = cast.space.vertex_count
    rows = np.arange(0, 3 * count + 1, 3, dtype=np.int32)
    product = csr_array((compiled.weights.ravel(), compiled.indices.ravel(), rows), shape=(count, count))
    return cast.faces[FACES[1]].positions, compiled, product


def exact_and_product(cast: Cast) -> tuple[float, float]:
    """The mixed face wears all sixty, located anew; the dense product that sums their fields on the sheet."""
    frame = Frame(dict.fromkeys(FACES, 0.5), dict.fromkeys(cast.expressions, 1.0 / ACTIVE))
    sheet = cast.space.on_sheet
    table = np.stack(
        [np.concatenate([e.dtheta[sheet], e.dh[sheet], e.ratio[sheet]]) for e in cast.expressions.values()]
    ).astype(np.float32)
    weights = np.full(ACTIVE, 1.0 / ACTIVE, np.float32)
    return _fastest(lambda: evaluate(cast, frame, "exact"), lambda: weights @ table)


PAIRS: dict[str, Callable[[Cast], tuple[float, float]]] = {
    "blend": blend_and_copy,
    "gather": gather_and_product,
    "compound": compound_and_product,
    "exact": exact_and_product,
}


# --- the report -------------------------------------------------------------------------------------------------------


def measure_pairs() -> dict[str, list[tuple[float, float]]]:
    """Seconds of ours and of the peer, for each pair at each size."""
    coarse = omote.load_cast()
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in PAIRS}
    for count in SIZES:
        cast = finer(coarse, count)
        for name, pair in PAIRS.items():
            pair(cast)  # compiles
            found[name].append(pair(cast))
    return found


def report(found: dict[str, list[tuple[float, float]]]) -> bool:
    """Prints the figures and says whether every bar is met."""
    table = Table(title="Cost of a frame, one core: ours / peer (ours in microseconds)", title_justify="left")
    for column in ("pair", *(f"{size:,}" for size in SIZES), "bar", "per vertex", "met"):
        table.add_column(column, justify="left" if column == "pair" else "right")
    good = True
    for name, pairs in found.items():
        ratios = [ours / peer for ours, peer in pairs]
        growth = ratios[-1] / ratios[0]
        met = max(ratios) <= BARS[name] and growth <= LINEAR
        cells = [f"{ratio:.2f} ({1e6 * ours:,.1f})" for ratio, (ours, _) in zip(ratios, pairs, strict=True)]
        table.add_row(NAMES[name], *cells, f"{BARS[name]:g}", f"x{growth:.2f}", "yes" if met else "NO")
        good = good and met
    Console(width=150).print(table)
    print(
        f"Linear: against its peer, whose cost is linear, a vertex may cost {LINEAR:g} times more at the finest size."
    )
    return good


if __name__ == "__main__":
    sys.exit(0 if report(measure_pairs()) else 1)
