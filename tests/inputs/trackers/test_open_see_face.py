"""Packets of OpenSeeFace, made as its tracker makes them: its head, its eyes, its features, and damage."""

import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.open_see_face import CHANNELS, NAMES, RECORD, decode_open_see_face
from omote.inputs.trackers.tracker_frame import TrackerError
from tests.inputs.trackers.packets import open_see_face

ANGLE = st.floats(-1.3, 1.3)


@given(st.tuples(ANGLE, ANGLE, ANGLE), st.tuples(st.floats(-0.6, 0.6), st.floats(-0.5, 0.5)))
def test_head_and_eyes_turn_as_ours_do(head: tuple[float, float, float], gaze: tuple[float, float]) -> None:
    (frame,) = decode_open_see_face(open_see_face(head, gaze))
    assert frame.head == pytest.approx(head, abs=1e-3)
    assert frame.gaze == pytest.approx(gaze, abs=1e-3)


def test_lids_and_features_become_the_nearest_coefficients() -> None:
    features = {"mouth_open": 0.7, "mouth_corner_updown_l": -0.4, "eyebrow_updown_r": 0.5}
    (frame,) = decode_open_see_face(open_see_face(eyes=(0.25, 1.0), features=features))
    moved = {name: round(value, 6) for name, value in frame.weights.items() if abs(value) > 1e-6}
    assert moved == {
        "eyeBlinkRight": 0.75, "jawOpen": 0.7, "mouthFrownLeft": 0.4, "browOuterUpRight": 0.5, "browInnerUp": 0.25,
    }  # fmt: skip


def test_every_feature_and_coefficient_is_one() -> None:
    assert set(CHANNELS) < set(NAMES)
    assert {name for parts in CHANNELS.values() for name, _ in parts} < set(ARKIT_NAMES)


def test_each_face_is_a_performer_and_one_that_does_not_fit_is_not_seen() -> None:
    first, second = decode_open_see_face(open_see_face() + open_see_face(number=3, fitted=0))
    assert (first.subject, first.found, first.time) == ("", True, 12.5)
    assert (second.subject, second.found, second.weights) == ("face 3", False, {})


def with_number(at: int, number: float) -> bytes:
    data = bytearray(open_see_face())
    struct.pack_into("<f", data, at, number)
    return bytes(data)


@pytest.mark.parametrize("data", [b"", bytes(RECORD - 1), bytes(40 * RECORD)])
def test_packets_of_another_size_are_rejected(data: bytes) -> None:
    with pytest.raises(TrackerError, match="multiple of 1785"):
        decode_open_see_face(data)


@pytest.mark.parametrize(
    ("data", "name", "why"),
    [
        (with_number(24, math.nan), "eyeBlinkLeft", "no number"),
        (with_number(24, 9.0), "eyeBlinkLeft", "-8"),
        (with_number(33, math.nan), "head", "no quaternion"),
        (with_number(1729 + 4 * 12, 5.0), "jawOpen", "5"),
        (with_number(1729 + 4 * 12, math.nan), "jawOpen", "no number"),
    ],
)
def test_one_wrong_number_costs_itself(data: bytes, name: str, why: str) -> None:
    (frame,) = decode_open_see_face(data)
    assert len(frame.weights) >= len(decode_open_see_face(open_see_face())[0].weights) - 1
    assert (frame.head is None) == (name == "head")
    ((said, reason),) = frame.left_out
    assert said == name
    assert why in reason


def test_an_error_that_is_no_number_is_no_fit() -> None:
    assert not decode_open_see_face(with_number(29, math.nan))[0].found
    assert decode_open_see_face(with_number(889 + 12 * 66, math.nan))[0].gaze is not None  # the other eye is known
