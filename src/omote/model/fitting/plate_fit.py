"""Bends the generic head onto a surface as a thin plate: coarse to fine, robust, free where nothing was seen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import LinearOperator, cg

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.geometry.laplacian import bending_energy, factor_symmetric
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.parameter_space import ParameterSpace

# The plate's stiffness as a length, metres; matches are found anew at each.
LENGTHS = (0.024, 0.014, 0.007, 0.0035, 0.0018, 0.0009, 0.0005)
# Before this one the skin is relaxed, once it lies near the surface.
RELAXED = 0.0035
# From this one on the skin lies near enough to look for where lids end.
LOOKED_AT = 0.007
# The share of a match that pulls along the surface too.
ALONG = 0.02
# Normals of a match lie within 60 degrees.
ALIKE = 0.5
# A match farther than so many lengths of the plate, and than LEAST metres, does not count.
REACH = 0.5
LEAST = 0.003
# Normals of neighbours differ by so much (chord, in the mean) on a rough surface; it is not followed finer than NOISY,
# metres.
ROUGH = 0.25
NOISY = 0.003
ITERATIONS = 60
EXACT = 1e-4


@dataclass(frozen=True, eq=False)
class Hold:
    """Points of the head that go to places of their own: each is the weighted sum of some vertices.

    matrix (k, V), places (k, 3) metres, weights (k,): of the plate's own vertices' weights.
    """

    matrix: sparse.csr_array
    places: Values
    weights: Values


Relax = Callable[[Values], Values]
FindPulls = Callable[[Values], Sequence[Hold]]


@dataclass(frozen=True, eq=False)
class Matches:
    """Where each vertex belongs, as far as that is known: rows of the surface (V,), weights (V,) from 0 to 1."""

    rows: Rows
    weights: Values


def match(surface: ScanSurface, space: ParameterSpace, skin: Values, reach: float, /) -> Matches:
    """The nearest of a surface to each vertex of a skin (V, 3), less sure the farther it is of reach metres.

    surface: the scan's; space: of the skin; skin (V, 3), reach: metres.
    """
    normals = mesh.normals(skin, space.triangles)
    rows = surface.find_nearest(skin, normals)
    away = np.linalg.norm(skin - surface.points[rows], axis=1)
    alike = (normals * surface.normals[rows]).sum(axis=1)
    good = (away < reach) & (alike > ALIKE) & ~surface.border[rows]
    return Matches(rows, good * (1.0 - np.minimum(away / reach, 1.0) ** 2) ** 2)


def bend(
    space: ParameterSpace, rest: Values, surface: ScanSurface, weights: Values, pulls: Sequence[tuple[Hold, Values]],
    lengths: Sequence[float] = LENGTHS, relax: Relax | None = None, find_pulls: FindPulls | None = None,
) -> Values:  # fmt: skip
    """The skin (V, 3) at rest bent onto a surface.

    weights (V,): how much each vertex's match counts; pulls: with how strong each is at each of the lengths; relax:
    slides the skin along itself once, before the length RELAXED, and what it is at rest goes along; find_pulls: what
    else pulls, found anew at each length from LOOKED_AT on.

    space: of the skin; rest (V, 3): metres; surface: the scan's; lengths: of the plate's stiffness, metres.
    """
    energy, area = bending_energy(rest, space.triangles)
    skin = rest.copy()
    for level, length in enumerate(lengths):
        if relax and length == RELAXED:
            relaxed = relax(skin)
            rest = rest + relaxed - skin
            skin = relaxed
        matches = match(surface, space, skin, max(REACH * length, LEAST))
        held = [(pull, float(area.mean() * strengths[level])) for pull, strengths in pulls]
        if find_pulls and length <= LOOKED_AT:
            held += [(pull, float(area.mean())) for pull in find_pulls(skin)]
        skin = _solve(rest, skin, length**4 * energy, surface, matches.rows, area * weights * matches.weights, held)
    return skin


def _solve(
    rest: Values, skin: Values, stiff: sparse.csr_array, surface: ScanSurface, rows: Rows, strength: Values,
    pulls: Sequence[tuple[Hold, float]],
) -> Values:  # fmt: skip
    """The plate's balance: planes and points of the surface, pulls, and bending against the shape at rest.

    Conjugate gradients, preconditioned by the system whose planes are taken to look every way alike.
    """
    normals = surface.normals[rows]
    goals = surface.points[rows]
    held, pull_side = _hold(rest, stiff, pulls)
    height = ((goals - skin) * normals).sum(axis=1, keepdims=True)
    off = skin + height * normals - rest  # beside the sample, in its plane
    side = strength[:, None] * (normals * (normals * off).sum(axis=1, keepdims=True) + ALONG * off) + pull_side
    alike = held + sparse.diags_array(strength * (1.0 / 3.0 + ALONG) + 1e-14)
    factor = factor_symmetric(alike)

    def apply(flat: Values) -> Values:
        moves = flat.reshape(-1, 3)
        planes = normals * (normals * moves).sum(axis=1, keepdims=True)
        return (held @ moves + strength[:, None] * (planes + ALONG * moves)).ravel()

    size = rest.size
    moves_flat, _ = cg(
        LinearOperator((size, size), apply), side.ravel(), (skin - rest).ravel(), rtol=EXACT, maxiter=ITERATIONS,
        M=LinearOperator((size, size), lambda flat: factor.solve(flat.reshape(-1, 3)).ravel()),
    )  # fmt: skip
    return rest + np.asarray(moves_flat).reshape(-1, 3)


def _hold(
    rest: Values, stiff: sparse.csr_array, pulls: Sequence[tuple[Hold, float]]
) -> tuple[sparse.csr_array, Values]:
    """The plate with what pulls it: matrix (V, V) and side (V, 3)."""
    held = stiff
    side = np.zeros(rest.shape)
    for pull, scale in pulls:
        weighted = sparse.csr_array(sparse.diags_array(scale * pull.weights) @ pull.matrix)
        held = held + pull.matrix.T @ weighted
        side += weighted.T @ (pull.places - pull.matrix @ rest)
    return sparse.csr_array(held), side


def find_lengths(surface: ScanSurface, /) -> Sequence[float]:
    """How fine a plate may follow a surface: as fine as it goes, or no finer than NOISY on one that is rough."""
    step = max(len(surface.points) // 4000, 1)
    _, rows = surface.tree.query(surface.points[::step], k=8, workers=1)
    alike = (surface.normals[rows] * surface.normals[rows[:, :1]]).sum(axis=2)
    rough = float(np.median(np.sqrt(np.maximum(2.0 - 2.0 * alike, 0.0)).mean(axis=1)))
    return LENGTHS if rough < ROUGH else tuple(length for length in LENGTHS if length >= NOISY)
