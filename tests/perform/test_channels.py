"""Channels and gaze: what is added to the mix, and where the eyes look."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.channels import (
    GAZE_UNITS,
    effective_channels,
    eye_angles,
    gaze_channels,
    with_channel,
    with_channels,
)
from omote.perform.frame import Gaze
from omote.perform.limits import GAZE_LIMITS
from tests.synthetic import EXPRESSIONS, LOOKS

yaws, pitches = (st.floats(-limit, limit) for limit in GAZE_LIMITS.values())
faders = st.dictionaries(st.sampled_from(EXPRESSIONS[1:]), st.floats(-0.5, 1.5))


@given(faders)
def test_channels_are_kept_as_set_in_one_order_without_zeros(cast: Cast, values: dict[str, float]) -> None:
    channels: dict[str, float] = {}
    for name, value in values.items():
        channels = with_channel(channels, cast.expressions, name, value)
    assert channels == {name: value for name, value in values.items() if value}
    assert list(channels) == sorted(channels)


@given(faders, faders)
def test_channels_set_at_once_are_those_set_one_by_one(
    cast: Cast, before: dict[str, float], values: dict[str, float]
) -> None:
    begun = with_channels({}, cast.expressions, before)
    channels = begun
    for name, value in values.items():
        channels = with_channel(channels, cast.expressions, name, value)
    assert list(with_channels(begun, cast.expressions, values).items()) == list(channels.items())


@pytest.mark.parametrize("name", ["neutral", "jawopen", ""])
def test_only_expressions_that_move_something_are_channels(cast: Cast, name: str) -> None:
    with pytest.raises(ValueError, match="there is no channel"):
        with_channel({}, cast.expressions, name, 0.5)


@pytest.mark.parametrize("value", [1.51, -0.51, float("nan"), float("inf")])
def test_a_channel_out_of_range_is_refused_never_clipped(cast: Cast, value: float) -> None:
    with pytest.raises(ValueError, match=r"the channel jawOpen is .*; give a number from -0.5 to 1.5"):
        with_channel({}, cast.expressions, "jawOpen", value)


@given(yaws, pitches)
def test_both_eyes_turn_exactly_by_the_gaze(cast: Cast, yaw: float, pitch: float) -> None:
    channels = effective_channels(cast.expressions, {}, Gaze(yaw, pitch))
    assert set(channels) <= set(GAZE_UNITS)
    assert all(weight > 0.0 for weight in channels.values())
    angles = eye_angles(cast.expressions, {"neutral": 1.0}, channels)
    assert angles == pytest.approx(np.array([[yaw, pitch], [yaw, pitch]]), abs=1e-9)


@given(yaws, pitches, st.sampled_from(sorted(LOOKS)), st.floats(-0.5, 1.5))
def test_gaze_and_fader_on_one_unit_never_double(cast: Cast, yaw: float, pitch: float, name: str, value: float) -> None:
    by_gaze = gaze_channels(cast.expressions, Gaze(yaw, pitch))
    both = effective_channels(cast.expressions, {name: value}, Gaze(yaw, pitch))
    assert abs(both[name]) == max(abs(value), abs(by_gaze.get(name, 0.0)))
    assert {unit: weight for unit, weight in both.items() if unit != name} == {
        unit: weight for unit, weight in by_gaze.items() if unit != name
    }


@given(faders)
def test_without_a_gaze_the_channels_are_the_faders(cast: Cast, values: dict[str, float]) -> None:
    assert effective_channels(cast.expressions, values, Gaze()) == values


def test_a_cast_without_the_units_looks_ahead(cast: Cast) -> None:
    assert gaze_channels({"neutral": cast.expressions["neutral"]}, Gaze(0.3, 0.2)) == {}


def test_expressions_on_air_turn_the_eyes_too(cast: Cast) -> None:
    angles = eye_angles(cast.expressions, {"eyeLookOutLeft": 0.5, "neutral": 0.5}, {"eyeLookDownRight": 1.0})
    assert angles == pytest.approx(np.array([[0.3, 0.0], [0.0, -0.5]]))
