"""Recordings from packets of trackers: which protocol it is, times, names, and what was not sent."""

import pytest

from omote.inputs.takes.packet_capture import Packet
from omote.inputs.takes.packet_take import choose_protocol, read_packet_take
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import encode_vmc
from tests.inputs.trackers.packets import live_link_face, motion_frame, motion_schema

HOST = "10.0.0.7"


def vmc(time: float, host: str = HOST, port: int = 39539, **weights: float) -> list[Packet]:
    return [Packet(time, host, port, data) for data in encode_vmc(weights, (0.3, 0.0, 0.0), (0.0, 0.0), time)]


def test_frames_keep_their_times_and_what_one_lacks() -> None:
    packets = [*vmc(10.0, JawOpen=0.25, A=0.9), *vmc(10.5, JawOpen=0.5), *vmc(11.0, BrowInnerUp=1.0)]
    take = read_packet_take(packets, TRACKER_PROTOCOLS["vmc"])
    assert take.times == [0.0, 0.5, 1.0]
    assert set(take.names) == {"jawOpen", "browInnerUp"}
    column = take.names.index("jawOpen")
    assert [row[column] for row in take.values] == pytest.approx([0.63, 0.63, 0.63])  # 0.7 of the vowel is the larger
    assert take.head(2) == pytest.approx((0.3, 0.0, 0.0), abs=1e-6)
    assert take.gaze(0) is None


def test_what_is_left_out_is_among_its_notes() -> None:
    packets = [*vmc(0.0, JawOpen=1.75, HeartRate=72.0), Packet(0.1, HOST, 39539, b"hello"), *vmc(0.2, JawOpen=0.5)]
    take = read_packet_take(packets, TRACKER_PROTOCOLS["vmc"])
    assert list(take.values) == [(1.5,), (0.5,)]
    assert take.notes[0].startswith("a packet is left out: a message begins with")
    assert list(take.notes[1:]) == ["JawOpen is 1.75, so 1.5 is taken (1 times)"]


def test_the_sender_that_sent_most_counts_and_times_never_fall() -> None:
    packets = [*vmc(1.0, JawOpen=0.25), *vmc(0.5, JawOpen=0.5), *vmc(2.0, "10.0.0.8", JawOpen=1.0)]
    take = read_packet_take(packets, TRACKER_PROTOCOLS["vmc"])
    assert (take.times, [row[0] for row in take.values]) == ([0.0, 0.0], [0.25, 0.5])


def test_a_binary_protocol_is_read_with_its_names() -> None:
    packets = [Packet(0.0, HOST, 49983, motion_schema(["jawOpen"])), Packet(0.1, HOST, 49983, motion_frame((50,)))]
    assert read_packet_take(packets, choose_protocol(packets)).values == [(0.5,)]


def test_the_protocol_is_that_of_the_port_or_the_one_that_is_named() -> None:
    live = [Packet(0.0, HOST, 11111, live_link_face([0.5] * 61))]
    other = [Packet(0.0, HOST, 5000, b"")] * 5
    assert choose_protocol([*other, *live]).name == "livelink"
    assert choose_protocol([Packet(0.0, HOST, 0, b"")]).name == "vmc"
    assert choose_protocol(other, "OpenSeeFace").name == "openseeface"
    with pytest.raises(ValueError, match="--protocol vmc"):
        choose_protocol(other)
    with pytest.raises(ValueError, match="tracker"):
        choose_protocol(live, "vcm")


def test_packets_at_another_port_are_read_by_what_they_are() -> None:
    assert choose_protocol(vmc(0.0, port=5000, JawOpen=0.5)).name == "vmc"


def test_packets_of_another_protocol_are_named() -> None:
    with pytest.raises(ValueError, match=r"no packet .* is a face of Live Link Face: they are VMC, --protocol vmc"):
        read_packet_take(vmc(0.0, JawOpen=0.5), TRACKER_PROTOCOLS["livelink"])


def test_packets_that_are_no_face_are_said() -> None:
    with pytest.raises(ValueError, match=r"no packet of the capture is a face of VMC: a message begins"):
        read_packet_take([Packet(0.0, HOST, 39539, b"hello")], TRACKER_PROTOCOLS["vmc"])
