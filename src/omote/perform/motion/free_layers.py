"""What automatic motion must know of the layers: which are free, and whether lips move."""

from __future__ import annotations

from omote.perform.layers.layer_names import DRIVEN, LayerName
from omote.perform.layers.layers import Layers
from omote.perform.layers.source_frame import AUTOMATIC, SPEECH
from omote.perform.speech.visemes import MOUTH_UNITS

SPOKEN = 0.1
"""Lips that are moved by more speak."""


def is_free(layers: Layers, layer: LayerName) -> bool:
    """Whether no source drives a layer but the character's own motion."""
    driver = layers.drivers.get(layer)
    return driver is None or driver.source == AUTOMATIC


def is_speaking(layers: Layers) -> bool:
    """Whether lips that a source drives move."""
    driver = layers.drivers.get("lips")
    if driver is None or not driver.is_trusted:
        return False
    lips = layers.columns.rows(layers.second, "streams")[DRIVEN.index("lips")]
    return bool(lips[: len(layers.columns.names)].max(initial=0.0) > SPOKEN)


def mouth_shown(layers: Layers) -> tuple[float, ...]:
    """The units of the mouth as a source moves the lips now; empty where none does."""
    driver = layers.drivers.get("lips")
    if driver is None or not driver.is_trusted or driver.source == SPEECH:
        return ()
    lips, index = layers.columns.rows(layers.second, "streams")[DRIVEN.index("lips")], layers.columns.index
    shown = [float(lips[index[unit]]) if unit in index else 0.0 for unit in MOUTH_UNITS]
    return tuple(min(max(weight, 0.0), 1.0) for weight in shown)
