"""The state of a character's layers: every follower in one vector, what an operator has chosen, who drives what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import Held
from omote.perform.layers.columns import Columns, HasExpressions, make_columns, moved_to
from omote.perform.layers.drivers import NOBODY, Driver, Owners
from omote.perform.layers.layer_names import DRIVEN, LAYER_PARTS, LAYERS, WHOLE, LayerName, LayerSetting

UNTRUSTED = np.zeros(len(NOBODY)).tobytes()


@dataclass(frozen=True, eq=False)
class Layers:
    """All layers of a character; the vectors hold every follower, in the order of `columns`, and are never changed.

    drivers: the sources of each layer. owners: who has each part of it now; followed: whose frames each part shows,
    which is another as long as one lets go. calm: nothing plays below the hands, so that they are immediate. back: a
    vector of where sources were seen last that have come back elsewhere; None where none is on its way back.
    """

    columns: Columns
    goal: Values
    first: Values
    second: Values
    settings: Mapping[LayerName, LayerSetting]
    drivers: Mapping[LayerName, tuple[Driver, ...]]
    held: Held
    calm: bool = True
    owners: Mapping[LayerName, Owners] = field(default_factory=dict)
    followed: Mapping[LayerName, Owners] = field(default_factory=dict)
    back: Values | None = None


def trust_of(layers: Layers, layer: LayerName) -> Values:
    """How far each part of a layer, and what acts on the whole face, is trusted now. layers: those of a character."""
    return np.asarray(layers.columns.rows(layers.second, "trust")[DRIVEN.index(layer)])


def columns_of_source(layers: Layers, layer: LayerName, source: str) -> NDArray[np.bool_]:
    """The columns of a layer that show the frames of a source. layers: those of a character."""
    return layers.columns.in_parts(_switches(layers.followed.get(layer, NOBODY), source))


def places_of_source(layers: Layers, layer: LayerName, source: str) -> NDArray[np.bool_]:
    """The parts of a layer, and what acts on the whole face (7), that show the frames of a source.

    layers: those of a character.
    """
    return _places_in(layers.followed.get(layer, NOBODY), source)


@lru_cache(maxsize=256)
def _switches(followed: Owners, source: str) -> tuple[bool, ...]:
    return tuple(shown == source for shown in followed)


@lru_cache(maxsize=256)
def _places_in(followed: Owners, source: str) -> NDArray[np.bool_]:
    """The same for all that have the same order of sources: found once, never changed."""
    places = np.array([shown == source for shown in followed])
    places.flags.writeable = False
    return places


def trust_goal(layers: Layers) -> bytes:
    """Where the trust of each part of each driven layer goes, as float64: to 1 where it shows whom it belongs to."""
    return b"".join(
        _trust_goal(layers.owners.get(layer, NOBODY), layers.followed.get(layer, NOBODY))
        if layer in layers.drivers
        else UNTRUSTED
        for layer in DRIVEN
    )


@lru_cache(maxsize=256)
def _trust_goal(owners: Owners, followed: Owners) -> bytes:
    pairs = zip(owners, followed, strict=True)
    return np.array([float(owner is not None and owner == shown) for owner, shown in pairs]).tobytes()


def share_goal(layers: Layers) -> Values:
    """All goals with those of the shares as they are set: of what acts on the whole face the mean of its regions."""
    goal = layers.goal.copy()
    shares = layers.columns.rows(goal, "share")
    for row, layer in enumerate(LAYERS):
        setting = layers.settings[layer]
        parts = [setting.influence[part] if setting.on else 0.0 for part in LAYER_PARTS]
        followed = layers.followed.get(layer, NOBODY)
        same = [layer not in DRIVEN or followed[place] == followed[WHOLE] for place in range(len(PLAY_REGIONS))]
        whole = [part if of_it else 0.0 for part, of_it in zip(parts[: len(PLAY_REGIONS)], same, strict=True)]
        shares[row] = [*parts, (whole[0] + whole[1] + whole[2] + whole[3]) / len(PLAY_REGIONS)]
    return goal


def eased_goal(layers: Layers) -> Values:
    """All goals, those of sources on their way back between where they were seen last and where they are."""
    if layers.back is None:
        return layers.goal
    returning = [(layer, driver) for layer, drivers in layers.drivers.items() for driver in drivers if driver.away]
    if not returning:
        return layers.goal
    goal = layers.goal.copy()
    for layer, driver in returning:
        own = columns_of_source(layers, layer, driver.source)
        streams = layers.columns.rows(goal, "streams")[DRIVEN.index(layer)]
        seen = layers.columns.rows(layers.back, "streams")[DRIVEN.index(layer)]
        streams[own] += driver.way_left * (seen[own] - streams[own])
    return goal


def with_share_goal(layers: Layers) -> Layers:
    """The layers on their way to the shares that are set."""
    return _woken(replace(layers, goal=share_goal(layers)))


def plays(layers: Layers) -> bool:
    """Whether anything below the hands shows, or is about to."""
    settings = layers.settings
    columns = layers.columns
    if any(
        settings[layer].plays and any(driver.is_trusted for driver in drivers)
        for layer, drivers in layers.drivers.items()
    ):
        return True
    trust = columns.rows(layers.second, "trust") + columns.rows(layers.goal, "trust")
    rows = [LAYERS.index(layer) for layer in DRIVEN]
    shares = (columns.rows(layers.second, "share") + columns.rows(layers.goal, "share"))[rows]
    return bool(((shares != 0.0) & (trust != 0.0)).any())


def with_names(cast: HasExpressions, layers: Layers, names: Iterable[str]) -> Layers:
    """The layers with columns for these channels too. cast: whose expressions there are; names: of the channels."""
    if layers.columns.index.keys() >= set(names):
        return layers
    return under(layers, make_columns(cast, (*layers.columns.names, *names)))


def under(layers: Layers, columns: Columns) -> Layers:
    """The layers under other columns: every follower keeps where it is."""
    goal, first, second = (
        moved_to(vector, layers.columns, columns) for vector in (layers.goal, layers.first, layers.second)
    )
    back = None if layers.back is None else moved_to(layers.back, layers.columns, columns)
    return replace(layers, columns=columns, goal=goal, first=first, second=second, back=back)


def _woken(layers: Layers) -> Layers:
    """What goes anywhere is no longer calm; shares of parts that nothing plays yet are there at once."""
    shares = layers.columns.rows(layers.goal, "share")
    first = layers.first.copy()
    second = layers.second.copy()
    for row, layer in enumerate(LAYERS):
        if layer in DRIVEN:
            unseen = trust_of(layers, layer) == 0.0
            for vector in (first, second):
                np.copyto(layers.columns.rows(vector, "share")[row], shares[row], where=unseen)
    return replace(layers, first=first, second=second, calm=layers.calm and not plays(layers))
