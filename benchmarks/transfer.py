"""How well four maps carry 86 units from the generic face to every face of the cast (docs/method.md, "The smooth map").

Added deltas, deformation transfer, the paper's map and ours: folds, of units and of 200 sums of three, and what these
cross and pierce; closure of lids and lips at five levels; eyes in lids and teeth in lips; roughness; time. All against
the source's own figures, in one run; ends with 1 where a bar is missed.

Usage: python -m benchmarks.transfer [--write] [--units N] [--faces kaori,baby]. --write puts the tables into
docs/transfer.md; fewer units or faces are for a quick look.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import sys
from pathlib import Path

from rich.console import Console
from rich.progress import track

from benchmarks.maps import report
from benchmarks.maps.bars import Run, verdicts
from benchmarks.maps.figures import Comparison, Figures
from benchmarks.maps.methods import METHODS, OURS
from benchmarks.maps.source import TRIPLES, load_source
from omote.model.known_names import GENERIC

PAGE = Path(__file__).resolve().parent.parent / "docs" / "transfer.md"


def measure_maps(console: Console, units: int | None, faces: list[str]) -> Run:
    """Figures by map and face; the generic face itself is the source and left out."""
    source = load_source(units)
    bench = Comparison(source)
    chosen = [face for name, face in source.cast.faces.items() if name != GENERIC and (not faces or name in faces)]
    run: dict[str, dict[str, Figures]] = {method: {} for method in METHODS}
    for face in track(chosen, "faces", console=console):
        for method, prepare in METHODS.items():
            worn = prepare(source, face)
            worn(next(iter(source.moves)))  # compiles, allocates
            run[method][face.name] = bench.measure(method, face, worn)
    return run


def main() -> int:
    """Prints the tables; 0 when every bar is held."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--write", action="store_true", help="put the tables into docs/transfer.md")
    parser.add_argument("--units", type=int, help="this many units, spread over the 86")
    parser.add_argument("--faces", default="", help="these faces only, separated by commas")
    given = parser.parse_args()
    console = Console(width=170)
    run = measure_maps(console, given.units, [name for name in given.faces.split(",") if name])
    found = verdicts(run)
    tables = (
        ("Four maps, the worst face named", report.METHOD_HEAD, report.method_rows(run, TRIPLES)),
        ("Ours, face by face (* no people)", report.FACE_HEAD, report.face_rows(run[OURS], TRIPLES)),
        ("Sums of three, the worst face named", report.SUM_HEAD, report.sum_rows(run)),
        ("Bars", report.BAR_HEAD, report.bar_rows(found)),
    )
    for title, head, rows in tables:
        report.show(console, title, head, rows)
    if given.write:
        parts = [f"### {title}\n\n{report.markdown(head, rows)}" for title, head, rows in tables]
        report.write_between(PAGE, "\n\n".join(parts))
    return 0 if all(bar.met for bar in found) else 1


if __name__ == "__main__":
    sys.exit(main())
