"""What gains do to faces that nobody tuned (issue 10; docs/method.md, "Where gains give way").

Random faces (mixes of three of the cast) with random gains, 0 to 2 in every region, wear every unit and every performed
expression; dog and cat theirs. Counted: triangles turned over here and not on the generic face that wears the same
without gains; how much further lids and lips cross, and how much deeper skin lies in eyeballs, than on the same face
without gains. The peer is the same gains without their limit. Ears are still here (`tests/model/space/test_ears.py`
turns them). The bars: no fold; half a millimetre crossed or pierced more. Ends with 1 where a bar is missed.

Usage: python -m benchmarks.gain_folds [--faces 20] [--seed 1993]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import sys
from dataclasses import dataclass, field, replace
from time import thread_time

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table

from benchmarks.maps.source import Source, load_source
from benchmarks.maps.sums import Sums
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.gain import FIELD_REGIONS, Gain, answer, field_gain
from omote.model.transfer.compound import apply_expression
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import prepare_smooth_map

Values = NDArray[np.float64]

KINDS = ("arkit", "makehuman", "performed")
ANIMALS = ("dog", "cat")
MOST_GAIN = 2.0
SLACK = 0.5
LIMITED = "limited"
UNLIMITED = "without the limit"


@dataclass
class Tally:
    """What was found on some faces: folded triangles, where most of them are; crossings and eyes, millimetres more than
    without gains; milliseconds of this thread for an answer."""

    compounds: int = 0
    folds: int = 0
    most: tuple[int, str] = (0, "")
    crossed: float = 0.0
    eyes: float = 0.0
    times: list[float] = field(default_factory=list)


def draw_face(source: Source, draw: np.random.Generator, number: int) -> Face:
    """A mix of three faces of the cast, with gains."""
    names = draw.choice(list(source.cast.faces), 3, replace=False)
    shares = draw.dirichlet(np.ones(3))
    shape = sum(share * source.cast.faces[name].positions for share, name in zip(shares, names, strict=True))
    gains = tuple(Gain(region, float(draw.uniform(0.0, MOST_GAIN))) for region in FIELD_REGIONS)
    return Face(f"{number}: {', '.join(names)}", np.asarray(shape), gains=gains)


class GainFolds:
    """The measure of faces with gains against the generic face without."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self._sums = Sums(source)
        cast = source.cast
        self._worn = {
            name: replace(cast.expressions[name], ears=np.zeros((2, 3)))  # how far ears turn is no fold
            for name, title in cast.titles.items()
            if title.kind in KINDS
        }
        self._generic = {name: self._displaced(each) for name, each in self._worn.items()}

    def _displaced(self, expression: Expression) -> Values:
        space = self._source.space
        return self._source.positions + displace_generic(space, compile_expression(space, expression))

    def add(self, tallies: dict[str, Tally], face: Face) -> None:
        """Counts what a face does in every expression that its gains change."""
        space = self._source.space
        rest = face.positions.astype(np.float64)
        for name, expression in self._worn.items():
            if field_gain(space, face.gains, name) is None:
                continue
            plain = self._wear(face, expression)
            for kind, tally in tallies.items():
                begin = thread_time()
                answered = (answer_expression if kind == LIMITED else answer)(space, face.gains, expression)
                tally.times.append(1e3 * (thread_time() - begin))
                self._count(tally, face, name, rest, plain, self._wear(face, answered))

    def _wear(self, face: Face, expression: Expression) -> Values:
        space = self._source.space
        return apply_expression(space, face, compile_expression(space, expression)).astype(np.float64)

    def _count(self, tally: Tally, face: Face, name: str, rest: Values, plain: Values, worn: Values) -> None:
        geometry = prepare_smooth_map(self._source.space, face).geometry
        folds = int(find_folds(geometry, worn, self._generic[name]).sum())
        crossed = [self._sums.find_crossed(rest, points).max() for points in (plain, worn)]
        deep = [self._sums.measure_deep(face, rest, points).max() for points in (plain, worn)]
        tally.compounds += 1
        tally.folds += folds
        if folds > tally.most[0]:
            tally.most = folds, f"{face.name}, {name}"
        tally.crossed = max(tally.crossed, 1e3 * float(crossed[1] - crossed[0]))
        tally.eyes = max(tally.eyes, 1e3 * float(deep[1] - deep[0]))


def show(console: Console, rows: dict[str, dict[str, Tally]]) -> None:
    """The table on the terminal."""
    table = Table(title="Gains", title_justify="left")
    heads = ("faces", "gains", "compounds", "folds", "most", "where", "cross, mm", "eyes, mm", "answer, ms", "p95")
    for column, head in enumerate(heads):
        table.add_column(head, justify="left" if column in (0, 1, 5) else "right")
    for faces, tallies in rows.items():
        for kind, tally in tallies.items():
            table.add_row(
                faces, kind, str(tally.compounds), str(tally.folds), str(tally.most[0]), tally.most[1],
                f"{tally.crossed:.2f}", f"{tally.eyes:.2f}",
                f"{np.mean(tally.times):.2f}", f"{np.quantile(tally.times, 0.95):.2f}",
            )  # fmt: skip
    console.print(table)


def main() -> int:
    """Prints the table; 0 when every bar is held."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--faces", type=int, default=20, help="this many random faces")
    parser.add_argument("--seed", type=int, default=1993)
    given = parser.parse_args()
    console = Console(width=170)
    source = load_source()
    draw = np.random.default_rng(given.seed)
    bench = GainFolds(source)
    groups = {
        "dog and cat": [source.cast.faces[name] for name in ANIMALS],
        "nobody's": [draw_face(source, draw, number) for number in range(given.faces)],
    }
    rows = {name: {LIMITED: Tally(), UNLIMITED: Tally()} for name in groups}
    for name, faces in groups.items():
        for face in track(faces, name, console=console):
            bench.add(rows[name], face)
    show(console, rows)
    found = [tallies[LIMITED] for tallies in rows.values()]
    return 0 if all(tally.folds == 0 and max(tally.crossed, tally.eyes) <= SLACK for tally in found) else 1


if __name__ == "__main__":
    sys.exit(main())
