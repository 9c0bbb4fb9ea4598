"""The built-in head's skin as photographs are compared with it."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from omote.arrays import Values
from omote.builtin import load_cast, load_landmark_table
from omote.model.cast import Cast
from omote.model.fitting.photographs.skin_evidence import SkinSamples, sample_skin
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame
from omote.perform.saturation import JAW_OPEN, TONGUE, TONGUE_OPENS

SKIN_LAYERS = Path(__file__).parent / "photographs" / "skin_layers.npz"


@functools.cache
def load_skin_samples() -> SkinSamples:
    """Where photographs of faces are compared with the built-in head, and what is known of its colours; errors as
    `load_cast`."""
    cast = load_cast()
    units = find_skin_moves(cast, list(load_landmark_table().units))
    with np.load(SKIN_LAYERS, allow_pickle=False) as file:
        return sample_skin(cast.space, file["rows"].astype(np.int64), file["layers"].astype(np.float64) / 255.0, units)


def find_skin_moves(cast: Cast, units: Sequence[str]) -> Values:
    """How each unit alone moves the built-in head's skin, (u, V, 3) metres: a tongue without the jaw that it brings
    (`TONGUE_OPENS`), since a photograph's jaw is a unit of its own.

    Parameters
    ----------
    cast : Cast
        The built-in one.
    units : sequence of str
        Names of units.
    """

    def wear(channels: dict[str, float]) -> Values:
        return evaluate(cast, Frame({"generic": 1.0}, {"neutral": 1.0}, channels)).astype(np.float64)

    brought = {TONGUE: {JAW_OPEN: TONGUE_OPENS}}
    return np.stack([wear({name: 1.0}) - wear(brought.get(name, {})) for name in units])
