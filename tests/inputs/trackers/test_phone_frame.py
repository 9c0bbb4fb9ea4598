"""Frames of VTube Studio and MeowFace: golden ones, and every damage is rejected."""

import json
import math
from typing import Any

import pytest

from omote.inputs.trackers.phone_frame import decode_phone_frame, request_frames
from omote.inputs.trackers.tracker_frame import TrackerError

FRAME: dict[str, Any] = {
    "Timestamp": 1664817520079,
    "Hotkey": -1,
    "FaceFound": True,
    "Rotation": {"x": -11.0, "y": 9.5, "z": 3.0},
    "Position": {"x": 0.5, "y": 1.3, "z": 4.7},
    "EyeLeft": {"x": 3.5, "y": 9.0, "z": 0.5},
    "EyeRight": {"x": 3.5, "y": 13.0, "z": 0.7},
    "BlendShapes": [{"k": "EyeLookOutLeft", "v": 0.26}, {"k": "JawOpen", "v": 0.1}],
    "Future": [1, 2],
}


def packet(**changed: Any) -> bytes:
    return json.dumps({**FRAME, **changed}).encode()


def test_a_golden_frame_is_read() -> None:
    (frame,) = decode_phone_frame(packet())
    assert frame.weights == {"EyeLookOutLeft": 0.26, "JawOpen": 0.1}
    assert frame.head == pytest.approx((math.radians(9.5), math.radians(11.0), math.radians(-3.0)))
    assert frame.gaze == pytest.approx((math.radians(11.0), math.radians(-3.5)))  # to the left, as the coefficient says
    assert frame.time == pytest.approx(1664817520.079)


def test_a_lost_face_is_a_loss_whatever_else_is_there() -> None:
    (frame,) = decode_phone_frame(packet(FaceFound=False))
    assert (frame.found, frame.weights, frame.head) == (False, {}, None)


def test_the_halves_of_meowface_s_inner_brow_become_one() -> None:
    halves = [{"k": "browInnerUpLeft", "v": 0.2}, {"k": "browInnerUpRight", "v": 0.6}, {"k": "jawOpen", "v": 0.5}]
    (frame,) = decode_phone_frame(packet(BlendShapes=halves))
    assert frame.weights == pytest.approx({"jawOpen": 0.5, "browInnerUp": 0.4})


def test_what_is_not_sent_is_left_out() -> None:
    (frame,) = decode_phone_frame(b'{"BlendShapes":[{"k":"JawOpen","v":1}]}')
    assert (frame.weights, frame.head, frame.gaze, frame.time) == ({"JawOpen": 1.0}, None, None, None)


def test_a_request_names_our_port() -> None:
    asked = json.loads(request_frames(11125))
    assert (asked["messageType"], asked["ports"]) == ("iOSTrackingDataRequest", [11125])
    assert 0.5 <= asked["time"] <= 10.0
    assert 1 <= len(asked["sentBy"]) <= 64


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "no frame"),
        (b"[]", "no frame"),
        (b"{}", "BlendShapes"),
        (b"\xff", "no frame"),
        (b"[" * 100_000, "no frame"),
        (packet(BlendShapes=3), "no frame"),
        (packet()[:-20], "no frame"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_phone_frame(data)


@pytest.mark.parametrize(
    "data",
    [
        packet().replace(b"0.26", b"0,26").replace(b"9.5", b"9,5").replace(b"0.1}", b"0,1}"),
        b"\xef\xbb\xbf" + packet() + b"\r\n",
        packet().replace(b"BlendShapes", b"blendShapes").replace(b"Rotation", b"rotation").replace(b"Eye", b"eye"),
        packet(BlendShapes=[{"K": "EyeLookOutLeft", "V": "0,26"}, {"K": "JawOpen", "V": "0.1"}]),
        packet(BlendShapes={"EyeLookOutLeft": 0.26, "JawOpen": 0.1}),
        packet(BlendShapes=[*FRAME["BlendShapes"], {"k": None, "v": 1}, 7]),
    ],
    ids=["commas", "mark", "case", "text", "object", "others"],
)
def test_a_frame_as_strangers_write_it_is_read_alike(data: bytes) -> None:
    (frame,) = decode_phone_frame(data)
    (golden,) = decode_phone_frame(packet())
    assert {name.lower(): value for name, value in frame.weights.items()} == {"eyelookoutleft": 0.26, "jawopen": 0.1}
    assert (frame.head, frame.gaze, frame.left_out) == (golden.head, golden.gaze, ())


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), None, "wide", [1]])
def test_a_value_that_is_no_number_costs_itself(wrong: object) -> None:
    shapes = [{"k": "JawOpen", "v": wrong}, {"k": "CheekPuff", "v": 0.5}]
    (frame,) = decode_phone_frame(packet(BlendShapes=shapes, EyeLeft={"x": wrong, "y": 1.0, "z": 0.0}))
    assert (frame.weights, frame.gaze) == ({"CheekPuff": 0.5}, None)
    assert frame.head is not None
    assert {name for name, _ in frame.left_out} == {"JawOpen", "gaze"}


def test_long_names_and_many_of_them_keep_none_of_a_face_out() -> None:
    shapes = [{"k": f"{'x' * 81}{number}", "v": 9} for number in range(300)]
    (frame,) = decode_phone_frame(packet(BlendShapes=[*shapes, {"k": "JawOpen", "v": 3}]))
    assert frame.weights["JawOpen"] == 1.5
