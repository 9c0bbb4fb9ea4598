"""Frames of iFacialMocap and Facemotion3D: golden ones in both versions, and every damage is rejected."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.face_text import (
    IFACIALMOCAP_START,
    LONGEST_FRAME,
    decode_face_text,
    encode_face_text,
)
from omote.inputs.trackers.tracker_frame import TrackerError

EYES = "rightEye#5.3555145,19.067966,1.8|leftEye#5.5607924,15.616646,1.5|"
FIRST = f"eyeLookIn_R-54|jawOpen-2|browInnerUp-104|hapihapi-0|=head#-1.67,-7.30,2.88,0.08,0.03,-0.47|{EYES}"


def test_a_frame_of_the_first_version_is_read() -> None:
    (frame,) = decode_face_text(FIRST.encode())
    assert frame.weights == pytest.approx({"eyeLookIn_R": 0.54, "jawOpen": 0.02, "browInnerUp": 1.04, "hapihapi": 0.0})
    assert frame.head == pytest.approx((math.radians(-7.30), math.radians(1.67), math.radians(-2.88)))
    assert frame.gaze == pytest.approx((math.radians(17.342306), math.radians(-5.45815345)))
    assert frame.found


def test_a_frame_of_the_second_version_has_values_below_zero() -> None:
    (frame,) = decode_face_text(b"jawLeft&-12|mouthSmile_L&30.5|=head#0,0,0|")
    assert frame.weights == pytest.approx({"jawLeft": -0.12, "mouthSmile_L": 0.305})
    assert frame.gaze is None
    assert decode_face_text(b"jawLeft--12|")[0].weights == pytest.approx({"jawLeft": -0.12})


def test_loose_ends_of_real_frames_are_left_out() -> None:
    text = "mouthSmile_R-0(eyeLookOut_L-0)mouthUpperUp_L-11|jawOpen-7|1|=leftEye#1,2,3|34903,-1.6,-0.2|head#1,2,3|"
    (frame,) = decode_face_text(text.encode())
    assert frame.weights == pytest.approx({"jawOpen": 0.07})
    assert frame.head is not None


def test_a_status_of_no_tracking_is_a_loss() -> None:
    assert decode_face_text(b"jawOpen&5|trackingStatus&1|")[0].found
    frame = decode_face_text(b"jawOpen&5|trackingStatus&0|")[0]
    assert (frame.found, list(frame.weights)) == (False, ["jawOpen"])


@given(
    st.lists(st.integers(-50, 150), min_size=52, max_size=52),
    st.tuples(*[st.floats(-1.5, 1.5)] * 3),
    st.tuples(*[st.floats(-0.6, 0.6)] * 2),
)
def test_what_is_written_is_read_as_it_was(
    percents: list[int], head: tuple[float, float, float], gaze: tuple[float, float]
) -> None:
    weights = {name: percent / 100.0 for name, percent in zip(ARKIT_NAMES, percents, strict=True)}
    (frame,) = decode_face_text(encode_face_text(weights, head, gaze))
    assert frame.weights == pytest.approx(weights)
    assert frame.head == pytest.approx(head, abs=1e-6)
    assert frame.gaze == pytest.approx(gaze, abs=1e-6)


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "no coefficient"),
        (b"hello", "no coefficient"),
        (IFACIALMOCAP_START, "no coefficient"),
        (b"\xff\xfe", "no text"),
        (b"jawOpen-1|" * 300, "300 fields"),
        (b"a" * (LONGEST_FRAME + 1), "bytes, but at most"),
        (b"jawOpen&nan|", "no number"),
        (b"jawOpen&1e999|", "no number"),
        (b"jawOpen-200|", "jawOpen is 2"),
        (b"jawOpen-1|=head#1,2|", "three angles"),
        (b"jawOpen-1|=head#1,2,x|", "three angles"),
        (b"jawOpen-1|=head#1,2,nan|", "angle"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_face_text(data)
