"""Layers are written and read exactly, and what no performer wrote is refused."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.layers.columns import PLACES, columns_of
from omote.perform.layers.drivers import Driver
from omote.perform.layers.layer_names import LAYER_PARTS, LayerName
from omote.perform.layers.layers_snapshot import LayersSnapshot
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot, names_held


def driven(cast: Cast) -> Snapshot:
    performer = Performer(cast)
    for _ in range(20):
        performer.drive({"jawOpen": 0.5, "smile": 0.1}, head=(0.1, 0.0, 0.0))
        performer.advance(1 / 60)
    performer.set_layer("lips", region="mouth", influence=0.3)
    return performer.snapshot()


def layers_of(snapshot: Snapshot) -> LayersSnapshot:
    assert snapshot.layers is not None
    return snapshot.layers


def test_they_are_written_and_read_exactly(cast: Cast) -> None:
    snapshot = driven(cast)
    for form in (msgspec.msgpack, msgspec.json):
        assert form.decode(form.encode(snapshot), type=Snapshot) == snapshot
    assert {"jawOpen", "smile"} <= names_held(snapshot)[1]


def test_a_snapshot_from_before_layers_has_none(cast: Cast) -> None:
    old = msgspec.to_builtins(Performer(cast).snapshot())
    del old["layers"]
    assert msgspec.convert(old, Snapshot) == Performer(cast).snapshot()


def several(layers: LayersSnapshot) -> dict[LayerName, tuple[Driver, ...]]:
    """The drivers of each layer."""
    return {layer: each for layer, each in layers.drivers.items() if isinstance(each, tuple)}


def with_one_driver(cast: Cast, layers: LayersSnapshot) -> LayersSnapshot:
    """The same as it was written when a layer had one source, and one trust for all its parts."""
    columns = columns_of(cast, layers.names)

    def of_before(data: bytes) -> bytes:
        vector = np.frombuffer(data, "<f8")
        shares = columns.rows(vector, "share")[:, : len(LAYER_PARTS)]
        trusts = columns.rows(vector, "trust").max(axis=1)
        sections = vector[: columns.sections["share"].start], shares, trusts, vector[columns.sections["yielded"]]
        return np.concatenate([each.ravel() for each in sections]).tobytes()

    drivers = {layer: each[0] for layer, each in several(layers).items()}
    vectors = {name: of_before(getattr(layers, name)) for name in ("goal", "first", "second")}
    return replace(layers, drivers=drivers, followed={}, **vectors)  # type: ignore[arg-type]


def test_layers_of_one_source_each_go_on(cast: Cast) -> None:
    snapshot = driven(cast)
    performer = Performer.restored(cast, snapshot)
    old = replace(snapshot, layers=with_one_driver(cast, layers_of(snapshot)))
    read = msgspec.msgpack.decode(msgspec.msgpack.encode(old), type=Snapshot)
    other = Performer.restored(cast, read)
    assert other.advance(0.0).channels == performer.advance(0.0).channels
    for _ in range(60):
        for each in (performer, other):
            each.drive({"jawOpen": 0.5, "smile": 0.1}, head=(0.1, 0.0, 0.0))
        frame = performer.advance(1 / 60)
        same = other.advance(1 / 60)
        assert dict(same.channels) == pytest.approx(dict(frame.channels))
        assert (same.head, same.layers) == (frame.head, frame.layers)


def beyond(data: bytes) -> bytes:
    values = np.frombuffer(data, "<f8").copy()
    values[-1] = 2.0
    return values.tobytes()


BROKEN: dict[str, Callable[[LayersSnapshot], LayersSnapshot]] = {
    "the layers in the snapshot have 8 bytes; expected": lambda one: replace(one, goal=bytes(8)),
    "a yielded of the layers in the snapshot is out of its range": lambda one: replace(one, second=beyond(one.second)),
    "a value of the layers in the snapshot is out of its range": lambda one: replace(
        one, first=np.array([np.nan]).tobytes() + one.first[8:]
    ),
    "the snapshot has the layers breath; expected": lambda one: replace(
        one, settings={"breath": one.settings["breath"]}
    ),
    "the silence of a source": lambda one: replace(
        one, drivers={layer: replace(each[0], silent=9.0) for layer, each in several(one).items()}
    ),
    "there is no channel 'gone'": lambda one: replace(
        one, drivers={layer: replace(each[0], names=("gone",)) for layer, each in several(one).items()}
    ),
    "the steady frames of a source": lambda one: replace(
        one, drivers={layer: (replace(each[0], steady=9.0),) for layer, each in several(one).items()}
    ),
    "the layer playback of the snapshot shows": lambda one: replace(one, followed={"playback": ("gone",) * PLACES}),
}


@pytest.mark.parametrize("message", BROKEN)
def test_what_no_performer_wrote_is_refused(cast: Cast, message: str) -> None:
    snapshot = driven(cast)
    broken: Any = BROKEN[message](layers_of(snapshot))
    with pytest.raises(ValueError, match=message):
        Performer.restored(cast, replace(snapshot, layers=broken))
