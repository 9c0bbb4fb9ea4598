"""The paper's own engine (section 2.4 and 3, eq. 3-7): vertex buffers that a call freezes; the weights' reference.

Each axis has the paper's two slots, and a third for the velocity that a call takes over (its weights sum to nothing).
Three buffers are kept: every pair of slots; every face slot wearing each expression that may still be called; every
expression slot worn by each face. The compound of a frozen slot with a newly called partner is that slot's weighted
sum of the partner's compounds (docs/method.md, "Weights are enough").
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Values = NDArray[np.float64]
SLOTS = 3
START, TARGET, VELOCITY = range(SLOTS)


class FrozenSlots:
    """The vertex buffers of a show, from the compounds (faces, expressions, V, 3) in metres.

    Slot weights and their rates per second come from outside, three each: start, target, velocity.
    """

    def __init__(
        self, compounds: ArrayLike, faces: Sequence[str], expressions: Sequence[str], face: str, expression: str
    ) -> None:  # fmt: skip
        self._compounds = np.asarray(compounds, np.float64)
        if self._compounds.shape[:2] != (len(faces), len(expressions)):
            raise ValueError(
                f"compounds {self._compounds.shape} for {len(faces)} faces and {len(expressions)} expressions; "
                "expected (faces, expressions, V, 3)"
            )
        self._faces = {name: row for row, name in enumerate(faces)}
        self._expressions = {name: row for row, name in enumerate(expressions)}
        i, j = self._faces[face], self._expressions[expression]
        self._worn_later = _resting(self._compounds[i])
        self._wearing_later = _resting(self._compounds[:, j])
        self._now = _resting(_resting(self._compounds[i, j]))

    def call_face(self, name: str, weights: ArrayLike, rates: ArrayLike) -> None:
        """Freezes the blend at these face slot weights and rates; the new face becomes the target (eq. 4, 5)."""
        row = self._faces[name]
        self._now = _frozen(self._now, weights, rates, self._wearing_later[:, row])
        self._worn_later = _frozen(self._worn_later, weights, rates, self._compounds[row])

    def call_expression(self, name: str, weights: ArrayLike, rates: ArrayLike) -> None:
        """Freezes the blend at these expression slot weights and rates; the new one becomes the target (eq. 6, 7)."""
        row = self._expressions[name]
        now = _frozen(self._now.swapaxes(0, 1), weights, rates, self._worn_later[:, row])
        self._now = now.swapaxes(0, 1)
        self._wearing_later = _frozen(self._wearing_later, weights, rates, self._compounds[:, row])

    def positions(self, faces: ArrayLike, expressions: ArrayLike) -> Values:
        """The blend (V, 3) at these slot weights of faces and expressions (eq. 3)."""
        worn = np.tensordot(np.asarray(faces, np.float64), self._now, axes=1)
        result: Values = np.tensordot(np.asarray(expressions, np.float64), worn, axes=1)
        return result


def _resting(target: Values) -> Values:
    """Slots (3, ...) of which only the target holds anything."""
    slots = np.zeros((SLOTS, *target.shape))
    slots[TARGET] = target
    return slots


def _frozen(slots: Values, weights: ArrayLike, rates: ArrayLike, target: Values) -> Values:
    frozen = np.empty_like(slots)
    frozen[START] = np.tensordot(np.asarray(weights, np.float64), slots, axes=1)
    frozen[VELOCITY] = np.tensordot(np.asarray(rates, np.float64), slots, axes=1)
    frozen[TARGET] = target
    return frozen
