"""Captures of packets, as tcpdump, Wireshark and `omote record-take` write them (pcap, pcapng), and VMC dumps (JSON).

A capture keeps what a tracker sent as it was sent, so that any protocol is recorded. Sources: the IETF's drafts
draft-ietf-opsawg-pcap and -pcapng; JSON: emilianavt/MotionReplay (`buffer` in base64, `time` in seconds).
"""

from __future__ import annotations

import base64
import codecs
import struct
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import msgspec

MICRO = 0xA1B2C3D4
NANO = 0xA1B23C4D
SECTION = 0x0A0D0D0A
LINK_BYTES = {0: 4, 1: 14, 12: 0, 14: 0, 101: 0, 108: 4, 113: 16, 228: 0, 276: 20}
"""Bytes before the packet of IP, by the kind of link: loopback, Ethernet, raw IP, Linux's "any"."""
RAW_IP = 101
UDP = 17
IPV4 = 4
MOST_PACKETS = 2_000_000
NOT_ONE = "the file is no capture (pcap, pcapng) and no dump of VMC packets (JSON)"


@dataclass(frozen=True)
class Packet:
    """A packet of UDP: when it came (seconds, from any beginning), who sent it, to which port, and what it held; port 0
    where the capture does not say."""

    time: float
    host: str
    port: int
    data: bytes


class _Dumped(msgspec.Struct, frozen=True):
    buffer: str
    time: float


def read_packets(data: bytes) -> list[Packet]:
    """The packets of UDP of a capture; ValueError where it is none, or has none."""
    try:
        packets = list(_read(data))
    except (struct.error, IndexError, msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"{NOT_ONE}: {str(error)[:120]}") from error
    if not packets:
        raise ValueError("the capture holds no packet of UDP over IPv4")
    return packets


def is_capture_cut(data: bytes) -> bool:
    """Whether a capture ends within a packet; a dump never does, for such one is not read."""
    if _is_dump(data):
        return False
    order = _order(data)
    at = 0
    (magic,) = struct.unpack_from(f"{order}I", data)
    if magic != SECTION:
        at = 24
        while at + 16 <= len(data):
            at += 16 + int(struct.unpack_from(f"{order}I", data, at + 8)[0])
        return at != len(data)
    while at + 12 <= len(data):
        size = int(struct.unpack_from(f"{order}I", data, at + 4)[0])
        at += max(size, 12)
    return at != len(data)


def encode_capture(packets: Iterable[Packet]) -> Iterator[bytes]:
    """The bytes of a capture (pcap), piece by piece: its head, then one packet after the other."""
    yield struct.pack("<IHHiIII", MICRO, 2, 4, 0, 0, 262_144, RAW_IP)
    for packet in packets:
        yield encode_packet(packet)


def encode_packet(packet: Packet) -> bytes:
    """One packet of a capture."""
    seconds, part = divmod(round(packet.time * 1e6), 1_000_000)
    source = bytes(map(int, packet.host.split(".")))
    total = 28 + len(packet.data)
    ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, total, 0, 0, 64, UDP, 0, source, b"\x7f\0\0\1")
    udp = struct.pack(">HHHH", packet.port, packet.port, 8 + len(packet.data), 0)
    return struct.pack("<IIII", seconds, part, total, total) + ip + udp + packet.data


def _read(data: bytes) -> Iterator[Packet]:
    if _is_dump(data):
        yield from _read_dump(data.removeprefix(codecs.BOM_UTF8))
        return
    if len(data) < 24:
        raise ValueError(NOT_ONE)
    order = _order(data)
    (magic,) = struct.unpack_from(f"{order}I", data)
    yield from _read_pcapng(data, order) if magic == SECTION else _read_pcap(data, order, magic)


def _is_dump(data: bytes) -> bool:
    return data.removeprefix(codecs.BOM_UTF8).lstrip()[:1] == b"["


def _order(data: bytes) -> str:
    """The order of the bytes of a capture's numbers; ValueError where it is none."""
    for order in "<>":
        (magic,) = struct.unpack_from(f"{order}I", data)
        (again,) = struct.unpack_from(f"{order}I", data, 8)
        if magic in (MICRO, NANO) or (magic == SECTION and again == 0x1A2B3C4D):
            return order
    raise ValueError(NOT_ONE)


def _read_dump(data: bytes) -> Iterator[Packet]:
    for dumped in msgspec.json.decode(data, type=list[_Dumped]):
        try:
            yield Packet(dumped.time, "127.0.0.1", 0, base64.b64decode(dumped.buffer, validate=True))
        except ValueError as error:
            raise ValueError(f"a packet of the dump is not in base64: {error}") from error


def _read_pcap(data: bytes, order: str, magic: int) -> Iterator[Packet]:
    (link,) = struct.unpack_from(f"{order}I", data, 20)
    scale = 1e-9 if magic == NANO else 1e-6
    at = 24
    for _ in range(MOST_PACKETS):
        if at + 16 > len(data):
            return  # a capture that was cut short ends within a packet
        seconds, part, size, _ = struct.unpack_from(f"{order}IIII", data, at)
        packet = _read_ip(seconds + scale * part, data[at + 16 : at + 16 + size], link & 0xFFFF)
        at += 16 + size
        if packet is not None:
            yield packet


def _read_pcapng(data: bytes, order: str) -> Iterator[Packet]:
    at = 0
    links = list[tuple[int, float]]()
    while at + 12 <= len(data):
        kind, size = struct.unpack_from(f"{order}II", data, at)
        if size < 12 or size % 4:
            raise ValueError(f"a block of the capture has {size} bytes, which cannot be")
        body = data[at + 8 : at + size - 4]
        at += size
        if kind == 1:
            links.append((struct.unpack_from(f"{order}H", body)[0], _resolution(body, order)))
        elif kind == 6 and len(body) >= 20:
            number, high, low, length, _ = struct.unpack_from(f"{order}IIIII", body)
            link, unit = links[number]
            packet = _read_ip(unit * ((high << 32) | low), body[20 : 20 + length], link)
            if packet is not None:
                yield packet


def _resolution(body: bytes, order: str) -> float:
    """Seconds of a unit of an interface's times: its option 9, microseconds without."""
    at = 8
    while at + 4 <= len(body):
        code, size = struct.unpack_from(f"{order}HH", body, at)
        if code == 9 and size:
            value = body[at + 4]
            return float(2.0 ** -(value & 0x7F) if value & 0x80 else 10.0**-value)
        at += 4 + size + -size % 4
        if code == 0:
            break
    return 1e-6


def _read_ip(time: float, frame: bytes, link: int) -> Packet | None:
    """The packet of UDP in a frame; None for anything else, and for one that was cut or came in pieces."""
    if link not in LINK_BYTES:
        raise ValueError(
            f"the capture is of the kind of link {link}, which is not read; record it with omote record-take"
        )
    at = LINK_BYTES[link]
    if link == 1 and frame[12:14] == b"\x81\x00":
        at += 4  # a tag of VLAN
    packet = frame[at:]
    if len(packet) < 28 or packet[0] >> 4 != IPV4 or packet[9] != UDP:
        return None
    head = 4 * (packet[0] & 0x0F)
    (pieces,) = struct.unpack_from(">H", packet, 6)
    if pieces & 0x3FFF or head < 20 or len(packet) < head + 8:
        return None
    port, size = struct.unpack_from(">HH", packet, head + 2)
    payload = packet[head + 8 : head + size]
    if size < 8 or len(payload) != size - 8:
        return None
    return Packet(time, ".".join(map(str, packet[12:16])), port, payload)
