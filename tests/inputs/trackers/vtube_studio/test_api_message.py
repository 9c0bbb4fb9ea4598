"""Messages of VTube Studio's API as its documentation writes them, and damage."""

import json

import pytest

from omote.inputs.trackers.tracker_frame import TrackerError
from omote.inputs.trackers.vtube_studio.api_message import (
    Announcement,
    decode_announcement,
    decode_message,
    encode_request,
)

ANNOUNCED = b"""{
	"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "timestamp": 1630159656406,
	"messageType": "VTubeStudioAPIStateBroadcast", "requestID": "VTubeStudioAPIStateBroadcast",
	"data": {"active": false, "port": 8001, "instanceID": "93aa0d0494304fddb057ae8a295c4e59",
	"windowTitle": "VTube Studio"}
}"""
STATE = b"""{
	"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "timestamp": 1625405710728,
	"messageType": "APIStateResponse", "requestID": "MyIDWithLessThan64Characters",
	"data": {"active": true, "vTubeStudioVersion": "1.9.0", "currentSessionAuthenticated": false}
}"""


def test_an_announcement_says_where_it_runs() -> None:
    assert decode_announcement(ANNOUNCED) == Announcement(active=False, port=8001, window_title="VTube Studio")
    assert decode_announcement(STATE) is None
    assert decode_announcement(ANNOUNCED.replace(b"8001", b"80010")) is None
    assert decode_announcement(b"{}") is None


def test_an_answer_is_read_with_fields_that_are_new() -> None:
    message = decode_message(STATE)
    assert (message.message_type, message.request_id) == ("APIStateResponse", "MyIDWithLessThan64Characters")


def test_a_request_has_what_the_api_asks_for() -> None:
    request = json.loads(encode_request("FaceFoundRequest"))
    assert request == {
        "apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "requestID": "omote", "messageType": "FaceFoundRequest",
        "data": {},
    }  # fmt: skip


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"hello", "none of VTube Studio"),
        (b"[" * 100_000, "none of VTube Studio"),
        (b"\xff\xfe", "none of VTube Studio"),
        (b'{"apiName":"Other","messageType":"APIError"}', "of the API 'Other'"),
        (b" " * 1_100_000, "has 1100000 bytes"),
    ],
)
def test_what_is_no_message_is_rejected(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_message(data)
