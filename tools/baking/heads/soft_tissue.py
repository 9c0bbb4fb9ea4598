"""What hangs and shakes of a face: the fields that springs of the cast play, signed, as moves of the generic head.

A blendshape goes one way; these go both ways about rest, so their weights run from -1 to 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.model.space.gain import FieldRegion, Gain
from omote.model.space.head_regions import eye_frame
from omote.model.space.parameter_space import ParameterSpace
from tools.baking.heads.basemesh import Floats
from tools.baking.heads.moves import Move


@dataclass(frozen=True)
class _Pouch:
    """Tissue on both sides of a face: its middle and half-widths in distances between the eyes from the point midway
    between them, x on both sides; way (3,): how far the middle goes at weight 1, millimetres."""

    middle: tuple[float, float, float]
    widths: tuple[float, float, float]
    way: tuple[float, float, float]


# Jowls hang below the corners of the mouth and go sideways together; cheeks bounce up and down in front of them. Both
# end before lips and lids, which touch.
_POUCHES: Mapping[str, _Pouch] = {
    "jowls-sway": _Pouch((0.72, -1.35, -0.05), (0.62, 0.72, 1.0), (3.2, 0.0, 0.0)),
    "cheeks-bounce": _Pouch((0.78, -0.72, 0.05), (0.5, 0.6, 0.9), (0.0, 2.2, 0.0)),
}
# The regions of the head in which they lie.
_REGIONS: tuple[FieldRegion, ...] = ("cheeks", "mouth", "jaw")


def soft_gains(*, jowls: float, cheeks: float) -> tuple[Gain, ...]:
    """How much of both a face has, 1 as people of usual weight."""
    amounts = {"jowls-sway": jowls, "cheeks-bounce": cheeks}
    return tuple(Gain(region, amount, name) for name, amount in amounts.items() for region in _REGIONS)


def soft_moves(space: ParameterSpace) -> dict[str, Move]:
    """The moves of soft tissue, by expression.

    space: of the generic face.
    """
    return {name: Move(_moved_skin(space, pouch), _still_parts(space)) for name, pouch in _POUCHES.items()}


def _moved_skin(space: ParameterSpace, pouch: _Pouch) -> Floats:
    """How far the skin goes, (V, 3) metres: all of the way at the middle, nothing and without slope a width from it."""
    middle, unit = eye_frame(space)
    local = (space.points - middle) / unit
    total = np.zeros(space.vertex_count)
    for side in (1.0, -1.0):
        off = (local * [side, 1.0, 1.0] - pouch.middle) / pouch.widths
        total += np.maximum(1.0 - (off**2).sum(axis=1), 0.0) ** 2
    moved: Floats = np.where(space.on_sheet, total, 0.0)[:, None] * (np.array(pouch.way) / 1000.0)
    return moved


def _still_parts(space: ParameterSpace) -> dict[str, Floats]:
    return {name: np.zeros_like(part.points) for name, part in space.parts.items()}
