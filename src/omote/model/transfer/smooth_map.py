"""What the smooth map needs of a face, solved once per face (docs/method.md, "The smooth map").

The stages that apply it to an expression, in order, are `omote.model.transfer.pipeline.STAGES`; its inverse is in
`omote.model.extraction.extract`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Mask, Values
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit, generic_face
from omote.model.space.lid_lip_lines import Line, jaw_amplitude
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.eyeball_clearance import Clearance, Eyeball, build_clearance
from omote.model.transfer.fold_repair import SheetGeometry, build_sheet_geometry
from omote.model.transfer.lid_lip_contact import Contact, build_contact, compute_gain
from omote.model.weak_cache import weakly_cached_with

# Where gradients give way to the displacement itself, metres.
LENGTH = 0.002
# What a triangle's gradient may miss without being corrected: people move alike where their triangles differ by so much
# (a fold misses 1). More of either is smoother on strong faces and farther from what people truly do:
# docs/decisions/expression-transfer.md.
TOLERANCE = 0.15
SYMMETRIC = {"SymmetricMode": True}


@dataclass(frozen=True, eq=False)
class DetailSolver:
    """The solved system of one face: (D' A D + M / LENGTH^2) correction = D' A (missing gradients).

    slopes (2 T, n): D on the sheet's vertices used (n,); areas (2 T,) and solver: the factorised matrix; carried
    (T, 3, 2): where the generic face's frames carry the two directions in each triangle's plane.
    """

    geometry: SheetGeometry
    used: Indices
    slopes: sparse.csr_array
    areas: Values
    solver: splu
    carried: Values


def factor_detail(geometry: SheetGeometry, /) -> DetailSolver:
    """The system of a face's sheet, factorised."""
    triangles = geometry.triangles
    used, corners = np.unique(triangles, return_inverse=True)
    values = geometry.gradients.transpose(2, 0, 1)
    rows = np.arange(2 * len(triangles)).reshape(2, -1, 1)
    places = np.broadcast_to(corners.reshape(triangles.shape), values.shape).ravel()
    where = (np.broadcast_to(rows, values.shape).ravel(), places)
    slopes = sparse.coo_array((values.ravel(), where), shape=(2 * len(triangles), len(used))).tocsr()
    area = 0.5 * np.linalg.norm(geometry.normals, axis=1)
    mass = np.bincount(corners.ravel(), np.repeat(area / 3.0, 3))
    areas = np.tile(area, 2)
    matrix = slopes.T @ sparse.diags_array(areas) @ slopes + sparse.diags_array(mass / LENGTH**2)
    carried = np.ascontiguousarray(geometry.inverse_frames @ geometry.plane)
    return DetailSolver(geometry, used.astype(np.int32), slopes, areas, _factor(matrix), carried)


def _factor(matrix: sparse.csr_array) -> splu:
    """The factors of a symmetric positive definite matrix: a minimum degree ordering of its own graph, no pivots."""
    return splu(sparse.csc_array(matrix), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=SYMMETRIC)


def solve_detail(detail: DetailSolver, displacement: Values, moved: Values, gain: Values, /) -> Values:
    """The displacement (V, 3), gain (V,) times as large, with its detail in the face's own triangles.

    moved (V, 3): the generic face wearing the expression. On the generic face itself nothing changes.
    """
    geometry = detail.geometry
    result = displacement * gain[:, None]
    pull = np.zeros_like(result)
    _pull_missing(
        moved, result, gain, geometry.triangles, detail.carried, geometry.gradients, geometry.plane, detail.areas, pull
    )
    result[detail.used] += detail.solver.solve(pull[detail.used])
    return result


@njit(cache=True)
def _pull_missing(
    moved: Values, result: Values, gain: Values, triangles: Indices, carried: Values, gradients: Values, plane: Values,
    areas: Values, pull: Values,
) -> None:  # fmt: skip
    """Adds D' A (missing gradients) to pull (V, 3), each triangle's gradient shortened by TOLERANCE (soft
    thresholding)."""
    one = np.empty(3)
    two = np.empty(3)
    up = np.empty(3)
    missing = np.empty((2, 3))
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        for c in range(3):
            one[c] = moved[j, c] - moved[i, c]
            two[c] = moved[k, c] - moved[i, c]
        up[0], up[1] = one[1] * two[2] - one[2] * two[1], one[2] * two[0] - one[0] * two[2]
        up[2] = one[0] * two[1] - one[1] * two[0]
        size = np.sqrt(np.sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]))
        share = (gain[i] + gain[j] + gain[k]) / 3.0
        square = 0.0
        for d in range(2):
            a, b, n = carried[t, 0, d], carried[t, 1, d], carried[t, 2, d] / size
            x, y, z = gradients[t, 0, d], gradients[t, 1, d], gradients[t, 2, d]
            for c in range(3):
                wanted = share * (one[c] * a + two[c] * b + up[c] * n - plane[t, c, d])
                missing[d, c] = wanted - x * result[i, c] - y * result[j, c] - z * result[k, c]
                square += missing[d, c] * missing[d, c]
        if square <= TOLERANCE * TOLERANCE:
            continue
        weight = areas[t] * (1.0 - TOLERANCE / np.sqrt(square))
        for corner in range(3):
            for c in range(3):
                slopes = gradients[t, corner, 0] * missing[0, c] + gradients[t, corner, 1] * missing[1, c]
                pull[triangles[t, corner], c] += weight * slopes


@dataclass(frozen=True, eq=False)
class SmoothMap:
    """The map from the generic face to another, solved once.

    generic, positions (V, 3): both faces at rest, metres; geometry: the triangles of the sheet on both; detail: the
    factorised system of `transfer_detail`; contacts: one per line of lids or lips; on_line (V,): the vertices on these
    lines; clearances: one per eyeball; gain (V,): how much larger a displacement becomes at each vertex.
    """

    generic: Values
    positions: Values
    geometry: SheetGeometry
    detail: DetailSolver
    contacts: tuple[Contact, ...]
    on_line: Mask
    clearances: tuple[Clearance, ...]
    gain: Values


def prepare_smooth_map(space: ParameterSpace, face: Face, /) -> SmoothMap:
    """The smooth map to a face, solved at the first call and remembered as long as the face lives.

    space: the space of the generic head.
    """
    fit(space, face)  # rejects what is no face of the space
    return _prepare(space, face)


@weakly_cached_with
def _prepare(space: ParameterSpace, face: Face) -> SmoothMap:
    fitted = fit(space, face)
    generic = fit(space, generic_face(space))
    here = fitted.positions.astype(np.float64)
    there = generic.positions.astype(np.float64)
    eyeballs = tuple(zip(_eyeballs(space, generic), _eyeballs(space, fitted), strict=True))
    return build_smooth_map(there, here, space.sheet_triangles, space.lines, eyeballs)


def build_smooth_map(
    generic: Values, positions: Values, triangles: Indices, lines: tuple[Line, ...],
    eyeballs: tuple[tuple[Eyeball, Eyeball], ...] = (), /,
) -> SmoothMap:  # fmt: skip
    """The map for displacements of the generic face (V, 3) to the face with positions (V, 3).

    triangles (T, 3): the sheet's; lines: of lids and lips; eyeballs: each of the generic face with the same one of this
    face.
    """
    geometry = build_sheet_geometry(generic, positions, triangles)
    on_line = np.zeros(len(generic), np.bool_)
    for line in lines:
        on_line[line.loop] = True
    contacts = tuple(build_contact(line, generic, positions, geometry) for line in lines)
    clearances = tuple(build_clearance(generic, positions, triangles, there, here) for there, here in eyeballs)
    amplitude = jaw_amplitude(lines, generic, positions)
    gain = compute_gain(generic, contacts, 1.0 if amplitude is None else amplitude)
    return SmoothMap(generic, positions, geometry, factor_detail(geometry), contacts, on_line, clearances, gain)


def _eyeballs(space: ParameterSpace, fitted: FittedFace) -> tuple[Eyeball, ...]:
    """The eyeballs of a face, in the order of the space's parts."""
    return tuple(Eyeball(fitted.centres[name], fitted.ball_radius(name)) for name in space.eyes)
