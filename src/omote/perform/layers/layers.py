"""The layers of a character: what drives them, what an operator has chosen, and where each follower is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from omote.perform.channels import effective_channels, gaze_channels
from omote.perform.frame import Gaze, Head, Held, with_fields
from omote.perform.layers.columns import GAZE, HEAD, Columns, HasExpressions, make_columns, moved_to
from omote.perform.layers.follower import Values, follow, steps_of
from omote.perform.layers.layer_names import (
    DEFAULT_SETTINGS,
    DRIVEN,
    LAYER_PARTS,
    LAYERS,
    LayerName,
    LayerPart,
    LayerSetting,
)
from omote.perform.layers.source_frame import LOSS_SECONDS, OWN_SOURCES, SPEECH, Driver, SourceFrame, fits, parts_of

UPRIGHT, STRAIGHT = Head(), Gaze()
LET_GO = 0.01
"""A layer that weighs less has let go: another measure no longer shows."""


@dataclass(frozen=True, eq=False)
class Layers:
    """All layers of a character; the vectors hold every follower, in the order of `columns`, and are never changed.

    calm: nothing plays below the hands, so that they are immediate.
    """

    columns: Columns
    goal: Values
    first: Values
    second: Values
    settings: Mapping[LayerName, LayerSetting]
    drivers: Mapping[LayerName, Driver]
    held: Held
    calm: bool = True


def begin(cast: HasExpressions, held: Held) -> Layers:
    """The layers of a character that none has changed and no source drives: what hands hold shows as it did."""
    columns = make_columns(cast, held.channels)
    still = np.zeros(columns.size)
    layers = Layers(columns, still, still, still, DEFAULT_SETTINGS, {}, Held())
    columns.rows(goal := _share_goal(layers), "trust")[:] = 0.0
    return _held_by(cast, replace(layers, goal=goal, first=goal, second=goal), held)


def is_at_rest(layers: Layers) -> bool:
    """Whether a character without layers plays the same."""
    if not layers.calm or layers.drivers or layers.settings != DEFAULT_SETTINGS:
        return False
    yielded = layers.columns.rows(layers.second, "yielded")
    shares = layers.columns.sections["share"]
    return bool(np.array_equal(layers.second[shares], layers.goal[shares]) and not yielded.any())


def set_layer(
    layers: Layers, layer: LayerName, part: LayerPart | None, influence: float | None, on: bool | None
) -> Layers:
    """The layers with another influence of one of them, or with it switched: what shows follows."""
    settings = {**layers.settings, layer: layers.settings[layer].change(part, influence, on)}
    return _with_share_goal(replace(layers, settings=settings))


def drive(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers after a source has sent one of them a frame, which is checked (`check_frame`)."""
    driver = layers.drivers.get(layer)
    if not frame.found:
        return layers  # silence counts from the last frame in which it was found
    if driver is None or driver.leaves or not fits(driver, frame):
        layers = _plugged(cast, layers, layer, frame)
        driver = layers.drivers[layer]
    drivers = layers.drivers if driver.silent == 0.0 else {**layers.drivers, layer: with_fields(driver, silent=0.0)}
    if driver.waits:
        return replace(layers, drivers=drivers)
    if driver.smoothing != frame.smoothing:
        drivers = {**drivers, layer: replace(drivers[layer], smoothing=frame.smoothing)}
    return _streamed(cast, layers, drivers, layer, frame)


def recalibrate(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers where a source begins to send by another measure: its layer lets go first."""
    driver = layers.drivers.get(layer)
    if driver is None or driver.source != source:
        return layers
    return replace(layers, drivers={**layers.drivers, layer: replace(driver, waits=True)})


def leave(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers after a source has gone: its layer lets go."""
    driver = layers.drivers.get(layer)
    if driver is None or driver.source != source:
        return layers
    return replace(layers, drivers={**layers.drivers, layer: replace(driver, leaves=True)})


def switch_off(layers: Layers, kept: Sequence[float]) -> Layers:
    """The layers after a panic: sources are switched off, the character's own motion ends; kept: how much of the mix
    shows in each play region, which stays so until all is still.

    What was on air of them the caller eases to rest.
    """
    sources = {layer: driver for layer, driver in layers.drivers.items() if driver.source not in OWN_SOURCES}
    settings = {layer: replace(each, on=each.on and layer not in sources) for layer, each in layers.settings.items()}
    layers = _with_share_goal(replace(layers, settings=settings, drivers=sources))
    columns, goal = layers.columns, layers.goal.copy()
    for section in ("streams", "hands", "hold", "trust"):
        goal[columns.sections[section]] = 0.0
    goal[columns.sections["yielded"]] = [1.0 - share for share in kept]
    return replace(layers, goal=goal, first=goal, second=goal, held=Held(), calm=True)


def advance(cast: HasExpressions, layers: Layers, held: Held, dt: float, *, still: bool) -> Layers:
    """The layers `dt` seconds later, under what hands hold now. still: False while a panic eases to rest."""
    if held is not layers.held and held != layers.held:
        layers = _held_by(cast, layers, held)
    if still and layers.columns.rows(layers.goal, "yielded").any():
        layers = replace(layers, goal=_with(layers, "yielded", 0.0))
    for step in steps_of(dt):
        layers = _stepped(layers, step)
    if layers.calm:
        return layers
    gone = {layer for layer, driver in layers.drivers.items() if driver.leaves and not _trust(layers, layer)}
    if gone:
        drivers = {layer: driver for layer, driver in layers.drivers.items() if layer not in gone}
        layers = _with_share_goal(replace(layers, drivers=drivers))
    calm = not _plays(layers) and _are_hands_settled(layers)
    return replace(layers, calm=True) if calm else layers


def recast(cast: HasExpressions, layers: Layers) -> Layers:
    """The layers under another cast, which has all that is on air."""
    return _under(layers, make_columns(cast, layers.columns.names))


def _with(layers: Layers, section: str, value: float) -> Values:
    goal = layers.goal.copy()
    goal[layers.columns.sections[section]] = value
    return goal


def _share_goal(layers: Layers) -> Values:
    goal = layers.goal.copy()
    shares = layers.columns.rows(goal, "share")
    for row, layer in enumerate(LAYERS):
        setting, driver = layers.settings[layer], layers.drivers.get(layer)
        parts = LAYER_PARTS if layer not in DRIVEN else () if driver is None else parts_of(driver, layers.columns)
        shares[row] = [setting.influence[part] if setting.on and part in parts else 0.0 for part in LAYER_PARTS]
    return goal


def _with_share_goal(layers: Layers) -> Layers:
    return _woken(replace(layers, goal=_share_goal(layers)))


def _woken(layers: Layers) -> Layers:
    """What goes anywhere is no longer calm; the shares of layers that nothing drives yet are there at once."""
    shares = layers.columns.rows(layers.goal, "share")
    first, second = layers.first.copy(), layers.second.copy()
    for row, layer in enumerate(LAYERS):
        if layer in DRIVEN and not _trust(layers, layer):
            layers.columns.rows(first, "share")[row] = layers.columns.rows(second, "share")[row] = shares[row]
    return replace(layers, first=first, second=second, calm=layers.calm and not _plays(layers))


def _trust(layers: Layers, layer: LayerName) -> float:
    return float(layers.columns.rows(layers.second, "trust")[DRIVEN.index(layer)])


def _plays(layers: Layers) -> bool:
    """Whether anything below the hands shows, or is about to."""
    settings, columns = layers.settings, layers.columns
    if any(each.is_trusted and settings[layer].plays for layer, each in layers.drivers.items()):
        return True
    trust = columns.rows(layers.second, "trust") + columns.rows(layers.goal, "trust")
    rows = [LAYERS.index(layer) for layer in DRIVEN]
    shares = (columns.rows(layers.second, "share") + columns.rows(layers.goal, "share"))[rows]
    return bool(((shares != 0.0).any(axis=1) & (trust != 0.0)).any())


def _are_hands_settled(layers: Layers) -> bool:
    begin, end = layers.columns.sections["hands"].start, layers.columns.sections["hold"].stop
    where = slice(begin, end)
    return np.array_equal(layers.first[where], layers.goal[where]) and np.array_equal(
        layers.second[where], layers.goal[where]
    )


def _stepped(layers: Layers, dt: float) -> Layers:
    drivers = {layer: _later(layers, layer, driver, dt) for layer, driver in layers.drivers.items()}
    goal, columns = layers.goal, layers.columns
    wanted = [float(layer in drivers and drivers[layer].is_trusted) for layer in DRIVEN]
    if columns.rows(goal, "trust").tolist() != wanted:
        goal = goal.copy()
        columns.rows(goal, "trust")[:] = wanted
    settles = not any(driver.is_trusted for driver in drivers.values())  # while a source plays nothing comes to rest
    quick = [DRIVEN.index(layer) for layer, driver in drivers.items() if driver.is_quick]
    slow = {DRIVEN.index(layer): driver.smoothing for layer, driver in drivers.items()}
    rate, haste = columns.stream_rates(slow, quick)
    first, second = follow(layers.first, layers.second, goal, rate, haste, dt, settles=settles)
    return with_fields(layers, goal=goal, first=first, second=second, drivers=drivers)


def _later(layers: Layers, layer: LayerName, driver: Driver, dt: float) -> Driver:
    """What drives a layer, `dt` seconds later."""
    silent, waits = min(driver.silent + dt, LOSS_SECONDS), driver.waits and _trust(layers, layer) >= LET_GO
    return with_fields(driver, silent=silent, waits=waits)


def _plugged(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where something else begins to drive one: where the last has not let go yet it waits."""
    layers = _with_names(cast, layers, frame.names)
    before = layers.drivers.get(layer)
    other = before is not None and (before.source, before.names) != (frame.source, frame.names)
    shows = frame.source != SPEECH and _trust(layers, layer) >= LET_GO
    waits = shows and (other or (before is not None and before.waits))
    turns = frame.head is not None, frame.gaze is not None
    driver = Driver(frame.source, frame.names, *turns, frame.parts, waits=waits)
    return _with_share_goal(replace(layers, drivers={**layers.drivers, layer: driver}))


def _streamed(
    cast: HasExpressions, layers: Layers, drivers: Mapping[LayerName, Driver], layer: LayerName, frame: SourceFrame
) -> Layers:
    columns, row, goal = layers.columns, DRIVEN.index(layer), layers.goal.copy()
    stream = columns.rows(goal, "streams")[row]
    stream[columns.of_face] = 0.0
    stream[columns.places(frame.names)] = frame.values
    if frame.head is not None:
        stream[HEAD] = frame.head.yaw, frame.head.pitch, frame.head.roll
    if frame.gaze is not None:
        stream[GAZE] = frame.gaze.yaw, frame.gaze.pitch
        turned = gaze_channels(cast.expressions, frame.gaze)
        stream[columns.places(columns.eyes)] = [turned.get(unit, 0.0) for unit in columns.eyes]
    columns.rows(goal, "trust")[row] = 1.0
    later = with_fields(layers, goal=goal, drivers=drivers, calm=False)
    return later if _trust(later, layer) and not frame.direct else _from_there(later, row)


def _from_there(layers: Layers, row: int) -> Layers:
    """The stream of a layer that does not show, or that is smooth already, is where it goes."""
    columns, first, second = layers.columns, layers.first.copy(), layers.second.copy()
    stream = columns.rows(layers.goal, "streams")[row]
    columns.rows(first, "streams")[row] = columns.rows(second, "streams")[row] = stream
    return replace(layers, first=first, second=second)


def _held_by(cast: HasExpressions, layers: Layers, held: Held) -> Layers:
    """The layers under what hands hold now; what a hand lets go keeps its value while the hold goes."""
    layers = _with_names(cast, layers, held.channels)
    columns, goal = layers.columns, layers.goal.copy()
    hands, hold = columns.sections["hands"], columns.sections["hold"]
    holds, wanted = _hold_of(cast, columns, held)
    goal[hold] = holds
    np.copyto(goal[hands], wanted, where=holds > 0.0)
    first, second = layers.first.copy(), layers.second.copy()
    free = layers.calm | ((first[hold] == 0.0) & (second[hold] == 0.0))
    for vector in (first, second):
        np.copyto(vector[hands], goal[hands], where=free)
        if layers.calm:
            vector[hold] = holds
    return with_fields(layers, goal=goal, first=first, second=second, held=held)


def _hold_of(cast: HasExpressions, columns: Columns, held: Held) -> tuple[Values, Values]:
    holds, wanted = np.zeros(columns.width), np.zeros(columns.width)
    channels = effective_channels(cast.expressions, held.channels, held.gaze)
    places = columns.places(tuple(channels))
    holds[places], wanted[places] = 1.0, list(channels.values())
    if held.head != UPRIGHT:
        holds[HEAD], wanted[HEAD] = 1.0, (held.head.yaw, held.head.pitch, held.head.roll)
    if held.gaze != STRAIGHT:
        holds[columns.places(columns.eyes)] = 1.0
        holds[GAZE], wanted[GAZE] = 1.0, (held.gaze.yaw, held.gaze.pitch)
    return holds, wanted


def _with_names(cast: HasExpressions, layers: Layers, names: Iterable[str]) -> Layers:
    if layers.columns.index.keys() >= set(names):
        return layers
    return _under(layers, make_columns(cast, (*layers.columns.names, *names)))


def _under(layers: Layers, columns: Columns) -> Layers:
    goal, first, second = (
        moved_to(each, layers.columns, columns) for each in (layers.goal, layers.first, layers.second)
    )
    return replace(layers, columns=columns, goal=goal, first=first, second=second)
