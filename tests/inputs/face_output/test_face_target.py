"""Where a face is sent, as it is typed, and its packets: read back by our own decoders."""

import pytest

from omote.inputs.face_output.face_target import FaceTarget, encode_face, read_targets
from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS, ARKIT_NAMES
from omote.inputs.trackers.live_link_face import decode_live_link_face
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.vmc_messages import VmcDecoder
from omote.model.cast import Cast
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetGaze, SetHead
from omote.show.objects.link import Hello
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession

WEIGHTS = {name: index / 64.0 for index, name in enumerate(ARKIT_NAMES)}


def read(protocol: str, packets: list[bytes]) -> TrackerFrame:
    """The frame that packets are read as."""
    decode = VmcDecoder().decode if protocol == "vmc" else decode_live_link_face
    return [frame for packet in packets for frame in decode(packet)][-1]


@pytest.fixture
def character(cast: Cast) -> CharacterState:
    """A character that looks aside."""
    session = ShowSession(cast)
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    session.receive("console", SetHead("one", 0.3, -0.2, 0.1), 0.0)
    session.receive("console", SetGaze("one", 0.2, 0.1), 0.0)
    return session.tick(0.0).characters["one"]


@pytest.mark.parametrize("protocol", ["vmc", "livelink"])
def test_what_is_sent_is_what_is_on_air(character: CharacterState, protocol: str) -> None:
    frame = read(protocol, encode_face(FaceTarget(protocol, "host", 1), character, WEIGHTS, 2.5))
    found = {channel: value for name, value in frame.weights.items() for channel in ARKIT_CHANNELS.find(name)}
    assert found == pytest.approx(WEIGHTS)
    assert frame.head == pytest.approx((0.3, -0.2, 0.1), abs=1e-5)
    yaw, pitch, other_yaw, other_pitch = character.eyes
    assert frame.gaze == pytest.approx(((yaw + other_yaw) / 2, (pitch + other_pitch) / 2), abs=1e-5)
    assert frame.time == pytest.approx(2.5)


def test_vmc_is_sent_by_the_names_of_perfect_sync_and_live_link_by_the_character_s(
    character: CharacterState,
) -> None:
    vmc = read("vmc", encode_face(FaceTarget("vmc", "host", 1), character, WEIGHTS, 0.0))
    assert "EyeBlinkLeft" in vmc.weights
    link = read("livelink", encode_face(FaceTarget("livelink", "host", 1), character, WEIGHTS, 0.0))
    assert link.subject == character.label
    assert encode_face(FaceTarget("osc", "host", 1), character, WEIGHTS, 0.0) == []


def test_targets_are_read_as_they_are_typed() -> None:
    assert read_targets(" ") == ()
    typed = read_targets("VMC:10.0.0.5, livelink:unreal.local:12000=dog,osc:10.0.0.6")
    assert typed == (
        FaceTarget("vmc", "10.0.0.5", 39539),
        FaceTarget("livelink", "unreal.local", 12000, "dog"),
        FaceTarget("osc", "10.0.0.6", 9001),
    )
    assert read_targets(",".join(target.word for target in typed)) == typed


@pytest.mark.parametrize(
    ("text", "why"),
    [("vcm:10.0.0.5", "vmc"), ("vmc", "no receiver"), ("vmc:=dog", "no receiver"), ("vmc:a:b", "is b; give"),
     ("vmc:a:0", "from 1 to 65535"), ("vmc:a:70000", "is 70000; give"), ("vmc:a:", "left out"),
     ("vmc:a,,", "way to send"), ("nosuch:a", "there are vmc, livelink, vtubestudio-pc, osc")],
)  # fmt: skip
def test_what_is_no_target_is_said(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_targets(text)
