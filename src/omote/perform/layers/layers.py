"""The layers of a character: driving, setting, holding, time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.perform.channels import gaze_channels
from omote.perform.frame import Held, with_fields
from omote.perform.layers.columns import GAZE, HEAD, Columns, HasExpressions, Pace, make_columns
from omote.perform.layers.drivers import (
    NOBODY,
    STEADY_SECONDS,
    Driver,
    Owners,
    advance_driver,
    driver_of,
    find_driver,
    fits,
    owners_of,
    replace_driver,
    with_driver,
)
from omote.perform.layers.follower import Values, follow, steps_of
from omote.perform.layers.held_columns import are_hands_settled, hold_by
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, DRIVEN, LayerName, LayerPart
from omote.perform.layers.layer_vectors import (
    Layers,
    columns_of_source,
    places_of_source,
    plays,
    share_goal,
    trust_goal,
    trust_of,
    under,
    with_names,
    with_share_goal,
)
from omote.perform.layers.source_frame import OWN_SOURCES, SourceFrame

LET_GO = 0.01
"""A part of a layer that weighs less has let go: another measure, or another source, no longer shows."""
FADED = 1e-6
"""A part that weighs less has faded out: who has left is forgotten, also while another source plays."""


def begin(cast: HasExpressions, held: Held) -> Layers:
    """The layers of a character that none has changed and no source drives: what hands hold shows as it did."""
    columns = make_columns(cast, held.channels)
    still = np.zeros(columns.size)
    layers = Layers(columns, still, still, still, DEFAULT_SETTINGS, {}, Held())
    goal = share_goal(layers)
    return hold_by(cast, replace(layers, goal=goal, first=goal, second=goal), held)


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
    return with_share_goal(replace(layers, settings=settings))


def drive(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers after a source has sent one of them a frame, which is checked (`check_frame`)."""
    if not frame.found:
        return layers  # silence counts from the last frame in which it was found
    driver = find_driver(layers.drivers.get(layer, ()), frame.source)
    if driver is None or driver.leaves or not fits(driver, frame):
        layers = _plugged(cast, layers, layer, frame)
    elif driver.silent or (driver.smoothing, driver.share) != (frame.smoothing, frame.share):
        heard = with_fields(driver, silent=0.0, smoothing=frame.smoothing, share=frame.share)
        layers = _with_drivers(layers, layer, replace_driver(layers.drivers[layer], heard))
        if not driver.is_trusted:
            layers = _owned(layers, layer)
    return _streamed(cast, layers, layer, frame)


def recalibrate(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers where a source begins to send by another measure: what it plays of a layer lets go first."""
    followed = layers.followed.get(layer, NOBODY)
    if find_driver(layers.drivers.get(layer, ()), source) is None:
        return layers
    return _with_followed(layers, layer, tuple(None if each == source else each for each in followed))


def leave(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers after a source has gone: what it plays of a layer lets go."""
    drivers = layers.drivers.get(layer, ())
    driver = find_driver(drivers, source)
    if driver is None:
        return layers
    return _owned(_with_drivers(layers, layer, replace_driver(drivers, replace(driver, leaves=True))), layer)


def switch_off(layers: Layers, kept: Sequence[float]) -> Layers:
    """The layers after a panic: sources are switched off, the character's own motion ends; kept: how much of the mix
    shows in each play region, which stays so until all is still.

    What was on air of them the caller eases to rest.
    """
    others = ((layer, [one for one in each if one.source not in OWN_SOURCES]) for layer, each in layers.drivers.items())
    sources = {layer: tuple(each) for layer, each in others if each}
    settings = {layer: replace(each, on=each.on and layer not in sources) for layer, each in layers.settings.items()}
    layers = replace(layers, settings=settings, drivers=sources, owners=_known(layers.owners, sources))
    layers = with_share_goal(replace(layers, followed=_known(layers.followed, sources)))
    columns, goal = layers.columns, layers.goal.copy()
    for section in ("streams", "hands", "hold", "trust"):
        goal[columns.sections[section]] = 0.0
    goal[columns.sections["yielded"]] = [1.0 - share for share in kept]
    return replace(layers, goal=goal, first=goal, second=goal, held=Held(), calm=True)


def advance(cast: HasExpressions, layers: Layers, held: Held, dt: float, *, still: bool) -> Layers:
    """The layers `dt` seconds later, under what hands hold now. still: False while a panic eases to rest."""
    if held is not layers.held and held != layers.held:
        layers = hold_by(cast, layers, held)
    if still and layers.columns.rows(layers.goal, "yielded").any():
        goal = layers.goal.copy()
        goal[layers.columns.sections["yielded"]] = 0.0
        layers = replace(layers, goal=goal)
    for step in steps_of(dt):
        layers = _stepped(layers, step)
    if layers.calm:
        return layers
    layers = _without_gone(layers)
    calm = not plays(layers) and are_hands_settled(layers)
    return replace(layers, calm=True) if calm else layers


def recast(cast: HasExpressions, layers: Layers) -> Layers:
    """The layers under another cast, which has all that is on air."""
    later = under(layers, make_columns(cast, layers.columns.names))
    owners = {layer: owners_of(each, later.columns) for layer, each in later.drivers.items()}
    return replace(later, owners=owners)


def _with_drivers(layers: Layers, layer: LayerName, drivers: tuple[Driver, ...]) -> Layers:
    return with_fields(layers, drivers={**layers.drivers, layer: drivers})


def _with_followed(layers: Layers, layer: LayerName, followed: Owners) -> Layers:
    return with_share_goal(replace(layers, followed={**layers.followed, layer: followed}))


def _known(
    names: Mapping[LayerName, Owners], drivers: Mapping[LayerName, tuple[Driver, ...]]
) -> dict[LayerName, Owners]:
    """The same without sources that drive no more."""
    found = dict[LayerName, Owners]()
    for layer, each in drivers.items():
        sources = {driver.source for driver in each}
        found[layer] = tuple(name if name in sources else None for name in names.get(layer, NOBODY))
    return found


def _owned(layers: Layers, layer: LayerName) -> Layers:
    """The layers where who has each part of one is decided anew; who comes is followed where the last has let go."""
    owners = owners_of(layers.drivers[layer], layers.columns)
    layers = with_fields(layers, owners={**layers.owners, layer: owners})
    followed = layers.followed.get(layer, NOBODY)
    low = (trust_of(layers, layer) < LET_GO).tolist()
    later = tuple(
        owner if owner is not None and free else other for owner, other, free in zip(owners, followed, low, strict=True)
    )
    return layers if later == followed else _with_followed(layers, layer, later)


def _waits(layers: Layers, layer: LayerName) -> bool:
    """Whether a part of a layer shows another than it belongs to."""
    owners, followed = layers.owners.get(layer, NOBODY), layers.followed.get(layer, NOBODY)
    return owners != followed and any(
        one is not None and one != other for one, other in zip(owners, followed, strict=True)
    )


def _stepped(layers: Layers, dt: float) -> Layers:
    before = layers.drivers
    drivers = {layer: tuple(advance_driver(one, dt, layer) for one in each) for layer, each in before.items()}
    layers = with_fields(layers, drivers=drivers)
    for layer, each in drivers.items():
        lost = any(one.is_trusted != other.is_trusted for one, other in zip(each, before[layer], strict=True))
        if lost or _waits(layers, layer):
            layers = _owned(layers, layer)
    goal, columns = layers.goal, layers.columns
    wanted = trust_goal(layers)
    if list(map(tuple, columns.rows(goal, "trust").tolist())) != wanted:
        goal = goal.copy()
        columns.rows(goal, "trust")[:] = wanted
    settles = not any(one.is_trusted for each in drivers.values() for one in each)  # nothing rests while one plays
    rate, haste = columns.stream_rates(_paces(layers))
    first, second = follow(layers.first, layers.second, goal, rate, haste, dt, settles=settles)
    return with_fields(layers, goal=goal, first=first, second=second)


def _paces(layers: Layers) -> list[Pace]:
    """How sources are followed that are smoothed otherwise than their layers, or have only just come."""
    return [
        Pace(DRIVEN.index(layer), columns_of_source(layers, layer, one.source), one.smoothing,
             one.steady / STEADY_SECONDS)
        for layer, each in layers.drivers.items()
        for one in each
        if one.smoothing or one.steady < STEADY_SECONDS
    ]  # fmt: skip


def _without_gone(layers: Layers) -> Layers:
    """The layers without the sources that have gone and of which nothing shows any more."""
    gone = {
        (layer, one.source)
        for layer, each in layers.drivers.items()
        for one in each
        if one.leaves and not _shows(layers, layer, one.source)
    }
    if not gone:
        return layers
    drivers = {
        layer: tuple(one for one in each if (layer, one.source) not in gone) for layer, each in layers.drivers.items()
    }
    drivers = {layer: each for layer, each in drivers.items() if each}
    owners, followed = _known(layers.owners, drivers), _known(layers.followed, drivers)
    return with_share_goal(replace(layers, drivers=drivers, owners=owners, followed=followed))


def _shows(layers: Layers, layer: LayerName, source: str) -> bool:
    followed, trust = layers.followed.get(layer, NOBODY), trust_of(layers, layer).tolist()
    return any(each == source and part >= FADED for each, part in zip(followed, trust, strict=True))


def _plugged(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where something begins to drive one, or to drive it by other channels, which lets go first."""
    layers = with_names(cast, layers, frame.names)
    drivers = layers.drivers.get(layer, ())
    before = find_driver(drivers, frame.source)
    layers = _with_drivers(layers, layer, with_driver(drivers, driver_of(frame)))
    if before is not None and before.names != frame.names:
        layers = recalibrate(layers, layer, frame.source)
    return _owned(layers, layer)


def _streamed(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where a frame is the goal of the parts that show its source; what these do not send is at rest."""
    columns, row, goal = layers.columns, DRIVEN.index(layer), layers.goal.copy()
    own, followed = columns_of_source(layers, layer, frame.source), layers.followed.get(layer, NOBODY)
    if frame.source not in followed:
        return layers
    write_frame(cast, columns, columns.rows(goal, "streams")[row], own, frame)
    later = with_fields(layers, goal=goal, calm=False)
    if frame.share == 0.0:  # nothing of it shows, so it can be trusted at once: a first word is whole
        later = _trusted(later, layer, frame.source)
    trust = trust_of(later, layer).tolist()
    unseen = tuple(
        name == frame.source and (frame.direct or part == 0.0) for name, part in zip(followed, trust, strict=True)
    )
    return _from_there(later, row, columns.in_parts(unseen)) if any(unseen) else later


def _from_there(layers: Layers, row: int, where: NDArray[np.bool_]) -> Layers:
    """Columns of a layer that do not show, or that are smooth already, are where they go."""
    columns, first, second = layers.columns, layers.first.copy(), layers.second.copy()
    stream = columns.rows(layers.goal, "streams")[row]
    for vector in (first, second):
        np.copyto(columns.rows(vector, "streams")[row], stream, where=where)
    return with_fields(layers, first=first, second=second)


def _trusted(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers where what shows a source is trusted from now on."""
    where, first, second = places_of_source(layers, layer, source), layers.first.copy(), layers.second.copy()
    for vector in (first, second):
        layers.columns.rows(vector, "trust")[DRIVEN.index(layer), where] = 1.0
    return with_fields(layers, first=first, second=second)


def write_frame(
    cast: HasExpressions, columns: Columns, stream: Values, own: NDArray[np.bool_], frame: SourceFrame
) -> None:
    """Writes a frame into those columns of a layer that show its source; what it does not send there is at rest."""
    places = columns.places(frame.names)
    stream[own] = 0.0
    if len(frame.names):
        stream[places] = np.where(own[places], frame.values, stream[places])
    if frame.head is not None and own[HEAD].all():
        stream[HEAD] = frame.head.yaw, frame.head.pitch, frame.head.roll
    if frame.gaze is not None and own[GAZE].all():
        stream[GAZE] = frame.gaze.yaw, frame.gaze.pitch
        turned = gaze_channels(cast.expressions, frame.gaze, frame.vergence)
        stream[columns.places(columns.eyes)] = [turned.get(unit, 0.0) for unit in columns.eyes]
