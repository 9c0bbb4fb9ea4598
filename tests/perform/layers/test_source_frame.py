"""A frame of a source is checked."""

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.frame import Gaze, Head
from omote.perform.layers.source_frame import SourceFrame, check_frame, check_names, source_frame


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
