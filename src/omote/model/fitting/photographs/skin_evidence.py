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

from omote.arrays import Indices, Rows, Values
from omote.geometry import mesh
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.bundle_problem import LIGHTS, PAINTS, POSE, Bundle, Problem, change_by_pose
from omote.model.fitting.photographs.photograph import PhotographCamera
from omote.model.fitting.photographs.soft_pictures import Shown, SoftPicture, cut_face, look_at, unhidden
from omote.model.fitting.soft_light import fit_soft_light, harmonics, slope_harmonics
from omote.model.space.parameter_space import ParameterSpace

_LEAST_AREA = 1e-15  # square metres
LIPS, BROWS, CHEEKS = range(3)
EVEN = 0.12
"""How far skin is lighter or darker than the person's skin is on the whole: a standard deviation of logarithms, and
more at the lips' border and at the brows, which nobody has where we have them."""
BORDER = 0.7
BROW = 0.5
ERROR = 0.05
"""Of a brightness' logarithm: what is neither light as we know it nor the skin's colour."""
ALIKE = 8.0
"""So many neighbouring points say no more than one."""
ODD = 2.0
"""A point that is off by so many standard deviations counts a quarter, and one far off nothing: hair before the face
(Geman and McClure)."""
FALL = (0.7, 0.7, 0.7, 0.25, 0.25, 0.25, 0.25, 0.25)
PAINT = (0.7, 1.0, 0.5)
"""How uneven light is, and how much lips, brows and cheeks differ from skin: standard deviations."""
SURE = 0.2
"""Skin whose colour is not known better than that does not begin the light."""
SHADE = 0.1
"""Skin in less light than so much of the usual says nothing."""


def slope_normals(points: Values, triangles: NDArray[np.integer], /) -> tuple[Values, sparse.csr_array]:
    """Normals (V, 3) of points (V, 3), weighted by area, and how they change with the points: (3 V, 3 V).

    Of a triangle a, b, c the normal is a x b + b x c + c x a: it changes with a by da x (b - c).

    points (V, 3): metres; triangles (t, 3): rows of them.
    """
    corners = triangles.astype(np.int64).T
    first, second, third = (points[corner] for corner in corners)
    total = np.zeros(points.shape)
    flat = np.cross(second - first, third - first)
    for corner in corners:
        np.add.at(total, corner, flat)
    length = np.linalg.norm(total, axis=1, keepdims=True) + _LEAST_AREA
    normals = total / length
    blocks = []
    rows = []
    columns = []
    for mover, side in zip(corners, (second - third, third - first, first - second), strict=True):
        turn = -mesh.cross_matrices(side)
        for receiver in corners:
            normal = normals[receiver]
            along = np.einsum("ti,tij->tj", normal, turn)
            blocks.append(((turn - normal[:, :, None] * along[:, None]) / length[receiver][:, None]).ravel())
            rows.append(np.repeat(_three(receiver).ravel(), 3))
            columns.append(np.repeat(_three(mover), 3, axis=0).ravel())
    where = (np.concatenate(rows), np.concatenate(columns))
    return normals, sparse.csr_array((np.concatenate(blocks), where), shape=(points.size, points.size))


def _three(rows: NDArray[np.int64]) -> NDArray[np.int64]:
    return 3 * rows[:, None] + np.arange(3)


@dataclass(frozen=True, eq=False)
class SkinSamples:
    """Points of the face's skin whose brightness is looked at: the middles of triangles.

    corners (s, 3): rows of the space's skin; areas (s,) of what each stands for, their mean being 1; layers (s, 3): how
    far it lies on lips, brows and cheeks; spread (s,): how far its brightness may be off beside that, logarithms; units
    (u, V, 3): how each expression moves the skin, metres.
    """

    corners: NDArray[np.int64]
    areas: Values
    layers: Values
    spread: Values
    units: Values

    def on(self, values: Values, /) -> Values:
        """Values (V, c) of the skin at the points, (s, c)."""
        return values[self.corners].mean(axis=1)


def sample_skin(space: ParameterSpace, rows: NDArray[np.int64], layers: Values, units: Values, /) -> SkinSamples:
    """The points in the middles of triangles (s,), rows of the space's; layers and units as in `SkinSamples`."""
    corners = space.triangles[rows].astype(np.int64)
    areas = mesh.areas(space.points, corners.astype(np.int32))
    border = BORDER * layers[:, LIPS] * (1.0 - layers[:, LIPS])
    spread = np.sqrt(EVEN**2 + border**2 + (BROW * layers[:, BROWS]) ** 2)
    return SkinSamples(corners, areas / areas.mean(), layers, spread, units)


@dataclass(frozen=True, eq=False)
class SkinEvidence:
    """What is looked at: points of the skin; of each photograph the part that shows the face; triangles (t, 3) about
    the points; how modes and units move the skin's vertices (3 V, m) and (3 V, u)."""

    samples: SkinSamples
    pictures: Sequence[SoftPicture | None]
    triangles: Indices
    modes: Values
    units: Values


@dataclass(frozen=True, eq=False)
class SeenFace:
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

    rows: Rows
    left: Values
    slopes: Values
    weights: Values


def open_evidence(problem: Problem, samples: SkinSamples, last: Bundle, /) -> SkinEvidence:
    """The parts of the photographs that show the face, where it is about known.

    problem: what is adjusted; samples: points of the skin; last: where shape and cameras are by now.
    """
    face = problem.modes.shape_skin(last.weights)[head_zones(problem.space).face]
    pictures = [cut_face(view, camera, face) for view, camera in zip(problem.photographs, last.cameras, strict=True)]
    near = np.isin(problem.space.triangles, samples.corners).any(axis=1)
    moves = problem.modes.moves
    units = samples.units
    return SkinEvidence(
        samples, pictures, problem.space.triangles[near],
        moves.transpose(1, 2, 0).reshape(-1, len(moves)), units.transpose(1, 2, 0).reshape(-1, len(units)),
    )  # fmt: skip


def start_lights(problem: Problem, evidence: SkinEvidence, last: Bundle, blur: float, /) -> Values:
    """The lights (v, 9) that explain best what the skin shows where its colour is known.

    problem: what is adjusted; evidence: what is looked at; last: where shape and cameras are by now; blur: of the
    pictures, metres.
    """
    lights = np.zeros((len(problem.photographs), LIGHTS))
    samples = evidence.samples
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


def add_skin(problem: Problem, evidence: SkinEvidence, last: Bundle, blur: float, matrix: Values, pull: Values) -> None:
    """Adds what the photographs, blurred by metres, show of the skin to the normal equations.

    The colour of each point is an unknown of its own that is eliminated at once.

    problem: what is adjusted; evidence: what is looked at; last: where all unknowns are by now; blur: metres; matrix
    (n, n), pull (n,): the normal equations, which change.
    """
    samples = evidence.samples
    known = samples.areas / ALIKE / samples.spread**2
    shared = known.copy()
    crossed = np.zeros((len(known), problem.size))
    bright = np.zeros(len(known))
    for view, picture in enumerate(evidence.pictures):
        if picture is None:
            continue
        at = unknowns(problem, view)
        compared = compare(problem, evidence, last, view, blur)
        weighed = compared.slopes * compared.weights[:, None]
        matrix[np.ix_(at, at)] += weighed.T @ compared.slopes
        pull[at] += weighed.T @ compared.left
        crossed[np.ix_(compared.rows, at)] += weighed
        bright[compared.rows] += compared.weights * compared.left
        shared[compared.rows] += compared.weights
    used = np.flatnonzero(np.abs(crossed).max(axis=0) > 0.0)
    inner = crossed[:, used]
    matrix[np.ix_(used, used)] -= (inner.T / shared) @ inner
    pull[used] -= inner.T @ (bright / shared)
    _expect(problem, last, matrix, pull)


def unknowns(problem: Problem, view: int, /) -> Rows:
    """On which a photograph's skin depends: modes, turn, shift, lens, units, light, paint.

    problem: what is adjusted; view: which photograph, from 0.
    """
    own = problem.columns(view)[problem.common :]
    light = problem.lit + LIGHTS * view
    return np.r_[: len(problem.moves), own, light : light + LIGHTS, problem.size - PAINTS : problem.size]


def _expect(problem: Problem, last: Bundle, matrix: Values, pull: Values) -> None:
    """Adds what is expected of lights and paint."""
    at = np.arange(problem.lit, problem.size)
    even = [0.0, *(np.array(FALL) ** -2.0)]  # how bright a picture is, nobody knows
    sure = np.concatenate([even * len(last.lights), np.array(PAINT) ** -2.0])
    matrix[at, at] += sure
    pull[at] += sure * np.concatenate([last.lights.ravel(), last.paint])


def _face(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int) -> SeenFace:
    """The face in a photograph, with its expression."""
    samples = evidence.samples
    skin = problem.modes.shape_skin(last.weights) + (evidence.units @ last.units[view]).reshape(-1, 3)
    vertices, change = slope_normals(skin, evidence.triangles)
    normals = samples.on(vertices)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return SeenFace(skin, samples.on(skin), normals / length, change, length)


def _look(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int, face: SeenFace, blur: float) -> Shown:
    """What a photograph shows of the points."""
    picture = evidence.pictures[view]
    camera = last.cameras[view]
    assert picture is not None
    shown = look_at(picture, camera, face.places, face.normals, blur)
    return Shown(
        shown.bright, shown.slopes, shown.seen * unhidden(camera, face.skin, problem.space.triangles, face.places)
    )


def compare(problem: Problem, evidence: SkinEvidence, last: Bundle, view: int, blur: float, /) -> Compared:
    """What a photograph shows of the skin beside what is expected there.

    problem: what is adjusted; evidence: what is looked at; last: where all unknowns are by now; view: which photograph,
    from 0; blur: metres.
    """
    samples = evidence.samples
    light = last.lights[view]
    camera = last.cameras[view]
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
    evidence: SkinEvidence, face: SeenFace, camera: PhotographCamera, rows: Rows, drift: Values, turned: Values
) -> Values:
    """How what is left of brightness changes with modes, pose, lens and units: (k, m + 7 + u).

    drift (k, 2): how the picture's brightness changes by metres; turned (k, 3): how the light's does with a normal.
    """
    samples = evidence.samples
    places = face.places[rows]
    normals = face.normals[rows]
    seen = camera.view(places)
    aside = np.column_stack([drift, -(drift * seen[:, :2]).sum(axis=1) / seen[:, 2]])
    along = (turned - normals * (turned * normals).sum(axis=1, keepdims=True)) / face.length[rows]
    corners = samples.corners[rows]
    count = face.skin.size
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
