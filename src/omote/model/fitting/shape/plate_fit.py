"""Bends the generic head onto a surface as a thin plate: coarse to fine, robust, free where nothing was seen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import LinearOperator, cg, splu

from omote.geometry import mesh
from omote.geometry.laplacian import bending_energy
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Indices = NDArray[np.intp]
Ease = Callable[[Values], Values]

# The plate's stiffness as a length, metres; matches are found anew at each.
LENGTHS = (0.024, 0.014, 0.007, 0.0035, 0.0018, 0.0009, 0.0005)
# Before this one the skin is eased, once it lies near the surface.
EASED = 0.0035
# The share of a match that pulls along the surface too.
ALONG = 0.02
# Normals of a match lie within 60 degrees.
ALIKE = 0.5
# A match farther than so many lengths of the plate, and than LEAST metres, does not count.
REACH, LEAST = 0.5, 0.003
# Normals of neighbours differ by so much (chord, in the mean) on a rough surface; it is not followed finer than NOISY,
# metres.
ROUGH, NOISY = 0.25, 0.003
ITERATIONS, EXACT = 60, 1e-4


@dataclass(frozen=True, eq=False)
class Pull:
    """Points of the head that go to places of their own: each is the weighted sum of some vertices.

    matrix (k, V), places (k, 3) metres, weights (k,): of the plate's own vertices' weights.
    """

    matrix: sparse.csr_array
    places: Values
    weights: Values


@dataclass(frozen=True, eq=False)
class Matches:
    """Where each vertex belongs, as far as that is known: rows of the surface (V,), weights (V,) from 0 to 1."""

    rows: Indices
    weights: Values


def match(surface: ScanSurface, space: ParameterSpace, skin: Values, reach: float, /) -> Matches:
    """The nearest of a surface to each vertex of a skin (V, 3), less sure the farther it is of reach metres."""
    normals = mesh.normals(skin, space.triangles)
    rows = surface.find_nearest(skin, normals)
    away = np.linalg.norm(skin - surface.points[rows], axis=1)
    alike = (normals * surface.normals[rows]).sum(axis=1)
    good = (away < reach) & (alike > ALIKE) & ~surface.border[rows]
    return Matches(rows, good * (1.0 - np.minimum(away / reach, 1.0) ** 2) ** 2)


def bend(
    space: ParameterSpace, rest: Values, surface: ScanSurface, weights: Values, pulls: Sequence[tuple[Pull, Values]],
    lengths: Sequence[float] = LENGTHS, ease: Ease | None = None,
) -> Values:  # fmt: skip
    """The skin (V, 3) at rest bent onto a surface.

    weights (V,): how much each vertex's match counts; pulls: with how strong each is at each of the lengths; ease:
    slides the skin along itself once, before the length EASED, and what it is at rest goes along.
    """
    energy, area = bending_energy(rest, space.triangles)
    skin = rest.copy()
    for level, length in enumerate(lengths):
        if ease and length == EASED:
            eased = ease(skin)
            rest, skin = rest + eased - skin, eased
        found = match(surface, space, skin, max(REACH * length, LEAST))
        held = [(pull, float(area.mean() * each[level])) for pull, each in pulls]
        skin = _solve(rest, skin, length**4 * energy, surface, found.rows, area * weights * found.weights, held)
    return skin


def _solve(
    rest: Values, skin: Values, stiff: sparse.csr_array, surface: ScanSurface, rows: Indices, strength: Values,
    pulls: Sequence[tuple[Pull, float]],
) -> Values:  # fmt: skip
    """The plate's balance: planes and points of the surface, pulls, and bending against the shape at rest.

    Conjugate gradients, preconditioned by the system whose planes are taken to look every way alike.
    """
    normals, goals = surface.normals[rows], surface.points[rows]
    held, pull_side = _hold(rest, stiff, pulls)
    height = ((goals - skin) * normals).sum(axis=1, keepdims=True)
    off = skin + height * normals - rest  # beside the sample, in its plane
    side = strength[:, None] * (normals * (normals * off).sum(axis=1, keepdims=True) + ALONG * off) + pull_side
    alike = held + sparse.diags_array(strength * (1.0 / 3.0 + ALONG) + 1e-14)
    factor = splu(sparse.csc_array(alike), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})

    def apply(flat: Values) -> Values:
        moves = flat.reshape(-1, 3)
        planes = normals * (normals * moves).sum(axis=1, keepdims=True)
        result: Values = (held @ moves + strength[:, None] * (planes + ALONG * moves)).ravel()
        return result

    size = rest.size
    found, _ = cg(
        LinearOperator((size, size), apply), side.ravel(), (skin - rest).ravel(), rtol=EXACT, maxiter=ITERATIONS,
        M=LinearOperator((size, size), lambda flat: factor.solve(flat.reshape(-1, 3)).ravel()),
    )  # fmt: skip
    result: Values = rest + np.asarray(found).reshape(-1, 3)
    return result


def _hold(
    rest: Values, stiff: sparse.csr_array, pulls: Sequence[tuple[Pull, float]]
) -> tuple[sparse.csr_array, Values]:  # fmt: skip
    """The plate with what pulls it: matrix (V, V) and side (V, 3)."""
    held, side = stiff, np.zeros(rest.shape)
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
