"""Pads: how smoothly weights go along a stroke, what a point of twelve looks costs, and a tick with four pads.

On fresh layouts (up to 12 looks at least .12 widths of the pad apart) a point goes straight at 2 widths a second, 60
frames a second: between two places inside the hull of the looks, and between any two of the pad, where weights stand
outside. *Kick*: the largest change of the velocity of the weights between two frames, over the median speed of the
stroke; strokes of which most stands are left out. The peer is SciPy's Delaunay triangulation with barycentric weights,
as blend spaces of game engines have it; it has none outside the hull.

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
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table
from scipy.spatial import Delaunay

import omote
from omote.perform.pads.blend_space import MOST_LOOKS
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.hand.pads import MovePad, SetPad
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from omote.show.wire import encode

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
STANDS = 1e-3
"""Of a weight a frame."""
BAR_KICK = 1.3, 4.5
"""Median and 95 % of strokes, of two dimensions."""
BAR_MICROSECONDS = 3.0
BAR_TICK = 1.3
PLAYED = {"moods": "jawOpen", "mouth": "mouthLeft", "faces": "cheekPuff", "brows": "browInnerUp"}
"""The pads that move, and the channels that hands move instead."""

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


def kicks(make: Callable[[Values], Weigh], seed: int, dimensions: int, *, anywhere: bool = False) -> Values:
    """The kick of each stroke; anywhere: on the pad, and not only inside the hull of the looks."""
    rng = np.random.default_rng([seed, dimensions])
    found = []
    for _ in range(LAYOUTS):
        places = layout(rng, dimensions)
        weigh = make(places)
        for _ in range(STROKES):
            begin, end = rng.dirichlet(np.ones(len(places)), 2) @ places
            if anywhere:
                begin, end = rng.uniform(-1.0, 1.0, (2, dimensions))
            steps = round(math.dist(begin, end) / (WIDTH * SPEED) * RATE)
            if steps < 6:
                continue
            rows = np.array([weigh(begin + (end - begin) * step / steps) for step in range(steps + 1)])
            moved = np.diff(rows, axis=0)
            bent = np.linalg.norm(np.diff(moved, axis=0), axis=1).max()
            speed = np.median(np.linalg.norm(moved, axis=1))
            if speed > STANDS:
                found.append(bent / speed)
    return np.array(found)


def microseconds(call: Callable[[], object], number: int = 100, repeat: int = 300) -> float:
    """What a call costs, the least of many means of a number of calls."""
    return min(timeit.repeat(call, number=number, repeat=repeat)) / number * 1e6


def tick(cast: omote.Cast, *, pads: bool) -> float:
    """Microseconds of a tick of a show with one character, from its messages to the bytes of its state: a face and an
    expression that are called, and hands on four channels; or four pads that move instead of these hands."""
    session = ShowSession(cast)
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    brows = replace(session.scene.pads["moods"], name="brows", part="brows")
    session.receive("ana", SetPad("p", brows.name, brows.part, 2, list(brows.looks)), 0.0)
    step = 0

    def advance() -> None:
        nonlocal step
        step += 1
        now = step / RATE
        if step % 300 == 1:
            name = ("kaori", "joy") if step % 600 == 1 else ("old", "sad")
            session.receive("ana", CallFace("one", f"f{step}", name[0], 4.0), now)
            session.receive("ana", CallExpression("one", f"e{step}", name[1], 4.0), now)
        for place, (pad, channel) in enumerate(PLAYED.items()):
            x, y = 0.9 * math.sin(0.02 * step + place), 0.9 * math.cos(0.03 * step)
            session.receive(
                "ana", MovePad("one", pad, x, y) if pads else SetChannel("one", channel, 0.5 + 0.5 * x), now
            )
        encode(session.tick(now))
        session.hands_now(now)

    return microseconds(advance, 10, 400)


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=secrets.randbelow(1_000_000))
    seed = parser.parse_args().seed
    table = Table(title=f"kick, median / 95 %, seed {seed}", title_justify="left")
    for column in ("dimensions", "soft bands", "anywhere", "Delaunay"):
        table.add_column(column)
    met = True
    for dimensions in (1, 2, 3):
        mine = np.percentile(kicks(ours, seed, dimensions), (50, 95))
        wide = np.percentile(kicks(ours, seed, dimensions, anywhere=True), (50, 95))
        peer = None if dimensions == 1 else np.percentile(kicks(delaunay, seed, dimensions), (50, 95))
        met &= dimensions != 2 or bool(np.all(mine <= BAR_KICK) and np.all(wide <= BAR_KICK))
        shown = "" if peer is None else f"{peer[0]:.2f} / {peer[1]:.2f}"
        table.add_row(str(dimensions), f"{mine[0]:.2f} / {mine[1]:.2f}", f"{wide[0]:.2f} / {wide[1]:.2f}", shown)
    console = Console(width=120)
    console.print(table)
    places = layout(np.random.default_rng(seed), 2, MOST_LOOKS)
    pad = pad_of(places)
    peer_of = delaunay(places)
    at = tuple(map(float, places.mean(0)))
    mine_us = microseconds(lambda: pad.weights_at(at))
    peer_us = microseconds(lambda: peer_of(places.mean(0)))
    met &= mine_us <= BAR_MICROSECONDS
    console.print(f"twelve looks: {mine_us:.2f} us, Delaunay {peer_us:.1f} us: {peer_us / mine_us:.1f} times as long")
    cast = omote.load_cast()
    without = tick(cast, pads=False)
    with_pads = tick(cast, pads=True)
    met &= with_pads <= BAR_TICK * without
    console.print(f"tick: {without:.0f} us, with four pads that move {with_pads:.0f}: {with_pads / without:.2f} of it")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
