"""Messages of the camera page: each is told from the others, and none begins as landmarks do."""

import msgspec
import pytest

from omote.inputs.camera.landmark_frame import LandmarkFrame, write_landmark_frame
from omote.inputs.performers import camera_messages as wire


def test_every_message_comes_back_and_is_no_frame() -> None:
    for message in (
        wire.Perform(1, "Ada"),
        wire.PlayCharacters(["one"]),
        wire.HandFrame(1.5, True, {"jawOpen": 0.5}, (0.1, 0.0, -0.1)),
        wire.PlayHand(["one"], ["mouth", "head"]),
        wire.BeginGuide(),
        wire.RedoStep("aa"),
        wire.UseFaces(),
    ):
        data = msgspec.msgpack.encode(message)
        assert msgspec.msgpack.decode(data, type=wire.FromCamera) == message
        assert not data.startswith(write_landmark_frame(LandmarkFrame(None, 640, 480, 0.0))[:4])


def test_messages_have_names_of_their_own() -> None:
    tags = [each.__struct_config__.tag for each in (*wire.CAMERA_MESSAGES, *wire.CAMERA_ANSWERS)]
    assert len(set(tags)) == len(tags)


@pytest.mark.parametrize(
    "document",
    [
        {"type": "perform", "name": 1},
        {"type": "dance"},
        {"type": "redo_step"},
        {"type": "play_hand", "characters": ["one"], "regions": ["ear"]},
    ],
)
def test_what_is_no_message_is_rejected(document: dict[str, object]) -> None:
    with pytest.raises(msgspec.ValidationError):
        msgspec.msgpack.decode(msgspec.msgpack.encode(document), type=wire.FromCamera)
