"""Frames of iFacialMocap and Facemotion3D: golden ones in both versions, those of strangers, and damage."""

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


COMMAS = "jawLeft-{minus}12,5|jawOpen-40|={head}|rightEye#5,3,0,35,0|leftEye#6,9,{minus}3,1,0|"


@pytest.mark.parametrize("minus", ["-", "\u2212"], ids=["hyphen", "minus"])
@pytest.mark.parametrize(
    ("head", "expected"),
    [
        ("head#-21,4,6,03,-6,6,0,1,0,2,0,65", (6.03, 21.4, 6.6)),
        ("HEAD # -21,4 , 6,25,0,0,1,0,2,0,65", (6.25, 21.4, 0.0)),
        ("head#1,2,3,4,5,6", None),
        ("head#1,2,3,4,5,6,7", None),
    ],
)
def test_commas_before_decimals_are_read_where_they_can_be_told(
    minus: str, head: str, expected: tuple[float, ...] | None
) -> None:
    """What could be one number or two is left out: six of a head are its numbers, or three with decimals."""
    text = COMMAS.format(minus=minus, head=head.replace("-", minus))
    (frame,) = decode_face_text(text.encode())
    assert frame.weights == pytest.approx({"jawLeft": -0.125, "jawOpen": 0.4})
    assert frame.gaze == pytest.approx((math.radians(-1.375), math.radians(-6.1)))
    if expected is None:
        assert frame.head is None
        assert [name for name, _ in frame.left_out] == ["head"]
    else:
        assert frame.head == pytest.approx(tuple(map(math.radians, expected)))


@pytest.mark.parametrize(
    "text",
    [
        "\ufeffjawOpen&25|eyeBlink_L&50|=head#0,10,0|\r\n",
        " jawOpen & 25 | eyeBlink_L &50|= Head # 0 , 10.0 , 0 |\n",
        "=head#0,10,0|eyeBlink_L-50|jawOpen-25|",
        "jawOpen-25|head#0,10,0|eyeBlink_L-50",
        "jawOpen-25|name-J\u00fcrgen|eyeBlink_L-50|=head#0,10,0",
        "jawOpen-25|jawOpen|3|eyeBlink_L-50|=HEAD#0,10,0",
    ],
)
def test_frames_as_strangers_write_them_are_read(text: str) -> None:
    for data in (text.encode(), text.encode("utf-16"), text.encode("latin-1", "ignore")):
        (frame,) = decode_face_text(data)
        assert frame.weights == pytest.approx({"jawOpen": 0.25, "eyeBlink_L": 0.5})
        assert frame.head == pytest.approx((math.radians(10), 0.0, 0.0))


@pytest.mark.parametrize(
    ("data", "name", "why"),
    [
        (b"jawOpen&nan|smile&10|=head#1,2,3|", "jawOpen", "no number"),
        (b"jawOpen&1e999|smile&10|=head#1,2,3|", "jawOpen", "no number"),
        (b"jawOpen&wide|smile&10|=head#1,2,3|", "jawOpen", "'wide', which is no number"),
        (b"smile&10|=head#1,2|", "head", "three angles"),
        (b"smile&10|=head#1,2,x|", "head", "three angles"),
        (b"smile&10|=head#1,2,nan|", "head", "angle"),
    ],
)
def test_what_is_no_number_costs_itself(data: bytes, name: str, why: str) -> None:
    (frame,) = decode_face_text(data)
    assert frame.weights == pytest.approx({"smile": 0.1})
    assert (frame.head is None) == (name == "head")
    assert [said for said, reason in frame.left_out if why in reason] == [name]


def test_a_value_that_is_far_too_large_is_at_its_end() -> None:
    (frame,) = decode_face_text(b"jawOpen-200|smile-10|")
    assert frame.weights == pytest.approx({"jawOpen": 1.5, "smile": 0.1})


def test_many_fields_keep_none_of_a_face_out() -> None:
    (frame,) = decode_face_text(b"".join(b"n%d-1|" % number for number in range(600)) + b"jawOpen-40|")
    assert frame.weights["jawOpen"] == pytest.approx(0.4)


def test_a_packet_that_is_cut_loses_its_last_field() -> None:
    (frame,) = decode_face_text(b"smile-10|jawOpen-8", cut=True)
    assert frame.weights == pytest.approx({"smile": 0.1})
    assert "ends within 'jawOpen-8'" in frame.left_out[0].reason


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "no coefficient"),
        (b"hello", "no coefficient"),
        (IFACIALMOCAP_START, "no coefficient"),
        (b"\xff\xfe", "no text"),
        (bytes(range(128, 200)), "no text"),
        (b"a" * (LONGEST_FRAME + 1), "bytes, but at most"),
    ],
)
def test_what_is_no_frame_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_face_text(data)
