"""Finds where in a scan a head is, how large and which way round; from its shape alone, or from clicks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree

from omote.geometry import mesh
from omote.model.fitting.doubt import PLACE, SIDES, Doubt
from omote.model.fitting.finding.alignment import Alignment
from omote.model.fitting.finding.candidates import (
    Candidate,
    find_candidates,
    find_others,
    place_back,
    refine,
    score,
)
from omote.model.fitting.finding.finding_template import HeadTemplate, make_template
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.landmarks import FEWEST_LANDMARKS, SEVEN
from omote.model.fitting.scan import Scan
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity, fit_similarity, measure_misfit

Values = NDArray[np.float64]

UNITS: Mapping[str, float] = MappingProxyType(
    {"millimetres": 0.001, "centimetres": 0.01, "decimetres": 0.1, "metres": 1.0, "inches": 0.0254}
)
"""Metres of one of each."""
# A scale so near to a unit's, as a logarithm, is that unit: heads differ by as much.
NEAR_UNIT = 0.2
# A head that is sure agrees within so many metres, and so much better than any other place.
SURE, MARGIN = 0.0016, 0.7
# What of the face must be there, and how near to it what is there must lie: metres.
COVERED, BACK = 0.6, 0.0025
# A second head is one whose nose is so far from the first's and which agrees within so many metres; the likeliest that
# agrees within NEARLY is aligned once more.
OTHER_HEAD, ALSO, NEARLY = 0.12, 0.0019, 0.003
# The points within so many metres of the skin, and at most so far below the neck's end, are the head's.
INSIDE, BELOW = 0.08, 0.005
# Clicks may miss a person's landmarks by so many metres before they are asked about; a refined place stays so near.
MISSED, STAYS = 0.02, 0.008


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
    inside: NDArray[np.bool_]
    residual: float
    unit: str
    landmarks: Mapping[str, Values]
    doubts: tuple[Doubt, ...]


def find_head(
    space: ParameterSpace, modes: IdentityModes, scan: Scan, *, landmarks: Mapping[str, ArrayLike] | None = None
) -> HeadPlacement:  # fmt: skip
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
    docs/decisions, 0155.
    """
    template = make_template(space, modes)
    if landmarks is not None:
        return _place_by_landmarks(template, scan, _validate_landmarks(landmarks))
    candidates = find_candidates(template, scan)
    if not candidates:
        raise ValueError(
            "nothing in the scan could be a face: expected a head; if there is one, points on it say where"
        )
    return _describe(template, scan, candidates[0], _doubt(template, scan, candidates), {})


def _doubt(template: HeadTemplate, scan: Scan, candidates: list[Candidate]) -> tuple[Doubt, ...]:
    """What is not sure of the best candidate, and of there being no other."""
    doubts, best = _doubt_best(candidates), candidates[0]
    # One head alone may have made all candidates: another is looked for where this one is not.
    if any(_is_other_head(best, each) for each in candidates[1:]) or (
        not doubts and _has_other_head(template, scan, best, [*candidates[1:], *find_others(template, scan, best)])
    ):
        doubts.append("There is more than one head; points on one say which is meant.")
    return tuple(Doubt(sentence, PLACE) for sentence in doubts)


def _has_other_head(template: HeadTemplate, scan: Scan, best: Candidate, others: list[Candidate]) -> bool:
    """Whether one of other candidates is a head too, the likeliest aligned once more from farther off: what was sampled
    of the whole scan may have led it beside the head."""
    if any(_is_other_head(best, each) for each in others):
        return True
    maybe = [each for each in others if _may_be_other_head(best, each)]
    return bool(maybe) and _is_other_head(best, refine(template, scan, min(maybe, key=score).found, rounds=3))


def _doubt_best(candidates: list[Candidate]) -> list[str]:
    """What is not sure of the best candidate, in sentences."""
    best = candidates[0]
    rivals = [score(each) for each in candidates[1:] if not _is_other_head(best, each)]
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
    apart = float(np.linalg.norm(best.tip - other.tip)) * best.found.pose.scale
    agreement = other.agreement
    near = agreement.residual < NEARLY and agreement.back < BACK and agreement.covered > COVERED
    return apart > OTHER_HEAD and near


def _place_by_landmarks(template: HeadTemplate, scan: Scan, given: Mapping[str, Values]) -> HeadPlacement:
    """Places a head by landmarks, then by its shape where that hardly moves it."""
    names = [*given]
    points = np.array([given[name] for name in names])
    clicked = Alignment(fit_similarity(points, _goals(template, names), np.ones(len(names))), np.zeros(0))
    refined = refine(template, scan, clicked, rounds=3)
    agreement = refined.agreement
    moved = np.linalg.norm(refined.found.pose(points) - _marks(template, refined.found, names), axis=1).mean()
    good = agreement.residual < SURE and agreement.covered > 0.5 * COVERED and moved < STAYS
    best = refined if good else Candidate(clicked, agreement, refined.tip, refined.samples)
    return _describe(template, scan, best, _doubt_clicks(template, points, names), given)


def _marks(template: HeadTemplate, found: Alignment, names: list[str]) -> Values:
    """The landmarks of some names (k, 3) on the template, metres."""
    return template.shape(template.marks[[SEVEN.index(name) for name in names]], found.weights)


def _goals(template: HeadTemplate, names: list[str]) -> Values:
    """The landmarks of some names (k, 3) on the mean head."""
    result: Values = template.points[template.marks[[SEVEN.index(name) for name in names]]]
    return result


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
    template: HeadTemplate, scan: Scan, best: Candidate, doubts: tuple[Doubt, ...], given: Mapping[str, Values]
) -> HeadPlacement:
    """The placement of a candidate, in a unit that people use where one is near."""
    found = place_back(best.found, _marks(template, best.found, [*SEVEN]))
    landmarks = {name: given.get(name, place) for name, place in zip(SEVEN, found, strict=True)}
    unit, scale = _name_unit(best.found.pose.scale)
    pose = best.found.pose
    middle = template.shape(template.face, best.found.weights).mean(axis=0)
    shift = middle - scale / pose.scale * (middle - pose.shift)
    return HeadPlacement(
        Similarity(scale, pose.rotation, shift), _find_inside(template, scan, best.found),
        1000.0 * best.agreement.residual, unit, MappingProxyType(landmarks), doubts,
    )  # fmt: skip


def _name_unit(scale: float) -> tuple[str, float]:
    """The unit of so many metres, and its exact size where it is one that people use."""
    name = min(UNITS, key=lambda each: abs(np.log(scale / UNITS[each])))
    if abs(np.log(scale / UNITS[name])) < NEAR_UNIT:
        return name, UNITS[name]
    return f"units of {1000.0 * scale:.3g} mm", scale


def _find_inside(template: HeadTemplate, scan: Scan, found: Alignment) -> NDArray[np.bool_]:
    """Which points of a scan are near the skin of the head, above the neck's end."""
    skin = template.shape(template.matched, found.weights)
    neck = template.points[template.skin, 1].min() - BELOW
    came = found.pose(scan.positions)
    low, high = skin.min(axis=0) - INSIDE, skin.max(axis=0) + INSIDE
    inside: NDArray[np.bool_] = ((came > low) & (came < high)).all(axis=1) & (came[:, 1] > neck)
    rows = np.flatnonzero(inside)
    away, _ = cKDTree(skin).query(came[rows], distance_upper_bound=INSIDE, workers=1)
    inside[rows] = np.isfinite(away)
    return inside


def _validate_landmarks(landmarks: Mapping[str, ArrayLike]) -> dict[str, Values]:
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
