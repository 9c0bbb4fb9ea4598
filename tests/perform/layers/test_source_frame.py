"""A frame of a source is checked."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.channels import GAZE_UNITS
from omote.perform.frame import Gaze, Head
from omote.perform.layers.source_frame import SourceFrame, check_frame, check_names, source_frame, with_gaze_of_units
from omote.perform.limits import GAZE_LIMITS


def test_what_cannot_be_driven_is_refused_by_name(cast: Cast) -> None:
    with pytest.raises(ValueError, match=r"there is no channel 'jawopen' in this cast; near are jawOpen"):
        check_names(["jawopen"], cast.expressions)
    with pytest.raises(ValueError, match=r"there is no channel 'neutral'"):
        check_names(["neutral"], cast.expressions)
    with pytest.raises(ValueError, match=r"names a channel twice"):
        check_names(["smile", "smile"], cast.expressions)
    with pytest.raises(ValueError, match=r"the channel smile is 2.0; give a number from -0.5 to 1.5"):
        source_frame(cast.expressions, {"smile": 2.0}, None, None)
    with pytest.raises(ValueError, match=r"the gaze's yaw \(radians; 40 degrees at most\) is 1.0"):
        source_frame(cast.expressions, {}, None, (1.0, 0.0))
    with pytest.raises(ValueError, match=r"smile of the layer tracker is no number \(NaN\)"):
        check_frame(SourceFrame(("smile",), np.array([np.nan])), "tracker")
    with pytest.raises(ValueError, match=r"2 values came for 1 channels; send one for each"):
        check_frame(SourceFrame(("smile",), np.zeros(2), gaze=Gaze()), "tracker")


@pytest.mark.parametrize(
    "given", [(0.1, 0.2), (0.1, 0.2, 0.3, 0.4), (), 0.1, "abc"], ids=["two", "four", "none", "one", "text"]
)
def test_a_head_has_three_angles_and_a_gaze_two(cast: Cast, given: object) -> None:
    with pytest.raises(ValueError, match=r"the head is .* give yaw, pitch, roll, radians"):
        source_frame(cast.expressions, {}, given, None)  # type: ignore[arg-type]
    if given != (0.1, 0.2):
        with pytest.raises(ValueError, match=r"the gaze is .* give yaw, pitch, radians"):
            source_frame(cast.expressions, {}, None, given)  # type: ignore[arg-type]


def test_weights_come_by_name(cast: Cast) -> None:
    with pytest.raises(TypeError, match="the channels are a list; give weights by name"):
        source_frame(cast.expressions, [0.1], None, None)  # type: ignore[arg-type]


def test_angles_may_come_as_an_array(cast: Cast) -> None:
    frame = source_frame(cast.expressions, {}, np.array([0.1, 0.2, 0.0]), None)  # type: ignore[arg-type]
    assert frame.head == Head(0.1, 0.2, 0.0)


def eyes(**weights: float) -> SourceFrame:
    """A frame of all coefficients of the eyes."""
    values = {**dict.fromkeys(GAZE_UNITS, 0.0), **weights}
    return SourceFrame(tuple(values), np.array(list(values.values())))


@given(st.floats(0.0, 0.6), st.floats(0.0, 0.6), st.booleans(), st.booleans())
def test_coefficients_of_the_eyes_turn_them_as_far_as_the_angles_of_the_device(
    side: float, height: float, left: bool, up: bool
) -> None:
    yaw = {"eyeLookOutLeft": side, "eyeLookInRight": side} if left else {"eyeLookInLeft": side, "eyeLookOutRight": side}
    pitch = {f"eyeLook{'Up' if up else 'Down'}{one}": height for one in ("Left", "Right")}
    gaze = with_gaze_of_units(eyes(**yaw, **pitch)).gaze
    assert gaze is not None
    assert gaze.yaw == pytest.approx(math.radians(35.0) * side * (1 if left else -1))
    assert gaze.pitch == pytest.approx(math.radians(25.0 if up else -35.0) * height)


def test_angles_that_a_source_sends_stay_and_some_coefficients_are_no_gaze() -> None:
    sent = replace(eyes(eyeLookUpLeft=1.0), gaze=Gaze(0.1, 0.0))
    assert with_gaze_of_units(sent) is sent
    some = SourceFrame(("eyeLookUpLeft", "jawOpen"), np.ones(2))
    assert with_gaze_of_units(some) is some
    far = dict.fromkeys(("eyeLookOutLeft", "eyeLookInRight", "eyeLookDownLeft", "eyeLookDownRight"), 1.5)
    assert with_gaze_of_units(eyes(**far)).gaze == Gaze(GAZE_LIMITS["yaw"], -GAZE_LIMITS["pitch"])
