"""Repairs a fitted skin: folds are smoothed away, and the inner corners of the eyes relaxed.

Folds take the mean displacement of their rings. At inner corners identity modes and matches say where a surface is and
little about where along it a vertex belongs: people's corners came out twice as long and a quarter as wide as the
generic ones, and a shape that folds nothing there folds the generic head, where those triangles are shorter. So skin
slides along itself there until its triangles are shaped as the generic head's.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.geometry.laplacian import bending_energy, factor_symmetric, smoothing_matrix
from omote.geometry.ramp import smooth_ramp
from omote.model.fitting.landmarks import find_landmarks
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import fit_similarity

# Triangles lie on each other where they bend by more than 148 degrees.
CREASED = -0.85
# Each round smooths what is folded and so many rings around, one more after every WIDER, and more often each time.
REPAIR_ROUNDS = 60
RINGS = 1
WIDER = 6
PASSES = 3
# What folds by less, metres, is mended where it is: nobody sees it.
SLIGHT = 2e-4
# Each round takes them so far to the means of their rings, so that they stop where nothing folds any more.
EASING = 0.02
# Of creases, which may be centimetres wide: in so many rounds, so far in each, and one ring more after so many.
EASING_ROUNDS = 120
CREASE_EASING = 0.5
# Until they bend by less than 135 degrees: what is smoothed towards a head that nearly lies on itself folds again.
ROOMY = -0.7
SLOWLY_WIDER = 20
# So near to a corner skin slides freely, so far from it not at all; the generic head is laid on what is around, metres.
FREE_WITHIN = 0.010
HELD_BEYOND = 0.024
AROUND = 0.03
# The stiffness as a length, metres, beside the skin's own planes.
RELAXED_LENGTH = 0.003
# How strong a vertex is held where it is, beside its plane: near corners, on the lids' lines, far from corners.
FREE = 0.02
ON_LINE = 1.0
HELD = 10.0


def find_folds(space: ParameterSpace, guide: Values, skin: Values, /) -> Rows:
    """The sheet's triangles whose normal on a skin (V, 3) points against that on a guide (V, 3), and those that lie on
    a neighbour as they do not on the guide.

    space: of both; guide (V, 3), skin (V, 3): metres.
    """
    sheet = space.sheet_triangles
    turned = (mesh.unit_normals(guide[sheet]) * mesh.unit_normals(skin[sheet])).sum(axis=1) <= 0.0
    return np.union1d(np.flatnonzero(turned), find_creases(space, guide, skin))


def find_creases(space: ParameterSpace, guide: Values, skin: Values, most: float = CREASED, /) -> Rows:
    """The sheet's triangles that lie on a neighbour on a skin (V, 3) as they do not on a guide (V, 3), wherever they
    face: an ear of another person may be turned by more than a right angle, and fold nothing.

    space: of both; guide (V, 3), skin (V, 3): metres; most: the cosine of the bend beyond which they lie on it.
    """
    sheet = space.sheet_triangles
    beside = mesh.neighbours(sheet)
    before, now = (_bend(mesh.unit_normals(points[sheet]), beside) for points in (guide, skin))
    return np.flatnonzero(((now < most) & (before >= most)).any(axis=1))


def _bend(normals: Values, beside: NDArray[np.integer]) -> Values:
    """The cosines (t, 3) between the normals of triangles and those of their neighbours; 1 where there is none."""
    return np.where(beside >= 0, (normals[:, None] * normals[beside]).sum(axis=2), 1.0)


def repair_folds(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) without the folds that it has against a guide (V, 3), as far as they can be smoothed away: folded
    places take the mean displacement from the guide of what is around, wider and wider.

    space: of both; guide (V, 3), skin (V, 3): metres.
    """
    average = smoothing_matrix(space.triangles, len(skin))
    moves = skin - guide
    for number in range(REPAIR_ROUNDS):
        folded = find_folds(space, guide, guide + moves)
        if not len(folded):
            break
        share = np.zeros(len(skin))
        share[space.sheet_triangles[folded]] = 1.0
        for _ in range(RINGS + number // WIDER):
            share = np.minimum(2.0 * (average @ share), 1.0)
        for _ in range(PASSES + number):
            moves = moves + share[:, None] * (average @ moves - moves)
    return guide + moves


def ease_creases(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) whose triangles lie on each other nowhere that a guide's (V, 3) do not, as far as the means of
    their rings can ease it, the rings a little wider with time; what is only turned stays. What lay there is
    eased on towards ROOMY, so that a fit which begins from that skin has room.

    space: of both; guide (V, 3), skin (V, 3): metres.
    """
    average = smoothing_matrix(space.triangles, len(skin))
    eased = skin
    lying: Rows = np.zeros(0, np.intp)
    for number in range(EASING_ROUNDS):
        still = np.intersect1d(lying, find_creases(space, guide, eased, ROOMY))
        lying = np.union1d(still, find_creases(space, guide, eased))
        if not len(lying):
            break
        share = np.zeros(len(skin))
        share[space.sheet_triangles[lying]] = 1.0
        for _ in range(number // SLOWLY_WIDER):
            share = np.minimum(2.0 * (average @ share), 1.0)
        eased = eased + CREASE_EASING * share[:, None] * (average @ eased - eased)
    return eased


def repair_slight_folds(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) without the last folds against a guide (V, 3), where they go by the means of their one-rings and
    move nothing farther than SLIGHT; else the same skin.

    space: of both; guide (V, 3), skin (V, 3): metres.
    """
    average = smoothing_matrix(space.triangles, len(skin))
    mended = skin.copy()
    for _ in range(REPAIR_ROUNDS):
        folded = find_folds(space, guide, mended)
        if not len(folded):
            break
        rows = np.unique(space.sheet_triangles[folded])
        mended[rows] += EASING * ((average @ mended)[rows] - mended[rows])
    slight = np.abs(mended - skin).max() <= SLIGHT
    return mended if slight and not len(find_folds(space, guide, mended)) else skin


def relax_corners(space: ParameterSpace, skin: Values, /) -> Values:
    """A skin (V, 3), metres, that bends near the inner corners of the eyes from the generic head as little as it can
    while it stays on its planes; far from them the same.

    space: of the skin; skin (V, 3): metres.
    """
    return _relax(space, skin, _measure_distances(space).min(axis=1))


def repair_corners(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) relaxed at those inner corners of eyes that fold against a guide (V, 3); the same where none does.

    What smooths folds away would squeeze a corner to a fifth of its size.

    space: of both; guide (V, 3), skin (V, 3): metres.
    """
    away = _measure_distances(space)
    folded = np.unique(space.sheet_triangles[find_folds(space, guide, skin)])
    corners = (away[folded] < FREE_WITHIN).any(axis=0)
    return _relax(space, skin, away[:, corners].min(axis=1)) if corners.any() else skin


def _relax(space: ParameterSpace, skin: Values, away: Values) -> Values:
    """A skin (V, 3) relaxed where it is not far away from a corner: (V,), metres."""
    share = smooth_ramp(FREE_WITHIN, HELD_BEYOND, away)
    home = fit_similarity(space.points, skin, np.where(away < AROUND, 1.0, 1e-6))(space.points)
    energy, area = bending_energy(home, space.triangles)
    hold = FREE + HELD * share**2
    for line in space.lines:
        hold[line.loop] += ON_LINE
    moving = np.flatnonzero(share < 1.0)
    held = _hold_planes(mesh.normals(skin, space.triangles)[moving], hold[moving], np.maximum(area[moving], 1e-10))
    stiff = RELAXED_LENGTH**4 * energy
    system = held + sparse.kron(stiff[moving][:, moving], sparse.eye_array(3))
    side = -(stiff @ (skin - home))[moving].ravel()
    factor = factor_symmetric(system)
    result = skin.copy()
    result[moving] += factor.solve(side).reshape(-1, 3)
    return result


def _measure_distances(space: ParameterSpace) -> Values:
    """How far each vertex of the generic head is from the inner corners of the eyes, (V, 2), metres."""
    corners = [row for name, row in find_landmarks(space).items() if name.endswith("_eye_inner")]
    return np.linalg.norm(space.points[:, None] - space.points[corners], axis=2)


def _hold_planes(normals: Values, hold: Values, area: Values) -> sparse.bsr_array:
    """The matrix (3 n, 3 n) that holds vertices in planes with normals (n, 3), and by hold (n,) where they are."""
    count = len(normals)
    blocks = normals[:, :, None] * normals[:, None, :] + np.eye(3) * hold[:, None, None]
    return sparse.bsr_array(
        (area[:, None, None] * blocks, np.arange(count), np.arange(count + 1)), shape=(3 * count, 3 * count)
    )
