"""A performer's measure: rest is nothing, the largest move all, lids are open at rest, nothing leaves its range."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.frame import Gaze, Head
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST
from omote.show.sources.calibration import AS_IT_IS, MOST_LID_REST, Calibration, measure_of

NAMES = ("jawOpen", "eyeBlinkLeft", "eyeBlinkRight", "mouthLeft", "mouthRight")
sent = st.lists(st.floats(CHANNEL_LOWEST, CHANNEL_HIGHEST), min_size=5, max_size=5).map(np.array)
calibrations = st.builds(
    Calibration,
    st.dictionaries(st.sampled_from(NAMES), st.floats(-0.2, 0.4)),
    st.dictionaries(st.sampled_from(NAMES), st.floats(0.3, 1.2)),
    st.booleans(),
    st.floats(0.0, 0.5),
    st.floats(-1.0, 1.0),
    st.floats(0.0, 4.0),
)


def weights(calibration: Calibration, values: list[float]) -> list[float]:
    found: list[float] = (
        measure_of(calibration, NAMES).weights(np.array(values), CHANNEL_LOWEST, CHANNEL_HIGHEST).tolist()
    )
    return found


@given(sent)
def test_without_a_measure_all_comes_through_unchanged(values: np.ndarray) -> None:
    assert weights(AS_IT_IS, values.tolist()) == values.tolist()


def test_rest_is_nothing_and_the_largest_move_is_all() -> None:
    measured = Calibration({"jawOpen": 0.1}, {"jawOpen": 0.6})
    assert weights(measured, [0.1, 0, 0, 0, 0])[0] == 0.0
    assert weights(measured, [0.6, 0, 0, 0, 0])[0] == pytest.approx(1.0)
    assert weights(measured, [0.35, 0, 0, 0, 0])[0] == pytest.approx(0.5)


def lid(rest: float, shut: float | None, value: float) -> float:
    """What is made of a left lid that rests and shuts so."""
    shuts = {} if shut is None else {"eyeBlinkLeft": shut}
    return weights(Calibration({"eyeBlinkLeft": rest}, shuts), [0, value, 0, 0, 0])[1]


def test_a_lid_at_rest_is_open_and_a_shut_one_shut() -> None:
    assert lid(0.07, 0.7, 0.07) == 0.0
    assert lid(0.07, 0.7, 0.7) == pytest.approx(1.0)
    assert lid(0.07, None, 1.0) == pytest.approx(1.0), "a lid of which only the rest is known shuts, too"
    assert lid(0.07, 0.7, 0.12) < 0.12


@given(st.floats(CHANNEL_LOWEST, CHANNEL_HIGHEST), st.none() | st.floats(CHANNEL_LOWEST, CHANNEL_HIGHEST), sent)
def test_lids_are_nothing_below_their_rest_and_all_when_shut(
    rest: float, shut: float | None, values: list[float]
) -> None:
    most = min(max(rest, 0.0), MOST_LID_REST)
    for value in values:
        found = lid(rest, shut, value)
        assert found >= 0.0
        assert found == 0.0 or value > most
        assert found >= 1.0 - 1e-9 or value < max(1.0, shut or 1.0)


def test_a_rest_that_was_measured_in_a_blink_leaves_lids_to_shut() -> None:
    assert lid(0.95, None, 1.0) == pytest.approx(1.0)
    assert lid(0.95, 1.0, 1.0) == pytest.approx(1.0)
    assert lid(0.95, None, MOST_LID_REST + 0.1) > 0.0


def test_a_mirror_swaps_the_sides_with_their_measures() -> None:
    mirrored = Calibration({}, {"mouthLeft": 0.5}, mirror=True)
    assert weights(mirrored, [0.3, 0.1, 0.2, 0.25, 0.75]) == [0.3, 0.2, 0.1, 0.75, 0.5]
    head, gaze = measure_of(mirrored, NAMES).turn(Head(0.1, 0.2, 0.3), Gaze(0.1, 0.2))
    assert (head, gaze) == (Head(-0.1, 0.2, -0.3), Gaze(-0.1, 0.2))
    assert measure_of(AS_IT_IS, NAMES).turn(None, Gaze(0.1)) == (None, Gaze(0.1))


def test_a_dead_zone_swallows_trembling_and_the_ends_stay() -> None:
    dull = Calibration(dead_zone=0.2)
    assert weights(dull, [0.2, -0.1, 0.6, 1.0, -0.6]) == [0.0, 0.0, pytest.approx(0.5), 1.0, pytest.approx(-0.5)]
    assert weights(Calibration(curve=1.0), [0.5, 1.0, 0.0, 1.2, 0.0]) == [0.75, 1.0, 0.0, 1.2, 0.0]


@given(calibrations, sent, sent)
def test_what_grows_stays_in_range_and_never_falls(calibration: Calibration, one: np.ndarray, step: np.ndarray) -> None:
    lower = np.minimum(one, step)
    higher = np.maximum(one, step)
    before = weights(calibration, lower.tolist())
    after = weights(calibration, higher.tolist())
    assert all(CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST for value in (*before, *after))
    assert all(low <= high + 1e-12 for low, high in zip(before, after, strict=True))


def test_what_is_out_of_range_is_refused() -> None:
    with pytest.raises(ValueError, match=r"jawOpen in the largest move of a performer is 3.0"):
        Calibration(highest={"jawOpen": 3.0})
    with pytest.raises(ValueError, match=r"the dead zone of a source is 0.7; give a number from 0 to 0.5"):
        Calibration(dead_zone=0.7)
    with pytest.raises(ValueError, match=r"the curve of a source is -2.0"):
        Calibration(curve=-2.0)
    with pytest.raises(ValueError, match=r"the gain of a source is 9.0"):
        Calibration(gain=9.0)


def test_lids_have_a_gain_of_their_own() -> None:
    assert weights(Calibration(gain=0.5, lids=3.0), [0.2, 0.2, 0.4, 0, 0])[:3] == pytest.approx([0.1, 0.3, 0.6])
    with pytest.raises(ValueError, match=r"the gain of the lids of a source is 5.0; give a number from 0 to 4"):
        Calibration(lids=5.0)
