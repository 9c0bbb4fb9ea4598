"""The masks of the play regions (`perform.blending.region_masks`) for the stages."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from omote.arrays import Floats
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.blending.region_masks import play_masks
from omote.show.cast_documents import RegionDocument
from omote.show.wire import le_bytes

ONE = 65535
"""Counts of what belongs to a region whole: at most a thousandth of a millimetre is lost of a move of 60 mm."""


def region_document(space: ParameterSpace) -> RegionDocument | None:
    """The masks of a space, rows as in `rest_positions`; None for a head without two eyeballs, which has no regions."""
    if len(space.eyes) != 2:
        return None
    masks = [play_masks(space)[region] for region in PLAY_REGIONS]
    rows = [np.concatenate([mask.skin, *(mask.parts[name] for name in space.parts)])[:, 0] for mask in masks]
    return RegionDocument(rows=_counts(rows), allowances=_counts(mask.allowances for mask in masks))


def _counts(masks: Iterable[Floats]) -> bytes:
    return le_bytes(np.rint(np.stack(list(masks), axis=1) * ONE), "<u2")
