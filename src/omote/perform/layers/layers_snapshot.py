"""Snapshots of layers: plain values, and their validation when they come from a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.perform.frame import Held
from omote.perform.layers.columns import GAZE_PART, Columns, HasExpressions, columns_of
from omote.perform.layers.follower import Values
from omote.perform.layers.layer_names import LAYERS, LayerName, LayerSetting, check_driven
from omote.perform.layers.layers import Layers, recast
from omote.perform.layers.source_frame import LOSS_SECONDS, Driver, check_share, check_smoothing
from omote.perform.limits import check_known, check_within

SLACK = 1e-6
"""How far rounding may carry a follower beyond its range."""


@dataclass(frozen=True)
class LayersSnapshot:
    """The layers of a character: plain values, so msgspec writes and reads them exactly.

    names: of the columns; goal, first, second: every follower as little-endian float64.
    """

    names: tuple[str, ...]
    goal: bytes
    first: bytes
    second: bytes
    settings: Mapping[LayerName, LayerSetting]
    drivers: Mapping[LayerName, Driver]
    held: Held
    calm: bool


def snapshot_of(layers: Layers | None) -> LayersSnapshot | None:
    """The snapshot of layers; None where a character has none."""
    if layers is None:
        return None
    goal, first, second = (each.astype("<f8").tobytes() for each in (layers.goal, layers.first, layers.second))
    return LayersSnapshot(
        names=layers.columns.names,
        goal=goal,
        first=first,
        second=second,
        settings=dict(layers.settings),
        drivers=dict(layers.drivers),
        held=layers.held,
        calm=layers.calm,
    )


def restored(cast: HasExpressions, snapshot: LayersSnapshot | None) -> Layers | None:
    """The layers of a snapshot, which go on as they did; ValueError where none can have been so."""
    if snapshot is None:
        return None
    if set(snapshot.settings) != set(LAYERS):
        raise ValueError(f"the snapshot has the layers {', '.join(snapshot.settings)}; expected {', '.join(LAYERS)}")
    for name in names_driven(snapshot):
        check_known(name, cast.expressions, "channel")
    for layer, driver in snapshot.drivers.items():
        check_driven(layer)
        check_within(driver.silent, 0.0, LOSS_SECONDS, "the silence of a source (seconds)")
        check_smoothing(driver.smoothing)
        check_share(driver.share)
    columns = columns_of(cast, tuple(snapshot.names))
    goal, first, second = (_vector(each, columns) for each in (snapshot.goal, snapshot.first, snapshot.second))
    settings = {layer: snapshot.settings[layer] for layer in LAYERS}
    layers = Layers(columns, goal, first, second, settings, dict(snapshot.drivers), snapshot.held, snapshot.calm)
    return recast(cast, layers)


def _vector(data: bytes, columns: Columns) -> Values:
    if len(data) != 8 * columns.size:
        raise ValueError(f"the layers in the snapshot have {len(data)} bytes; expected {8 * columns.size}")
    vector = np.frombuffer(data, "<f8").astype(np.float64)
    for section in ("hold", "share", "trust", "yielded"):
        _check_range(vector[columns.sections[section]], np.zeros(1), np.ones(1), section)
    widest, units = columns.highest.copy(), slice(len(columns.names))
    widest[units][columns.parts[units] == GAZE_PART] = np.inf  # `recast` limits them: another cast's eyes turned less
    for row in (*columns.rows(vector, "streams"), columns.rows(vector, "hands")):
        _check_range(row, columns.lowest, widest, "value")
    return vector


def _check_range(values: Values, lowest: Values, highest: Values, what: str) -> None:
    if not ((values >= lowest - SLACK) & (values <= highest + SLACK) & np.isfinite(values)).all():
        raise ValueError(f"a {what} of the layers in the snapshot is out of its range; another program wrote it")


def names_driven(snapshot: LayersSnapshot | None) -> frozenset[str]:
    """The channels that layers cannot be played without: those that sources send, and those that hands hold."""
    if snapshot is None:
        return frozenset()
    return frozenset(snapshot.held.channels).union(*(driver.names for driver in snapshot.drivers.values()))
