"""Packets in a stream of TCP: however it is cut, the same packets come out; python-osc's framing is read."""

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pythonosc import slip

from omote.inputs.osc_packet import LONGEST_PACKET, OscError, encode_message
from omote.inputs.osc_stream import Framing, LengthFraming, SlipFraming, choose_framing, require_packets

packets = st.lists(st.binary(min_size=1, max_size=20), max_size=6)
FRAMINGS = (SlipFraming, LengthFraming)


@pytest.mark.parametrize("kind", FRAMINGS)
@given(packets, st.lists(st.integers(1, 7), max_size=60))
def test_packets_come_out_however_the_stream_is_cut(kind: type[Framing], sent: list[bytes], cuts: list[int]) -> None:
    framing = kind()
    data = b"".join(kind().frame(packet) for packet in sent)
    found = list[bytes]()
    for size in [*cuts, len(data)]:
        found += framing.feed(data[:size])
        data = data[size:]
    assert found == sent


@given(st.binary(min_size=1, max_size=40))
def test_python_osc_frames_slip_as_we_do(packet: bytes) -> None:
    assert SlipFraming().feed(slip.encode(packet)) == [packet]
    assert slip.decode(SlipFraming().frame(packet)) == packet


@pytest.mark.parametrize("kind", FRAMINGS)
def test_the_first_byte_tells_the_framing(kind: type[Framing]) -> None:
    packet = encode_message("/omote/panic")
    assert isinstance(choose_framing(kind().frame(packet)), kind)


def test_a_slip_frame_may_lack_its_first_end() -> None:
    packet = encode_message("/omote/panic")
    framing = choose_framing(packet)
    assert framing.feed(packet + b"\xc0") == [packet]


@given(st.binary(min_size=1))
def test_what_does_not_begin_as_osc_does_is_no_stream_of_it(first: bytes) -> None:
    if first[:1] in (b"\0", b"\xc0", b"/", b"#"):
        assert choose_framing(first).feed(b"") == []
        return
    with pytest.raises(OscError, match="no OSC"):
        choose_framing(first)
    with pytest.raises(OscError, match="no OSC"):
        require_packets([encode_message("/omote/panic"), first])


@pytest.mark.parametrize(
    ("framing", "data", "said"),
    [
        (SlipFraming(), bytes(2 * LONGEST_PACKET + 1), "no end"),
        (SlipFraming(), b"\xdbx\xc0", "ESC byte"),
        (LengthFraming(), struct.pack(">i", LONGEST_PACKET + 1), "is announced"),
        (LengthFraming(), struct.pack(">i", -1), "is announced"),
    ],
)
def test_a_stream_that_cannot_be_read_on_is_rejected(framing: Framing, data: bytes, said: str) -> None:
    with pytest.raises(OscError, match=said):
        framing.feed(data)
