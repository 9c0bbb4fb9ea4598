"""Mixes the layers of a character, lowest first, to what is on air."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.model.space.expression import Expression
from omote.perform.frame import Frame, Gaze, Head, Held, LayerStatus, SourceStatus, with_fields
from omote.perform.layers.columns import GAZE, HEAD
from omote.perform.layers.drivers import NOBODY, Owners
from omote.perform.layers.follower import Values
from omote.perform.layers.layer_names import (
    DEFAULT_SETTINGS,
    DRIVEN,
    LAYER_PARTS,
    LAYERS,
    RULES,
    WHOLE,
    LayerName,
    LayerPart,
)
from omote.perform.layers.layer_vectors import Layers, places_of_source, trust_of
from omote.perform.layers.worn_units import worn_by
from omote.perform.panic import Settling, with_settling_channels, with_settling_gaze, with_settling_head

Mix = Mapping[str, float]
Mixes = Mapping[PlayRegion, Mix]

MOST_SHOWN = 3
LEAST_SHOWN = 0.02
"""Channels by which a layer shows what it does now: the strongest few, none that can hardly be seen."""
_DRIVEN_ROWS = [LAYERS.index(layer) for layer in DRIVEN]
_EMOTION = LAYERS.index("emotion")
_ABOVE_EMOTION = [LAYERS.index(layer) for layer in DRIVEN if RULES[layer] == "replace" and layer != "gaze"]
UPRIGHT, STRAIGHT = Head(), Gaze()


@dataclass(frozen=True)
class Mixed:
    """What all layers make: the mix of the face and of the regions that show another, channels with what the gaze makes
    of them, head and gaze."""

    expressions: Mix
    regions: Mixes
    channels: Mapping[str, float]
    head: Head
    gaze: Gaze


def mix_layers(
    layers: Layers, shares: Values, expressions: Mapping[str, Expression], mix: Mix, regions: Mixes
) -> Mixed:
    """All layers mixed over the mix of called expressions; shares: how much of each layer shows; regions: of those that
    go their own way."""
    kept = kept_of_mix(layers, shares)
    face, own = _with_neutral(mix, regions, kept)
    values = _mixed_values(layers, shares, _closed(layers, expressions, own.get("eyes", face)))
    numbers = values.tolist()  # all in range
    channels = {name: value for name, value in zip(layers.columns.names, numbers, strict=False) if value}
    (yaw, pitch, roll), (side, height) = numbers[HEAD], numbers[GAZE]
    return Mixed(
        face, own, channels, with_fields(UPRIGHT, yaw=yaw, pitch=pitch, roll=roll),
        with_fields(STRAIGHT, yaw=side, pitch=height),
    )  # fmt: skip


def with_layers(
    frame: Frame, layers: Layers, expressions: Mapping[str, Expression], held: Held, settling: Settling | None
) -> Frame:
    """A frame of calls and hands with all layers in; settling: what a panic has left on its way to rest."""
    shares = influences(layers)
    mixed = mix_layers(layers, shares, expressions, frame.expressions, frame.regions)
    return with_fields(
        frame,
        expressions=mixed.expressions,
        regions=mixed.regions,
        channels=with_settling_channels(mixed.channels, settling),
        head=with_settling_head(mixed.head, settling),
        gaze=with_settling_gaze(mixed.gaze, settling),
        layers=statuses(layers, shares),
        held=held,
    )


def influences(layers: Layers) -> Values:
    """How much of each layer (8) shows on each part and on the whole face (7): influence and switch, and where a source
    drives it trust and the share that it takes."""
    shares: Values = layers.columns.rows(layers.second, "share").copy()
    shares[_DRIVEN_ROWS] *= layers.columns.rows(layers.second, "trust")
    for layer, drivers in layers.drivers.items():
        for driver in drivers:
            if driver.share != 1.0:
                shares[LAYERS.index(layer)][places_of_source(layers, layer, driver.source)] *= driver.share
    return shares


def kept_of_mix(layers: Layers, shares: Values) -> list[float]:
    """How much of the mix of called expressions shows in each play region; neutral takes the rest."""
    rows, yielded = shares[:, : len(PLAY_REGIONS)].tolist(), layers.columns.rows(layers.second, "yielded").tolist()
    kept = [share * (1.0 - part) for share, part in zip(rows[_EMOTION], yielded, strict=True)]
    for row in _ABOVE_EMOTION:
        kept = [share * (1.0 - part) for share, part in zip(kept, rows[row], strict=True)]
    return kept


def statuses(layers: Layers, shares: Values) -> dict[str, LayerStatus]:
    """The layers that differ from what they are at first, or that a source drives; lowest first."""
    found, strongest, most = dict[str, LayerStatus](), _strongest(layers), shares[:, :WHOLE].max(axis=1).tolist()
    for row, layer in enumerate(LAYERS):
        setting, first = layers.settings[layer], DEFAULT_SETTINGS[layer]
        if layer in layers.drivers or (setting is not first and setting != first):
            found[layer] = _status(layers, layer, most[row], strongest.get(layer, {}))
    return found


def _status(layers: Layers, layer: LayerName, share: float, strongest: Mapping[str, float]) -> LayerStatus:
    setting = layers.settings[layer]
    if layer not in layers.drivers:
        return LayerStatus(setting.by_part, setting.on, 0.0 if layer in DRIVEN else 1.0, "", share, {})
    sources = sources_of(layers, layer)
    first = max(sources, key=lambda each: len(each.parts))
    told = sources if len(sources) > 1 else ()
    return LayerStatus(setting.by_part, setting.on, first.trust, first.source, share, strongest, told)


def sources_of(layers: Layers, layer: LayerName) -> tuple[SourceStatus, ...]:
    """The sources of a layer, the newest first: the parts that each has, and how far it is trusted there."""
    followed, owners = layers.followed.get(layer, NOBODY), layers.owners.get(layer, NOBODY)
    trust = trust_of(layers, layer).tolist()
    found = []
    for driver in reversed(layers.drivers[layer]):
        shows = max([trust[place] for place in _places(followed, driver.source)], default=0.0)
        found.append(SourceStatus(driver.source, shows, _parts(owners, driver.source)))
    return tuple(found)


@lru_cache(maxsize=256)
def _places(followed: Owners, source: str) -> tuple[int, ...]:
    return tuple(place for place, name in enumerate(followed) if name == source)


@lru_cache(maxsize=256)
def _parts(owners: Owners, source: str) -> tuple[LayerPart, ...]:
    return tuple(part for part, owner in zip(LAYER_PARTS, owners, strict=False) if owner == source)


def _strongest(layers: Layers) -> dict[LayerName, dict[str, float]]:
    """The few channels that each driven layer moves most, of all layers at once."""
    names = layers.columns.names
    streams = layers.columns.rows(layers.second, "streams")[:, : len(names)]
    order = np.argsort(-np.abs(streams), axis=1, kind="stable")[:, :MOST_SHOWN]
    values, places = np.take_along_axis(streams, order, axis=1).tolist(), order.tolist()
    return {
        layer: {names[place]: value for place, value in zip(*both, strict=True) if abs(value) >= LEAST_SHOWN}
        for layer, both in zip(DRIVEN, zip(places, values, strict=True), strict=True)
        if layer in layers.drivers
    }


def _mixed_values(layers: Layers, shares: Values, closed: Values | None) -> Values:
    """The channels and angles of all layers; closed: how much of each the mix wears already."""
    columns = layers.columns
    streams, mixed = columns.rows(layers.second, "streams"), np.zeros(columns.width)
    for row, layer in enumerate(DRIVEN):
        if layer not in layers.drivers:
            continue
        part, value = shares[LAYERS.index(layer)][columns.parts], streams[row]
        if RULES[layer] == "replace":
            mixed = (1.0 - part) * mixed + part * value
        elif RULES[layer] == "offset":
            mixed = mixed + part * value
        else:
            open_yet = 1.0 - mixed if closed is None else (1.0 - mixed) * (1.0 - closed)
            mixed = mixed + part * value * open_yet
    part = shares[LAYERS.index("hands")][columns.parts] * columns.rows(layers.second, "hold")
    return _in_range(layers, (1.0 - part) * mixed + part * columns.rows(layers.second, "hands"))


def _in_range(layers: Layers, values: Values) -> Values:
    """The same without what rounding has added beyond the ends of the ranges: means lie within."""
    return np.maximum(np.minimum(values, layers.columns.highest), layers.columns.lowest)


def _closed(layers: Layers, expressions: Mapping[str, Expression], mix: Mix) -> Values | None:
    """How much of each channel of the fills the mix wears already; None where nothing fills."""
    found: Values | None = None
    for layer, drivers in layers.drivers.items():
        if RULES[layer] != "fill":
            continue
        found = np.zeros(layers.columns.width) if found is None else found
        for name in {name for driver in drivers for name in driver.names}:
            found[layers.columns.index[name]] = worn_by(expressions[name], mix, expressions)
    return found


def _with_neutral(mix: Mix, regions: Mixes, kept: Sequence[float]) -> tuple[Mix, Mixes]:
    """The mixes of the face and of its regions, each as much as is kept of it; neutral takes the rest."""
    if all(share == 1.0 for share in kept):
        return mix, regions
    shares = dict(zip(PLAY_REGIONS, kept, strict=True))
    face = shares["rest"]
    own = {
        region: _kept(regions.get(region, mix), share)
        for region, share in shares.items()
        if region in regions or share != face
    }
    return _kept(mix, face), own


def _kept(mix: Mix, share: float) -> Mix:
    found = {name: share * weight for name, weight in mix.items() if share * weight}
    found[NEUTRAL] = found.get(NEUTRAL, 0.0) + (1.0 - share)
    return {name: found[name] for name in sorted(found) if found[name]}
