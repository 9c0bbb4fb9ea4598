"""What automatic motion must know of the layers: which are free, and whether lips move."""

from __future__ import annotations

from omote.perform.layers.layer_names import DRIVEN, LayerName
from omote.perform.layers.layer_vectors import Layers, trust_of
from omote.perform.layers.source_frame import AUTOMATIC

SPOKEN = 0.1
"""Lips that are moved by more speak."""
SHOWN = 0.99
"""A tracker that is trusted by more hides what lies below."""
_TRACKER: LayerName = "tracker"


def is_free(layers: Layers, layer: LayerName) -> bool:
    """Whether no source drives a layer but the character's own motion."""
    return all(driver.source == AUTOMATIC for driver in layers.drivers.get(layer, ()))


def is_speaking(layers: Layers) -> bool:
    """Whether lips that a source drives move."""
    if not any(driver.is_trusted for driver in layers.drivers.get("lips", ())):
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
    drivers = layers.drivers.get(_TRACKER, ())
    if not drivers:
        return lost
    if any(driver.is_trusted for driver in drivers):
        return lost and float(trust_of(layers, _TRACKER).max()) < SHOWN
    return True
