"""Similarity transforms (rotation, scale, shift) that align two sets of points by weighted least squares."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values


@dataclass(frozen=True, eq=False)
class Similarity:
    """points -> scale * rotation @ points + shift."""

    scale: float
    rotation: Values
    shift: Values

    def __call__(self, points: NDArray[np.floating], /) -> Values:
        """Where points (m, 3) go."""
        return self.scale * (points @ self.rotation.T) + self.shift

    def back(self, points: NDArray[np.floating], /) -> Values:
        """Where points (m, 3) came from."""
        return ((points - self.shift) @ self.rotation) / self.scale


def fit_turn(points: Values, targets: Values, /) -> Values:
    """The rotation (3, 3) about the origin that brings points (n, 3) nearest to targets (n, 3) (Kabsch 1976)."""
    left, _, right = np.linalg.svd(targets.T @ points)
    return (left * [1.0, 1.0, np.sign(np.linalg.det(left @ right))]) @ right


def fit_similarity(points: NDArray[np.floating], targets: NDArray[np.floating], weights: Values, /) -> Similarity:
    """The similarity that brings points (n, 3) nearest to targets (n, 3), least squares by weights (n,) (Umeyama 1991).

    The same points, or weights that are all zero, give the identity.
    """
    total = weights.sum()
    if not total > 0.0 or np.array_equal(points, targets):
        return Similarity(1.0, np.eye(3), np.zeros(3))
    share = weights / total
    middle = share @ points
    there = share @ targets
    away = points - middle
    wanted = targets - there
    left, sizes, right = np.linalg.svd((share[:, None] * wanted).T @ away)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    rotation = (left * signs) @ right
    scale = float((sizes * signs).sum() / (share @ (away**2).sum(axis=1)))
    return Similarity(scale, rotation, there - scale * rotation @ middle)


def measure_misfit(points: NDArray[np.floating], targets: NDArray[np.floating], /) -> float:
    """How far points (n, 3) are from targets (n, 3) at their best place, all counting alike: the mean distance."""
    off = fit_similarity(points, targets, np.ones(len(points)))(points) - targets
    return float(np.linalg.norm(off, axis=1).mean())
