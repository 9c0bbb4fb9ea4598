"""What automatic motion must know of the layers: which are free, and whether lips move."""

from __future__ import annotations

from omote.perform.layers.layer_names import DRIVEN, LayerName
from omote.perform.layers.layers import Layers
from omote.perform.layers.source_frame import AUTOMATIC

SPOKEN = 0.1
"""Lips that are moved by more speak."""
SHOWN = 0.99
"""A tracker that is trusted by more hides what lies below."""
_TRACKER: LayerName = "tracker"


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


def is_tracker_lost(layers: Layers | None, lost: bool) -> bool:
    """Whether the tracker that played is lost: silent, blind or gone, until another shows altogether; not while an
    operator, or a panic, has switched its layer off. lost: whether it was before."""
    if layers is None:
        return lost
    if not layers.settings[_TRACKER].on:
        return False
    driver = layers.drivers.get(_TRACKER)
    if driver is None or driver.waits:
        return lost
    if driver.is_trusted:
        return lost and float(layers.columns.rows(layers.second, "trust")[DRIVEN.index(_TRACKER)]) < SHOWN
    return True
