"""Real performances, played through every face: what folds, and how much more a face jitters than the generic one.

A take of Live Link Face (the data is beside the repository; a synthetic take where it is absent) plays the units of the
generic face, of all others of the cast and of new random ones, as it would on air: compounds blended, then correctives
of combinations. Beside it, blended in the same run: added deltas and deformation transfer.

* Folds: triangles of the sheet turned over against the face at rest, a frame; those of ears that turn left out.
* Jitter: of each vertex, the largest changes of step (second differences, 99.9 % of the frames have less) over its
  own amplitude (95 %), beside the same of the generic face; that of a face is the 99th percentile over its vertices.
  Vertices that move less than half a millimetre say nothing. Peers beside the generic face played plainly.

The bars: no fold on any face, the generic one among them; jitter at most 1.5 of the generic face's.

`python -m benchmarks.performance_take [--take CSV] [--faces kaori,dog] [--new 12] [--seed N] [--every 5]
[--no-peers] [--pictures FOLDER]`; a quick look: `--every 5` plays one second of five. Without a seed each run draws
its own and prints it. Ends with 1 where a bar is missed.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import secrets
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table

import omote
from benchmarks.maps.measures import find_folds
from benchmarks.maps.methods import DEFORMATION, DELTAS, METHODS, OURS
from benchmarks.maps.random_faces import CARICATURES, MIXES, PEOPLE, STRONG, draw_faces
from benchmarks.maps.source import Source, load_source
from omote.inputs.takes.live_link_take import read_live_link_take
from omote.model.cast import Cast
from omote.model.known_names import GENERIC, NEUTRAL
from omote.model.space.ears import ear_weights
from omote.model.space.face import Face
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST
from tools.tracking.films import talk

Values = NDArray[np.float64]
Player = Callable[[Values], Values]
"""Weights of the units in one frame (u,) to the skin (V, 3)."""
TAKE = Path(__file__).resolve().parents[2] / "shared" / "data" / "livelinkface" / "alex_rom_3.csv"
RATE = 30
SYNTHETIC = 1200
"""Frames a second; of a synthetic take."""
MOVES = 5e-4
"""Metres that a vertex must move to say something about jitter."""
MOST_FRAMES = 0.999
AMPLITUDE = 0.95
MOST_VERTICES = 0.99
BAR = 1.5
WORST = 10
"""Frames that are named and drawn."""


@dataclass(frozen=True)
class Take:
    """The units' names, their weights (frames, units), and which run of consecutive frames each belongs to."""

    name: str
    units: tuple[str, ...]
    weights: Values
    times: Values
    runs: NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Played:
    """A take on one face: folds of each frame; amplitude and largest changes of step of each vertex, metres."""

    method: str
    face: str
    folds: NDArray[np.intp]
    shared: int
    amplitude: Values
    steps: Values


def read_take(path: Path, seed: int) -> Take:
    """A take of Live Link Face; a synthetic one where there is no such file."""
    if not path.exists():
        return synthetic_take(seed)
    take = read_live_link_take(path.read_text(encoding="utf-8"))
    weights = np.clip(np.array(take.values, np.float64), CHANNEL_LOWEST, CHANNEL_HIGHEST)
    return Take(path.stem, tuple(take.names), weights, np.array(take.times), np.zeros(len(weights), np.intp))


def synthetic_take(seed: int) -> Take:
    """Talk with feelings and blinks, as of the training of the camera's map."""
    moments = talk(np.random.default_rng(seed), SYNTHETIC)
    units = tuple(sorted({name for moment in moments for name in moment.weights}))
    weights = np.array([[moment.weights.get(name, 0.0) for name in units] for moment in moments])
    times = np.arange(SYNTHETIC) / RATE
    return Take("a synthetic take: the data is absent", units, weights, times, np.zeros(SYNTHETIC, np.intp))


def thin(take: Take, every: int) -> Take:
    """One second of so many, each a run of its own."""
    second = (take.times - take.times[0]).astype(np.intp)
    kept = second % every == 0
    return replace(take, weights=take.weights[kept], times=take.times[kept], runs=second[kept] // every * (every > 1))


# ---- ways to play it


def ours(cast: Cast, face: str, units: Sequence[str]) -> Player:
    """As programs, and stages on the GPU, do it: compounds blended, correctives of combinations."""

    def play(weights: Values) -> Values:
        channels = {unit: weight for unit, weight in zip(units, weights.tolist(), strict=True) if weight}
        return evaluate(cast, Frame({face: 1.0}, {NEUTRAL: 1.0}, channels)).astype(np.float64)

    return play


def plain(source: Source, method: str, face: Face, units: Sequence[str]) -> Player:
    """A peer: what each unit does alone, added up."""
    rest = face.positions.astype(np.float64)
    wear = METHODS[method](source, face)
    moves = np.array([(wear(unit) - rest).ravel() for unit in units])
    return lambda weights: rest + (weights @ moves).reshape(rest.shape)


def players(cast: Cast, source: Source, face: str, units: Sequence[str], peers: bool) -> Iterator[tuple[str, Player]]:
    """All ways on a face."""
    yield OURS, ours(cast, face, units)
    if peers:
        for method in (DELTAS, DEFORMATION):
            yield method, plain(source, method, cast.faces[face], units)


# ---- what is measured


class Measure:
    """Folds and jitter of a take."""

    def __init__(self, cast: Cast, take: Take) -> None:
        self._cast = cast
        self._take = take
        self._sheet = cast.space.sheet_triangles
        self._used = np.unique(self._sheet)
        self._ears = (ear_weights(cast.space).max(axis=0) > 0.0)[self._sheet].any(axis=1)
        self._folded: dict[str, list[NDArray[np.bool_]]] = {}

    def play(self, method: str, face: str, player: Player) -> Played:
        """A face that wears the take; the generic one first."""
        rest = self._cast.faces[face].positions.astype(np.float64)
        counted = ~self._ears | (not turns_ears(self._cast.faces[face]))
        path = np.empty((len(self._take.weights), len(self._used), 3), np.float32)
        folded = []
        for frame, weights in enumerate(self._take.weights):
            now = player(weights)
            path[frame] = (now - rest)[self._used]
            folded.append(find_folds(rest, now, self._sheet) & counted)
        known = self._folded.setdefault(method, folded)
        shared = sum(int((here & there).sum()) for here, there in zip(folded, known, strict=True))
        return Played(method, face, np.array([each.sum() for each in folded]), shared, *self._motion(path))

    def _motion(self, path: NDArray[np.float32]) -> tuple[Values, Values]:
        runs = self._take.runs
        amplitude = np.quantile(np.linalg.norm(path, axis=2), AMPLITUDE, axis=0)
        change = np.linalg.norm(path[2:] - 2.0 * path[1:-1] + path[:-2], axis=2)[runs[2:] == runs[:-2]]
        return amplitude, np.quantile(change, MOST_FRAMES, axis=0)


def turns_ears(face: Face) -> bool:
    """Whether a face answers with its ears."""
    return any(gain.region == "ears" and gain.value != 0.0 for gain in face.gains)


def jitter(played: Played, generic: Played) -> float:
    """How much more a face jitters than the generic one, vertex by vertex."""
    moved = (generic.amplitude > MOVES) & (played.amplitude > MOVES)
    here, there = (each.steps[moved] / each.amplitude[moved] for each in (played, generic))
    return float(np.quantile(here / there, MOST_VERTICES))


# ---- what is told


def new_faces(cast: Cast, count: int, seed: int) -> dict[str, Face]:
    """Random faces of all kinds, half of them ordinary people."""
    kinds = {PEOPLE: count - 3 * (count // 6), STRONG: count // 6, CARICATURES: count // 6, MIXES: count // 6}
    return {face.name: face for faces in draw_faces(cast, seed, kinds).values() for face in faces}


def show(console: Console, rows: Sequence[Played]) -> None:
    """The table of all faces."""
    table = Table(title="folds a frame (the worst frame), and jitter beside the generic face's", title_justify="left")
    methods = list(dict.fromkeys(row.method for row in rows))
    generic = {row.method: row for row in rows if row.face == GENERIC}
    table.add_column("face")
    for method in methods:
        for column in (f"{method}: folds", "worst", "as the generic", "jitter"):
            table.add_column(column, justify="right")
    for face in dict.fromkeys(row.face for row in rows):
        cells = list[str]()
        for row in (row for row in rows if row.face == face):
            frames = len(row.folds)
            cells += [f"{row.folds.sum() / frames:.3f}", str(row.folds.max()), f"{row.shared / frames:.3f}"]
            cells.append(f"{jitter(row, generic[row.method]):.2f}")
        table.add_row(face, *cells)
    console.print(table)


def find_worst(rows: Sequence[Played], take: Take) -> list[tuple[int, Played, int]]:
    """Ours, the frames that fold most: (folds, face, frame); of those within a second on a face the worst alone."""
    found: dict[tuple[str, int], tuple[int, Played, int]] = {}
    for row in (row for row in rows if row.method == OURS):
        for frame in np.flatnonzero(row.folds):
            key = (row.face, int(take.times[frame]))
            count = int(row.folds[frame])
            if key not in found or count > found[key][0]:
                found[key] = count, row, int(frame)
    return sorted(found.values(), key=lambda each: -each[0])[:WORST]


def tell_worst(console: Console, worst: Sequence[tuple[int, Played, int]], take: Take) -> None:
    """Names the worst frames, so that they can be looked at."""
    for count, row, frame in worst:
        weights = dict(zip(take.units, take.weights[frame], strict=True))
        strongest = sorted(weights, key=lambda unit: -abs(weights[unit]))[:8]
        said = ", ".join(f"{unit} {weights[unit]:.2f}" for unit in strongest)
        console.print(f"{count} folds: {row.face} at {take.times[frame]:.2f} s, {said}")


def draw(cast: Cast, worst: Sequence[tuple[int, Played, int]], take: Take, folder: Path) -> None:
    """The worst frames as the stage draws them."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, (_, row, frame) in enumerate(worst):
        channels = dict(zip(take.units, take.weights[frame].tolist(), strict=True))
        path = folder / f"{number}-{row.face.split(':')[0]}-{take.times[frame]:.2f}.png".replace(" ", "-")
        omote.render(cast, Frame({row.face: 1.0}, {NEUTRAL: 1.0}, channels), size=(960, 1080), quality="low", path=path)


def verdict(console: Console, rows: Sequence[Played]) -> bool:
    """Prints the bars; whether all hold."""
    found = {row.face: row for row in rows if row.method == OURS}
    folding = max(found.values(), key=lambda row: int(row.folds.sum()))
    shaky = max(found.values(), key=lambda row: jitter(row, found[GENERIC]))
    shaking = jitter(shaky, found[GENERIC])
    claims = (
        (f"folds in {len(folding.folds)} frames: {folding.folds.sum()} on {folding.face}", not folding.folds.any()),
        (f"jitter: {shaking:.2f} of the generic face's on {shaky.face}, of {BAR}", shaking <= BAR),
    )
    for told, holds in claims:
        console.print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return all(holds for _, holds in claims)


def parse() -> argparse.Namespace:
    """The options."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--take", type=Path, default=TAKE)
    parser.add_argument("--faces", default="")
    parser.add_argument("--new", type=int, default=12)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--pictures", type=Path)
    return parser.parse_args()


def main() -> int:
    """Plays, measures and prints; 1 where a bar is missed."""
    asked = parse()
    seed = secrets.randbits(32) if asked.seed is None else asked.seed
    console = Console(width=200)
    source = load_source()
    take = thin(read_take(asked.take, seed), asked.every)
    made: Mapping[str, Face] = new_faces(source.cast, asked.new, seed)
    looks = {**source.cast.looks, **dict.fromkeys(made, source.cast.looks[GENERIC])}
    cast = replace(source.cast, faces={**source.cast.faces, **made}, looks=looks)
    wanted = [face for face in asked.faces.split(",") if face] or [*source.cast.faces]
    measure = Measure(cast, take)
    rows = list[Played]()
    console.print(f"{take.name}: {len(take.weights)} frames; new faces of seed {seed}")
    for face in track(dict.fromkeys([GENERIC, *wanted, *made]), "faces", console=Console(stderr=True)):
        ways = players(cast, source, face, take.units, not asked.no_peers)
        rows += [measure.play(method, face, player) for method, player in ways]
    show(console, rows)
    worst = find_worst(rows, take)
    tell_worst(console, worst, take)
    if asked.pictures:
        draw(cast, worst, take, asked.pictures)
    return 0 if verdict(console, rows) else 1


if __name__ == "__main__":
    sys.exit(main())
