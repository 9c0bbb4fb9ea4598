"""A program routes, measures and tunes sources; what it names wrong is rejected in words."""

import struct
from typing import Any

import pytest

from omote.model.cast import Cast
from omote.show import messages as wire
from tests.server.client.test_remote_show import Wired


@pytest.fixture
def wired(cast: Cast) -> Wired:
    """A show of two characters, and one frame of a source."""
    wired = Wired(cast)
    wired.show.add("two", label="Rex")
    wired.session.receive("p", wire.Source("phone", "tracker", ["jawOpen"], ["one"]), 0.0)
    drive(wired, 0.5)
    return wired


def drive(wired: Wired, value: float) -> None:
    wired.send(wire.Drive(1, struct.pack("<f", value)))


def told(wired: Wired) -> wire.SourceState:
    (source,) = wired.session.sources.states({})
    return source


def test_a_source_is_routed_by_label_to_regions_of_several(wired: Wired) -> None:
    wired.show.route_source("phone", ["one", "rex"], layer="playback", regions=["mouth", "brows"])
    source = told(wired)
    assert (source.characters, source.layer, source.regions) == (["one", "two"], "playback", ["brows", "mouth"])
    wired.show.route_source("phone", ["*"])
    assert (told(wired).characters, told(wired).layer) == (["*"], "tracker")
    wired.show.route_source("phone", [])
    assert told(wired).characters == []


def test_a_source_is_measured_and_tuned(wired: Wired) -> None:
    wired.show.calibrate_source("phone", "range", ["jawOpen"])
    drive(wired, 0.75)
    wired.show.calibrate_source("phone", "done")
    wired.show.tune_source("phone", mirror=True, lids=1.5, smoothing=0.25)
    source = told(wired)
    assert source.highest == {"jawOpen": 0.75}
    assert (source.mirror, source.lids, source.smoothing, source.gain) == (True, 1.5, 0.25, 1.0)


WRONG: dict[str, tuple[type[Exception], Any]] = {
    "there is no character 'gone'": (ValueError, lambda show: show.route_source("a", ["gone"])),
    "there is no layer for a source 'hands'": (ValueError, lambda show: show.route_source("a", ["one"], layer="hands")),
    "there is no region of a layer 'nose'": (
        ValueError,
        lambda show: show.route_source("a", ["one"], regions=["nose"]),
    ),
    "lists of names; give": (TypeError, lambda show: show.route_source("a", "one")),
}


@pytest.mark.parametrize("message", WRONG)
def test_what_is_named_wrong_is_refused_in_words(wired: Wired, message: str) -> None:
    error, call = WRONG[message]
    with pytest.raises(error, match=message):
        call(wired.show)
