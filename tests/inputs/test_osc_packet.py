"""Packets of OSC: what we write and what python-osc writes is read alike, and nothing else gets through."""

import math
import struct
from typing import cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pythonosc.osc_bundle_builder import OscBundleBuilder
from pythonosc.osc_message import OscMessage as OtherMessage
from pythonosc.osc_message_builder import ArgValue, OscMessageBuilder

from omote.inputs.osc_packet import (
    BUNDLE,
    LONGEST_PACKET,
    MOST_BUNDLES,
    MOST_MESSAGES,
    Argument,
    OscError,
    OscMessage,
    decode_packet,
    encode_bundle,
    encode_message,
)

texts = st.text(st.characters(exclude_characters="\0", exclude_categories=["Cs"]), max_size=12)
addresses = texts.map(lambda text: f"/{text}")
arguments = st.lists(
    st.one_of(
        st.integers(-(2**31), 2**31 - 1), st.floats(width=32, allow_nan=False), texts, st.booleans(), st.none(),
        st.binary(min_size=1, max_size=9),
    ),
    max_size=6,
)  # fmt: skip
PACKET = encode_bundle([encode_message("/omote/one/face", "dog", 0.5), encode_message("/omote/one/head", 1, 2.0, "3")])


@given(addresses, arguments)
def test_what_is_written_is_read(address: str, given: list[Argument]) -> None:
    assert decode_packet(encode_message(address, *given)) == [OscMessage(address, tuple(given))]


@given(addresses, arguments)
def test_python_osc_reads_what_we_write_and_we_what_it_writes(address: str, given: list[Argument]) -> None:
    ours = OtherMessage(encode_message(address, *given))
    assert (ours.address, ours.params) == (address, given)
    builder = OscMessageBuilder(address)
    for argument in given:
        builder.add_arg(cast(ArgValue, argument))
    assert decode_packet(builder.build().dgram) == [OscMessage(address, tuple(given))]


def test_bundles_within_bundles_come_in_their_order_whatever_their_time() -> None:
    inner = OscBundleBuilder(2_000_000_000)  # in the year 2033
    outer = OscBundleBuilder(1)
    for builder, names in ((inner, "bc"), (outer, "a")):
        for name in names:
            builder.add_content(OscMessageBuilder(f"/{name}").build())
    outer.add_content(inner.build())
    outer.add_content(OscMessageBuilder("/d").build())
    assert [message.address for message in decode_packet(outer.build().dgram)] == ["/a", "/b", "/c", "/d"]


def test_all_types_of_osc_1_0_are_read() -> None:
    data = b"/a\0\0,hdtcrmSTFNI[i]\0" + struct.pack(">qdQIIi", -5, 0.25, 1, 65, 7, 9) + b"abc\0" + struct.pack(">i", 3)
    assert decode_packet(data) == [OscMessage("/a", (-5, 0.25, 1, 65, 7, 9, "abc", True, False, None, True, 3))]


def test_a_message_of_before_1_0_has_no_tags() -> None:
    assert decode_packet(b"/panic\0\0") == [OscMessage("/panic")]


@pytest.mark.parametrize(
    ("packet", "said"),
    [
        (b"", "begins with b''"),
        (b"one\0", "expected an address"),
        (b"/a\0", "four zero bytes"),
        (b"/a\0x", "four zero bytes"),
        (b"/\xff\0\0", "not UTF-8"),
        (b"/a\0\0ifs\0", "expected a comma"),
        (b"/a\0\0,i\0\0\0\0", "ends within a number"),
        (b"/a\0\0,q\0\0", "'q', which OSC 1.0 does not know"),
        (b"/a\0\0,T\0\0more", "4 bytes more"),
        (b"/a\0\0,b\0\0\x7f\xff\xff\xff", "a blob has 2147483647 bytes"),
        (b"/a\0\0,b\0\0\xff\xff\xff\xff", "a blob has -1 bytes"),
        (BUNDLE + bytes(4), "within its time tag"),
        (BUNDLE + bytes(8) + struct.pack(">i", 400), "has 400 bytes, which are not there"),
        (BUNDLE + bytes(8) + struct.pack(">i", -4), "has -4 bytes"),
        (BUNDLE + bytes(8) + b"\0", "ends within a number"),
        (bytes(LONGEST_PACKET + 1), "at most 65507 are read"),
        (encode_bundle([b"/a\0\0"] * (MOST_MESSAGES + 1)), "more than 256 messages"),
    ],
)  # fmt: skip
def test_what_is_no_packet_is_rejected_whole(packet: bytes, said: str) -> None:
    with pytest.raises(OscError, match=said):
        decode_packet(packet)


@pytest.mark.parametrize(
    "wrong",
    [
        b"one\0", b"/a\0\0,q\0\0", b"/a\0\0,i\0\0\0\0", b"/\xff\0\0", b"", b"hello", BUNDLE + bytes(4),
        encode_bundle([b"/a\0\0,T\0\0more"]),
    ],
)  # fmt: skip
def test_a_wrong_element_costs_itself_and_not_its_bundle(wrong: bytes) -> None:
    faults: list[OscError] = []
    before, after = encode_message("/before", 1), encode_message("/after", 0.5)
    inner = BUNDLE + bytes(8) + b"".join(struct.pack(">i", len(each)) + each for each in (before, wrong, after))
    for packet in (inner, encode_bundle([inner])):
        assert decode_packet(packet, faults) == [OscMessage("/before", (1,)), OscMessage("/after", (0.5,))]
    assert len(faults) == 2
    with pytest.raises(OscError, match=str(faults[0])[:20].replace("(", ".")):
        decode_packet(inner)


def test_a_bundle_that_is_cut_or_too_large_gives_what_can_be_read() -> None:
    faults: list[OscError] = []
    assert [message.address for message in decode_packet(PACKET[:-1], faults)] == ["/omote/one/face"]
    many = encode_bundle([encode_message("/a", number) for number in range(MOST_MESSAGES + 50)])
    assert [message.arguments for message in decode_packet(many, faults)] == [(n,) for n in range(MOST_MESSAGES)]
    assert decode_packet(encode_bundle([]), faults) == []
    assert ["not there" in str(faults[0]), "256 messages" in str(faults[1]), len(faults)] == [True, True, 2]


def test_a_deep_nest_of_bundles_is_rejected_before_it_costs_much() -> None:
    packet = encode_message("/a")
    for _ in range(MOST_BUNDLES + 1):
        packet = encode_bundle([packet])
    with pytest.raises(OscError, match="64 bundles"):
        decode_packet(packet)


def test_mutated_packets_raise_nothing_else() -> None:
    rng = np.random.default_rng(1)
    for _ in range(20_000):
        data = bytearray(PACKET[: rng.integers(len(PACKET) + 1)] if rng.random() < 0.3 else PACKET)
        for _ in range(rng.integers(1, 5)):
            if data:
                data[rng.integers(len(data))] = rng.integers(256)
        try:
            messages = decode_packet(bytes(data))
        except OscError:
            continue
        assert all(message.address.startswith("/") for message in messages)


@pytest.mark.parametrize(
    ("address", "argument", "said"),
    [("one", 1, "begins with /"), ("/a\0", 1, "zero byte"), ("/a", 2**63, "cannot be sent"), ("/a", [1], "cannot be")],
)
def test_what_cannot_be_sent_is_said(address: str, argument: Argument, said: str) -> None:
    with pytest.raises(OscError, match=said):
        encode_message(address, argument)


def test_no_number_comes_through_as_it_is_for_the_performer_to_reject() -> None:
    (message,) = decode_packet(encode_message("/a", math.nan))
    assert math.isnan(cast(float, message.arguments[0]))
