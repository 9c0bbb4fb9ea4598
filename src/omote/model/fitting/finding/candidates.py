"""Candidates: the best places for a head in a scan; many guesses, aligned by rounds, fewer and finer each time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.fitting.finding.agreement import Agreement, measure_agreement
from omote.model.fitting.finding.alignment import Alignment, Samples, align
from omote.model.fitting.finding.finding_template import MODES, HeadTemplate
from omote.model.fitting.finding.nose_search import (
    Guess,
    are_alike,
    guess_faces,
    guess_faces_beside,
    leave_out_crumbs,
)
from omote.model.fitting.finding.surface_samples import measure_spacing, sample_surface
from omote.model.fitting.scan import Scan

Values = NDArray[np.float64]

# How many guesses are aligned, and how many are left after each round.
GUESSES, LEFT = 60, (16, 5)
# How far matches may be in each round, metres, from first to last step; steps; modes.
ROUNDS = ((0.03, 0.015, 6, 0), (0.02, 0.012, 6, 12), (0.012, 0.006, 8, 30), (0.008, 0.005, 8, MODES))
# How much the way back counts beside the residual: small patches of smooth skin lie on anything, one way.
BOTH = 0.5
# What is left of a scan beside a head lies so far from its skin, metres; so many guesses of another head are aligned
# there, and so many left after each round.
BESIDE, OTHERS, OTHERS_LEFT = 0.03, 40, (10, 4)
# What is sampled anew about a candidate, metres from the nose.
AROUND = 0.25


@dataclass(frozen=True, eq=False)
class Candidate:
    """A place for a head, how well it agrees, the nose's tip in the scan (3,), and the samples it was fitted to."""

    found: Alignment
    agreement: Agreement
    tip: Values
    samples: Samples


def take_samples(scan: Scan, chosen: NDArray[np.bool_] | None = None, /) -> Samples:
    """Samples of a scan, or of what its chosen points (n,) span, with their tree."""
    points = sample_surface(scan, chosen=chosen)
    tree = cKDTree(points)
    return Samples(points, tree, measure_spacing(points, tree))


def find_candidates(template: HeadTemplate, scan: Scan, /) -> list[Candidate]:
    """The best places for a head in a scan, no two alike, the best first; none where nothing juts out."""
    samples = take_samples(scan)
    return _align(template, scan, samples, guess_faces(template, samples.points, GUESSES), LEFT)


def find_others(template: HeadTemplate, scan: Scan, best: Candidate, /) -> list[Candidate]:
    """The best places for another head about as large, in what is left of a scan beside a head, the best first."""
    points, _ = leave_out_crumbs(take_samples(scan).points)
    found, skin = best.found, template.shape(template.skin, best.found.weights)
    away, _ = cKDTree(skin).query(found.pose(points), distance_upper_bound=BESIDE, workers=1)
    rest = points[np.isinf(away)]
    guesses = guess_faces_beside(template, rest, found.pose.scale, OTHERS)
    if not guesses:
        return []
    tree = cKDTree(rest)
    return _align(template, scan, Samples(rest, tree, measure_spacing(rest, tree)), guesses, OTHERS_LEFT)


def _align(
    template: HeadTemplate, scan: Scan, samples: Samples, guesses: Sequence[Guess], most: Sequence[int]
) -> list[Candidate]:
    """The best of some guesses, aligned by all rounds; at most so many are left after each."""
    left = [_candidate(template, samples, Alignment(guess.pose, np.zeros(0)), 0) for guess in guesses]
    for number, count in enumerate(most, start=1):
        left = [_candidate(template, samples, each.found, number) for each in _best(left, count)]
    return _best([refine(template, scan, each.found) for each in _best(left, most[-1])], most[-1])


def refine(template: HeadTemplate, scan: Scan, found: Alignment, /, *, rounds: int = 1) -> Candidate:
    """A candidate aligned by the last so many rounds, to denser samples of what is around it."""
    near = np.linalg.norm(scan.positions - _tip(template, found), axis=1) * found.pose.scale < AROUND
    samples = take_samples(scan, near if near.any() else None)
    for number in range(len(ROUNDS) - rounds, len(ROUNDS)):
        candidate = _candidate(template, samples, found, number)
        found = candidate.found
    return candidate


def _candidate(template: HeadTemplate, samples: Samples, start: Alignment, number: int) -> Candidate:
    first, last, steps, modes = ROUNDS[number]
    rows = template.matched if number else template.front
    counted = template.weights if number else np.ones(len(template.front))
    least = 2.0 * samples.spacing * start.pose.scale
    reaches = [max(float(reach), least) for reach in np.linspace(first, last, steps)]
    found = align(template, samples, start, rows, counted, reaches=reaches, modes=modes)
    agreement = measure_agreement(template, samples, found, back=number == len(ROUNDS) - 1)
    return Candidate(found, agreement, _tip(template, found), samples)


def _tip(template: HeadTemplate, found: Alignment) -> Values:
    """Where in the scan the nose's tip is."""
    tip: Values = place_back(found, template.shape(template.marks[4:5], found.weights))[0]
    return tip


def place_back(found: Alignment, points: Values, /) -> Values:
    """Where points (n, 3) of the template are in the scan."""
    pose = found.pose
    result: Values = ((points - pose.shift) @ pose.rotation) / pose.scale
    return result


def _best(candidates: Sequence[Candidate], most: int) -> list[Candidate]:
    """At most so many candidates by their score, no two alike."""
    kept = list[Candidate]()
    for each in sorted(candidates, key=score):
        if not any(are_alike(each.found.pose, other.found.pose, each.tip, other.tip) for other in kept):
            kept.append(each)
        if len(kept) == most:
            break
    return kept


def score(candidate: Candidate, /) -> float:
    """What orders candidates, metres: how far off they are both ways, worse the less of the face there is."""
    agreement = candidate.agreement
    return (agreement.residual + BOTH * agreement.back) / max(agreement.covered, 0.05)
