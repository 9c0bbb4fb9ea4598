"""Clips: lanes laid over one another, spans replaced without a seam."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.perform.clips.clip import (
    SEAM_SECONDS,
    Clip,
    Lane,
    Span,
    find_lane,
    replace_span,
    with_changed_lane,
    with_lane,
)
from omote.perform.clips.motion_curve import make_curve
from omote.perform.clips.sample import Sample
from omote.perform.layers.layer_names import LAYER_PARTS
from tests.perform.clips.curves import PARTS, STEP, curve, same

seeds = st.integers(0, 2**16)
times = st.floats(0.0, 2.0)
parts = st.sets(st.sampled_from(LAYER_PARTS)).map(lambda chosen: tuple(sorted(chosen)))
lanes = st.builds(
    lambda seed, given, weight: Lane(curve(seed), parts=given, weight=weight),
    seeds,
    parts,
    st.sampled_from([0.25, 1.0]),
)


@given(lane=lanes, time=times)
def test_a_lane_that_gives_all_of_a_part_has_the_numbers_of_its_curve(lane: Lane, time: float) -> None:
    found = Clip([lane]).sample(time)
    own = Sample(lane.curve.layout, lane.curve.values(time), found.shares)
    assert same(found, own)


@given(drawn=st.lists(lanes, min_size=1, max_size=4), muted=seeds, time=times)
def test_a_muted_lane_is_absent(drawn: list[Lane], muted: int, time: float) -> None:
    place = muted % (len(drawn) + 1)
    with_it = [*drawn[:place], Lane(curve(muted), muted=True), *drawn[place:]]
    assert same(Clip(with_it).sample(time), Clip(drawn).sample(time))
    assert Clip(with_it).layout is Clip(drawn).layout


@given(drawn=st.lists(lanes, min_size=1, max_size=3), time=times, later=st.integers(-256, 256))
def test_what_comes_later_is_the_same_later(drawn: list[Lane], time: float, later: int) -> None:
    clip = Clip([replace(lane, shift=place * 8 * STEP) for place, lane in enumerate(drawn)])
    position = round(time / STEP) * STEP
    moved = clip.shifted(later * STEP)
    assert moved.seconds == clip.seconds
    assert same(moved.sample(position), clip.sample(position))


@given(lane=lanes, ends=st.tuples(times, times), time=times)
def test_a_span_that_is_replaced_by_itself_changes_nothing(lane: Lane, ends: tuple[float, float], time: float) -> None:
    replaced = replace_span(lane, min(ends), max(ends), lane.curve)
    assert same(Clip([replaced]).sample(time), Clip([lane]).sample(time))


@given(seed=seeds, time=st.floats(0.5, 1.5))
def test_a_span_shows_between_its_seams_and_nothing_of_it_outside(seed: int, time: float) -> None:
    lane = Lane(curve(seed))
    other = curve(seed + 1)
    clip = Clip([replace_span(lane, 0.5, 1.5, other)])
    inside = 0.5 + SEAM_SECONDS <= time <= 1.5 - SEAM_SECONDS
    if inside:
        assert same(clip.sample(time), Clip([Lane(other)]).sample(time))
    for outside in (time - 1.0, time + 1.0):
        assert same(clip.sample(outside), Clip([lane]).sample(outside))


@settings(max_examples=20)
@given(seed=seeds)
def test_seams_have_no_jump_of_value_or_speed(seed: int) -> None:
    """Two lanes that stand still, so that all that moves is the seam: its speed ends as it begins, at rest."""
    random = np.random.default_rng(seed)
    low, high = random.uniform(0.0, 0.4), random.uniform(0.6, 1.0)
    still = [make_curve([0.0, 2.0], {"jawOpen": [value] * 2}, PARTS) for value in (low, high)]
    clip = Clip(
        [replace_span(Lane(still[0]), 0.25, 0.75, still[1]), Lane(still[1], shift=1.0, parts=("mouth",))], stop=2.5
    )
    at = np.arange(0.0, 2.0, 1e-3)
    place = clip.layout.columns.index("channel/jawOpen")
    shown = np.array([clip.sample(time).values[place] for time in at])
    fastest = 1.875 * (high - low) / SEAM_SECONDS
    assert np.abs(np.diff(shown)).max() <= 1.01 * fastest * 1e-3
    assert np.abs(np.diff(shown, 2)).max() <= 6.0 * (high - low) / SEAM_SECONDS**2 * 1e-6
    assert shown.min() >= low - 1e-12
    assert shown.max() <= high + 1e-12


def test_lanes_are_found_by_name_and_by_number() -> None:
    clip = with_lane(Clip([Lane(curve(1), "mouth")]), Lane(curve(2)))
    assert [find_lane(clip, name) for name in ("mouth", "1", "2")] == [0, 0, 1]
    louder = with_changed_lane(clip, "mouth", replace(clip.lanes[0], weight=0.5))
    assert [lane.weight for lane in louder.lanes] == [0.5, 1.0]
    assert with_changed_lane(clip, "2", None).lanes == clip.lanes[:1]
    with pytest.raises(ValueError, match="no lane of this clip 'brows'"):
        find_lane(clip, "brows")


REJECTED: dict[str, Any] = {
    "a clip has 0 lanes": lambda: Clip([]),
    "a clip has 17 lanes": lambda: Clip([Lane(curve(1))] * 17),
    "ends at 1 s, where it has not begun": lambda: Clip([Lane(curve(1))], start=1.0, stop=1.0),
    "the weight of a lane is 2": lambda: Lane(curve(1), weight=2.0),
    "no part of a clip 'nose'": lambda: Lane(curve(1), parts=("nose",)),  # type: ignore[arg-type]
    "the name of a lane is": lambda: Lane(curve(1), "x" * 41),
    "a lane has 33 spans": lambda: Lane(curve(1), spans=(Span(0.0, 1.0, curve(1)),) * 33),
    "the end of a span": lambda: Span(1.0, 0.5, curve(1)),
    "the speed of a clip is 99": lambda: Clip([Lane(curve(1))], speed=99.0),
}


@pytest.mark.parametrize("reason", REJECTED)
def test_what_no_clip_can_be_is_rejected(reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        REJECTED[reason]()
