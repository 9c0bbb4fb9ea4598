"""What a landmark model says of heads whose shape is known: where its points lie on our skin, and how far it errs.

The error of all points together, is normally distributed about a
mean that depends on the head: a landmark model draws what it sees towards the faces that it has learned from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Indices, Values
from omote.model.space.parameter_space import ParameterSpace

LANDMARKS = 478
ON_SKIN = 468
"""Points of MediaPipe's face mesh, and those of them that lie on the skin; the others are irises."""


@dataclass(frozen=True, eq=False)
class LandmarkError:
    """How landmarks of a head that is turned so far are off: right and up, point by point (2 p,).

    mean (2 p,): metres; slopes (2 p, m): the same by the weights of modes; person (2 p, q): by what a person is beside
    that, the same in all their photographs, in standard deviations; basis (2 p, k), shared (k, k): what they have
    in common, as a covariance in a basis; alone (2 p,): the variance of the rest of each.
    """

    mean: Values
    slopes: Values
    person: Values
    basis: Values
    shared: Values
    alone: Values

    def weigh(self, matrix: Values, trust: Values, /) -> Values:
        """The inverse of the covariance times a matrix (2 p, n); trust (2 p,): 1, or less where a point is odd."""
        inverse = trust / self.alone
        scaled = self.basis * inverse[:, None]
        inner = np.linalg.inv(self.shared) + self.basis.T @ scaled
        return inverse[:, None] * matrix - scaled @ np.linalg.solve(inner, scaled.T @ matrix)

    @property
    def variance(self) -> Values:
        """Of each coordinate by itself, (2 p,)."""
        return self.alone + ((self.basis @ self.shared) * self.basis).sum(axis=1)


@dataclass(frozen=True, eq=False)
class LandmarkTable:
    """Where p landmarks lie on the skin and how they err, learned from photographs of heads whose shape is known.

    Attributes
    ----------
    corners : ndarray of int, (p, 3)
        Of each point's triangle: rows of the space's skin.
    shares : ndarray, (p, 3)
        Of these corners.
    nodes : ndarray, (n,)
        Turns of a head, radians, at which errors are known; `PhotographCamera.yaw`.
    basis, mean, slopes, person, shared, alone : ndarray
        Errors at the nodes, as in `LandmarkError`: basis (2 p, k); mean (n, k), slopes (n, k, m), person (n, k, q) and
        shared (n, k, k) in that basis; alone (n, 2 p).
    units : mapping of ndarray (p, 3), by the name of an expression
        How each moves the points on the generic head, metres.
    """

    corners: Indices
    shares: Values
    nodes: Values
    basis: Values
    mean: Values
    slopes: Values
    person: Values
    shared: Values
    alone: Values
    units: Mapping[str, Values]

    def places(self, skin: NDArray[np.floating], /) -> Values:
        """Where the points lie on a skin (..., V, 3): (..., p, 3)."""
        return np.einsum("pk,...pkc->...pc", self.shares, skin[..., self.corners, :])

    def error_at(self, yaw: float, /) -> LandmarkError:
        """How landmarks of a head that is turned so far are off."""
        at = float(np.interp(yaw, self.nodes, np.arange(len(self.nodes))))
        low = min(int(at), len(self.nodes) - 2)
        share = at - low

        def between(values: Values) -> Values:
            return (1.0 - share) * values[low] + share * values[low + 1]

        mean, slopes, person = (self.basis @ between(nodes) for nodes in (self.mean, self.slopes, self.person))
        return LandmarkError(mean, slopes, person, self.basis, between(self.shared), between(self.alone))


def refuse_other_space(space: ParameterSpace, table: LandmarkTable, /) -> None:
    """Raises ValueError where a table names rows that the space's skin does not have."""
    if table.corners.max() >= space.vertex_count:
        raise ValueError(
            f"the landmark table names row {table.corners.max()} of a skin of {space.vertex_count} vertices; "
            "expected the built-in cast's space"
        )
