"""Reads and writes packets of OSC 1.0 (opensoundcontrol.org): messages, and bundles of them.

Strict: what is not exactly a message is rejected; one wrong element costs itself, not its bundle. A bundle within a
bundle takes no recursion, and its time tag is not waited for: a sender's clock may be wrong, and what a hand does
counts when it comes.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from omote.inputs.rejection import PacketError

LONGEST_PACKET = 65507
"""Bytes of a packet: the most that UDP carries."""
MOST_MESSAGES = 256
"""Messages of one packet, all its bundles together: they are decoded at once, within a tick."""
MOST_ELEMENTS = 2048
"""Elements of one bundle: no packet has room for more with a value in each."""
MOST_BUNDLES = 64
"""Bundles of one packet: nobody nests more, and each is read anew."""
BUNDLE = b"#bundle\0"
SIZE = struct.Struct(">i")
"""What stands before each element of a bundle: trackers send a hundred bundles a second."""
IMMEDIATELY = b"\0\0\0\0\0\0\0\1"
"""The time tag "now"."""

Argument = int | float | str | bool | bytes | None


class OscError(PacketError):
    """What came is no packet of OSC, and why."""


class OscMessage(NamedTuple):
    """A message: its address, which begins with "/", and its arguments; what stood in arrays stands among them."""

    address: str
    arguments: tuple[Argument, ...] = ()


def decode_packet(data: bytes, faults: list[OscError] | None = None) -> list[OscMessage]:
    """The messages of a packet, in their order; OscError where it is none.

    data: its bytes; faults: gets why elements of it were left out; without it they are a reason to reject the packet.
    """
    if len(data) > LONGEST_PACKET:
        raise OscError(f"the packet has {len(data)} bytes, but at most {LONGEST_PACKET} are read")
    leave_out = _reject if faults is None else faults.append
    messages: list[OscMessage] = []
    left = [data]
    bundles = 0
    while left:
        part = left.pop()
        try:
            if part.startswith(BUNDLE):
                bundles += 1
                elements, fault = split_bundle(part)
                left.extend(reversed(elements))
                if fault is not None:
                    leave_out(fault)
            else:
                messages.append(_decode_message(part))
        except OscError as error:
            leave_out(error)
        if len(messages) + len(left) > MOST_MESSAGES or bundles > MOST_BUNDLES:
            leave_out(OscError(f"the packet has more than {MOST_MESSAGES} messages or {MOST_BUNDLES} bundles"))
            left = left[len(messages) + len(left) - MOST_MESSAGES :] if bundles <= MOST_BUNDLES else []
    return messages


def encode_message(address: str, *arguments: Argument) -> bytes:
    """The packet of one message; OscError for an address or an argument that cannot be sent.

    arguments: in their order.
    """
    if not address.startswith("/"):
        raise OscError(f"the address is {address[:80]!r}; an address begins with /")
    tags, values = zip(*map(_encode_argument, arguments), strict=True) if arguments else ((), ())
    return _padded(address) + _padded("," + "".join(tags)) + b"".join(values)


def encode_bundle(packets: Iterable[bytes]) -> bytes:
    """A bundle of packets, to be carried out at once."""
    return BUNDLE + IMMEDIATELY + b"".join(struct.pack(">i", len(packet)) + packet for packet in packets)


def split_bundle(bundle: bytes) -> tuple[list[bytes], OscError | None]:
    """The packets within a bundle, and why it cannot be read further, None where it can; OscError where it has no
    beginning."""
    if len(bundle) < len(BUNDLE) + 8:
        raise OscError("a bundle ends within its time tag")
    packets: list[bytes] = []
    at = len(BUNDLE) + 8
    end = len(bundle)
    while at < end:
        if at + SIZE.size > end:
            return packets, OscError("the packet ends within a number")
        (size,) = SIZE.unpack_from(bundle, at)
        at += SIZE.size
        if size < 0 or at + size > end:
            return packets, OscError(f"an element of a bundle has {size} bytes, which are not there")
        if len(packets) == MOST_ELEMENTS:
            return packets, OscError(f"a bundle has more than {MOST_ELEMENTS} elements")
        packets.append(bundle[at : at + size])
        at += size
    return packets, None


def _reject(error: OscError) -> None:
    raise error


def _decode_message(data: bytes) -> OscMessage:
    if not data.startswith(b"/"):
        raise OscError(f"a message begins with {data[:8]!r}; expected an address, which begins with /")
    address, at = _text(data, 0)
    if at == len(data):
        return OscMessage(address)  # senders of before 1.0 leave the tags out where there are no arguments
    tags, at = _text(data, at)
    if not tags.startswith(","):
        raise OscError(f"the type tags of {address[:80]} begin with {tags[:8]!r}; expected a comma")
    arguments: list[Argument] = []
    for tag in tags[1:]:
        if tag in "[]":
            continue
        if tag not in READERS:
            raise OscError(f"{address[:80]} has an argument of type {tag!r}, which OSC 1.0 does not know")
        argument, at = READERS[tag](data, at)
        arguments.append(argument)
    if at != len(data):
        raise OscError(f"{address[:80]} has {len(data) - at} bytes more than its type tags tell")
    return OscMessage(address, tuple(arguments))


def _text(data: bytes, at: int) -> tuple[str, int]:
    end = data.find(b"\0", at)
    after = end + 4 - (end - at) % 4
    if end < 0 or after > len(data) or any(data[end:after]):
        raise OscError("a text does not end with one to four zero bytes")
    try:
        return data[at:end].decode(), after
    except UnicodeDecodeError as error:
        raise OscError(f"a text is not UTF-8: {data[at:end][:80]!r}") from error


def _blob(data: bytes, at: int) -> tuple[bytes, int]:
    size, at = _number(">i", data, at)
    after = at + size + -size % 4
    if size < 0 or after > len(data):
        raise OscError(f"a blob has {size} bytes, which are not there")
    return data[at : at + size], after


def _number(form: str, data: bytes, at: int) -> tuple[int, int]:
    number, after = _value(form)(data, at)
    return int(number), after


def _value(form: str) -> Callable[[bytes, int], tuple[float, int]]:
    size = struct.calcsize(form)
    unpack = struct.Struct(form).unpack_from

    def read(data: bytes, at: int) -> tuple[float, int]:
        if at + size > len(data):
            raise OscError("the packet ends within a number")
        (value,) = unpack(data, at)
        return value, at + size

    return read


def _constant(value: Argument) -> Callable[[bytes, int], tuple[Argument, int]]:
    return lambda _, at: (value, at)


READERS: Mapping[str, Callable[[bytes, int], tuple[Argument, int]]] = {
    "i": _value(">i"),
    "f": _value(">f"),
    "h": _value(">q"),
    "t": _value(">Q"),
    "d": _value(">d"),
    "c": _value(">I"),
    "r": _value(">I"),
    "m": _value(">I"),
    "s": _text,
    "S": _text,
    "b": _blob,
    "T": _constant(True),
    "F": _constant(False),
    "N": _constant(None),
    "I": _constant(True),
}
"""What reads an argument, by its type tag: all of OSC 1.0; an impulse ("I") is a button pressed."""


def _padded(text: str) -> bytes:
    data = text.encode()
    if b"\0" in data:
        raise OscError(f"{text[:80]!r} has a zero byte, which ends a text")
    return data + b"\0" * (4 - len(data) % 4)


def _encode_argument(value: Argument) -> tuple[str, bytes]:
    match value:
        case True | False:
            return ("T" if value else "F"), b""
        case None:
            return "N", b""
        case int() if -(2**31) <= value < 2**31:
            return "i", struct.pack(">i", value)
        case int() if -(2**63) <= value < 2**63:
            return "h", struct.pack(">q", value)
        case float():
            return "f", struct.pack(">f", value)
        case str():
            return "s", _padded(value)
        case bytes():
            return "b", struct.pack(">i", len(value)) + value + b"\0" * (-len(value) % 4)
    raise OscError(f"{value!r} cannot be sent as an argument")
