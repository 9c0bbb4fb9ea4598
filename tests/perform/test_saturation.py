"""Units that saturate: one jaw, whatever opens it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.builtin import load_cast
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.perform.frame import Frame
from omote.perform.saturation import (
    BEYOND,
    FULL,
    SATURATING,
    SOFTNESS,
    TONGUE,
    TONGUE_OPENS,
    added_by,
    saturate,
    worn_share,
)

CAST = load_cast()
WEIGHTS = st.floats(0.0, 1.5)
PERFORMED = ("laugh", "shout", "surprise", "cry", "fear", "joy", "mouth-open")


def drop(frame: Frame) -> float:
    """How far the lower teeth go down, metres."""
    rest = omote.evaluate_parts(CAST, Frame({"generic": 1.0}, {"neutral": 1.0}))["teeth_lower"]
    return float((rest - omote.evaluate_parts(CAST, frame)["teeth_lower"])[:, 1].mean())


@given(st.dictionaries(st.sampled_from(ARKIT_NAMES).filter(lambda name: name != TONGUE), st.floats(-0.5, 1.5)))
def test_what_a_tracker_sends_over_a_face_at_rest_stays_bit_for_bit(channels: dict[str, float]) -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, channels)
    assert saturate(CAST.expressions, frame, channels) is channels


@given(WEIGHTS, WEIGHTS)
def test_two_sources_go_as_far_as_the_further(one: float, other: float) -> None:
    total = one + added_by(other, one)
    assert total >= max(one, other) - 1e-12
    assert total <= max(one, other) + 0.5 * (SOFTNESS * one * other) ** 0.5 + 1e-12
    assert total == pytest.approx(other + added_by(one, other), abs=1e-12)  # whichever is called first


@given(WEIGHTS, WEIGHTS, st.floats(0.0, 0.01))
def test_more_opens_more_without_a_step(weight: float, worn: float, more: float) -> None:
    rise = added_by(weight + more, worn, held=True) - added_by(weight, worn, held=True)
    assert -1e-12 <= rise <= more + 1e-12
    change = added_by(weight, worn + more, held=True) - added_by(weight, worn, held=True)
    assert abs(change) <= 6.0 * more + 1e-12  # the total bends in while the second source comes


@given(WEIGHTS, st.floats(0.2, 1.5))
def test_a_jaw_of_two_sources_opens_no_further_than_a_jaw_can(weight: float, worn: float) -> None:
    assert added_by(weight, worn, held=True) <= FULL + BEYOND + 0.5 * SOFTNESS**0.5 * 1.5


@pytest.mark.parametrize("worn", PERFORMED)
def test_lower_teeth_go_as_far_as_the_further_of_expression_and_fader(worn: str) -> None:
    mix = {worn: 1.0}
    alone = drop(Frame({"generic": 1.0}, mix))
    fader = drop(Frame({"generic": 1.0}, {"neutral": 1.0}, {"jawOpen": 1.0}))
    both = drop(Frame({"generic": 1.0}, mix, {"jawOpen": 1.0}))
    assert 0.9 * max(alone, fader) <= both <= 1.2 * max(alone, fader)  # shares are found at the chin, not at teeth


@pytest.mark.parametrize("order", [("jawOpen", "mouth-open"), ("mouth-open", "jawOpen")])
def test_two_faders_of_one_jaw_open_it_once(order: tuple[str, str]) -> None:
    both = Frame({"generic": 1.0}, {"neutral": 1.0}, dict.fromkeys(order, 1.0))
    one = Frame({"generic": 1.0}, {"neutral": 1.0}, {"mouth-open": 1.0})
    assert drop(both) == pytest.approx(drop(one), rel=0.1)


@pytest.mark.parametrize("unit", SATURATING)
def test_a_unit_called_and_driven_is_worn_once(unit: str) -> None:
    called = Frame({"generic": 1.0}, {unit: 1.0})
    both = Frame({"generic": 1.0}, {unit: 1.0}, {unit: 1.0})
    wide = np.abs(omote.evaluate(CAST, called) - CAST.faces["generic"].positions).max()
    assert np.abs(omote.evaluate(CAST, both) - omote.evaluate(CAST, called)).max() < 0.1 * wide


@given(st.floats(-0.5, 1.5), st.floats(0.0, 1.0), st.booleans())
def test_a_tongue_parts_lips_that_nothing_has_opened(jaw: float, tongue: float, called: bool) -> None:
    mix = {TONGUE: tongue, "neutral": 1.0 - tongue} if called else {"neutral": 1.0}
    channels = {"jawOpen": jaw} if called else {"jawOpen": jaw, TONGUE: tongue}
    opened = saturate(CAST.expressions, Frame({"generic": 1.0}, mix, channels), channels)["jawOpen"]
    least = TONGUE_OPENS * tongue
    assert opened >= (max(jaw, least) if jaw > 0.0 else jaw + least) - 1e-12
    assert opened <= (max(jaw, least) if jaw > 0.0 else jaw + least) + 0.5 * (SOFTNESS * max(jaw, 0.0) * least) ** 0.5


@pytest.mark.parametrize("face", ["kaori", "man", "child", "old", "dog"])
def test_a_tongue_has_room_between_the_lips(face: str) -> None:
    lips = next(line.loop for line in CAST.space.lines if line.kind == "lips")

    def gap(weights: dict[str, float]) -> float:
        edge = omote.evaluate(CAST, Frame({face: 1.0}, {"neutral": 1.0}, weights))[lips]
        near = edge[np.abs(edge[:, 0] - edge[:, 0].mean()) < 0.004]
        return float(np.ptp(near[:, 1]))

    def height() -> float:
        tongue = omote.evaluate_parts(CAST, Frame({face: 1.0}, {"neutral": 1.0}, {TONGUE: 1.0}))["tongue"]
        tip = tongue[tongue[:, 2] > tongue[:, 2].max() - 0.004]
        return float(np.ptp(tip[:, 1]))

    assert gap({TONGUE: 1.0}) >= height() - 0.001


def test_in_a_region_the_mix_that_shows_there_counts() -> None:
    channels = {"jawOpen": 1.0, "eyeBlinkLeft": 1.0}
    frame = Frame({"generic": 1.0}, {"sleepy": 1.0}, channels, regions={"mouth": {"shout": 1.0}})
    added = saturate(CAST.expressions, frame, channels)
    shouts = saturate(CAST.expressions, replace(frame, expressions={"shout": 1.0}), channels)
    assert added["jawOpen"] == shouts["jawOpen"]
    assert added["eyeBlinkLeft"] == saturate(CAST.expressions, replace(frame, regions={}), channels)["eyeBlinkLeft"]


def test_a_unit_wears_itself_and_neutral_wears_nothing() -> None:
    jaw = CAST.expressions["jawOpen"]
    assert worn_share(jaw, jaw) == pytest.approx(1.0)
    assert worn_share(jaw, CAST.expressions["neutral"]) == 0.0
    half = replace(jaw, dtheta=jaw.dtheta / 2, dh=jaw.dh / 2, ratio=1.0 + (jaw.ratio - 1.0) / 2)
    assert worn_share(jaw, half) == pytest.approx(0.5)
