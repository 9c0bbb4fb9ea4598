"""Captures of packets: written and read back, of other programs' kinds too, and damage is refused."""

import base64
import struct

import msgspec
import numpy as np
import pytest

from omote.inputs.takes.packet_capture import Packet, encode_capture, read_packets

PACKETS = [Packet(1.5, "10.0.0.7", 39539, b"one"), Packet(2.25, "10.0.0.8", 11111, b"")]
ETHERNET = bytes(12) + b"\x08\x00"


def ip(packet: Packet) -> bytes:
    """The packet of IP, as ours writes it."""
    return b"".join(encode_capture([packet]))[40:]


def pcapng(*packets: Packet, order: str = "<", unit: int = 6, link: int = 1) -> bytes:
    """A capture as Wireshark writes it."""

    def block(kind: int, body: bytes) -> bytes:
        size = 12 + len(body) + -len(body) % 4
        return struct.pack(f"{order}II", kind, size) + body + bytes(-len(body) % 4) + struct.pack(f"{order}I", size)

    head = block(0x0A0D0D0A, struct.pack(f"{order}IHHq", 0x1A2B3C4D, 1, 0, -1))
    interface = block(1, struct.pack(f"{order}HHIHHB3xI", link, 0, 0, 9, 1, unit, 0))
    blocks = [block(5, bytes(12))]
    for packet in packets:
        frame = ETHERNET + ip(packet)
        ticks = round(packet.time * 10**unit)
        sizes = (0, ticks >> 32, ticks & 0xFFFFFFFF, len(frame), len(frame))
        blocks.append(block(6, struct.pack(f"{order}IIIII", *sizes) + frame))
    return head + interface + b"".join(blocks)


def test_what_is_written_is_read_as_it_was() -> None:
    assert read_packets(b"".join(encode_capture(PACKETS))) == PACKETS


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("unit", [6, 9])
def test_a_capture_of_wireshark_is_read(order: str, unit: int) -> None:
    found = read_packets(pcapng(*PACKETS, order=order, unit=unit))
    assert [(each.host, each.port, each.data) for each in found] == [(p.host, p.port, p.data) for p in PACKETS]
    assert [each.time for each in found] == pytest.approx([1.5, 2.25])


@pytest.mark.parametrize(
    ("link", "before"),
    [(0, b"\2\0\0\0"), (1, ETHERNET), (1, bytes(12) + b"\x81\x00\x00\x05\x08\x00"), (113, bytes(16)), (276, bytes(20)),
     (228, b"")],
)  # fmt: skip
def test_a_capture_of_tcpdump_is_read_whatever_its_link(link: int, before: bytes) -> None:
    frame = before + ip(PACKETS[0])
    head = struct.pack(">IHHiIII", 0xA1B23C4D, 2, 4, 0, 0, 65535, link)
    data = head + struct.pack(">IIII", 1, 500_000_000, len(frame), len(frame)) + frame
    assert read_packets(data) == [PACKETS[0]]


def test_a_dump_of_vmc_packets_is_read() -> None:
    document = [{"buffer": base64.b64encode(b"abc").decode(), "time": 0.25}]
    for mark in (b"", b"\xef\xbb\xbf"):
        assert read_packets(mark + msgspec.json.encode(document)) == [Packet(0.25, "127.0.0.1", 0, b"abc")]


def test_what_is_no_packet_of_udp_is_left_out_and_a_capture_that_was_cut_short_is_read() -> None:
    whole = b"".join(encode_capture(PACKETS))
    tcp = bytearray(whole)
    tcp[40 + 9] = 6
    assert read_packets(bytes(tcp)) == [PACKETS[1]]
    assert read_packets(whole[:-3]) == [PACKETS[0]]


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "no capture"),
        (b"x" * 50, "no capture"),
        (b"[3]", "no capture"),
        (b'[{"buffer":"*","time":1}]', "not in base64"),
        (b"".join(encode_capture([])), "no packet of UDP"),
        (pcapng(PACKETS[0], link=147), "kind of link 147"),
        (struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 147) + bytes(16), "kind of link 147"),
        (pcapng()[:28] + bytes(20), "cannot be"),
    ],
)
def test_what_cannot_be_read_is_said(data: bytes, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_packets(data)


def test_damaged_captures_raise_nothing_else() -> None:
    generator = np.random.default_rng(8)
    for golden in (b"".join(encode_capture(PACKETS)), pcapng(*PACKETS)):
        for _ in range(2000):
            damaged = bytearray(golden)
            for place in generator.integers(0, len(golden), 3):
                damaged[place] = generator.integers(256)
            try:
                read_packets(bytes(damaged))
            except ValueError:
                continue
