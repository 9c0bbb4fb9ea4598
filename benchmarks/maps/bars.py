"""The requirements on the retargeting map, each as a figure of the whole run against its bar."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.maps.figures import Figures, Worst
from benchmarks.maps.methods import DEFORMATION, OURS
from benchmarks.maps.source import NOT_HUMAN

Faces = Mapping[Any, Figures]
Run = Mapping[str, Faces]

LATE = 10.0 / 1.8
"""Of compounds 95 % take at most so many times what one takes deformation transfer, in the median of the same run:
issue 13 asked for 10 ms where that took 1.8."""


@dataclass(frozen=True)
class Verdict:
    """One bar: what is measured, what was found, what is allowed (at most), and the face it happened on."""

    name: str
    found: float
    bar: float
    face: str = ""

    @property
    def met(self) -> bool:
        """Whether the figure stays within its bar."""
        return self.found <= self.bar + 1e-12


def verdicts(run: Run) -> list[Verdict]:
    """Every bar of a run over the methods and faces."""
    ours = run[OURS]
    peer = run[DEFORMATION]
    people = {name: figures for name, figures in ours.items() if name not in NOT_HUMAN}
    return [
        Verdict("folds per hundred compounds, people", per_hundred(people), 1.0),
        Verdict("folds, all faces, against a fifth of deformation transfer's", folds(ours), folds(peer) / 5),
        Verdict("folds of triples against deformation transfer's", triple_folds(ours), triple_folds(peer)),
        _most_against_peer(ours, peer),
        Verdict("folds per triple where no summand folds", new_folds(ours), 0.25),
        worst("lids and lips cross in triples, mm more than alone", ours, lambda f: at_most(f.sums.crossed), 0.4, 1e3),
        worst("eyes pierce in triples, mm more than alone", ours, lambda f: at_most(f.sums.eyes), 0.3, 1e3),
        worst("lids, mean", ours, lambda f: f.lids[0], 0.02),
        worst("lids, along", ours, lambda f: f.lids[1], 0.04),
        worst("lips, mean", ours, lambda f: f.lips[0], 0.03),
        worst("lips, along", ours, lambda f: f.lips[1], 0.05),
        worst("eyes pierce, mm more than on the source", ours, lambda f: f.eyes, 0.3, 1e3),
        worst("teeth pierce, mm more than on the source", ours, lambda f: f.teeth, 0.3, 1e3),
        worst("mouth bag comes out, mm more than on the source", ours, lambda f: f.bag, 0.3, 1e3),
        worst("lining of the sockets comes out, mm more than on the source", ours, lambda f: f.sockets, 0.3, 1e3),
        Verdict("roughness against deformation transfer's", rough(ours), rough(peer)),
        Verdict("time, 95th percentile, over deformation transfer's median", slow(ours) / median_time(peer), LATE),
    ]


def worst(name: str, faces: Faces, of: Callable[[Figures], Worst], bar: float, scale: float = 1.0) -> Verdict:
    """The bar on the worst of the faces, which is named; nothing is found on none."""
    if not faces:
        return Verdict(name, 0.0, bar)
    face = max(faces, key=lambda name: of(faces[name]).value)
    met = of(faces[face])
    return Verdict(name, scale * met.value, bar, f"{face}, {met.unit}" if met.unit else "")


def _most_against_peer(ours: Faces, peer: Faces) -> Verdict:
    """Folds of triples on the face where they come nearest to, or exceed, deformation transfer's."""
    face = max(ours, key=lambda name: ours[name].sums.folds / max(peer[name].sums.folds, 1))
    return Verdict(
        "the same, face by face: the nearest", float(ours[face].sums.folds), float(peer[face].sums.folds), face
    )


def at_most(values: list[float]) -> Worst:
    """The largest of the triples' values, nothing where there is none."""
    return Worst(max(values, default=0.0))


def new_folds(faces: Faces) -> float:
    """Triangles turned over per sum of three that no summand turns over alone."""
    return sum(f.sums.new_folds for f in faces.values()) / max(sum(f.sums.triples for f in faces.values()), 1)


def folds(faces: Faces) -> float:
    """Folded triangles of all units."""
    return float(sum(figures.folds for figures in faces.values()))


def per_hundred(faces: Faces) -> float:
    """Folded triangles per hundred compounds."""
    return 100 * folds(faces) / sum(figures.units for figures in faces.values())


def triple_folds(faces: Faces) -> float:
    """Folded triangles of all sums of three."""
    return float(sum(figures.sums.folds for figures in faces.values()))


def rough(faces: Faces) -> float:
    """Roughness against the source's, the mean of the faces."""
    return float(np.mean([figures.rough for figures in faces.values()]))


def median_time(faces: Faces) -> float:
    """The median of the times of all compounds, seconds."""
    return float(np.median([time for figures in faces.values() for time in figures.times]))


def slow(faces: Faces) -> float:
    """The 95th percentile of the times of all compounds, seconds."""
    return float(np.quantile([time for figures in faces.values() for time in figures.times], 0.95))
