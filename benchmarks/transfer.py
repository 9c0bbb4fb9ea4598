"""How well four maps carry expressions from the generic face to others (docs/method.md, "The smooth map").

Added deltas, deformation transfer, the paper's map and ours: folds, of units and of sums of three, and what these
cross and pierce; closure of lids and lips at five levels; eyes in lids and teeth in lips; roughness; time. All against
the source's own figures, in one run; ends with 1 where a bar is missed. First 86 units and 200 sums on every face of
the cast; then 106 (with performed ones) and 60 sums on faces that nobody tuned on: 30 people, 10 strong ones, 10
caricatures, 10 regional mixes, another seed in each run (printed; the people need the package that the bake keeps).

Usage: python -m benchmarks.transfer [--write] [--units N] [--faces kaori,baby] [--only cast|new] [--seed N]
[--new people=3,mixes=1] [--methods ours] [--workers 2]. --write puts the tables into docs/transfer.md; fewer units,
faces or methods are for a quick look.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import secrets
import sys
from collections.abc import Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track

from benchmarks.maps import new_faces, report
from benchmarks.maps.bars import Run, Verdict, verdicts
from benchmarks.maps.figures import Comparison, Figures
from benchmarks.maps.methods import METHODS, OURS
from benchmarks.maps.random_faces import COUNTS, draw_faces
from benchmarks.maps.source import KINDS, PLAYED, SEED, TRIPLES, load_source
from omote.model.known_names import GENERIC
from omote.model.space.face import Face

PAGE = Path(__file__).resolve().parent.parent / "docs" / "transfer.md"
NEW_TRIPLES = 60

Question = tuple[int | None, tuple[str, ...], int, int]
"""Units, their kinds, the triples' seed and how many."""
Points = NDArray[np.floating]
Parts = Mapping[str, Points]
Measured = dict[str, Figures]
Table = tuple[str, report.Row, list[report.Row]]


@cache
def compare(question: Question) -> Comparison:
    """The source's own figures, once a process."""
    units, kinds, seed, count = question
    return Comparison(load_source(units, kinds=kinds, seed=seed, count=count))


def measure_face(question: Question, methods: tuple[str, ...], name: str, points: Points, parts: Parts) -> Measured:
    """The figures of maps on one face, by map; what it answers expressions with, its gains, does not count."""
    face = Face(name, points, parts)
    bench = compare(question)
    found = {}
    for method in methods:
        worn = METHODS[method](bench.source, face)
        worn(next(iter(bench.source.moves)))  # compiles, allocates
        found[method] = bench.measure(method, face, worn)
    return found


def measure_maps(
    console: Console, workers: int, question: Question, faces: Iterable[Face], methods: tuple[str, ...]
) -> Run:
    """Figures by map and face."""
    chosen = list(faces)
    run: dict[str, dict[str, Figures]] = {method: {} for method in methods}
    with ProcessPoolExecutor(workers, get_context("spawn")) as pool:
        waiting = [
            pool.submit(measure_face, question, methods, face.name, face.positions, dict(face.parts)) for face in chosen
        ]
        for face, figures in track(zip(chosen, waiting, strict=True), "faces", total=len(chosen), console=console):
            for method, each in figures.result().items():
                run[method][face.name] = each
    return run


def measure_cast(
    console: Console, given: argparse.Namespace, methods: tuple[str, ...]
) -> tuple[list[Verdict], list[Table]]:
    """Verdicts and tables of the cast; the generic face itself is the source and left out."""
    question: Question = (given.units, KINDS, SEED, TRIPLES)
    names = [name for name in given.faces.split(",") if name]
    faces = compare(question).source.cast.faces.items()
    chosen = [face for name, face in faces if name != GENERIC and (not names or name in names)]
    run = measure_maps(console, given.workers, question, chosen, methods)
    found = verdicts(run) if len(methods) == len(METHODS) else []
    return found, [
        ("Four maps, the worst face named", report.METHOD_HEAD, report.method_rows(run, TRIPLES)),
        ("Ours, face by face (* no people)", report.FACE_HEAD, report.face_rows(run[OURS], TRIPLES)),
        ("Sums of three, the worst face named", report.SUM_HEAD, report.sum_rows(run)),
        ("Bars", report.BAR_HEAD, report.bar_rows(found)),
    ]


def measure_new(
    console: Console, given: argparse.Namespace, methods: tuple[str, ...]
) -> tuple[list[Verdict], list[Table]]:
    """Verdicts and tables of new faces."""
    question: Question = (given.units, PLAYED, given.seed, NEW_TRIPLES)
    drawn = draw_faces(compare(question).source.cast, given.seed, read_counts(given.new))
    every = [face for faces in drawn.values() for face in faces]
    run = measure_maps(console, given.workers, question, every, methods)
    kinds: Mapping[str, Run] = {
        kind: {method: {face.name: run[method][face.name] for face in faces} for method in methods}
        for kind, faces in drawn.items()
        if faces
    }
    found = new_faces.new_verdicts(kinds)
    return found, [
        (f"New faces, seed {given.seed}", new_faces.KIND_HEAD, new_faces.kind_rows(kinds)),
        ("Their worst, ours", new_faces.WORST_HEAD, new_faces.worst_rows(kinds)),
        ("Sums that fold where no summand does, ours", new_faces.TRIPLE_HEAD, new_faces.triple_rows(kinds)),
        ("Sums, the worst face", new_faces.CROSSING_HEAD, new_faces.crossing_rows(kinds)),
        ("Bars of new faces", report.BAR_HEAD, report.bar_rows(found)),
    ]


def read_counts(text: str) -> dict[str, int]:
    """How many faces of each kind: `people=3,mixes=1`; all of them where nothing is said."""
    if not text:
        return dict(COUNTS)
    counts = {kind: int(count) for kind, count in (each.split("=") for each in text.split(","))}
    strange = [kind for kind in counts if kind not in COUNTS]
    if strange:
        raise SystemExit(f"--new names {strange[0]!r}; expected some of {', '.join(COUNTS)}, such as people=3,mixes=1")
    return counts


def parse_arguments() -> argparse.Namespace:
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--write", action="store_true", help="put the tables into docs/transfer.md")
    parser.add_argument("--units", type=int, help="this many units, spread over all")
    parser.add_argument("--faces", default="", help="these faces of the cast only, separated by commas")
    parser.add_argument("--only", choices=("cast", "new"), help="the cast alone, or new faces alone")
    parser.add_argument("--seed", type=int, default=secrets.randbelow(10**6), help="of the new faces; drawn anew")
    parser.add_argument("--new", default="", help="how many new faces, such as people=3,mixes=1")
    parser.add_argument("--methods", default=",".join(METHODS), help="some of " + ", ".join(METHODS))
    parser.add_argument("--workers", type=int, default=min(os.cpu_count() or 1, 4), help="processes")
    return parser.parse_args()


def main() -> int:
    """Prints the tables; 0 when every bar is held."""
    given = parse_arguments()
    console = Console(width=190)
    methods = tuple(given.methods.split(","))
    found: list[Verdict] = []
    tables: list[Table] = []
    for part, measure in (("cast", measure_cast), ("new", measure_new)):
        if given.only in (None, part):
            verdict, shown = measure(console, given, methods)
            found += verdict
            tables += shown
    for title, head, rows in tables:
        report.show(console, title, head, rows)
    if given.write:
        parts = [f"### {title}\n\n{report.markdown(head, rows)}" for title, head, rows in tables]
        report.write_between(PAGE, "\n\n".join(parts))
    return 0 if all(bar.met for bar in found) else 1


if __name__ == "__main__":
    sys.exit(main())
