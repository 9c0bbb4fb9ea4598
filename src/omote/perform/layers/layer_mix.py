"""Mixes the layers of a character, lowest first, to what is on air."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.perform.frame import Frame, Gaze, Head, Held, LayerStatus, SourceStatus, with_fields
from omote.perform.layers.columns import GAZE, HEAD
from omote.perform.layers.drivers import NOBODY, Owners
from omote.perform.layers.follower import load_kernels
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
from omote.perform.layers.source_frame import CLIP
from omote.perform.panic import EasingToRest, eased

Mix = Mapping[str, float]
Mixes = Mapping[PlayRegion, Mix]

NO_MIXES: Mixes = {}
MOST_SHOWN = 3
LEAST_SHOWN = 0.02
"""Channels by which a layer shows what it does now: the strongest few, none that can hardly be seen."""
_DRIVEN_RUNS = [(slice(0, 2), slice(0, 2)), (slice(2, 6), slice(3, 7))]
"""Rows of `DRIVEN` and of `LAYERS` that follow one another in both."""
_EMOTION = LAYERS.index("emotion")
_MIXED_ROWS = np.array([LAYERS.index(layer) for layer in (*DRIVEN, "hands")], np.int64)
"""Of the driven layers and of the hands above them, among all."""
CLIP_LAYER: LayerName = "playback"
"""The layer that clips play."""
_ABOVE_EMOTION = [LAYERS.index(layer) for layer in DRIVEN if RULES[layer] == "replace" and layer != "gaze"]
UPRIGHT = Head()
STRAIGHT = Gaze()


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
    layers: Layers,
    shares: Values,
    mix: Mix,
    regions: Mixes,
    played: Mixes = NO_MIXES,
) -> Mixed:
    """All layers mixed over the mix of called expressions; shares: how much of each layer shows; regions: of those that
    go their own way; played: the mixes of clips."""
    kept = kept_of_mix(layers, shares)
    face, own = _with_neutral(mix, regions, kept)
    if played:
        face, own = _with_played(face, own, played, _shares_of_clip(layers, shares))
    values = _mixed_values(layers, shares)
    numbers = values.tolist()  # all in range
    channels = {name: value for name, value in zip(layers.columns.names, numbers, strict=False) if value}
    (yaw, pitch, roll) = numbers[HEAD]
    (side, height) = numbers[GAZE]
    return Mixed(
        face, own, channels, with_fields(UPRIGHT, yaw=yaw, pitch=pitch, roll=roll),
        with_fields(STRAIGHT, yaw=side, pitch=height),
    )  # fmt: skip


def with_layers(
    frame: Frame,
    layers: Layers,
    held: Held,
    easing_to_rest: EasingToRest | None,
    played: Mixes = NO_MIXES,
) -> Frame:
    """A frame of calls and hands with all layers in; easing_to_rest: what a panic has left on its way to rest.

    held: what hands hold; played: the mixes of clips, by region.
    """
    shares = influences(layers)
    mixed = mix_layers(layers, shares, frame.expressions, frame.regions, played)
    return with_fields(
        frame,
        expressions=mixed.expressions,
        regions=mixed.regions,
        **vars(eased(Held(mixed.channels, mixed.head, mixed.gaze), easing_to_rest)),
        layers=statuses(layers, shares),
        held=held,
    )


def influences(layers: Layers) -> Values:
    """How much of each layer (8) shows on each part and on the whole face (7): influence and switch, and where a source
    drives it trust and the share that it takes."""
    shares: Values = layers.columns.rows(layers.second, "share").copy()
    trusts = layers.columns.rows(layers.second, "trust")
    for driven, rows in _DRIVEN_RUNS:
        shares[rows] *= trusts[driven]
    for layer, drivers in layers.drivers.items():
        for driver in drivers:
            if driver.share != 1.0 or driver.part_shares:
                where = places_of_source(layers, layer, driver.source)
                by_part = np.array(driver.part_shares)[where] if driver.part_shares else 1.0
                shares[LAYERS.index(layer)][where] *= driver.share * by_part
    return shares


def kept_of_mix(layers: Layers, shares: Values) -> list[float]:
    """How much of the mix of called expressions shows in each play region; neutral takes the rest.

    layers: those of a character; shares: of the layers, of `influences`.
    """
    rows = shares[:, : len(PLAY_REGIONS)].tolist()
    yielded = layers.columns.rows(layers.second, "yielded").tolist()
    kept = [share * (1.0 - part) for share, part in zip(rows[_EMOTION], yielded, strict=True)]
    for row in _ABOVE_EMOTION:
        kept = [share * (1.0 - part) for share, part in zip(kept, rows[row], strict=True)]
    return kept


def statuses(layers: Layers, shares: Values) -> dict[str, LayerStatus]:
    """The layers that differ from what they are at first, or that a source drives; lowest first.

    shares: of the layers, of `influences`.
    """
    by_layer = dict[str, LayerStatus]()
    strongest = _strongest(layers)
    trusts = layers.columns.rows(layers.second, "trust").tolist()
    most = shares[:, :WHOLE].max(axis=1).tolist()
    for row, layer in enumerate(LAYERS):
        setting = layers.settings[layer]
        first = DEFAULT_SETTINGS[layer]
        if layer in layers.drivers or (setting is not first and setting != first):
            trust = trusts[DRIVEN.index(layer)] if layer in layers.drivers else []
            by_layer[layer] = _status(layers, layer, most[row], strongest.get(layer, {}), trust)
    return by_layer


def _status(
    layers: Layers, layer: LayerName, share: float, strongest: Mapping[str, float], trust: Sequence[float]
) -> LayerStatus:
    setting = layers.settings[layer]
    if layer not in layers.drivers:
        return LayerStatus(setting.by_part, setting.on, 0.0 if layer in DRIVEN else 1.0, "", share, {})
    sources = _sources_trusted(layers, layer, trust)
    first = sources[0] if len(sources) == 1 else max(sources, key=lambda source: len(source.parts))
    several = sources if len(sources) > 1 else ()
    return LayerStatus(setting.by_part, setting.on, first.trust, first.source, share, strongest, several)


def sources_of(layers: Layers, layer: LayerName) -> tuple[SourceStatus, ...]:
    """The sources of a layer, the newest first: the parts that each has, and how far it is trusted there.

    layers: those of a character.
    """
    return _sources_trusted(layers, layer, trust_of(layers, layer).tolist())


def _sources_trusted(layers: Layers, layer: LayerName, trust: Sequence[float]) -> tuple[SourceStatus, ...]:
    followed = layers.followed.get(layer, NOBODY)
    owners = layers.owners.get(layer, NOBODY)
    sources = []
    for driver in reversed(layers.drivers[layer]):
        shows = max([trust[place] for place in _places(followed, driver.source)], default=0.0)
        sources.append(SourceStatus(driver.source, shows, _parts(owners, driver.source)))
    return tuple(sources)


@lru_cache(maxsize=256)
def _places(followed: Owners, source: str) -> tuple[int, ...]:
    return tuple(place for place, name in enumerate(followed) if name == source)


@lru_cache(maxsize=256)
def _parts(owners: Owners, source: str) -> tuple[LayerPart, ...]:
    return tuple(part for part, owner in zip(LAYER_PARTS, owners, strict=False) if owner == source)


def _strongest(layers: Layers) -> dict[LayerName, dict[str, float]]:
    """The few channels that each driven layer moves most, of all layers at once."""
    names = layers.columns.names
    streams = layers.columns.rows(layers.second, "streams")
    found = np.empty((len(DRIVEN), min(MOST_SHOWN, len(names))), np.int64)
    values = np.empty(found.shape)
    load_kernels().find_strongest(streams, len(names), found, values)
    return {
        layer: {names[place]: value for place, value in zip(*both, strict=True) if abs(value) >= LEAST_SHOWN}
        for layer, both in zip(DRIVEN, zip(found.tolist(), values.tolist(), strict=True), strict=True)
        if layer in layers.drivers
    }


def _mixed_values(layers: Layers, shares: Values) -> Values:
    """The channels and angles of all layers."""
    columns = layers.columns
    streams, hold, hands = (columns.rows(layers.second, section) for section in ("streams", "hold", "hands"))
    mixed = np.empty(columns.width)
    rules = _rules(tuple(layers.drivers))
    load_kernels().mix_streams(
        streams, shares, columns.parts, rules, _MIXED_ROWS, hold, hands, columns.lowest, columns.highest, mixed
    )
    return mixed


@lru_cache(maxsize=256)
def _rules(drives: tuple[LayerName, ...]) -> NDArray[np.int64]:
    """What each layer that may be driven does, by its number in the kernel, where some are."""
    kernels = load_kernels()
    does = {"offset": kernels.OFFSETS, "replace": kernels.REPLACES, "fill": kernels.FILLS}
    return np.array([does[RULES[layer]] if layer in drives else kernels.SKIPS for layer in DRIVEN], np.int64)


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


def _shares_of_clip(layers: Layers, shares: Values) -> list[float]:
    """How much of the mixes of clips shows in each play region: as much as of their channels."""
    followed = layers.followed.get(CLIP_LAYER, NOBODY)
    row = shares[LAYERS.index(CLIP_LAYER)].tolist()
    return [row[place] if followed[place] == CLIP else 0.0 for place in range(len(PLAY_REGIONS))]


def _with_played(face: Mix, own: Mixes, played: Mixes, shares: Sequence[float]) -> tuple[Mix, Mixes]:
    """The mixes of the face and of its regions, with those of clips in the place of as much neutral as they take."""
    taken = {
        region: _with_clip(own.get(region, face), played[region], share)
        for region, share in zip(PLAY_REGIONS, shares, strict=True)
    }
    rest = taken["rest"]
    return rest, {region: mix for region, mix in taken.items() if mix != rest}


def _with_clip(mix: Mix, played: Mix, share: float) -> Mix:
    if share == 0.0 or share == 1.0:
        return played if share else mix
    mixed = {name: mix.get(name, 0.0) + share * played.get(name, 0.0) for name in {**mix, **played}}
    mixed[NEUTRAL] = mixed.get(NEUTRAL, 0.0) - share
    return {name: mixed[name] for name in sorted(mixed) if mixed[name]}


def _kept(mix: Mix, share: float) -> Mix:
    kept = {name: share * weight for name, weight in mix.items() if share * weight}
    kept[NEUTRAL] = kept.get(NEUTRAL, 0.0) + (1.0 - share)
    return {name: kept[name] for name in sorted(kept) if kept[name]}
