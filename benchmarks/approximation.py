"""The paper's approximation error: how far its blend is from the mixed face that wears the mixed expression.

The paper blends compounds (eq. 3) because locating anew was too slow in 1993. Here both are computed for every pair of
faces and every pair of performed expressions, in two passes: all pairs half way along both axes, then the worst of them
along the whole path, face and expression moving together and against each other. The distance is that of the worst
vertex of skin and inner skin, in millimetres; there is no bar, it is a figure to know.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

from itertools import combinations

import numpy as np
from rich.console import Console
from rich.table import Table

import omote
from omote.model.cast import Cast
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame

WORST = 10
CANDIDATES = 120
STEPS = np.linspace(0.0, 1.0, 21)

Pair = tuple[str, str]


def apart(cast: Cast, faces: Pair, expressions: Pair, s: float, t: float) -> tuple[float, float]:
    """The largest and the root mean square distance of a vertex between both evaluators, millimetres."""
    frame = Frame({faces[0]: 1 - s, faces[1]: s}, {expressions[0]: 1 - t, expressions[1]: t})
    difference = evaluate(cast, frame, "bilinear").astype(np.float64) - evaluate(cast, frame, "exact")
    distance = 1000 * np.linalg.norm(difference, axis=1)
    return float(distance.max()), float(np.sqrt((distance**2).mean()))


def along(cast: Cast, faces: Pair, expressions: Pair) -> tuple[float, float, str]:
    """The worst of the path: largest distance, root mean square there, and where it is."""
    places = [(s, t) for u in STEPS for s, t in ((u, u), (u, 1 - u), (0.5, u), (u, 0.5))]
    found = [(*apart(cast, faces, expressions, s, t), f"s = {s:.2f}, t = {t:.2f}") for s, t in places]
    return max(found)


def candidates(cast: Cast) -> list[tuple[float, Pair, Pair]]:
    """The pairs that are farthest apart half way, worst first."""
    names = [name for name, title in cast.titles.items() if title.kind in ("neutral", "performed")]
    found = [
        (apart(cast, faces, expressions, 0.5, 0.5)[0], faces, expressions)
        for faces in combinations(sorted(cast.faces), 2)
        for expressions in combinations(sorted(names), 2)
    ]
    print(f"{len(found):,} pairs half way: median {np.median([worst for worst, _, _ in found]):.2f} mm")
    return sorted(found, reverse=True)[:CANDIDATES]


def main() -> None:
    """Searches, and prints the ten worst pairs."""
    cast = omote.load_cast().under("paper")
    found = [(*along(cast, faces, worn), faces, worn) for _, faces, worn in candidates(cast)]
    table = Table(title="Bilinear against exact, along the path: the ten worst pairs", title_justify="left")
    for column in ("faces", "expressions", "largest, mm", "rms, mm", "where"):
        table.add_column(column)
    for largest, mean, where, faces, worn in sorted(found, reverse=True)[:WORST]:
        table.add_row(" - ".join(faces), " - ".join(worn), f"{largest:.2f}", f"{mean:.3f}", where)
    Console(width=120).print(table)


if __name__ == "__main__":
    main()
