"""A driver covers the parts in which its channels act; several share a layer, each where it may play."""

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.perform.frame import Head
from omote.perform.layers.columns import Columns, make_columns
from omote.perform.layers.drivers import (
    GAP_SECONDS,
    STEADY_SECONDS,
    UNSTEADY_SECONDS,
    Driver,
    advance_driver,
    fits,
    owners_of,
    parts_of,
    with_driver,
)
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.layers.source_frame import AUTOMATIC, LOSS_SECONDS, SPEECH, SourceFrame


def test_it_covers_the_parts_of_its_channels_as_far_as_it_may(cast: Cast) -> None:
    titles = {**cast.titles, "jawOpen": Title("jaw", region="jaw"), "browInnerUp": Title("brows", region="brows")}
    columns = make_columns(_titled(cast, titles), ("jawOpen", "browInnerUp", "smile"))
    assert parts_of(Driver("a", ("jawOpen",)), columns) == ("mouth",)
    assert parts_of(Driver("a", ("jawOpen", "browInnerUp"), head=True), columns) == ("brows", "mouth", "head")
    assert parts_of(Driver("a", ("smile",)), columns) == ("brows", "eyes", "mouth", "rest")
    assert parts_of(Driver("a", ("smile",), parts=("mouth", "gaze")), columns) == ("mouth",)
    assert parts_of(Driver("a", (), gaze=True), columns) == ("gaze",)


def _titled(cast: Cast, titles: dict[str, Title]) -> Cast:
    found = cast.with_expressions()
    object.__setattr__(found, "titles", titles)
    return found


def test_what_drives_a_layer_is_the_same_while_it_sends_the_same_channels() -> None:
    frame = SourceFrame(("jawOpen",), np.zeros(1), head=Head(), source="phone")
    driver = Driver("phone", ("jawOpen",), head=True)
    assert fits(driver, frame)
    for other in (
        Driver("tablet", ("jawOpen",), head=True),
        Driver("phone", ("smile",), head=True),
        Driver("phone", ("jawOpen",)),
        Driver("phone", ("jawOpen",), head=True, gaze=True),
        Driver("phone", ("jawOpen",), head=True, parts=LAYER_PARTS[:2]),
        Driver("phone", ("jawOpen",), head=True, route_number=1),
    ):
        assert not fits(other, frame)


TITLES = {
    "jawOpen": Title("jaw", region="jaw"),
    "browInnerUp": Title("brows", region="brows"),
    "smile": Title("smile", region="face"),
}
ALL_NAMES = ("browInnerUp", "jawOpen", "smile")


@pytest.fixture
def columns(cast: Cast) -> Columns:
    return make_columns(_titled(cast, {**cast.titles, **TITLES}), ALL_NAMES)


def test_who_may_play_fewer_parts_has_them_whoever_came_first(columns: Columns) -> None:
    face = Driver("face", ALL_NAMES)
    lips = Driver("lips", ALL_NAMES, parts=("mouth",))
    wanted = ("face", "face", "lips", "face", None, None, "face")
    assert owners_of((face, lips), columns) == wanted
    assert owners_of((lips, face), columns) == wanted


def test_of_equals_the_newest_has_all_and_when_it_is_lost_the_other(columns: Columns) -> None:
    one = Driver("one", ALL_NAMES)
    other = Driver("other", ALL_NAMES)
    assert set(owners_of((one, other), columns)) == {"other", None}
    for gone in (Driver("other", ALL_NAMES, silent=LOSS_SECONDS), Driver("other", ALL_NAMES, leaves=True)):
        assert set(owners_of((one, gone), columns)) == {"one", None}


def test_of_equals_the_one_that_was_told_to_play_last_has_all_whenever_it_came(columns: Columns) -> None:
    told = Driver("told", ALL_NAMES, route_number=2)
    came = Driver("came", ALL_NAMES, route_number=1)
    assert set(owners_of((told, came), columns)) == {"told", None}
    lips = Driver("lips", ALL_NAMES, parts=("mouth",))
    assert "lips" in owners_of((lips, told), columns), "who may play fewer parts has them all the same"
    speech = Driver(SPEECH, ALL_NAMES)
    assert set(owners_of((speech, told), columns)) == {SPEECH, None}, "what a character says is its own"


def test_a_source_that_sends_again_keeps_its_place_and_one_with_another_route_comes_last() -> None:
    drivers = Driver("a", ALL_NAMES), Driver("b", ALL_NAMES)
    again = with_driver(drivers, Driver("a", ("jawOpen",)))
    assert [each.source for each in again] == ["a", "b"]
    assert again[0].names == ("jawOpen",)
    routed = with_driver(drivers, Driver("a", ALL_NAMES, parts=("mouth",)))
    assert [each.source for each in routed] == ["b", "a"]


def test_a_characters_own_motion_makes_way(columns: Columns) -> None:
    assert with_driver((Driver(AUTOMATIC, ALL_NAMES),), Driver("a", ALL_NAMES)) == (Driver("a", ALL_NAMES),)
    assert with_driver((), Driver(AUTOMATIC, ALL_NAMES)) == (Driver(AUTOMATIC, ALL_NAMES),)


def test_a_source_is_steady_while_its_frames_have_no_gap() -> None:
    driver = Driver("a", ALL_NAMES)
    for _ in range(100):
        before = driver
        driver = advance_driver(driver, 0.01, "tracker")
        assert 0.0 <= driver.steady <= STEADY_SECONDS
        assert (driver.steady > before.steady) == (driver.silent < GAP_SECONDS)
        assert driver.steady == 0.0 or driver.silent < GAP_SECONDS + UNSTEADY_SECONDS + 0.01
    assert driver.silent == LOSS_SECONDS
