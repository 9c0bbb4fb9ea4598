"""What photographs show of the skin, as evidence for its shape: each picture against soft light on the fitted face.

A point's brightness is its colour's, which is one for all photographs and known roughly, times the light that its
normal gets, which each photograph has of its own. So shades, lips and brows say where the face stands out, and what is
seen from two sides must look alike (Blanz and Vetter 1999; shading after Horn 1970).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from omote.model.fitting.photographs.bundle_problem import LIGHTS, PAINTS, Bundle, Problem
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.fitting.photographs.skin.normal_slopes import slope_normals
from omote.model.fitting.photographs.skin.skin_samples import SkinSamples
from omote.model.fitting.photographs.skin.soft_pictures import Shown, SoftPicture, cut_face, look_at, unhidden
from omote.model.fitting.photographs.view_errors import POSE, change_by_pose
from omote.model.fitting.shape.head_zones import head_zones
from omote.model.fitting.soft_light import fit_soft_light, harmonics, slope_harmonics

Values = NDArray[np.float64]

ERROR = 0.05
"""Of a brightness' logarithm: what is neither light as we know it nor the skin's colour."""
ALIKE = 8.0
"""So many neighbouring points say no more than one."""
ODD = 2.0
"""A point that is off by so many standard deviations counts a quarter, and one far off nothing: hair before the face
(Geman and McClure)."""
FALL, PAINT = (0.7, 0.7, 0.7, 0.25, 0.25, 0.25, 0.25, 0.25), (0.7, 1.0, 0.5)
"""How uneven light is, and how much lips, brows and cheeks differ from skin: standard deviations."""
SURE = 0.2
"""Skin whose colour is not known better than that does not begin the light."""
SHADE = 0.1
"""Skin in less light than so much of the usual says nothing."""


@dataclass(frozen=True, eq=False)
class SkinEvidence:
    """What is looked at: points of the skin; of each photograph the part that shows the face; triangles (t, 3) about
    the points; how modes and units move the skin's vertices (3 V, m) and (3 V, u)."""

    samples: SkinSamples
    pictures: Sequence[SoftPicture | None]
    triangles: NDArray[np.int32]
    modes: Values
    units: Values


@dataclass(frozen=True, eq=False)
class Face:
    """A face as a photograph may show it: skin (V, 3), places and normals (s, 3) of the points, how the vertices'
    normals change with them (3 V, 3 V), and how long the mean of a triangle's normals is (s, 1)."""

    skin: Values
    places: Values
    normals: Values
    change: sparse.csr_array
    length: Values


@dataclass(frozen=True, eq=False)
class Compared:
    """Of the points that a photograph shows, rows (k,): how much brighter each is than expected (k,), the logarithm;
    how that changes with the photograph's unknowns (k, n); and its weight (k,)."""

    rows: NDArray[np.intp]
    left: Values
    slopes: Values
    weights: Values


def open_evidence(problem: Problem, samples: SkinSamples, last: Bundle, /) -> SkinEvidence:
    """The parts of the photographs that show the face, where it is about known."""
    face = problem.modes.shape_skin(last.weights)[head_zones(problem.space).face]
    pictures = [cut_face(each, camera, face) for each, camera in zip(problem.photographs, last.cameras, strict=True)]
    near = np.isin(problem.space.triangles, samples.corners).any(axis=1)
    moves, units = problem.modes.moves, samples.units
    return SkinEvidence(
        samples, pictures, problem.space.triangles[near],
        moves.transpose(1, 2, 0).reshape(-1, len(moves)), units.transpose(1, 2, 0).reshape(-1, len(units)),
    )  # fmt: skip


def start_lights(problem: Problem, evidence: SkinEvidence, last: Bundle, blur: float, /) -> Values:
    """The lights (v, 9) that explain best what the skin shows where its colour is known."""
    lights, samples = np.zeros((len(problem.photographs), LIGHTS)), evidence.samples
    for view, picture in enumerate(evidence.pictures):
        if picture is None:
            continue
        face = _face(problem, evidence, last, view)
        shown = _look(problem, evidence, last, view, face, blur)
        weight = shown.seen * samples.areas * (samples.spread < SURE)
        if (weight > 0.0).sum() < LIGHTS**2:
            continue
        light = fit_soft_light(harmonics(face.normals), np.exp(shown.bright), weight)
        level = max(float(light[0]), SHADE * float(np.average(np.exp(shown.bright), weights=weight)))
        lights[view] = np.log(level), *(light[1:] / level)
    return lights


def add_skin(
    problem: Problem, evidence: SkinEvidence, last: Bundle, blur: float, matrix: Values, pull: Values
) -> None:  # fmt: skip
    """Adds what the photographs, blurred by metres, show of the skin to the normal equations.

    The colour of each point is an unknown of its own that is eliminated at once.
    """
    samples = evidence.samples
    known = samples.areas / ALIKE / samples.spread**2
    shared, crossed, bright = known.copy(), np.zeros((len(known), problem.size)), np.zeros(len(known))
    for view, picture in enumerate(evidence.pictures):
        if picture is None:
            continue
        at, found = unknowns(problem, view), compare(problem, evidence, last, view, blur)
        weighed = found.slopes * found.weights[:, None]
        matrix[np.ix_(at, at)] += weighed.T @ found.slopes
        pull[at] += weighed.T @ found.left
        crossed[np.ix_(found.rows, at)] += weighed
        bright[found.rows] += found.weights * found.left
        shared[found.rows] += found.weights
    used = np.flatnonzero(np.abs(crossed).max(axis=0) > 0.0)
    inner = crossed[:, used]
    matrix[np.ix_(used, used)] -= (inner.T / shared) @ inner
    pull[used] -= inner.T @ (bright / shared)
    _expect(problem, last, matrix, pull)


def unknowns(problem: Problem, view: int, /) -> NDArray[np.intp]:
    """On which a photograph's skin depends: modes, turn, shift, lens, units, light, paint."""
    own, light = problem.columns(view)[problem.common :], problem.lit + LIGHTS * view
    found: NDArray[np.intp] = np.r_[
        : len(problem.moves), own, light : light + LIGHTS, problem.size - PAINTS : problem.size
    ]
    return found


def _expect(problem: Problem, last: Bundle, matrix: Values, pull: Values) -> None:
    """Adds what is expected of lights and paint."""
    at = np.arange(problem.lit, problem.size)
    even = [0.0, *(np.array(FALL) ** -2.0)]  # how bright a picture is, nobody knows
    sure = np.concatenate([even * len(last.lights), np.array(PAINT) ** -2.0])
    matrix[at, at] += sure
    pull[at] += sure * np.concatenate([last.lights.ravel(), last.paint])


def _face(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int) -> Face:
    """The face in a photograph, with its expression."""
    samples = evidence.samples
    skin = problem.modes.shape_skin(last.weights) + (evidence.units @ last.units[view]).reshape(-1, 3)
    vertices, change = slope_normals(skin, evidence.triangles)
    normals = samples.on(vertices)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return Face(skin, samples.on(skin), normals / length, change, length)


def _look(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int, face: Face, blur: float) -> Shown:
    """What a photograph shows of the points."""
    picture, camera = evidence.pictures[view], last.cameras[view]
    assert picture is not None
    shown = look_at(picture, camera, face.places, face.normals, blur)
    return Shown(
        shown.bright, shown.slopes, shown.seen * unhidden(camera, face.skin, problem.space.triangles, face.places)
    )  # fmt: skip


def compare(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int, blur: float, /) -> Compared:
    """What a photograph shows of the skin beside what is expected there."""
    samples, light, camera = evidence.samples, last.lights[view], last.cameras[view]
    face = _face(problem, evidence, last, view)
    shown = _look(problem, evidence, last, view, face, blur)
    basis = harmonics(face.normals)
    fall = basis @ [1.0, *light[1:]]
    rows = np.flatnonzero((shown.seen > 0.0) & (fall > SHADE))
    expected = light[0] + np.log(fall[rows]) + samples.layers[rows] @ last.paint
    left = shown.bright[rows] - expected
    turned = np.einsum("skc,k->sc", slope_harmonics(face.normals[rows]), [0.0, *light[1:]]) / fall[rows, None]
    basis[:, 0] = fall  # its logarithm's slope is 1
    slopes = np.column_stack([
        _by_shape(evidence, face, camera, rows, shown.slopes[rows], turned),
        -basis[rows] / fall[rows, None], -samples.layers[rows],
    ])  # fmt: skip
    odd = left**2 / (ERROR**2 + samples.spread[rows] ** 2)
    trust = samples.areas[rows] / ALIKE * shown.seen[rows] / (1.0 + odd / ODD**2) ** 2
    return Compared(rows, left, slopes, trust / ERROR**2)


def _by_shape(
    evidence: SkinEvidence, face: Face, camera: PhotographCamera, rows: NDArray[np.intp], drift: Values, turned: Values
) -> Values:  # fmt: skip
    """How what is left of brightness changes with modes, pose, lens and units: (k, m + 7 + u).

    drift (k, 2): how the picture's brightness changes by metres; turned (k, 3): how the light's does with a normal.
    """
    samples, places, normals = evidence.samples, face.places[rows], face.normals[rows]
    seen = camera.view(places)
    aside = np.column_stack([drift, -(drift * seen[:, :2]).sum(axis=1) / seen[:, 2]])
    along = (turned - normals * (turned * normals).sum(axis=1, keepdims=True)) / face.length[rows]
    corners, count = samples.corners[rows], face.skin.size
    moved = _at_corners(corners, aside @ camera.rotation, count)
    moved = moved - _at_corners(corners, along, count) @ face.change
    pose = -change_by_pose(camera, places).reshape(len(rows), 2, POSE)
    return np.column_stack([moved @ evidence.modes, (drift[:, :, None] * pose).sum(axis=1), moved @ evidence.units])


def _at_corners(corners: NDArray[np.int64], slopes: Values, count: int) -> sparse.csr_array:
    """Slopes (k, 3) by the middles of triangles as slopes by their corners, (k, count)."""
    values = np.repeat(slopes[:, None] / 3.0, 3, axis=1).ravel()
    columns = (3 * corners[:, :, None] + np.arange(3)).ravel()
    ends = 9 * np.arange(len(corners) + 1)
    return sparse.csr_array((values, columns, ends), shape=(len(corners), count))
