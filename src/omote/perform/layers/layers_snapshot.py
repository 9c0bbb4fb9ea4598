"""Snapshots of layers: plain values, and their validation when they come from a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from omote.arrays import Values
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import Held
from omote.perform.layers.columns import GAZE_PART, PLACES, Columns, HasExpressions, columns_of
from omote.perform.layers.drivers import LONGEST_WAY_BACK, NOBODY, STEADY_SECONDS, Driver, Owners, owners_of
from omote.perform.layers.layer_names import DRIVEN, LAYER_PARTS, LAYERS, LayerName, LayerSetting, check_driven
from omote.perform.layers.layer_vectors import Layers, with_share_goal
from omote.perform.layers.layers import recast
from omote.perform.layers.source_frame import LOSS_SECONDS, check_part_shares, check_share, check_smoothing
from omote.perform.limits import check_known, check_within

SLACK = 1e-6
"""How far rounding may carry a follower beyond its range."""


@dataclass(frozen=True)
class LayersSnapshot:
    """The layers of a character: plain values, so msgspec writes and reads them exactly.

    names: of the columns; goal, first, second: every follower as little-endian float64. drivers: the sources of each
    layer; one alone as it was written when a layer had one. followed: whom each part of a layer shows. back: where
    sources were seen last that are on their way back, b"" where none is.
    """

    names: tuple[str, ...]
    goal: bytes
    first: bytes
    second: bytes
    settings: Mapping[LayerName, LayerSetting]
    drivers: Mapping[LayerName, tuple[Driver, ...] | Driver]
    held: Held
    calm: bool
    followed: Mapping[LayerName, Owners] = field(default_factory=dict)
    back: bytes = b""


def snapshot_of(layers: Layers | None) -> LayersSnapshot | None:
    """The snapshot of layers; None where a character has none."""
    if layers is None:
        return None
    goal, first, second = (vector.astype("<f8").tobytes() for vector in (layers.goal, layers.first, layers.second))
    return LayersSnapshot(
        names=layers.columns.names,
        goal=goal,
        first=first,
        second=second,
        settings=dict(layers.settings),
        drivers=dict(layers.drivers),
        held=layers.held,
        calm=layers.calm,
        followed=dict(layers.followed),
        back=b"" if layers.back is None else layers.back.astype("<f8").tobytes(),
    )


def restored(cast: HasExpressions, snapshot: LayersSnapshot | None) -> Layers | None:
    """The layers of a snapshot, which go on as they did; ValueError where none can have been so.

    cast: whose expressions there are.
    """
    if snapshot is None:
        return None
    if set(snapshot.settings) != set(LAYERS):
        raise ValueError(f"the snapshot has the layers {', '.join(snapshot.settings)}; expected {', '.join(LAYERS)}")
    for name in names_driven(snapshot):
        check_known(name, cast.expressions, "channel")
    drivers = {check_driven(layer): _several(stored) for layer, stored in snapshot.drivers.items()}
    _check_drivers(drivers, snapshot.followed)
    columns = columns_of(cast, tuple(snapshot.names))
    owners = {layer: owners_of(driven, columns) for layer, driven in drivers.items()}
    goal, first, second = (
        _vector(vector, columns, owners) for vector in (snapshot.goal, snapshot.first, snapshot.second)
    )
    settings = {layer: snapshot.settings[layer] for layer in LAYERS}
    back = _vector(snapshot.back, columns, owners) if snapshot.back else None
    is_old = len(snapshot.goal) != 8 * columns.size
    layers = Layers(
        columns, goal, first, second, settings, drivers, snapshot.held, snapshot.calm, owners,
        owners if is_old else dict(snapshot.followed), back,
    )  # fmt: skip
    return recast(cast, with_share_goal(layers) if is_old else layers)


def _several(drivers: tuple[Driver, ...] | Driver) -> tuple[Driver, ...]:
    return (drivers,) if isinstance(drivers, Driver) else tuple(drivers)


def _check_drivers(drivers: Mapping[LayerName, tuple[Driver, ...]], followed: Mapping[LayerName, Owners]) -> None:
    for driver in (driver for layer_drivers in drivers.values() for driver in layer_drivers):
        check_within(driver.silent, 0.0, LOSS_SECONDS, "the silence of a source (seconds)")
        check_within(driver.steady, 0.0, STEADY_SECONDS, "the steady frames of a source (seconds)")
        for seconds in (driver.way, driver.away):
            check_within(seconds, 0.0, LONGEST_WAY_BACK, "the way back of a source (seconds)")
        check_smoothing(driver.smoothing)
        check_share(driver.share)
        check_part_shares(driver.part_shares)
    for layer, names in followed.items():
        sources = {driver.source for driver in drivers.get(layer, ())}
        if len(names) != PLACES or not sources.issuperset(name for name in names if name is not None):
            raise ValueError(f"the layer {layer} of the snapshot shows {names}; expected {PLACES} of its sources")


def _vector(data: bytes, columns: Columns, owners: Mapping[LayerName, Owners]) -> Values:
    single = columns.size - (len(LAYERS) + len(DRIVEN) * len(LAYER_PARTS))
    if len(data) not in (8 * columns.size, 8 * single):
        raise ValueError(f"the layers in the snapshot have {len(data)} bytes; expected {8 * columns.size}")
    vector = np.frombuffer(data, "<f8").astype(np.float64)
    if len(vector) == single:
        vector = _by_part(vector, columns, owners)
    for section in ("hold", "share", "trust", "yielded"):
        _check_range(vector[columns.sections[section]], np.zeros(1), np.ones(1), section)
    widest = columns.highest.copy()
    units = slice(len(columns.names))
    widest[units][columns.parts[units] == GAZE_PART] = np.inf  # `recast` limits them: another cast's eyes turned less
    for row in (*columns.rows(vector, "streams"), columns.rows(vector, "hands")):
        _check_range(row, columns.lowest, widest, "value")
    return vector


def _by_part(vector: Values, columns: Columns, owners: Mapping[LayerName, Owners]) -> Values:
    """A vector from when a layer had one source, and one trust for all its parts."""
    later = np.zeros(columns.size)
    begin = columns.sections["share"].start
    later[:begin] = vector[:begin]
    end = begin + len(LAYERS) * len(LAYER_PARTS)
    shares = vector[begin:end].reshape(len(LAYERS), -1)
    trusts = vector[end : end + len(DRIVEN)].tolist()
    columns.rows(later, "share")[:] = np.column_stack([shares, shares[:, : len(PLAY_REGIONS)].mean(axis=1)])
    for row, (layer, trust) in enumerate(zip(DRIVEN, trusts, strict=True)):
        columns.rows(later, "trust")[row] = [trust if owner is not None else 0.0 for owner in owners.get(layer, NOBODY)]
    later[columns.sections["yielded"]] = vector[end + len(DRIVEN) :]
    return later


def _check_range(values: Values, lowest: Values, highest: Values, what: str) -> None:
    if not ((values >= lowest - SLACK) & (values <= highest + SLACK) & np.isfinite(values)).all():
        raise ValueError(f"a {what} of the layers in the snapshot is out of its range; another program wrote it")


def names_driven(snapshot: LayersSnapshot | None) -> frozenset[str]:
    """The channels that layers cannot be played without: those that sources send, and those that hands hold."""
    if snapshot is None:
        return frozenset()
    return frozenset(snapshot.held.channels).union(
        *(driver.names for drivers in snapshot.drivers.values() for driver in _several(drivers))
    )
