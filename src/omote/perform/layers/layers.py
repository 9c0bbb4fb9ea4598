"""The layers of a character: driving, setting, holding, time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.channels import effective_channels, gaze_channels
from omote.perform.frame import Gaze, Head, Held, with_fields
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
    way_back,
    with_driver,
)
from omote.perform.layers.follower import follow, load_kernels, steps_of
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, DRIVEN, LayerName, LayerPart
from omote.perform.layers.layer_vectors import (
    Layers,
    columns_of_source,
    eased_goal,
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

UPRIGHT = Head()
STRAIGHT = Gaze()


def hold_by(cast: HasExpressions, layers: Layers, held: Held, *, on_way: bool = False) -> Layers:
    """The layers under what hands hold now; what a hand lets go keeps its value while the hold goes.

    cast: whose expressions there are; held: what hands hold; on_way: it has moved smoothly, so what was held already
    moves along with it, where the jump of a hand is followed.
    """
    layers = with_names(cast, layers, held.channels)
    columns = layers.columns
    goal = layers.goal.copy()
    hands = columns.sections["hands"]
    hold = columns.sections["hold"]
    holds, wanted = _hold_of(cast, columns, held)
    goal[hold] = holds
    np.copyto(goal[hands], wanted, where=holds > 0.0)
    first = layers.first.copy()
    second = layers.second.copy()
    free = layers.calm | ((first[hold] == 0.0) & (second[hold] == 0.0))
    moved = np.where(layers.goal[hold] > 0.0, goal[hands] - layers.goal[hands], 0.0) if on_way else 0.0
    for vector in (first, second):
        vector[hands] += moved
        np.copyto(vector[hands], goal[hands], where=free)
        if layers.calm:
            vector[hold] = holds
    return with_fields(layers, goal=goal, first=first, second=second, held=held)


def _hold_of(cast: HasExpressions, columns: Columns, held: Held) -> tuple[Values, Values]:
    holds = np.zeros(columns.width)
    wanted = np.zeros(columns.width)
    channels = effective_channels(cast.expressions, held.channels, held.gaze)
    places = columns.places(tuple(channels))
    holds[places] = 1.0
    wanted[places] = list(channels.values())
    if held.head != UPRIGHT:
        holds[HEAD] = 1.0
        wanted[HEAD] = (held.head.yaw, held.head.pitch, held.head.roll)
    if held.gaze != STRAIGHT:
        holds[columns.places(columns.eyes)] = 1.0
        holds[GAZE] = 1.0
        wanted[GAZE] = (held.gaze.yaw, held.gaze.pitch)
    return holds, wanted


def are_hands_still(layers: Layers) -> bool:
    """Whether all that hands hold, and all that they have let go, is where it goes."""
    begin = layers.columns.sections["hands"].start
    end = layers.columns.sections["hold"].stop
    where = slice(begin, end)
    return np.array_equal(layers.first[where], layers.goal[where]) and np.array_equal(
        layers.second[where], layers.goal[where]
    )


HEAD_FARTHER = 3.0
"""By which an angle of the head counts more than a weight, where a source comes back elsewhere: a turn of the head is a
matter of a second."""
LET_GO = 0.01
"""A part of a layer that weighs less has let go: another measure, or another source, no longer shows."""
FADED = 1e-6
"""A part that weighs less has faded out: who has left is forgotten, also while another source plays."""


def begin(cast: HasExpressions, held: Held) -> Layers:
    """The layers of a character that none has changed and no source drives: what hands hold shows as it did.

    cast: whose expressions there are; held: what hands hold.
    """
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
    """The layers with another influence of one of them, or with it switched: what shows follows.

    layer: which; part: of the face, None for all; on: whether it plays, None to leave it.
    """
    settings = {**layers.settings, layer: layers.settings[layer].change(part, influence, on)}
    return with_share_goal(replace(layers, settings=settings))


def drive(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers after a source has sent one of them a frame, which is checked (`check_frame`).

    cast: whose expressions there are; layer: which.
    """
    driver = find_driver(layers.drivers.get(layer, ()), frame.source)
    if not frame.found:  # silence counts from the last frame in which it was found
        return layers if driver is None or driver.lost else _with_state(layers, layer, with_fields(driver, lost=True))
    follows_on = frame.direct or (driver is not None and not driver.leaves and not driver.may_be_elsewhere)
    if driver is None or driver.leaves or not fits(driver, frame):
        layers = _plugged(cast, layers, layer, frame)
    elif driver.silent or driver.lost or _pace(driver) != _pace(frame):
        heard = with_fields(
            driver, silent=0.0, lost=False, smoothing=frame.smoothing, share=frame.share, part_shares=frame.part_shares
        )
        layers = _with_state(layers, layer, heard)
        if not driver.is_trusted:
            layers = _owned(layers, layer)
    later = _streamed(cast, layers, layer, frame)
    return later if follows_on else _coming_back(layers, later, layer, frame.source)


def _pace(sent: Driver | SourceFrame) -> tuple[float, float, tuple[float, ...]]:
    """What each frame says anew of how its layer follows it."""
    return sent.smoothing, sent.share, sent.part_shares


def recalibrate(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers where a source begins to send by another measure: what it plays of a layer lets go first."""
    followed = layers.followed.get(layer, NOBODY)
    if find_driver(layers.drivers.get(layer, ()), source) is None:
        return layers
    return _with_followed(layers, layer, tuple(None if shown == source else shown for shown in followed))


def leave(layers: Layers, layer: LayerName, source: str) -> Layers:
    """The layers after a source has gone: what it plays of a layer lets go."""
    driver = find_driver(layers.drivers.get(layer, ()), source)
    if driver is None:
        return layers
    return _owned(_with_state(layers, layer, replace(driver, leaves=True)), layer)


def switch_off(layers: Layers, kept: Sequence[float]) -> Layers:
    """The layers after a panic: sources are switched off, the character's own motion ends; kept: how much of the mix
    shows in each play region, which stays so until all is still.

    What was on air of them the caller eases to rest.
    """
    others = (
        (layer, [driver for driver in drivers if driver.source not in OWN_SOURCES])
        for layer, drivers in layers.drivers.items()
    )
    sources = {layer: tuple(drivers) for layer, drivers in others if drivers}
    settings = {
        layer: replace(setting, on=setting.on and layer not in sources) for layer, setting in layers.settings.items()
    }
    owners = {layer: owners_of(drivers, layers.columns) for layer, drivers in sources.items()}
    layers = replace(layers, settings=settings, drivers=sources, owners=owners)
    layers = with_share_goal(replace(layers, followed=_still_driving(layers.followed, sources)))
    columns = layers.columns
    goal = layers.goal.copy()
    for section in ("streams", "hands", "hold", "trust"):
        goal[columns.sections[section]] = 0.0
    goal[columns.sections["yielded"]] = [1.0 - share for share in kept]
    return replace(layers, goal=goal, first=goal, second=goal, held=Held(), calm=True, back=None)


def advance(cast: HasExpressions, layers: Layers, held: Held, dt: float, *, still: bool) -> Layers:
    """The layers `dt` seconds later, under what hands hold now. still: False while a panic eases to rest.

    cast: whose expressions there are; held: what hands hold.
    """
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
    calm = not plays(layers) and are_hands_still(layers)
    return replace(layers, calm=True) if calm else layers


def recast(cast: HasExpressions, layers: Layers) -> Layers:
    """The layers under another cast, which has all that is on air."""
    later = under(layers, make_columns(cast, layers.columns.names))
    owners = {layer: owners_of(drivers, later.columns) for layer, drivers in later.drivers.items()}
    return replace(later, owners=owners)


def _with_drivers(layers: Layers, layer: LayerName, drivers: tuple[Driver, ...]) -> Layers:
    return with_fields(layers, drivers={**layers.drivers, layer: drivers})


def _with_state(layers: Layers, layer: LayerName, driver: Driver) -> Layers:
    """The layers with another state of a driver."""
    return _with_drivers(layers, layer, replace_driver(layers.drivers[layer], driver))


def _with_followed(layers: Layers, layer: LayerName, followed: Owners) -> Layers:
    return with_share_goal(replace(layers, followed={**layers.followed, layer: followed}))


def _still_driving(
    names: Mapping[LayerName, Owners], drivers: Mapping[LayerName, tuple[Driver, ...]]
) -> dict[LayerName, Owners]:
    """The same without sources that drive no more."""
    names_left = dict[LayerName, Owners]()
    for layer, driven in drivers.items():
        sources = {driver.source for driver in driven}
        names_left[layer] = tuple(name if name in sources else None for name in names.get(layer, NOBODY))
    return names_left


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
    owners = layers.owners.get(layer, NOBODY)
    followed = layers.followed.get(layer, NOBODY)
    return owners != followed and any(
        owner is not None and owner != shown for owner, shown in zip(owners, followed, strict=True)
    )


def _stepped(layers: Layers, dt: float) -> Layers:
    before = layers.drivers
    drivers = {
        layer: tuple(advance_driver(driver, dt, layer) for driver in layer_drivers)
        for layer, layer_drivers in before.items()
    }
    layers = with_fields(layers, drivers=drivers)
    for layer, layer_drivers in drivers.items():
        lost = any(
            driver.is_trusted != other.is_trusted for driver, other in zip(layer_drivers, before[layer], strict=True)
        )
        if lost or _waits(layers, layer):
            layers = _owned(layers, layer)
    goal = layers.goal
    columns = layers.columns
    wanted = trust_goal(layers)
    trust = columns.sections["trust"]
    if goal[trust].tobytes() != wanted:
        goal = goal.copy()
        goal[trust] = np.frombuffer(wanted)
    comes_to_rest = not any(
        driver.is_trusted for layer_drivers in drivers.values() for driver in layer_drivers
    )  # nothing rests while one plays
    rate, haste = columns.stream_rates(_paces(layers))
    layers = with_fields(layers, goal=goal)
    eased = eased_goal(layers)
    first, second = follow(layers.first, layers.second, eased, rate, haste, dt, comes_to_rest=comes_to_rest)
    return with_fields(layers, first=first, second=second, back=None if eased is goal else layers.back)


def _paces(layers: Layers) -> list[Pace]:
    """How sources are followed that are smoothed otherwise than their layers, or have only just come."""
    return [
        Pace(DRIVEN.index(layer), columns_of_source(layers, layer, driver.source), driver.smoothing,
             driver.steady / STEADY_SECONDS)
        for layer, drivers in layers.drivers.items()
        for driver in drivers
        if driver.smoothing or driver.steady < STEADY_SECONDS
    ]  # fmt: skip


def _without_gone(layers: Layers) -> Layers:
    """The layers without the sources that have gone and of which nothing shows any more."""
    gone = {
        (layer, driver.source)
        for layer, drivers in layers.drivers.items()
        for driver in drivers
        if driver.leaves and not _shows(layers, layer, driver.source)
    }
    if not gone:
        return layers
    drivers = {
        layer: tuple(driver for driver in drivers if (layer, driver.source) not in gone)
        for layer, drivers in layers.drivers.items()
    }
    drivers = {layer: drivers for layer, drivers in drivers.items() if drivers}
    owners = _still_driving(layers.owners, drivers)
    followed = _still_driving(layers.followed, drivers)
    return with_share_goal(replace(layers, drivers=drivers, owners=owners, followed=followed))


def _shows(layers: Layers, layer: LayerName, source: str) -> bool:
    """Whether something of a source may show: a part that lets go for another measure (`recalibrate`) follows nobody,
    and shows for as long as it weighs."""
    followed = layers.followed.get(layer, NOBODY)
    trust = trust_of(layers, layer).tolist()
    return any(shown in (source, None) and part >= FADED for shown, part in zip(followed, trust, strict=True))


def _plugged(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where something begins to drive one, or to drive it by other channels, which lets go first."""
    layers = with_names(cast, layers, frame.names)
    drivers = layers.drivers.get(layer, ())
    before = find_driver(drivers, frame.source)
    driver = driver_of(frame)
    if before is not None:
        driver = with_fields(driver, way=before.way, away=before.away)
    layers = _with_drivers(layers, layer, with_driver(drivers, driver))
    if before is not None and before.names != frame.names and not frame.direct:
        layers = recalibrate(layers, layer, frame.source)
    return _owned(layers, layer)


def _streamed(cast: HasExpressions, layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where a frame is the goal of the parts that show its source; what these do not send is at rest."""
    columns = layers.columns
    row = DRIVEN.index(layer)
    goal = layers.goal.copy()
    own = columns_of_source(layers, layer, frame.source)
    followed = layers.followed.get(layer, NOBODY)
    if frame.source not in followed:
        return layers
    write_frame(cast, columns, columns.rows(goal, "streams")[row], own, frame)
    later = with_fields(layers, goal=goal, calm=False)
    if frame.share == 0.0 or 0.0 in frame.part_shares:
        later = _trusted(later, layer, frame)
    trust = trust_of(later, layer).tolist()
    unseen = tuple(
        name == frame.source and (frame.direct or part == 0.0) for name, part in zip(followed, trust, strict=True)
    )
    return _from_there(later, row, columns.in_parts(unseen)) if any(unseen) else later


def _coming_back(before: Layers, later: Layers, layer: LayerName, source: str) -> Layers:
    """The layers where a source, of which something shows, goes from where it was seen last to where it is, by an ease
    that takes the longer the farther that is.

    before: without its frame; later: with it.
    """
    columns = later.columns
    row = DRIVEN.index(layer)
    followed = later.followed.get(layer, NOBODY)
    weighs = (trust_of(later, layer) >= LET_GO).tolist()
    shown = columns.in_parts(tuple(name == source and shows for name, shows in zip(followed, weighs, strict=True)))
    now = columns.rows(later.goal, "streams")[row]
    seen = columns.rows(eased_goal(before), "streams")[row]
    distances = np.abs(now - seen)
    distances[HEAD] *= HEAD_FARTHER
    way = way_back(float(distances[shown].max(initial=0.0)))
    driver = find_driver(later.drivers[layer], source)
    if driver is None or not (way or driver.away):
        return later
    own = columns_of_source(later, layer, source)
    back = (later.goal if later.back is None else later.back).copy()
    columns.rows(back, "streams")[row][own] = np.where(shown, seen, now)[own]
    return _with_state(with_fields(later, back=back), layer, with_fields(driver, way=way, away=way))


def _from_there(layers: Layers, row: int, where: NDArray[np.bool_]) -> Layers:
    """Columns of a layer that do not show, or that are smooth already, are where they go."""
    columns = layers.columns
    first = layers.first.copy()
    second = layers.second.copy()
    stream = columns.rows(layers.goal, "streams")[row]
    for vector in (first, second):
        np.copyto(columns.rows(vector, "streams")[row], stream, where=where)
    return with_fields(layers, first=first, second=second)


def _trusted(layers: Layers, layer: LayerName, frame: SourceFrame) -> Layers:
    """The layers where what shows a source is trusted from now on wherever it takes nothing yet: so a first word is
    whole."""
    where = places_of_source(layers, layer, frame.source)
    if frame.share and frame.part_shares:
        where = where & (np.array(frame.part_shares) == 0.0)
    first = layers.first.copy()
    second = layers.second.copy()
    for vector in (first, second):
        layers.columns.rows(vector, "trust")[DRIVEN.index(layer), where] = 1.0
    return with_fields(layers, first=first, second=second)


def write_frame(
    cast: HasExpressions, columns: Columns, stream: Values, own: NDArray[np.bool_], frame: SourceFrame
) -> None:
    """Writes a frame into those columns of a layer that show its source; what it does not send there is at rest.

    cast: whose expressions there are; stream: the values of the layer's columns, written; own: which of them show the
    source.
    """
    head = frame.head
    gaze = frame.gaze
    turned = [] if head is None else [head.yaw, head.pitch, head.roll]
    if gaze is not None:
        weights = gaze_channels(cast.expressions, gaze, frame.vergence)
        turned += [gaze.yaw, gaze.pitch, *(weights.get(unit, 0.0) for unit in columns.eyes)]
    turns = columns.places_of_turns(head is not None, gaze is not None)
    values = np.ascontiguousarray(frame.values, np.float64)
    load_kernels().write_stream(stream, own, columns.places(frame.names), values, turns, np.array(turned))


def drive_direct(cast: HasExpressions, layers: Layers, frames: Mapping[LayerName, SourceFrame]) -> Layers:
    """The layers after direct frames (`SourceFrame.direct`) of some of them: as `drive` one after the other, to the
    bit, with one copy of each vector instead of one for each layer.

    cast: whose expressions there are.
    """
    ready = {layer: _find_ready(layers, layer, frame) for layer, frame in frames.items()}
    if None in ready.values():
        for layer, frame in frames.items():
            if ready[layer] is None:
                layers = drive(cast, layers, layer, frame)
        ready = {layer: _find_ready(layers, layer, frame) for layer, frame in frames.items()}
    drivers = dict(layers.drivers)
    goal = layers.goal.copy()
    first = layers.first.copy()
    second = layers.second.copy()
    for layer, frame in frames.items():
        driver = ready[layer]
        if driver is None:
            continue
        drivers[layer] = replace_driver(
            drivers[layer], with_fields(driver, silent=0.0, lost=False, smoothing=frame.smoothing)
        )
        row = DRIVEN.index(layer)
        own = columns_of_source(layers, layer, frame.source)
        stream, *shown = (layers.columns.rows(vector, "streams")[row] for vector in (goal, first, second))
        write_frame(cast, layers.columns, stream, own, frame)
        for each in shown:
            np.copyto(each, stream, where=own)
    return with_fields(layers, goal=goal, first=first, second=second, drivers=drivers, calm=False)


def _find_ready(layers: Layers, layer: LayerName, frame: SourceFrame) -> Driver | None:
    """The driver of a frame that only has to be written: it plays already, with the same channels, and is trusted."""
    driver = find_driver(layers.drivers.get(layer, ()), frame.source)
    ready = driver is not None and frame.found and frame.share == driver.share == 1.0
    return driver if ready and driver is not None and driver.is_trusted and fits(driver, frame) else None
