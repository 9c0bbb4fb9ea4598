"""The gestures that there are."""

import numpy as np
import pytest

from omote.perform.gestures.gesture_curves import CURVES, GESTURES, check_gesture, mirror_channel, value_at


@pytest.mark.parametrize("name", GESTURES)
def test_a_gesture_begins_and_ends_at_nothing_without_a_jump(name: str) -> None:
    curves = CURVES[check_gesture(name)]
    for curve in (curves.yaw, curves.pitch, curves.roll, *curves.channels.values()):
        shares = np.linspace(-0.1, 1.1, 1000)
        values = [value_at(curve, share) for share in shares]
        assert values[0] == values[-1] == 0.0
        assert np.abs(np.diff(values)).max() < 0.02
        assert curve == () or np.abs(values).max() > 0.02


def test_a_nod_goes_down_and_a_shake_to_both_sides() -> None:
    pitches = [value_at(CURVES["nod"].pitch, share) for share in np.linspace(0, 1, 100)]
    yaws = [value_at(CURVES["shake"].yaw, share) for share in np.linspace(0, 1, 100)]
    assert min(pitches) < -0.2
    assert min(yaws) < -0.1 < 0.1 < max(yaws)


def test_sides_are_mirrored() -> None:
    assert [mirror_channel(name) for name in ("eyeBlinkLeft", "eyeBlinkRight", "jawOpen")] == [
        "eyeBlinkRight", "eyeBlinkLeft", "jawOpen",
    ]  # fmt: skip


def test_rejects_a_gesture_that_there_is_not() -> None:
    with pytest.raises(ValueError, match="gesture 'dance'"):
        check_gesture("dance")
