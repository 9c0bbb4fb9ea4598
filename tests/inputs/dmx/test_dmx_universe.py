"""Sources of one universe: priority, order, merge and loss."""

import numpy as np
import pytest

from omote.inputs.dmx.dmx_universe import LOST_SECONDS, MOST_SOURCES, Universe, merge_levels
from omote.inputs.rejection import PacketError


@pytest.fixture
def universe() -> Universe:
    return Universe()


def test_the_highest_priority_wins_until_it_is_lost(universe: Universe) -> None:
    universe.receive(b"desk", b"\x10", 0.0, priority=100)
    universe.receive(b"backup", b"\xff", 0.0, priority=50)
    assert universe.levels(0.1) == b"\x10"
    universe.receive(b"backup", b"\xff", LOST_SECONDS, priority=50)
    assert universe.levels(LOST_SECONDS) == b"\x10"
    assert universe.levels(LOST_SECONDS + 0.01) == b"\xff"
    assert not universe.lost


def test_equals_are_merged_slot_by_slot(universe: Universe) -> None:
    universe.receive(b"a", b"\x10\x80", 0.0)
    universe.receive(b"b", b"\x20", 0.0)
    assert universe.levels(0.0) == b"\x20\x80"


def test_the_last_levels_hold_when_all_are_lost(universe: Universe) -> None:
    universe.receive(b"a", b"\x10", 0.0)
    assert (universe.levels(10.0), universe.lost) == (b"\x10", True)
    universe.receive(b"a", b"\x11", 11.0)
    assert (universe.levels(11.0), universe.lost) == (b"\x11", False)


def test_a_source_that_says_that_it_ends_is_gone_at_once(universe: Universe) -> None:
    universe.receive(b"a", b"\x10", 0.0)
    universe.receive(b"b", b"\x80", 0.0)
    universe.end(b"b", 0.0)
    assert universe.levels(0.0) == b"\x10"
    universe.end(b"a", 0.0)
    assert (universe.levels(0.0), universe.lost) == (b"\x10", True)


@pytest.mark.parametrize("before", range(0, 256, 5))
def test_what_comes_late_is_left_out_and_a_new_start_is_not(universe: Universe, before: int) -> None:
    universe.receive(b"a", b"\x01", 0.0, sequence=before)
    for behind in (0, 1, 19):
        universe.receive(b"a", b"\x02", 0.0, sequence=(before - behind) % 256)
    assert (universe.levels(0.0), universe.late) == (b"\x01", 3)
    universe.receive(b"a", b"\x03", 0.0, sequence=(before - 20) % 256)
    assert universe.levels(0.0) == b"\x03"
    universe.receive(b"a", b"\x04", 0.0, sequence=(before - 19) % 256)
    assert universe.levels(0.0) == b"\x04"


def test_a_source_without_numbers_is_never_late(universe: Universe) -> None:
    for level in (b"\x01", b"\x02"):
        universe.receive(b"a", level, 0.0)
    assert (universe.levels(0.0), universe.late) == (b"\x02", 0)


def test_one_source_too_many_is_rejected_until_another_is_lost(universe: Universe) -> None:
    for number in range(MOST_SOURCES):
        universe.receive(bytes([number]), b"\1", 0.0)
    with pytest.raises(PacketError, match="more than 16 sources"):
        universe.receive(b"more", b"\xff", 0.0)
    universe.receive(b"more", b"\xff", LOST_SECONDS + 1.0)
    assert universe.levels(LOST_SECONDS + 1.0) == b"\xff"


def test_a_merge_is_the_maximum_whatever_the_order() -> None:
    generator = np.random.default_rng(4)
    parts = [generator.integers(0, 256, n, np.uint8) for n in (512, 3, 100)]
    whole = np.zeros(512, np.uint8)
    for part in parts:
        whole[: len(part)] = np.maximum(whole[: len(part)], part)
    assert merge_levels([part.tobytes() for part in parts]) == whole.tobytes()
    assert merge_levels([part.tobytes() for part in parts[::-1]]) == whole.tobytes()
