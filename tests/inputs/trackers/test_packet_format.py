"""Packets by their first bytes: each protocol's is known, and what comes to a wrong port is told where it goes."""

from itertools import product

import numpy as np
import pytest

from omote.inputs.osc_packet import encode_message
from omote.inputs.trackers.packet_format import explain_format, is_read_by, recognize_format
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.model.cast import Cast
from tests.inputs.trackers.packets import motion_schema
from tests.inputs.trackers.test_tracker_input import FACES, Stage

PROTOCOLS = ("vmc", "livelink", "ifacialmocap", "openseeface", "vtubestudio", "mediapipe")
"""Those whose packets no other protocol reads."""


@pytest.mark.parametrize("protocol", TRACKER_PROTOCOLS)
def test_a_packet_of_every_protocol_is_recognized(protocol: str) -> None:
    name = recognize_format(FACES[protocol]())
    assert name in TRACKER_PROTOCOLS
    assert is_read_by(name, protocol)


def test_other_beginnings_are_recognized_and_what_is_none_is_not() -> None:
    assert recognize_format(encode_message("/VMC/Ext/OK", 1)) == "vmc"
    assert recognize_format(motion_schema(["jawOpen"])) == "ifacialmocap"
    assert recognize_format(b' {"apiName":"VTubeStudioPublicAPI"}') == "vtubestudio-pc"
    for other in (b"", b"hello", b"{}", encode_message("/omote/one/face", "broad"), b"\x06\xff\xff\xff\xff"):
        assert recognize_format(other) == ""


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_what_comes_to_a_wrong_port_is_named_with_where_it_goes(cast: Cast, protocol: str) -> None:
    """Also where its own packets have come before."""
    for sent, before in product(PROTOCOLS, (False, True)):
        stage = Stage(cast, protocol)
        if before:
            stage.play(0.0, FACES[protocol]())
        stage.play(0.0, FACES[sent]())
        reason = "" if stage.trackers.last_rejection is None else stage.trackers.last_rejection.reason
        assert reason == ("" if sent == protocol else explain_format(sent))
        assert sent == protocol or TRACKER_PROTOCOLS[sent].title in reason


def test_the_port_is_the_one_where_it_is_heard_or_its_usual_one() -> None:
    assert "port 39539" in explain_format("vmc")
    assert "--listen vmc" in explain_format("vmc")
    assert "port 22739" in explain_format("vmc", 22739)
    assert "--listen" not in explain_format("vmc", 22739)
    assert "WebSocket" in explain_format("mediapipe")


def test_a_wrong_value_of_its_own_protocol_keeps_its_reason(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    stage.play(0.0, encode_message("/VMC/Ext/Blend/Val", "JawOpen", "wide"))
    assert stage.trackers.last_rejection is not None
    assert "JawOpen" in stage.trackers.last_rejection.reason


def test_a_long_text_in_place_of_a_name_is_cut_with_its_quotes_shut(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    stage.play(0.0, encode_message("/VMC/Ext/Blend/Val", "x" * 200, 0.5))
    stage.play(0.0, encode_message("/VMC/Ext/Blend/Val", b"y" * 200, 0.5))
    assert stage.trackers.last_rejection is not None
    assert stage.trackers.last_rejection.reason.endswith(f"has {b'y' * 36!r} where a name is expected")


def test_no_bytes_break_it() -> None:
    generator = np.random.default_rng(7)
    for size in generator.integers(0, 4000, 500):
        assert recognize_format(generator.bytes(int(size))) in {"", *TRACKER_PROTOCOLS}
