"""Shape, cameras and expressions that explain landmarks of several photographs best: Gauss-Newton, all at once.

What landmarks are off by is weighed by its covariance (`LandmarkTable`), what a person looks like by what people differ
by: the maximum a posteriori (Blanz and Vetter 1999; bundle adjustment after Triggs et al. 1999).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from omote.arrays import Values
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.photographs.bundle_problem import (
    LIGHTS,
    PAINTS,
    POSE,
    Bundle,
    Problem,
    change_by_places,
    change_by_pose,
    measure_errors,
)
from omote.model.fitting.photographs.landmark_table import LandmarkTable
from omote.model.fitting.photographs.outlines import REACH, find_outline
from omote.model.fitting.photographs.photograph import FILM, Photograph, PhotographCamera
from omote.model.fitting.photographs.skin_evidence import (
    SkinEvidence,
    SkinSamples,
    add_skin,
    open_evidence,
    start_lights,
)
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import fit_similarity

FOCAL = 1.2
"""Widths of the longer side: what most photographs of heads are taken with."""
FOCAL_SPREAD = 0.4
KNOWN_SPREAD = 0.03
"""Of the logarithm of a focal length that nobody told, and of one that a file tells."""
_AFAR_ROUNDS = 40
LANDMARK_ROUNDS = 14
# From this round on, outlines are sought in the pictures.
OUTLINES = 4
# Of a unit of expression in a photograph.
UNIT = 0.12
# A point that is off by so many standard deviations counts half (Student's t).
ODD = 5.0
# Landmarks of real people err more than those of ours: variances times this, and times the other where pictures say
# better.
CARE = 4.0
LATE = 16.0
# Of an edge, metres, and how many neighbouring points of an outline say no more than one.
EDGE = 0.0015
ALIKE = 4.0
# No turn of one round is larger, radians, nor a change of a focal length's logarithm; nor one of a mode where pictures
# are looked at, which are known only nearby.
STRIDE = 0.3
LEAP = 1.0
# Metres by which pictures are blurred, round by round, where skin is looked at.
BLURS = (0.005, 0.005, 0.004, 0.003, 0.0025, 0.002, 0.0015, 0.0015)


def usual_focal(photograph: Photograph, /) -> float:
    """The focal length in pixels: as the file says, else as usual."""
    longer = max(photograph.width, photograph.height)
    return longer * (FOCAL if photograph.focal is None else photograph.focal / FILM)


def start_camera(photograph: Photograph, places: Values, /) -> PhotographCamera:
    """The camera from which points (p, 3) of a usual head lie as the photograph's landmarks do.

    photograph: with its landmarks; places (p, 3): metres.
    """
    pixels = photograph.landmarks[: len(places)]
    upright = np.column_stack([pixels[:, 0], -pixels[:, 1], np.zeros(len(pixels))])
    if photograph.has_depth:
        upright[:, 2] = -pixels[:, 2]
    else:
        upright[:, 2] = _guess_depth(upright[:, :2], places)
    pose = fit_similarity(places, upright, np.ones(len(places)))
    focal = usual_focal(photograph)
    away = focal / pose.scale
    aside = (pose.shift[:2] - [0.5 * photograph.width, -0.5 * photograph.height]) / pose.scale
    shift = np.array([aside[0], aside[1], -away])
    return PhotographCamera(pose.rotation, shift, focal, photograph.width, photograph.height)


def _guess_depth(flat: Values, places: Values) -> Values:
    """Depths (p,) of points whose places in the picture (p, 2) are known, as a usual head turned the same way has."""
    depth = np.zeros(len(flat))
    for _ in range(_AFAR_ROUNDS):
        pose = fit_similarity(places, np.column_stack([flat, depth]), np.ones(len(flat)))
        depth = pose(places)[:, 2]
    return depth


def adjust(
    space: ParameterSpace, modes: IdentityModes, table: LandmarkTable, photographs: Sequence[Photograph], /,
    skin: SkinSamples | None = None,
) -> Bundle:  # fmt: skip
    """The most likely shape, cameras and expressions: by landmarks, then, where skin is known and pictures come along,
    by what these show of it.

    space, modes: the head and what heads differ by; table: how landmarks err; photographs: of one person; skin: where
    it is looked at.
    """
    problem = Problem(
        space, modes, table, photographs, table.places(modes.skin), table.places(modes.moves),
        np.stack(list(table.units.values())), _lenses(photographs), [_brightness(view) for view in photographs],
    )  # fmt: skip
    bundle = _start(problem)
    for number in range(LANDMARK_ROUNDS):
        bundle = _step(problem, bundle, number >= OUTLINES)
    if skin is None or all(photograph.picture is None for photograph in photographs):
        return bundle
    evidence = open_evidence(problem, skin, bundle)
    bundle = replace(bundle, lights=start_lights(problem, evidence, bundle, BLURS[0]))
    for blur in BLURS:
        bundle = _step(problem, bundle, True, evidence, blur)
    return bundle


def _start(problem: Problem) -> Bundle:
    """A usual head, seen as if from afar."""
    count = len(problem.moves)
    views = problem.photographs
    return Bundle(
        np.zeros(count), np.ones(count), np.zeros(problem.common - count),
        tuple(start_camera(view, problem.mean) for view in views),
        tuple(np.zeros(len(problem.units)) for _ in views), (), np.zeros((len(views), LIGHTS)), np.zeros(PAINTS),
    )  # fmt: skip


def _lenses(photographs: Sequence[Photograph]) -> list[int]:
    """The number of each photograph's lens."""
    names = [photograph.camera if photograph.camera is not None else at for at, photograph in enumerate(photographs)]
    order = list(dict.fromkeys(names))
    return [order.index(name) for name in names]


def _brightness(photograph: Photograph) -> Values | None:
    if photograph.picture is None:
        return None
    return photograph.picture.astype(np.float64).mean(axis=2)


def _step(
    problem: Problem, last: Bundle, outlined: bool, evidence: SkinEvidence | None = None, blur: float = 0.0
) -> Bundle:
    matrix = np.eye(problem.size) * 1e-9
    pull = np.zeros(problem.size)
    errors = []
    shape = problem.modes.shape_skin(last.weights) if outlined else None
    for view in range(len(problem.photographs)):
        at = problem.columns(view)
        slopes, error, weighed = _look(problem, last, view)
        weighed /= CARE if evidence is None else LATE
        matrix[np.ix_(at, at)] += slopes.T @ weighed[:, :-1]
        pull[at] += slopes.T @ weighed[:, -1]
        errors.append(error)
        _expect(problem, last, view, matrix, pull)
        if shape is not None:
            _add_outline(problem, last, view, shape, matrix, pull)
    rows = np.arange(problem.common)
    matrix[rows, rows] += 1.0
    pull[rows] += np.concatenate([last.weights, last.person])
    if evidence is not None:
        add_skin(problem, evidence, last, blur, matrix, pull)
    inverse = np.linalg.inv(matrix)
    step = -inverse @ pull
    if evidence is not None:
        step *= min(1.0, LEAP / max(float(np.abs(step[: len(problem.moves)]).max()), 1e-9))
    return _moved(problem, last, step, np.sqrt(np.diag(inverse)), errors)


def _look(problem: Problem, last: Bundle, view: int) -> tuple[Values, Values, Values]:
    """Of a photograph: how what is left of its errors changes (2 p, n), that itself (2 p,), and both weighed."""
    camera = last.cameras[view]
    table = problem.table
    places = problem.mean + np.tensordot(last.weights, problem.moves, 1)
    places = places + np.tensordot(last.units[view], problem.units, 1)
    pixels = problem.photographs[view].landmarks[: len(places), :2]
    law = table.error_at(camera.yaw)
    explained = law.mean + law.slopes @ last.weights + law.person @ last.person
    error = measure_errors(pixels, camera, places) - explained
    slopes = np.column_stack([
        change_by_places(camera, places, problem.moves) - law.slopes, -law.person,
        change_by_pose(camera, places), change_by_places(camera, places, problem.units),
    ])  # fmt: skip
    odd = (error**2 / law.variance).reshape(-1, 2).sum(axis=1)
    trust = np.repeat(1.0 / (1.0 + odd / ODD**2), 2)
    return slopes, error, law.weigh(np.column_stack([slopes, error]), trust)


def _expect(problem: Problem, last: Bundle, view: int, matrix: Values, pull: Values) -> None:
    """Adds what is expected of a photograph's expression and lens."""
    at = problem.columns(view)[problem.common + POSE - 1 :]
    matrix[at[1:], at[1:]] += UNIT**-2
    pull[at[1:]] += UNIT**-2 * last.units[view]
    photograph = problem.photographs[view]
    spread = FOCAL_SPREAD if photograph.focal is None else KNOWN_SPREAD
    matrix[at[0], at[0]] += spread**-2
    pull[at[0]] += spread**-2 * np.log(last.cameras[view].focal / usual_focal(photograph))


def _add_outline(problem: Problem, last: Bundle, view: int, shape: Values, matrix: Values, pull: Values) -> None:
    """Adds the edges found near where the head ends."""
    luma = problem.luma[view]
    camera = last.cameras[view]
    if luma is None:
        return
    face = head_zones(problem.space).face
    outline = find_outline(problem.space, camera, shape, luma, face)
    if not len(outline.rows):
        return
    places = shape[outline.rows]
    moves = problem.modes.moves[:, outline.rows]
    across = outline.ways.ravel()[:, None]
    slopes = np.column_stack([
        (across * part).reshape(len(places), 2, -1).sum(axis=1)
        for part in (change_by_places(camera, places, moves), change_by_pose(camera, places))
    ])  # fmt: skip
    share = outline.clear * (1.0 - (outline.away / REACH) ** 2) ** 2 / (EDGE**2 * ALIKE)
    at = problem.columns(view)[: problem.common + POSE]
    at = np.r_[at[: len(moves)], at[problem.common :]]
    matrix[np.ix_(at, at)] += (slopes.T * share) @ slopes
    pull[at] += (slopes.T * share) @ outline.away


def _moved(problem: Problem, last: Bundle, step: Values, deviations: Values, errors: list[Values]) -> Bundle:
    count = len(problem.moves)
    cameras = []
    units = []
    for view, camera in enumerate(last.cameras):
        own = step[problem.columns(view)[problem.common :]]
        share = min(1.0, STRIDE / max(float(np.linalg.norm(own[:3])), 1e-9))
        growth = float(np.clip(own[6], -STRIDE, STRIDE))
        cameras.append(camera.move(share * own[:3], share * own[3:6], growth))
        units.append(np.clip(last.units[view] + own[POSE:], 0.0, 1.0))
    lit = problem.lit + last.lights.size
    return Bundle(
        last.weights + step[:count], deviations[:count], last.person + step[count : problem.common],
        tuple(cameras), tuple(units), tuple(errors),
        last.lights + step[problem.lit : lit].reshape(last.lights.shape), last.paint + step[lit:],
    )  # fmt: skip
