"""The curves that pages draw of a lane."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.clip import Lane, replace_span
from omote.perform.clips.motion_curve import make_curve
from omote.perform.clips.outline import MOST_MOVED, outline_lane
from omote.perform.layers.layer_names import LAYER_PARTS
from tests.perform.clips.curves import curve

TIMES = np.linspace(0.0, 1.0, 61)
MOUTH = LAYER_PARTS.index("mouth")
JAW = make_curve(TIMES, {"jawOpen": TIMES, "mouthFunnel": np.full(61, 0.5)}, {"jawOpen": MOUTH, "mouthFunnel": MOUTH})


def test_what_changes_most_comes_first_and_what_stands_is_a_line() -> None:
    shown = outline_lane(Lane(JAW), points=61)
    assert list(shown) == ["channel/jawOpen", "channel/mouthFunnel"]
    assert shown["channel/jawOpen"] == pytest.approx(TIMES, abs=1e-3)
    assert set(shown["channel/mouthFunnel"]) == {0.5}


def test_a_span_shows_in_the_place_of_what_it_replaces_and_other_parts_do_not_show() -> None:
    again = make_curve(TIMES, {"jawOpen": np.full(61, 0.25)}, {"jawOpen": MOUTH})
    lane = replace_span(Lane(JAW), 0.5, 0.75, again)
    shown = np.array(outline_lane(lane, points=61)["channel/jawOpen"])
    inside = (TIMES > 0.5) & (TIMES < 0.75)
    assert shown[inside] == pytest.approx(0.25)
    assert shown[~inside] == pytest.approx(TIMES[~inside], abs=1e-3)
    assert outline_lane(replace(lane, parts=("brows",))) == {}


def test_angles_are_parts_of_the_most_that_a_head_turns() -> None:
    head = [[pi / 4 * time, 0.0, 0.0] for time in TIMES]
    shown = outline_lane(Lane(make_curve(TIMES, {}, {}, head=head)), points=61)
    assert shown["head/yaw"] == pytest.approx(TIMES / 2, abs=1e-3)


@given(seed=st.integers(0, 2**16), points=st.integers(2, 50))
def test_no_lane_has_more_curves_or_other_points_than_were_asked_for(seed: int, points: int) -> None:
    shown = outline_lane(Lane(curve(seed)), points=points)
    assert len(shown) <= MOST_MOVED
    assert {len(values) for values in shown.values()} <= {points}
