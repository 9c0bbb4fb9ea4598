"""How far maps are from what other people truly do (docs/method.md, "The smooth map").

Added deltas, deformation transfer, the paper's map and ours, with extraction and without, on the artist's own units of
three origins, from each to each and from the generic head; and on identities of ICT-FaceKit, another topology, where
that is at hand (there deltas are the truth by its making). The error of a unit is |found - true| / |true|; stated is
the median over units, of all skin and by kind: the sheet, inner skin, the mouth bag. Needs the package that the bake
keeps.

Usage: python -m benchmarks.truth [--units N] [--stage-units N] [--seed N] [--only origins|stage]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import secrets
import sys
from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray
from rich.console import Console

import omote
from benchmarks.maps import report
from benchmarks.truths.carriers import CARRIERS
from benchmarks.truths.light_stage import FOLDER, light_stage_pairs
from benchmarks.truths.origins import Origins
from benchmarks.truths.pair import ALL, BAG, INNER, SHEET, Pair, measure_errors
from tools.baking.expressions import MAKEHUMAN

KINDS = (ALL, SHEET, INNER, BAG)
HEAD = ("pair", "map", *KINDS, "worst unit", "its error")

Errors = Mapping[str, NDArray[np.float64]]


def measure_pair(console: Console, pair: Pair) -> None:
    """Prints the figures of all maps on a pair."""
    rows = []
    for name, carrier in CARRIERS.items():
        errors = measure_errors(pair, carrier(pair))
        worst = int(errors[ALL].argmax())
        medians = [f"{np.median(errors[kind]):.3f}" for kind in KINDS]
        rows.append((pair.name, name, *medians, [*pair.true][worst], f"{errors[ALL][worst]:.3f}"))
    report.show(console, pair.name, HEAD, rows)


def known_pairs(console: Console, given: argparse.Namespace) -> Iterator[Pair]:
    """All pairs of people that are asked for and at hand."""
    if given.only in (None, "origins"):
        names = [*MAKEHUMAN]
        chosen = [names[i] for i in np.linspace(0, len(names) - 1, given.units or len(names)).astype(int)]
        origins = Origins(omote.load_cast(), chosen)
        console.print(f"{origins.copies()} of {len(chosen)} units are the same for all origins")
        yield from origins.pairs()
    if given.only in (None, "stage"):
        if FOLDER.is_dir():
            console.print(f"identities of seed {given.seed}")
            yield from light_stage_pairs(given.stage_units, given.seed)
        else:
            console.print("ICT-FaceKit is not at hand; its identities are left out")


def main() -> int:
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--units", type=int, help="this many of the origins' units, spread over all")
    parser.add_argument("--stage-units", type=int, default=12, help="this many of ICT-FaceKit's expressions")
    parser.add_argument("--seed", type=int, default=secrets.randbelow(10**6), help="of its identities; drawn anew")
    parser.add_argument("--only", choices=("origins", "stage"), help="the three origins, or ICT-FaceKit alone")
    given = parser.parse_args()
    console = Console(width=150)
    for pair in known_pairs(console, given):
        measure_pair(console, pair)
    return 0


if __name__ == "__main__":
    sys.exit(main())
