"""Finds where in a scan a head is, how large and which way round; from its shape alone, or from clicks.

Many guesses are aligned by rounds, fewer and finer each time. How well scan and template lie on each other, both ways,
what is missing left out, says which of them is the head and whether that is sure.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from omote.arrays import Mask, Values
from omote.geometry import mesh
from omote.model.fitting.alignment import Alignment, Samples, align, find_matches
from omote.model.fitting.doubt import PLACE, SIDES, Doubt
from omote.model.fitting.head_template import MODES, HeadTemplate, make_template
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.landmarks import FEWEST_LANDMARKS, SEVEN
from omote.model.fitting.nose_search import Guess, are_alike, guess_faces, guess_faces_beside, leave_out_crumbs
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import measure_spacing, sample_surface
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity, fit_similarity, measure_misfit

# Farther than this, metres, a place of the face is simply not there: it counts no more.
NOT_THERE = 0.01
# Nothing of the scan is here where the nearest lies aside by so many metres, or spacings.
ASIDE = 0.002
SPACINGS = 4.0
# Of the scan, what lies so near to the face, metres, is asked whether it lies on it.
AROUND_FACE = 0.012
# How many guesses are aligned, and how many are left after each round.
GUESSES = 60
LEFT = (16, 5)
# How far matches may be in each round, metres, from first to last step; steps; modes.
ROUNDS = ((0.03, 0.015, 6, 0), (0.02, 0.012, 6, 12), (0.012, 0.006, 8, 30), (0.008, 0.005, 8, MODES))
# How much the way back counts beside the residual: small patches of smooth skin lie on anything, one way.
BOTH = 0.5
# What is left of a scan beside a head lies so far from its skin, metres; of the guesses of another head there so many
# are left after each round. With 40 guesses in place of 60 one in five turns of a round head was missed.
BESIDE = 0.03
OTHERS_LEFT = (10, 4)
# What is sampled anew about a candidate, metres from the nose.
AROUND_NOSE = 0.25
UNITS: Mapping[str, float] = MappingProxyType(
    {"millimetres": 0.001, "centimetres": 0.01, "decimetres": 0.1, "metres": 1.0, "inches": 0.0254}
)
"""Metres of one of each."""
# A scale so near to a unit's, as a logarithm, is that unit: heads differ by as much.
NEAR_UNIT = 0.2
# A head that is sure agrees within so many metres, and so much better than any other place.
SURE = 0.0016
MARGIN = 0.7
# What of the face must be there, and how near to it what is there must lie: metres.
COVERED = 0.6
BACK = 0.0025
# A second head is one whose nose is so far from the first's and which agrees within so many metres; the likeliest that
# agrees within NEARLY is aligned once more.
OTHER_HEAD = 0.12
ALSO = 0.0019
NEARLY = 0.003
# The points within so many metres of the skin, and at most so far below the neck's end, are the head's.
INSIDE = 0.08
BELOW = 0.005
# Clicks may miss a person's landmarks by so many metres before they are asked about; a refined place stays so near.
MISSED = 0.02
STAYS = 0.008


@dataclass(frozen=True)
class Agreement:
    """residual: the mean distance of the face that is there from the scan; back: the median distance of the scan
    around the face from the face; covered: how much of the face is there; metres."""

    residual: float
    back: float
    covered: float


def measure_agreement(
    template: HeadTemplate, samples: Samples, alignment: Alignment, /, *, back: bool = True
) -> Agreement:
    """How well an aligned scan and the template's face lie on each other; without back, only how the face does.

    template: the head; samples: the scan's; alignment: how they were aligned; back: whether the way back from the scan
    is measured too.
    """
    goals = template.shape(template.face, alignment.weights)
    normals = template.normals[template.face]
    off = find_matches(samples, alignment.pose, goals) - goals
    across = np.abs((off * normals).sum(axis=1))
    aside = np.sqrt(np.maximum((off**2).sum(axis=1) - across**2, 0.0))
    spacing = samples.spacing * alignment.pose.scale
    missing = (aside > max(ASIDE, SPACINGS * spacing)) & (aside > 2.0 * across)
    away = np.minimum(np.hypot(across, np.maximum(aside - spacing, 0.0)), NOT_THERE)
    # All missing is no agreement.
    residual = float(away[~missing].mean()) if not missing.all() else NOT_THERE
    behind = _measure_back(samples, alignment, goals, normals) if back else 0.0
    return Agreement(residual, behind, float(1.0 - missing.mean()))


def _measure_back(samples: Samples, alignment: Alignment, goals: Values, normals: Values) -> float:
    """The median distance of the samples around the face from it, along its normals."""
    middle = goals.mean(axis=0)
    reach = float(np.linalg.norm(goals - middle, axis=1).max()) + AROUND_FACE
    rows = samples.tree.query_ball_point(alignment.pose.back(middle), reach / alignment.pose.scale, workers=1)
    came = alignment.pose(samples.points[rows][:: max(len(rows) // 8000, 1)])
    if not len(came):
        return NOT_THERE
    away, at = cKDTree(goals).query(came, distance_upper_bound=AROUND_FACE, workers=1)
    near = np.isfinite(away)
    heights = ((came[near] - goals[at[near]]) * normals[at[near]]).sum(axis=1)
    return float(np.median(np.abs(heights))) if near.any() else NOT_THERE


@dataclass(frozen=True, eq=False)
class Candidate:
    """A place for a head, how well it agrees, the nose's tip in the scan (3,), and the samples it was fitted to."""

    alignment: Alignment
    agreement: Agreement
    tip: Values
    samples: Samples


def take_samples(scan: Scan, chosen: Mask | None = None, /) -> Samples:
    """Samples of a scan, or of what its chosen points (n,) span, with their tree."""
    points = sample_surface(scan, chosen=chosen)
    tree = cKDTree(points)
    return Samples(points, tree, measure_spacing(points, tree))


def find_candidates(template: HeadTemplate, scan: Scan, /) -> list[Candidate]:
    """The best places for a head in a scan, no two alike, the best first; none where nothing juts out.

    template: the head; scan: in its own frame.
    """
    samples = take_samples(scan)
    return _align_guesses(template, scan, samples, guess_faces(template, samples.points, GUESSES), LEFT)


def find_others(template: HeadTemplate, scan: Scan, best: Candidate, /) -> list[Candidate]:
    """The best places for another head about as large, in what is left of a scan beside a head, the best first.

    template: the head; scan: in its own frame; best: the candidate that was taken.
    """
    points, _ = leave_out_crumbs(take_samples(scan).points)
    head = best.alignment
    skin = template.shape(template.skin, best.alignment.weights)
    away, _ = cKDTree(skin).query(head.pose(points), distance_upper_bound=BESIDE, workers=1)
    rest = points[np.isinf(away)]
    guesses = guess_faces_beside(template, rest, head.pose.scale, GUESSES)
    if not guesses:
        return []
    tree = cKDTree(rest)
    return _align_guesses(template, scan, Samples(rest, tree, measure_spacing(rest, tree)), guesses, OTHERS_LEFT)


def _align_guesses(
    template: HeadTemplate, scan: Scan, samples: Samples, guesses: Sequence[Guess], most: Sequence[int]
) -> list[Candidate]:
    """The best of some guesses, aligned by all rounds; at most so many are left after each."""
    left = [_candidate(template, samples, Alignment(guess.pose, np.zeros(0)), 0) for guess in guesses]
    for number, count in enumerate(most, start=1):
        left = [_candidate(template, samples, candidate.alignment, number) for candidate in _best(left, count)]
    return _best([refine(template, scan, candidate.alignment) for candidate in _best(left, most[-1])], most[-1])


def refine(template: HeadTemplate, scan: Scan, alignment: Alignment, /, *, rounds: int = 1) -> Candidate:
    """A candidate aligned by the last so many rounds, to denser samples of what is around it.

    template: the head; scan: in its own frame; alignment: from where; rounds: how many of the last ones.
    """
    near = np.linalg.norm(scan.positions - _tip(template, alignment), axis=1) * alignment.pose.scale < AROUND_NOSE
    samples = take_samples(scan, near if near.any() else None)
    for number in range(len(ROUNDS) - rounds, len(ROUNDS)):
        candidate = _candidate(template, samples, alignment, number)
        alignment = candidate.alignment
    return candidate


def _candidate(template: HeadTemplate, samples: Samples, start: Alignment, number: int) -> Candidate:
    first, last, steps, modes = ROUNDS[number]
    rows = template.matched if number else template.front
    counted = template.weights if number else np.ones(len(template.front))
    least = 2.0 * samples.spacing * start.pose.scale
    reaches = [max(float(reach), least) for reach in np.linspace(first, last, steps)]
    alignment = align(template, samples, start, rows, counted, reaches=reaches, modes=modes)
    agreement = measure_agreement(template, samples, alignment, back=number == len(ROUNDS) - 1)
    return Candidate(alignment, agreement, _tip(template, alignment), samples)


def _tip(template: HeadTemplate, alignment: Alignment) -> Values:
    """Where in the scan the nose's tip is."""
    return alignment.pose.back(template.shape(template.marks[4:5], alignment.weights))[0]


def _best(candidates: Sequence[Candidate], most: int) -> list[Candidate]:
    """At most so many candidates by their score, no two alike."""
    kept = list[Candidate]()
    for candidate in sorted(candidates, key=score):
        if not any(
            are_alike(candidate.alignment.pose, other.alignment.pose, candidate.tip, other.tip) for other in kept
        ):
            kept.append(candidate)
        if len(kept) == most:
            break
    return kept


def score(candidate: Candidate, /) -> float:
    """What orders candidates, metres: how far off they are both ways, worse the less of the face there is."""
    agreement = candidate.agreement
    return (agreement.residual + BOTH * agreement.back) / max(agreement.covered, 0.05)


@dataclass(frozen=True, eq=False)
class HeadPlacement:
    """Where in a scan the head is.

    Attributes
    ----------
    similarity : Similarity
        From the scan to the space's frame: metres, upright, facing +z.
    inside : ndarray of bool, (n,)
        Which points of the scan belong to the head.
    residual : float
        How far the face of the nearest person of the modes is from the scan, millimetres.
    unit : str
        The scan's unit in words.
    landmarks : mapping of ndarray (3,), by name
        The seven landmarks in the scan's frame: those given, the others found.
    doubts : tuple of Doubt
        What is not sure, in sentences; empty when sure.
    """

    similarity: Similarity
    inside: Mask
    residual: float
    unit: str
    landmarks: Mapping[str, Values]
    doubts: tuple[Doubt, ...]


def find_head(
    space: ParameterSpace, modes: IdentityModes, scan: Scan, *, landmarks: Mapping[str, ArrayLike] | None = None
) -> HeadPlacement:
    """Finds the head in a scan of any unit and axes: a head, a bust, a body, in part or whole.

    Whose axes are mirrored comes out as the mirror image: a shape alone does not tell.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    modes : IdentityModes
        What heads differ by.
    scan : Scan
        In its own frame and unit; its triangles may face either way.
    landmarks : mapping of array_like (3,), by name
        Three or more of the seven, in the scan's frame; then these decide.

    Returns
    -------
    HeadPlacement
        The place. Where it has doubts it is a guess: ask.

    Raises
    ------
    ValueError
        Where nothing in the scan could be a face, and on landmarks that are unknown, too few or at one place.

    References
    ----------
    docs/decisions/scans-and-foreign-shapes.md.
    """
    template = make_template(space, modes)
    if landmarks is not None:
        return _place_by_landmarks(template, scan, validate_landmarks(landmarks))
    candidates = find_candidates(template, scan)
    if not candidates:
        raise ValueError(
            "nothing in the scan could be a face: expected a head; if there is one, points on it say where"
        )
    return _describe(template, scan, candidates[0], _doubt(template, scan, candidates), {})


def _doubt(template: HeadTemplate, scan: Scan, candidates: list[Candidate]) -> tuple[Doubt, ...]:
    """What is not sure of the best candidate, and of there being no other."""
    doubts = _doubt_best(candidates)
    best = candidates[0]
    # One head alone may have made all candidates: another is looked for where this one is not.
    if any(_is_other_head(best, candidate) for candidate in candidates[1:]) or (
        not doubts and _has_other_head(template, scan, best, [*candidates[1:], *find_others(template, scan, best)])
    ):
        doubts.append("There is more than one head; points on one say which is meant.")
    return tuple(Doubt(sentence, PLACE) for sentence in doubts)


def _has_other_head(template: HeadTemplate, scan: Scan, best: Candidate, others: list[Candidate]) -> bool:
    """Whether one of other candidates is a head too, the likeliest aligned once more from farther off: what was sampled
    of the whole scan may have led it beside the head."""
    if any(_is_other_head(best, other) for other in others):
        return True
    maybe = [other for other in others if _may_be_other_head(best, other)]
    return bool(maybe) and _is_other_head(best, refine(template, scan, min(maybe, key=score).alignment, rounds=3))


def _doubt_best(candidates: list[Candidate]) -> list[str]:
    """What is not sure of the best candidate, in sentences."""
    best = candidates[0]
    rivals = [score(candidate) for candidate in candidates[1:] if not _is_other_head(best, candidate)]
    if best.agreement.residual > SURE or best.agreement.back > BACK:
        return [f"This may be no face: what is most like one is {1000 * best.agreement.residual:.1f} mm off."]
    if best.agreement.covered < COVERED:
        return [f"Only {100 * best.agreement.covered:.0f} % of the face is there."]
    if rivals and score(best) > MARGIN * min(rivals):
        return ["The face may be elsewhere, or the other way up."]
    return []


def _is_other_head(best: Candidate, other: Candidate) -> bool:
    """Whether another candidate is a head too, somewhere else."""
    return _may_be_other_head(best, other) and other.agreement.residual < ALSO


def _may_be_other_head(best: Candidate, other: Candidate) -> bool:
    """Whether another candidate, somewhere else, is near to being a head."""
    apart = float(np.linalg.norm(best.tip - other.tip)) * best.alignment.pose.scale
    agreement = other.agreement
    near = agreement.residual < NEARLY and agreement.back < BACK and agreement.covered > COVERED
    return apart > OTHER_HEAD and near


def _place_by_landmarks(template: HeadTemplate, scan: Scan, clicks: Mapping[str, Values]) -> HeadPlacement:
    """Places a head by landmarks, then by its shape where that hardly moves it."""
    names = [*clicks]
    points = np.array([clicks[name] for name in names])
    clicked = Alignment(fit_similarity(points, _goals(template, names), np.ones(len(names))), np.zeros(0))
    refined = refine(template, scan, clicked, rounds=3)
    agreement = refined.agreement
    moved = np.linalg.norm(refined.alignment.pose(points) - _marks(template, refined.alignment, names), axis=1).mean()
    good = agreement.residual < SURE and agreement.covered > 0.5 * COVERED and moved < STAYS
    best = refined if good else Candidate(clicked, agreement, refined.tip, refined.samples)
    return _describe(template, scan, best, _doubt_clicks(template, points, names), clicks)


def _marks(template: HeadTemplate, alignment: Alignment, names: list[str]) -> Values:
    """The landmarks of some names (k, 3) on the template, metres."""
    return template.shape(template.marks[[SEVEN.index(name) for name in names]], alignment.weights)


def _goals(template: HeadTemplate, names: list[str]) -> Values:
    """The landmarks of some names (k, 3) on the mean head."""
    return template.points[template.marks[[SEVEN.index(name) for name in names]]]


def _doubt_clicks(template: HeadTemplate, points: Values, names: list[str]) -> tuple[Doubt, ...]:
    """What is odd about clicks: sides exchanged, or places that no face has."""
    swap = {"left": "right", "right": "left"}
    other = ["_".join(swap.get(word, word) for word in name.split("_")) for name in names]
    missed = measure_misfit(points, _goals(template, names))
    if 2.0 * measure_misfit(points, _goals(template, other)) < missed:
        return (Doubt("Left and right seem to be exchanged: left is the character's own.", SIDES),)
    if missed > MISSED:
        return (Doubt(f"The points that were given are {1000 * missed:.0f} mm from any face's.", PLACE),)
    return ()


def _describe(
    template: HeadTemplate, scan: Scan, best: Candidate, doubts: tuple[Doubt, ...], clicks: Mapping[str, Values]
) -> HeadPlacement:
    """The placement of a candidate, in a unit that people use where one is near."""
    marks = best.alignment.pose.back(_marks(template, best.alignment, [*SEVEN]))
    landmarks = {name: clicks.get(name, place) for name, place in zip(SEVEN, marks, strict=True)}
    unit, scale = _name_unit(best.alignment.pose.scale)
    pose = best.alignment.pose
    middle = template.shape(template.face, best.alignment.weights).mean(axis=0)
    shift = middle - scale / pose.scale * (middle - pose.shift)
    return HeadPlacement(
        Similarity(scale, pose.rotation, shift), _find_inside(template, scan, best.alignment),
        1000.0 * best.agreement.residual, unit, MappingProxyType(landmarks), doubts,
    )  # fmt: skip


def _name_unit(scale: float) -> tuple[str, float]:
    """The unit of so many metres, and its exact size where it is one that people use."""
    name = min(UNITS, key=lambda unit: abs(np.log(scale / UNITS[unit])))
    if abs(np.log(scale / UNITS[name])) < NEAR_UNIT:
        return name, UNITS[name]
    return f"units of {1000.0 * scale:.3g} mm", scale


def _find_inside(template: HeadTemplate, scan: Scan, alignment: Alignment) -> Mask:
    """Which points of a scan are near the skin of the head, above the neck's end."""
    skin = template.shape(template.matched, alignment.weights)
    neck = template.points[template.skin, 1].min() - BELOW
    came = alignment.pose(scan.positions)
    low = skin.min(axis=0) - INSIDE
    high = skin.max(axis=0) + INSIDE
    inside: Mask = ((came > low) & (came < high)).all(axis=1) & (came[:, 1] > neck)
    rows = np.flatnonzero(inside)
    away, _ = cKDTree(skin).query(came[rows], distance_upper_bound=INSIDE, workers=1)
    inside[rows] = np.isfinite(away)
    return inside


def validate_landmarks(landmarks: Mapping[str, ArrayLike], /) -> dict[str, Values]:
    """The landmarks (3,) by name that say where a head is; ValueError on unknown, too few, or ones at one place."""
    unknown = [name for name in landmarks if name not in SEVEN]
    if unknown:
        raise ValueError(f"there is no landmark {unknown[0]!r}; expected some of {', '.join(SEVEN)}")
    if len(landmarks) < FEWEST_LANDMARKS:
        raise ValueError(f"there are {len(landmarks)} landmarks; expected at least {FEWEST_LANDMARKS}")
    kept = {name: np.asarray(landmarks[name], np.float64) for name in SEVEN if name in landmarks}
    points = mesh.validate_points(np.array([np.reshape(place, 3) for place in kept.values()]), name="landmarks")
    sizes = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if sizes[1] <= 1e-3 * max(sizes[0], 1e-12):
        raise ValueError("the landmarks lie at one place or on one line; expected points around a face")
    return dict(zip(kept, points, strict=True))
