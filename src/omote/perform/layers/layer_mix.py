"""Mixes the layers of a character, lowest first, to what is on air."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.model.space.expression import Expression
from omote.perform.frame import Frame, Gaze, Head, Held, LayerStatus, with_fields
from omote.perform.layers.columns import GAZE, HEAD, Columns
from omote.perform.layers.follower import Values
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, DRIVEN, LAYERS, RULES, LayerName
from omote.perform.layers.layers import Layers
from omote.perform.layers.worn_units import worn_by
from omote.perform.panic import Settling, with_settling_channels, with_settling_gaze, with_settling_head

Mix = Mapping[str, float]
Mixes = Mapping[PlayRegion, Mix]

MOST_SHOWN = 3
LEAST_SHOWN = 0.02
"""Channels by which a layer shows what it does now: the strongest few, none that can hardly be seen."""
_TRUST_OF = [DRIVEN.index(layer) if layer in DRIVEN else len(DRIVEN) for layer in LAYERS]
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
    """How much of each layer (8) shows on each part (6): influence and switch, and where a source drives it trust and
    the share that it takes."""
    trust = [*layers.columns.rows(layers.second, "trust").tolist(), 1.0]
    for layer, driver in layers.drivers.items():
        trust[DRIVEN.index(layer)] *= driver.share
    shares: Values = layers.columns.rows(layers.second, "share") * np.array([[trust[row]] for row in _TRUST_OF])
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
    found = dict[str, LayerStatus]()
    for row, layer in enumerate(LAYERS):
        setting, first = layers.settings[layer], DEFAULT_SETTINGS[layer]
        if layer in layers.drivers or (setting is not first and setting != first):
            found[layer] = _status(layers, layer, max(shares[row].tolist()))
    return found


def _status(layers: Layers, layer: LayerName, share: float) -> LayerStatus:
    setting, driver = layers.settings[layer], layers.drivers.get(layer)
    trust, strongest = 1.0, dict[str, float]()
    if layer in DRIVEN:
        row = DRIVEN.index(layer)
        trust = float(layers.columns.rows(layers.second, "trust")[row])
        values = layers.columns.rows(layers.second, "streams")[row, : len(layers.columns.names)]
        strongest = {} if driver is None else _strongest(layers.columns.names, values)
    return LayerStatus(setting.by_part, setting.on, trust, "" if driver is None else driver.source, share, strongest)


def _strongest(names: tuple[str, ...], values: Values) -> dict[str, float]:
    places, numbers = np.argsort(-np.abs(values), kind="stable")[:MOST_SHOWN].tolist(), values.tolist()
    return {names[place]: numbers[place] for place in places if abs(numbers[place]) >= LEAST_SHOWN}


def _mixed_values(layers: Layers, shares: Values, closed: Values | None) -> Values:
    """The channels and angles of all layers; closed: how much of each the mix wears already."""
    columns = layers.columns
    streams, mixed = columns.rows(layers.second, "streams"), np.zeros(columns.width)
    for row, layer in enumerate(DRIVEN):
        if layer not in layers.drivers:
            continue
        part, value = _by_column(columns, shares, layer), streams[row]
        if RULES[layer] == "replace":
            mixed = (1.0 - part) * mixed + part * value
        elif RULES[layer] == "offset":
            mixed = mixed + part * value
        else:
            open_yet = 1.0 - mixed if closed is None else (1.0 - mixed) * (1.0 - closed)
            mixed = mixed + part * value * open_yet
    part = _by_column(columns, shares, "hands") * columns.rows(layers.second, "hold")
    return _in_range(layers, (1.0 - part) * mixed + part * columns.rows(layers.second, "hands"))


def _by_column(columns: Columns, shares: Values, layer: LayerName) -> Values:
    """How much of a layer shows in each column; of what acts on the whole face the mean of the four regions."""
    parts = shares[LAYERS.index(layer)].tolist()
    parts.append((parts[0] + parts[1] + parts[2] + parts[3]) / 4.0)
    found: Values = np.array(parts)[columns.parts]
    return found


def _in_range(layers: Layers, values: Values) -> Values:
    """The same without what rounding has added beyond the ends of the ranges: means lie within."""
    return np.maximum(np.minimum(values, layers.columns.highest), layers.columns.lowest)


def _closed(layers: Layers, expressions: Mapping[str, Expression], mix: Mix) -> Values | None:
    """How much of each channel of the fills the mix wears already; None where nothing fills."""
    found: Values | None = None
    for layer, driver in layers.drivers.items():
        if RULES[layer] != "fill":
            continue
        found = np.zeros(layers.columns.width) if found is None else found
        for name in driver.names:
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
