"""Shape, cameras and expressions that explain landmarks of several photographs best: Gauss-Newton, all at once.

What landmarks are off by is weighed by its covariance (`LandmarkTable`), what a person looks like by what people differ
by: the maximum a posteriori (Blanz and Vetter 1999; bundle adjustment after Triggs et al. 1999).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.shape.identity_modes import IdentityModes
from omote.model.fitting.photographs.landmark_table import ON_SKIN, LandmarkError, LandmarkTable
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.fitting.photographs.pose_start import (
    FOCAL_SPREAD,
    KNOWN_SPREAD,
    start_camera,
    usual_focal,
)
from omote.model.fitting.photographs.view_errors import (
    POSE,
    change_by_places,
    change_by_pose,
    measure_errors,
)

Values = NDArray[np.float64]

ROUNDS = 12
# Of a unit of expression in a photograph.
UNIT = 0.12
# A point that is off by so many standard deviations counts half (Student's t).
ODD = 5.0
# Landmarks of real people err more than those of ours: variances times this.
CARE = 1.5
# No turn of one round is larger, radians, nor a change of a focal length's logarithm.
STRIDE = 0.3


@dataclass(frozen=True, eq=False)
class Bundle:
    """What explains the photographs: weights (m,) of the modes, their standard deviations (m,); a camera, weights (u,)
    of units and errors (3 p,) in metres for each photograph."""

    weights: Values
    deviations: Values
    cameras: tuple[PhotographCamera, ...]
    units: tuple[Values, ...]
    errors: tuple[Values, ...]


@dataclass(frozen=True, eq=False)
class _Points:
    """Of the p landmarks: where they lie on the mean head (p, 3), and how modes (m, p, 3) and units (u, p, 3) move
    them."""

    mean: Values
    modes: Values
    units: Values


def adjust(modes: IdentityModes, table: LandmarkTable, photographs: Sequence[Photograph], /) -> Bundle:
    """The most likely shape, cameras and expressions."""
    points = _Points(
        table.places(modes.skin), table.places(modes.moves), np.stack(list(table.units.values()))
    )  # fmt: skip
    cameras = tuple(start_camera(each, points.mean) for each in photographs)
    units = tuple(np.zeros(len(points.units)) for _ in photographs)
    found = Bundle(np.zeros(len(points.modes)), np.ones(len(points.modes)), cameras, units, ())
    lenses = _lenses(photographs)
    for _ in range(ROUNDS):
        found = _step(points, table, photographs, lenses, found)
    return found


def _lenses(photographs: Sequence[Photograph]) -> list[int]:
    """The number of each photograph's lens."""
    names = [each.camera if each.camera is not None else at for at, each in enumerate(photographs)]
    order = list(dict.fromkeys(names))
    return [order.index(name) for name in names]


def _step(
    points: _Points, table: LandmarkTable, photographs: Sequence[Photograph], lenses: list[int], last: Bundle
) -> Bundle:  # fmt: skip
    count, kinds, views = len(points.modes), len(points.units), len(photographs)
    each = POSE - 1 + kinds
    size = count + views * each + max(lenses) + 1
    matrix, pull, errors = np.zeros((size, size)), np.zeros(size), []
    for view, photograph in enumerate(photographs):
        first = count + view * each
        columns = np.r_[:count, first : first + POSE - 1, count + views * each + lenses[view], first + 6 : first + each]
        error, slopes, law, trust = _look(points, table, photograph, last, view)
        weighed = law.weigh(np.column_stack([slopes, error]), trust) / CARE
        matrix[np.ix_(columns, columns)] += slopes.T @ weighed[:, :-1]
        pull[columns] += slopes.T @ weighed[:, -1]
        errors.append(error)
        rows = np.arange(first + 6, first + each)
        matrix[rows, rows] += UNIT**-2
        pull[rows] += UNIT**-2 * last.units[view]
        _expect_lens(photograph, last.cameras[view], count + views * each + lenses[view], matrix, pull)
    rows = np.arange(count)
    matrix[rows, rows] += 1.0
    pull[:count] += last.weights
    matrix[np.arange(size), np.arange(size)] += 1e-9
    step = -np.linalg.solve(matrix, pull)
    deviations = np.sqrt(np.diag(np.linalg.inv(matrix))[:count])
    cameras, units = [], []
    for view in range(views):
        first = count + view * each
        own = step[first : first + each]
        share = min(1.0, STRIDE / max(np.linalg.norm(own[:3]), 1e-9))
        growth = np.clip(step[count + views * each + lenses[view]], -STRIDE, STRIDE)
        cameras.append(last.cameras[view].move(share * own[:3], share * own[3:6], float(growth)))
        units.append(np.clip(last.units[view] + own[6:], 0.0, 1.0))
    return Bundle(last.weights + step[:count], deviations, tuple(cameras), tuple(units), tuple(errors))


def _look(
    points: _Points, table: LandmarkTable, photograph: Photograph, last: Bundle, view: int
) -> tuple[Values, Values, LandmarkError, Values]:
    """Of a photograph: what is left of its errors (3 p,), how that changes (3 p, m + 7 + u), their law, and how much
    each is trusted (3 p,)."""
    camera = last.cameras[view]
    places = points.mean + np.tensordot(last.weights, points.modes, 1) + np.tensordot(last.units[view], points.units, 1)
    pixels, law = np.zeros((len(places), 3)), table.error_at(camera.yaw)
    pixels[:, : photograph.landmarks.shape[1]] = photograph.landmarks[:ON_SKIN]
    error = measure_errors(pixels, camera, places) - law.mean - law.slopes @ last.weights
    slopes = np.column_stack([
        change_by_places(camera, places, points.modes) - law.slopes,
        change_by_pose(camera, places),
        change_by_places(camera, places, points.units),
    ])  # fmt: skip
    odd = (error**2 / law.variance).reshape(-1, 3)
    if not photograph.has_depth:
        odd[:, 2] = 0.0
    trust = np.repeat(1.0 / (1.0 + odd.sum(axis=1) / ODD**2), 3)
    if not photograph.has_depth:
        trust[2::3] = 1e-9
    return error, slopes, law, trust


def _expect_lens(photograph: Photograph, camera: PhotographCamera, row: int, matrix: Values, pull: Values) -> None:
    spread = FOCAL_SPREAD if photograph.focal is None else KNOWN_SPREAD
    matrix[row, row] += spread**-2
    pull[row] += spread**-2 * np.log(camera.focal / usual_focal(photograph))
