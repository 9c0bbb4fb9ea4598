"""The built-in head's skin as photographs are compared with it."""

from __future__ import annotations

import functools
from pathlib import Path

import numpy as np

from omote.arrays import Values
from omote.builtin import load_cast, load_landmark_table
from omote.model.fitting.photographs.skin_evidence import SkinSamples, sample_skin
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame

SKIN_LAYERS = Path(__file__).parent / "photographs" / "skin_layers.npz"


@functools.cache
def load_skin_samples() -> SkinSamples:
    """Where photographs of faces are compared with the built-in head, and what is known of its colours; errors as
    `load_cast`."""
    cast = load_cast()
    names = list(load_landmark_table().units)

    def wear(units: dict[str, float]) -> Values:
        return evaluate(cast, Frame({"generic": 1.0}, {"neutral": 1.0}, units)).astype(np.float64)

    units = np.stack([wear({name: 1.0}) - wear({}) for name in names])
    with np.load(SKIN_LAYERS, allow_pickle=False) as file:
        return sample_skin(cast.space, file["rows"].astype(np.int64), file["layers"].astype(np.float64) / 255.0, units)
