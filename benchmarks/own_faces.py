"""How near fits of scans come to people, what other registrations make of the same, and what fitted faces can wear.

Random people of ICT-FaceKit (a seed drawn anew in each run, printed), given as whole meshes with eyeballs, teeth and
lashes and seven landmarks; the Lee Perry-Smith scan, eyes shut. Distances are exact, from our vertices to the true
skin, millimetres. Correspondence: how far apart, on the mean head, one of our vertices lies on different people. Both
of trimesh's non-rigid registrations get the same landmarks and the true skin alone; the looser they are set, the nearer
they come and the more they fold, so the best of those settings counts that fold no more than their default does.
Animals with seven clicks, exact and off as hands are, beside their fits as people. Expressions: all of the cast on the
fitted faces, against the generic face's own. Ends with 1 where a bar is missed; heads that are not at hand are left out
with a sentence.

Usage: python -m benchmarks.own_faces [--people N] [--peers N] [--worn N] [--seed N]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import secrets
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from time import thread_time

import numpy as np
from numpy.typing import NDArray
from rich.console import Console

import omote
from benchmarks.maps import report
from benchmarks.maps.figures import Comparison, Figures
from benchmarks.maps.methods import METHODS, OURS
from benchmarks.maps.source import PLAYED, load_source
from benchmarks.scans import fit_measures, ict_people, nonrigid_peers, perry_smith, true_heads
from benchmarks.scans.fit_measures import FACE, LIDS, NO_LIDS, PLAIN, Landings
from omote.builtin import load_identity_modes
from omote.model.fitting.find_head import find_head
from omote.model.fitting.fit_face import Fit, fit_face
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
HEAD = ("head", "region", "median mm", "p95 mm")
PEER_HEAD = ("registration", "setting", "face median", "p95", "folds", "correspondence", "seconds")
ANIMAL_HEAD = (
    "animal",
    "clicks off, of the eyes' distance",
    "began from",
    "median mm",
    "as a person",
    "folds",
    "as a person",
)
CLICKED = 0.03
"""How far clicks are off, of the distance of the eyes' outer corners: a tenth of an eye."""
WORN_HEAD = ("face", "compounds folded", "lids", "lips", "teeth mm", "eyes mm", "bag mm", "sockets mm")


@dataclass(frozen=True)
class Bar:
    """A figure and the most that it may be."""

    what: str
    value: float
    most: float

    @property
    def met(self) -> bool:
        """Whether it is held."""
        return self.value <= self.most


@dataclass(frozen=True, eq=False)
class People:
    """Fitted people: their points, fits, where the fits lie on them, seconds of this thread."""

    points: dict[int, Values]
    fits: dict[int, Fit]
    landings: list[Landings]
    seconds: list[float]


def fit_people(space: ParameterSpace, seed: int, count: int) -> People:
    """So many random people, fitted."""
    model = ict_people.read_model()
    found = People({}, {}, [], [])
    for number in range(count):
        person = model.draw((seed, number))
        begin = thread_time()
        fit = omote.fit(space, person, model.triangles, landmarks=model.clicks(person))
        found.seconds.append(thread_time() - begin)
        found.points[number], found.fits[number] = person, fit
        skin = fit.face.positions.astype(np.float64)
        found.landings.append(fit_measures.land(space, skin, fit.placement(person), model.skin))
    return found


def measure_people(console: Console, space: ParameterSpace, people: People) -> list[Bar]:
    """Prints what fits of people are like; the bars."""
    where = fit_measures.regions(space)
    model = ict_people.read_model()
    found = {
        name: np.array([fit_measures.quantiles(each.away, rows) for each in people.landings])
        for name, rows in where.items()
    }
    rows = [(f"{len(people.fits)} people", name, *_shown(np.median(each, axis=0))) for name, each in found.items()]
    rows += [("the worst", name, *_shown(each.max(axis=0))) for name, each in found.items()]
    report.show(console, "Distance to the true skin", HEAD, rows)
    apart = fit_measures.spread(model, people.landings, where[FACE])
    marks = fit_measures.landmark_errors(space, model, people.fits, people.points)
    eyes = [fit_measures.eye_errors(fit, people.points[number]) for number, fit in people.fits.items()]
    sure = [fit.face.positions.astype(np.float64) for fit in people.fits.values() if not fit.doubts]
    folds = max((fit_measures.count_folds(space, skin) for skin in sure), default=0)
    return [
        *_distance_bars(found),
        Bar("68 landmarks of others, mean mm", float(marks.mean()), 2.0),
        Bar("eyeballs, mean mm", float(np.mean(eyes)), 1.2),
        Bar("correspondence, median mm", float(np.median(apart)), 1.6),
        Bar("folds at rest of a face without doubts, the most", folds, 0),
        Bar("people of whom it doubts", sum(bool(fit.doubts) for fit in people.fits.values()), len(people.fits) // 10),
    ]


def _distance_bars(found: Mapping[str, Values]) -> list[Bar]:
    """The bars of distances, found (people, 2) by region: the median person's median and 95th percentile."""
    limits = {FACE: (0.06, 1.2), PLAIN: (0.03, 0.4), LIDS: (0.4, 1.5)}
    return [
        Bar(f"{name}, {what}, mm", float(np.median(found[name][:, at])), limit[at])
        for name, limit in limits.items() for at, what in enumerate(("median", "p95"))
    ]  # fmt: skip


def measure_peers(console: Console, space: ParameterSpace, people: People, count: int) -> list[Bar]:
    """Prints what peers make of the first people, in several settings; the bars against their best."""
    model = ict_people.read_model()
    where = fit_measures.regions(space)[FACE]
    ours = np.median([fit_measures.quantiles(each.away, where)[0] for each in people.landings[:count]])
    own = [fit_measures.count_folds(space, people.fits[i].face.positions.astype(np.float64)) for i in range(count)]
    rows = [_peer_row("ours", "", space, people.landings[:count], own, people.seconds[:count])]
    bars = list[Bar]()
    for peer, settings in nonrigid_peers.SETTINGS.items():
        tried: dict[str, tuple[float, int, float]] = {}
        for setting, steps in settings.items():
            landings = list[Landings]()
            folds = list[int]()
            seconds = list[float]()
            for number in range(count):
                person = people.points[number]
                skin, took = nonrigid_peers.register(space, peer, steps, (person, model.skin), model.clicks(person))
                landings.append(fit_measures.land(space, skin, person, model.skin))
                folds.append(fit_measures.count_folds(space, skin))
                seconds.append(took)
            rows.append(_peer_row(peer, setting, space, landings, folds, seconds))
            error = float(np.median([fit_measures.quantiles(each.away, where)[0] for each in landings]))
            tried[setting] = (error, sum(folds), float(np.median(seconds)))
        allowed = [each for each in tried.values() if each[1] <= tried["default"][1]]
        best = min(allowed, key=lambda each: each[0])
        bars += [
            Bar(f"our error over that of {peer}", float(ours) / best[0], 1 / 8),
            Bar(f"our seconds over those of {peer}", float(np.median(people.seconds[:count])) / best[2], 1.0),
        ]
    report.show(console, f"The same {count} people, peers", PEER_HEAD, rows)
    return bars


def _peer_row(
    peer: str, setting: str, space: ParameterSpace, landings: Sequence[Landings], folds: Sequence[int],
    seconds: Sequence[float],
) -> tuple[str, ...]:  # fmt: skip
    where = fit_measures.regions(space)[FACE]
    middle = np.median([fit_measures.quantiles(each.away, where) for each in landings], axis=0)
    apart = np.median(fit_measures.spread(ict_people.read_model(), landings, where))
    return (peer, setting, *_shown(middle), str(sum(folds)), f"{apart:.2f}", f"{np.median(seconds):.1f}")


def measure_scan(console: Console, space: ParameterSpace) -> tuple[Fit, list[Bar]]:
    """Prints what the fit of the Lee Perry-Smith scan is like; the bars."""
    points, triangles = perry_smith.read_scan()
    fit = omote.fit(space, points, triangles, landmarks=perry_smith.clicks(points), shut=True)
    landing = fit_measures.land(space, fit.face.positions.astype(np.float64), fit.placement(points), triangles)
    found = {name: fit_measures.quantiles(landing.away, rows) for name, rows in fit_measures.regions(space).items()}
    report.show(
        console, "Lee Perry-Smith", HEAD, [("eyes opened", name, *_shown(each)) for name, each in found.items()]
    )
    for doubt in fit.doubts:
        console.print(doubt)
    return fit, [
        Bar("Lee Perry-Smith without lids, median mm", found[NO_LIDS][0], 0.06),
        Bar("Lee Perry-Smith without lids, p95 mm", found[NO_LIDS][1], 0.6),
    ]


def wear_all(console: Console, fits: Mapping[str, Fit]) -> list[Bar]:
    """Prints what all expressions do on fitted faces; the bars."""
    bench = Comparison(load_source(None, kinds=PLAYED, seed=0, count=1))
    found: dict[str, Figures] = {}
    for name, fit in fits.items():
        found[name] = bench.measure(OURS, fit.face, METHODS[OURS](bench.source, fit.face))
    rows = [
        (name, str(len(each.folded)), f"{each.lids[0].value:.3f} {each.lids[1].value:.3f}",
         f"{each.lips[0].value:.3f} {each.lips[1].value:.3f}", *(f"{1000 * worst.value:.2f}" for worst in
         (each.teeth, each.eyes, each.bag, each.sockets)))
        for name, each in found.items()
    ]  # fmt: skip
    report.show(console, f"{len(bench.known)} expressions worn", WORN_HEAD, rows)
    every = [*found.values()]
    return [
        Bar("compounds with folds, share", sum(len(e.folded) for e in every) / sum(e.units for e in every), 1 / 200),
        Bar("lids, the worst", max(each.lids[1].value for each in every), 0.05),
        Bar("lips, the worst", max(each.lips[1].value for each in every), 0.05),
        Bar("teeth through skin, mm", 1000 * max(each.teeth.value for each in every), 0.3),
    ]


def measure_animals(console: Console, space: ParameterSpace, draw: np.random.Generator) -> list[Bar]:
    """Prints what animals come to by seven clicks, half of them off as hands are, beside the fit as a person; the
    bars."""
    rows = list[tuple[str, ...]]()
    folds = list[tuple[int, int]]()
    sure = 0
    for name in true_heads.ANIMALS:
        animal = true_heads.animal(name)
        marks = animal.landmarks
        apart = float(np.linalg.norm(marks["left_eye_outer"] - marks["right_eye_outer"]))
        for off in (0.0, CLICKED):
            clicks = {mark: point + off * apart * draw.normal(size=3) for mark, point in marks.items()}
            found = omote.fit(space, animal.points, animal.triangles, landmarks=clicks, shut=False)
            person = _fit_as_person(space, omote.Scan(animal.points, animal.triangles), clicks)
            folds.append((_count_folds(space, found), _count_folds(space, person)))
            sure += not found.doubts
            rows.append((name, f"{off:.2f}", found.kind, *(f"{np.nanmedian(each.residual):.2f}" for each in
                        (found, person)), *map(str, folds[-1])))  # fmt: skip
    report.show(console, "Animals by seven clicks", ANIMAL_HEAD, rows)
    ours, persons = np.sum(folds, axis=0)
    return [
        Bar("animals without a doubt", sure, 0),
        Bar("their folds at rest over those of fits as people", float(ours / max(persons, 1)), 1.0),
    ]


def _fit_as_person(space: ParameterSpace, scan: omote.Scan, clicks: Mapping[str, Values]) -> Fit:
    modes = load_identity_modes()
    place = find_head(space, modes, scan, landmarks=clicks)
    return fit_face(space, modes, scan, place.similarity, landmarks=clicks, shut=False)


def _count_folds(space: ParameterSpace, fit: Fit) -> int:
    return fit_measures.count_folds(space, fit.face.positions.astype(np.float64))


def measure_fits(
    console: Console, space: ParameterSpace, given: argparse.Namespace
) -> tuple[list[Bar], dict[str, Fit]]:  # fmt: skip
    """Prints what fits of all heads at hand are like; the bars, and fits that are to wear expressions."""
    bars = list[Bar]()
    worn = dict[str, Fit]()
    if ict_people.at_hand():
        console.print(f"people of seed {given.seed}")
        people = fit_people(space, given.seed, given.people)
        bars += measure_people(console, space, people)
        bars += measure_peers(console, space, people, given.peers) if given.peers else []
        worn |= {f"person {number}": people.fits[number] for number in range(min(given.worn, given.people))}
    else:
        console.print("ICT-FaceKit is not at hand; its people are left out")
    if perry_smith.FILE.is_file():
        worn["Lee Perry-Smith"], more = measure_scan(console, space)
        bars += more
    else:
        console.print("the Lee Perry-Smith scan is not at hand; it is left out")
    if true_heads.ANIMALS_AT.is_dir():
        bars += measure_animals(console, space, np.random.default_rng((given.seed, 7)))
    else:
        console.print("the animals are not at hand; they are left out")
    return bars, worn


def _shown(pair: Sequence[float] | Values) -> tuple[str, str]:
    return f"{pair[0]:.3f}", f"{pair[1]:.3f}"


def main() -> int:
    """Prints the tables; 0 when every bar is held."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--people", type=int, default=20, help="how many random people")
    parser.add_argument("--peers", type=int, default=4, help="how many of them the peers get")
    parser.add_argument("--worn", type=int, default=8, help="how many of them wear all expressions")
    parser.add_argument("--seed", type=int, default=secrets.randbelow(10**6), help="of the people; drawn anew")
    given = parser.parse_args()
    console = Console(width=150)
    bars, worn = measure_fits(console, omote.load_cast().space, given)
    bars += wear_all(console, worn) if worn and given.worn else []
    rows = [(bar.what, f"{bar.value:.3f}", f"{bar.most:.3f}", "held" if bar.met else "MISSED") for bar in bars]
    report.show(console, "Bars", ("what", "figure", "at most", ""), rows)
    return 0 if all(bar.met for bar in bars) else 1


if __name__ == "__main__":
    sys.exit(main())
