"""Pads: how smoothly weights go along a stroke, what a point of twelve looks costs, and a tick with four pads.

On fresh layouts (up to 12 looks at least .12 widths of the pad apart) a point goes straight at 2 widths a second from one
place inside the hull of the looks to another, 60 frames a second. *Kick*: the largest change of the velocity of the weights
between two frames, over the median speed of the stroke. The peer is SciPy's Delaunay triangulation with barycentric
weights, as blend spaces of game engines have it.

`python -m benchmarks.pads [--seed N]`; without a seed it draws its own. 1 where a bar is missed.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import math
import secrets
import sys
import timeit
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table
from scipy.spatial import Delaunay

import omote
from omote.perform.pads.blend_space import MOST_LOOKS
from omote.perform.scene.cast_pads import cast_pads

LAYOUTS = 120
STROKES = 8
APART = 0.12
FEWEST = {1: 3, 2: 4, 3: 5}
"""Looks by dimensions: what a triangulation needs."""
SPEED = 2.0
"""Widths."""
WIDTH = 2.0
"""Of a pad, whose places go from -1 to 1."""
RATE = 60.0
BAR_KICK = 1.3, 4.5
"""Median and 95 % of strokes, of two dimensions."""
BAR_MICROSECONDS = 3.0

Values = NDArray[np.float64]
Weigh = Callable[[Values], Values]


def layout(rng: np.random.Generator, dimensions: int, count: int | None = None) -> Values:
    """Places of looks."""
    wanted = int(rng.integers(FEWEST[dimensions], MOST_LOOKS + 1)) if count is None else count
    while True:
        places: list[Values] = []
        for place in rng.uniform(-1.0, 1.0, (40 * wanted, dimensions)):
            if all(np.linalg.norm(place - other) >= WIDTH * APART for other in places):
                places.append(place)
            if len(places) == wanted:
                return np.array(places)
        wanted = wanted if count is not None else max(FEWEST[dimensions], wanted - 1)


def pad_of(places: Values) -> omote.Pad:
    """A pad with a look of its own at each place."""
    looks = [omote.PadLook(f"l{n}", {f"n{n}": 1.0}, tuple(map(float, place))) for n, place in enumerate(places)]
    return omote.Pad("pad", "expression", places.shape[1], tuple(looks))


def ours(places: Values) -> Weigh:
    """Soft bands."""
    pad = pad_of(places)
    return lambda at: np.array(pad.weights_at(tuple(map(float, at))))


def delaunay(places: Values) -> Weigh:
    """Barycentric weights in the triangle that holds a point."""
    mesh = Delaunay(places)

    def weigh(at: Values) -> Values:
        simplex = int(mesh.find_simplex(at))
        weights = np.zeros(len(places))
        if simplex >= 0:
            inner = mesh.transform[simplex, :-1] @ (at - mesh.transform[simplex, -1])
            weights[mesh.simplices[simplex]] = [*inner, 1.0 - inner.sum()]
        return weights

    return weigh


def kicks(make: Callable[[Values], Weigh], seed: int, dimensions: int) -> Values:
    """The kick of each stroke."""
    rng = np.random.default_rng([seed, dimensions])
    found = []
    for _ in range(LAYOUTS):
        places = layout(rng, dimensions)
        weigh = make(places)
        for _ in range(STROKES):
            begin, end = rng.dirichlet(np.ones(len(places)), 2) @ places
            steps = round(math.dist(begin, end) / (WIDTH * SPEED) * RATE)
            if steps < 6:
                continue
            rows = np.array([weigh(begin + (end - begin) * step / steps) for step in range(steps + 1)])
            moved = np.diff(rows, axis=0)
            bent = np.linalg.norm(np.diff(moved, axis=0), axis=1).max()
            found.append(bent / np.median(np.linalg.norm(moved, axis=1)))
    return np.array(found)


def microseconds(call: Callable[[], object], number: int = 300) -> float:
    """What a call costs, the least of many."""
    return min(timeit.repeat(call, number=number, repeat=60)) / number * 1e6


def tick(cast: omote.Cast, *, pads: bool) -> float:
    """Microseconds of a tick of a character that calls a face and an expression, with four pads that move or without.
    The look at what shows is left out."""
    performer = omote.Performer(cast)
    playing = list(cast_pads(cast).values())
    playing.append(omote.Pad("brows", "brows", 2, playing[0].looks))
    step = 0

    def advance() -> None:
        nonlocal step
        step += 1
        if step % 300 == 1:
            performer.call_face("kaori" if step % 600 == 1 else "old", seconds=4.0)
            performer.call_expression("joy" if step % 600 == 1 else "sad", seconds=4.0)
        if pads:
            for place, pad in enumerate(playing):
                performer.move_pad(pad, 0.9 * math.sin(0.02 * step + place), 0.9 * math.cos(0.03 * step))
        performer.advance(1.0 / RATE)

    return microseconds(advance, 100)


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=secrets.randbelow(1_000_000))
    seed = parser.parse_args().seed
    table = Table(title=f"kick, median / 95 %, seed {seed}", title_justify="left")
    for column in ("dimensions", "soft bands", "Delaunay"):
        table.add_column(column)
    met = True
    for dimensions in (1, 2, 3):
        mine = np.percentile(kicks(ours, seed, dimensions), (50, 95))
        peer = None if dimensions == 1 else np.percentile(kicks(delaunay, seed, dimensions), (50, 95))
        met &= dimensions == 1 or bool(np.all(mine <= BAR_KICK))
        shown = "" if peer is None else f"{peer[0]:.2f} / {peer[1]:.2f}"
        table.add_row(str(dimensions), f"{mine[0]:.2f} / {mine[1]:.2f}", shown)
    console = Console(width=120)
    console.print(table)
    places = layout(np.random.default_rng(seed), 2, MOST_LOOKS)
    pad, peer_of = pad_of(places), delaunay(places)
    at = tuple(map(float, places.mean(0)))
    mine_us = microseconds(lambda: pad.weights_at(at))
    peer_us = microseconds(lambda: peer_of(places.mean(0)))
    met &= mine_us <= BAR_MICROSECONDS
    console.print(f"twelve looks: {mine_us:.2f} us, Delaunay {peer_us:.1f} us: {peer_us / mine_us:.1f} times as long")
    cast = omote.load_cast()
    without, with_pads = tick(cast, pads=False), tick(cast, pads=True)
    more = with_pads - without
    console.print(f"tick of a character: {without:.1f} us, with four pads that move {with_pads:.1f}, {more:.1f} more")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
