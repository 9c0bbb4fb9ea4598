"""Frames of several layers at once, of one source that is smooth already: a character's own motion, in each tick."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.frame import with_fields
from omote.perform.layers.columns import HasExpressions
from omote.perform.layers.drivers import Driver, find_driver, fits, replace_driver
from omote.perform.layers.layer_names import DRIVEN, LayerName
from omote.perform.layers.layer_vectors import Layers, columns_of_source
from omote.perform.layers.layers import drive, write_frame
from omote.perform.layers.source_frame import SourceFrame


def drive_direct(cast: HasExpressions, layers: Layers, frames: Mapping[LayerName, SourceFrame]) -> Layers:
    """The layers after direct frames (`SourceFrame.direct`) of some of them: as `drive` one after the other, to the
    bit, with one copy of each vector instead of one for each layer."""
    for layer, frame in frames.items():
        if _find_ready(layers, layer, frame) is None:
            layers = drive(cast, layers, layer, frame)
    drivers = dict(layers.drivers)
    goal, first, second = layers.goal.copy(), layers.first.copy(), layers.second.copy()
    for layer, frame in frames.items():
        driver = _find_ready(layers, layer, frame)
        if driver is None:
            continue
        drivers[layer] = replace_driver(drivers[layer], with_fields(driver, silent=0.0, smoothing=frame.smoothing))
        columns, row = layers.columns, DRIVEN.index(layer)
        own, stream = columns_of_source(layers, layer, frame.source), columns.rows(goal, "streams")[row]
        write_frame(cast, columns, stream, own, frame)
        for vector in (first, second):
            columns.rows(vector, "streams")[row][own] = stream[own]
    return with_fields(layers, goal=goal, first=first, second=second, drivers=drivers, calm=False)


def _find_ready(layers: Layers, layer: LayerName, frame: SourceFrame) -> Driver | None:
    """The driver of a frame that only has to be written: it plays already, with the same channels, and is trusted."""
    driver = find_driver(layers.drivers.get(layer, ()), frame.source)
    ready = driver is not None and frame.found and frame.share == driver.share == 1.0
    return driver if ready and driver is not None and driver.is_trusted and fits(driver, frame) else None
