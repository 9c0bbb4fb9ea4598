"""A packet at the port of another protocol is known by its beginning, and told where to go."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.takes.packet_capture import Packet
from omote.inputs.takes.packet_take import read_packet_take
from omote.inputs.trackers.packet_recognition import explain_protocol, explain_wrong_port
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.model.cast import Cast
from tests.inputs.trackers.test_tracker_input import FACES, Stage

SENT = {name: FACES[name] for name in ("vmc", "livelink", "ifacialmocap", "vtubestudio")}


@pytest.mark.parametrize("sent", SENT)
@pytest.mark.parametrize("heard", ["vmc", "livelink", "ifacialmocap", "vtubestudio", "openseeface"])
def test_it_is_told_by_its_own_name_and_never_to_its_own_port(sent: str, heard: str) -> None:
    wanted = "" if sent == heard else explain_protocol(sent)
    assert explain_wrong_port(SENT[sent](), TRACKER_PROTOCOLS[heard]) == wanted


def test_those_that_speak_alike_are_not_told_apart() -> None:
    for sent, heard in (("vmc", "vmc-performer"), ("ifacialmocap", "facemotion3d-tcp"), ("vtubestudio", "meowface")):
        assert explain_wrong_port(SENT[sent](), TRACKER_PROTOCOLS[heard]) == ""


@given(st.binary(max_size=80))
def test_any_bytes_are_answered(data: bytes) -> None:
    for protocol in TRACKER_PROTOCOLS.values():
        explain_wrong_port(data, protocol)


def test_an_operator_and_a_take_are_told(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    stage.play(0.0, SENT["vmc"]())
    rejection = stage.trackers.last_rejection
    assert rejection is not None
    assert rejection.reason == explain_protocol("vmc")
    with pytest.raises(ValueError, match="this is VMC"):
        read_packet_take([Packet(0.0, "10.0.0.7", 11111, SENT["vmc"]())], TRACKER_PROTOCOLS["livelink"])
