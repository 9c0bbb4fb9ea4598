"""Reads compounds as pages do."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.show.cast_documents import CompoundAsset


def unpack_compound(asset: CompoundAsset, count: int) -> NDArray[np.float64]:
    """The displacements (count, 3), metres, that a page reads from a compound."""
    moves = np.zeros((count, 3))
    moves[np.frombuffer(asset.indices, "<u4")] = np.frombuffer(asset.deltas, "<i2").reshape(-1, 3) * asset.scale
    return moves
