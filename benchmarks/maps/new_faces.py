"""What is asked of the map on faces that nobody tuned it on, and the tables of that."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from benchmarks.maps.bars import LATE, Run, Verdict, at_most, median_time, slow, worst
from benchmarks.maps.figures import Figures
from benchmarks.maps.methods import DEFORMATION, OURS
from benchmarks.maps.random_faces import CARICATURES, MIXES, PEOPLE
from benchmarks.maps.report import Row

NATURAL = (PEOPLE, MIXES, CARICATURES)
"""Kinds of faces that may not fold; strong ones are printed."""
KIND_HEAD = (
    "kind", "map", "faces with a fold, %", "folds per 100", "per triple", "new", "lids mean", "along", "lips",
    "eyes > .3 mm, %", "bag, %", "teeth, %", "sockets, %", "ms", "p95",
)  # fmt: skip
WORST_HEAD = (
    "face", "folds", "units", "lids", "along", "lips", "eyes, mm", "bag, mm", "teeth, mm", "sockets, mm",
    "new in triples",
)  # fmt: skip
TRIPLE_HEAD = ("triple", "faces", "triangles")
INSIDE = ("eyes", "bag", "teeth", "sockets")
PIERCED = 0.3e-3
MEDIAN = 4.0 / 1.8
"""As `LATE`, of the median: issue 13 asked for 4 ms."""

Kinds = Mapping[str, Run]


def new_verdicts(kinds: Kinds) -> list[Verdict]:
    """The bars of issue 13 over new faces; runs by kind of face."""
    named = {name: figures for kind in NATURAL if kind in kinds for name, figures in kinds[kind][OURS].items()}
    natural = [*named.values()]
    every = [figures for run in kinds.values() for figures in run[OURS].values()]
    pierced = {part: _share(every, part) for part in INSIDE}
    return [
        Verdict("faces with a fold, % of people, mixes, caricatures", _folding(natural), 0.0),
        Verdict("folds of triples where no summand folds, people, mixes, caricatures", _new(natural), 0.0),
        Verdict("lids, worst unit, median face", _median(every, "lids", 0), 0.02),
        Verdict("lids along, worst unit, median face", _median(every, "lids", 1), 0.04),
        Verdict("lips, worst unit, median face", _median(every, "lips", 0), 0.03),
        worst("lids, worst of people, mixes, caricatures", named, lambda f: f.lids[0], 0.04),
        worst("lids along, worst of people, mixes, caricatures", named, lambda f: f.lids[1], 0.08),
        worst("lips, worst of people, mixes, caricatures", named, lambda f: f.lips[0], 0.06),
        *(Verdict(f"{part} over .3 mm, % of faces", share, 0.0) for part, share in pierced.items()),
        *_time_verdicts(kinds),
    ]


def _time_verdicts(kinds: Kinds) -> list[Verdict]:
    """Time beside deformation transfer's in the same run; none where that was not asked."""
    times = {(kind, name): figures for kind, run in kinds.items() for name, figures in run[OURS].items()}
    peers = {(kind, name): figures for kind, run in kinds.items() for name, figures in run.get(DEFORMATION, {}).items()}
    if not peers:
        return []
    peer = median_time(peers)
    return [
        Verdict("time, median, over deformation transfer's median", median_time(times) / peer, MEDIAN),
        Verdict("time, 95th percentile, over deformation transfer's median", slow(times) / peer, LATE),
    ]


def _folding(faces: Sequence[Figures]) -> float:
    return 100.0 * float(np.mean([figures.folds > 0 for figures in faces]))


def _new(faces: Sequence[Figures]) -> float:
    return float(sum(figures.sums.new_folds for figures in faces))


def _median(faces: Sequence[Figures], line: str, which: int) -> float:
    return float(np.median([getattr(figures, line)[which].value for figures in faces]))


def _share(faces: Sequence[Figures], part: str) -> float:
    return 100.0 * float(np.mean([getattr(figures, part).value > PIERCED for figures in faces]))


def kind_rows(kinds: Kinds) -> list[Row]:
    """One row a kind of faces and map: medians over faces of the worst unit, shares of faces."""
    return [(kind, method, *_cells([*run[method].values()])) for kind, run in kinds.items() for method in run]


def _cells(faces: Sequence[Figures]) -> Row:
    times = [time for figures in faces for time in figures.times]
    triples = max(sum(figures.sums.triples for figures in faces), 1)
    return (
        f"{_folding(faces):.0f}",
        f"{100 * sum(f.folds for f in faces) / sum(f.units for f in faces):.2f}",
        f"{sum(f.sums.folds for f in faces) / triples:.2f}",
        f"{_new(faces) / triples:.3f}",
        f"{_median(faces, 'lids', 0):.3f}",
        f"{_median(faces, 'lids', 1):.3f}",
        f"{_median(faces, 'lips', 0):.3f}",
        *(f"{_share(faces, part):.0f}" for part in INSIDE),
        f"{1e3 * float(np.median(times)):.1f}",
        f"{1e3 * float(np.quantile(times, 0.95)):.1f}",
    )


def worst_rows(kinds: Kinds, count: int = 10) -> list[Row]:
    """Ours on the faces with most folds, then with the deepest teeth."""
    faces = {name: figures for run in kinds.values() for name, figures in run[OURS].items()}
    order = sorted(faces, key=lambda name: (faces[name].folds, faces[name].teeth.value), reverse=True)
    return [(name, *_worst_cells(faces[name])) for name in order[:count]]


def _worst_cells(figures: Figures) -> Row:
    units = sorted(figures.folded, key=lambda unit: -figures.folded[unit])
    return (
        str(figures.folds),
        ", ".join(f"{unit} {figures.folded[unit]}" for unit in units[:3]),
        f"{figures.lids[0].value:.3f} {figures.lids[0].unit}",
        f"{figures.lids[1].value:.3f} {figures.lids[1].unit}",
        f"{figures.lips[0].value:.3f} {figures.lips[0].unit}",
        *(f"{1e3 * worst.value:.2f} {worst.unit}" for worst in (getattr(figures, part) for part in INSIDE)),
        str(figures.sums.new_folds),
    )


def triple_rows(kinds: Kinds, count: int = 10) -> list[Row]:
    """The triples that fold most where no summand does, ours."""
    triangles = Counter[tuple[str, ...]]()
    faces = Counter[tuple[str, ...]]()
    for run in kinds.values():
        for figures in run[OURS].values():
            triangles.update(figures.sums.folded)
            faces.update(figures.sums.folded.keys())
    return [(" + ".join(triple), str(faces[triple]), str(found)) for triple, found in triangles.most_common(count)]


def crossing_rows(kinds: Kinds) -> list[Row]:
    """How far lids and lips cross, lids pierce and teeth stand out in triples, more than their summands, the worst of a
    kind, mm; and in how many triples teeth do by more than .3 mm."""
    return [
        (kind, f"{1e3 * max(at_most(f.sums.crossed).value for f in run[OURS].values()):.2f}",
         f"{1e3 * max(at_most(f.sums.eyes).value for f in run[OURS].values()):.2f}",
         f"{1e3 * max(at_most(f.sums.teeth).value for f in run[OURS].values()):.2f}",
         f"{100 * np.mean([out > PIERCED for f in run[OURS].values() for out in f.sums.teeth]):.2f}")
        for kind, run in kinds.items()
    ]  # fmt: skip


CROSSING_HEAD = ("kind", "lids and lips cross in triples, mm", "eyes, mm", "teeth, mm", "triples with teeth out, %")
