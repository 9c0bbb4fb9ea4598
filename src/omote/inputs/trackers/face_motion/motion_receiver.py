"""What a phone sends over FMV3: first the list of its names (the schema), which is acknowledged, then frames.

Source: the vendor's PROTOCOL_V3.md, sections 4 to 9. Angles are degrees and values percents, as in its text frames.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Literal

import msgspec

from omote.inputs.trackers.face_motion.motion_message import (
    MAGIC,
    Kind,
    MotionMessage,
    PartCollector,
    decode_part,
)
from omote.inputs.trackers.face_text import decode_face_text
from omote.inputs.trackers.head_angles import average_eyes, read_right_handed_degrees
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame, read_json
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST

REVISION = 4
"""Of the protocol that is spoken."""
NONCE = int.from_bytes(b"omote-v3", "little")
"""By which a phone knows our hello; the same after a restart, so that it goes on with its session."""
RATE = 60
LONGEST_DATAGRAM = 1200
HELLO = struct.Struct("<HHI")
START = struct.Struct("<QHHII")
POSE = struct.Struct("<12f")
PING_SECONDS = 2.0
ASK_FRAMES = 60
"""Between two signs of life to a phone; frames without their list of names between two requests for it."""
TRACKED = 1
RECORDED = 2
Answer = Callable[[bytes], None]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=255)]


class Schema(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the numbers of a frame are."""

    schema_version: Literal[1]
    app: Literal["iFacialMocap", "Facemotion3d"]
    profile: Literal["ifacialmocap-stream", "facemotion3d-other"]
    blend_names: Annotated[list[Name], msgspec.Meta(max_length=4096)]
    blend_encoding: Literal["i16", "i32"]
    blend_unit: Literal["percent"]
    pose_layout: Literal["head_rxyz_pxyz_rightEye_rxyz_leftEye_rxyz"]
    rotation_unit: Literal["degree"]
    position_unit: Literal["meter"]


@dataclass(frozen=True)
class _Agreed:
    """What frames are read by. numbers: of the channels; every: frames between two signs of life."""

    session: int
    schema: int
    payload: bytes
    names: tuple[str, ...]
    numbers: struct.Struct
    every: int


def ask_for_motion(_: int) -> bytes:
    """What asks a phone for frames: a hello; it answers where that came from."""
    return MotionMessage(Kind.HELLO, NONCE, payload=HELLO.pack(RATE, LONGEST_DATAGRAM, REVISION)).encode()


class MotionReceiver:
    """Reads the packets of one phone, those of the text protocol too. answer: sends it a packet. stream: whether it is
    one of TCP, where nothing is acknowledged."""

    def __init__(self, answer: Answer, *, stream: bool = False) -> None:
        self._answer = answer
        self._stream = stream
        self._parts = PartCollector()
        self._agreed: _Agreed | None = None
        self._newest: int | None = None
        self._ends = False
        self._frames = self._unknown = 0

    def decode(self, data: bytes) -> list[TrackerFrame]:
        """The frame that a packet completes, if it does; TrackerError where it is none."""
        if not data.startswith(MAGIC):
            return self._read_text(data)
        message = self._parts.collect(decode_part(data))
        if message is None or message.kind is Kind.PONG:
            return []
        if message.kind is Kind.SCHEMA:
            self._agree(message)
            return []
        if message.kind is Kind.ERROR:
            raise TrackerError(f"the phone says: {message.payload.decode(errors='replace')[:120]}")
        return self._read_frame(message)

    def _read_text(self, data: bytes) -> list[TrackerFrame]:
        """The frame of a text; its last field is left out where it ends within it, of a phone that ends all fields."""
        whole = data.rstrip(b"\0 \r\n").endswith(b"|")
        self._ends = self._ends or whole
        return decode_face_text(data, cut=self._ends and not whole)

    def _agree(self, message: MotionMessage) -> None:
        """Takes a list of names, and says that it has come."""
        known = self._agreed
        if known is None or (known.session, known.schema, known.payload) != _key(message):
            self._agreed = _read_schema(message)
            if known is None or known.session != message.session:
                self._newest = None
        if not self._stream:
            self._answer(MotionMessage(Kind.SCHEMA_ACK, message.session, message.schema).encode())

    def _read_frame(self, message: MotionMessage) -> list[TrackerFrame]:
        agreed = self._agreed
        if agreed is None or (agreed.session, agreed.schema) != (message.session, message.schema):
            if self._unknown % ASK_FRAMES == 0:
                self._answer(MotionMessage(Kind.GET_SCHEMA, message.session).encode())
            self._unknown += 1
            raise TrackerError("the frame's list of names has not come yet; the phone is asked for it")
        expected = agreed.numbers.size + POSE.size
        if len(message.payload) != expected:
            raise TrackerError(f"the frame has {len(message.payload)} bytes, expected {expected}")
        frame = _make_frame(agreed, message)
        step = (message.sequence - (message.sequence - 1 if self._newest is None else self._newest)) % (1 << 32)
        if not 0 < step < 1 << 31:
            return []  # older than what has come, or the same
        self._newest = message.sequence
        self._frames += 1
        if self._frames % agreed.every == 0:
            self._answer(MotionMessage(Kind.PING, message.session, sequence=self._frames & 0xFFFFFFFF).encode())
        return [frame]


def _key(message: MotionMessage) -> tuple[int, int, bytes]:
    return message.session, message.schema, message.payload


def _read_schema(message: MotionMessage) -> _Agreed:
    """What a list of names says; TrackerError where it is none, or is not for us."""
    if len(message.payload) < START.size or message.schema == 0:
        raise TrackerError("a list of names has no beginning, or no number")
    nonce, rate, _, _, revision = START.unpack_from(message.payload)
    if revision != REVISION:
        raise TrackerError(
            f"the phone speaks revision {revision} of FMV3, expected {REVISION}; update the app or Omote"
        )
    if nonce not in (0, NONCE) or not 0 < rate <= RATE:
        raise TrackerError("the phone's list of names answers another program, or is for another rate")
    schema = read_json(Schema, message.payload[START.size :], "the phone's list of names cannot be read")
    names = tuple(schema.blend_names)
    if len(set(names)) != len(names):
        raise TrackerError("the phone's list of names has one twice")
    numbers = struct.Struct(f"<{len(names)}{'h' if schema.blend_encoding == 'i16' else 'i'}")
    return _Agreed(*_key(message), names, numbers, max(1, round(PING_SECONDS * rate)))


def _make_frame(agreed: _Agreed, message: MotionMessage) -> TrackerFrame:
    """The frame of a message. Its values have no bounds; ours are at their ends there."""
    values = agreed.numbers.unpack_from(message.payload)
    pose = POSE.unpack_from(message.payload, agreed.numbers.size)
    weights = {
        name: min(CHANNEL_HIGHEST, max(CHANNEL_LOWEST, 0.01 * value))
        for name, value in zip(agreed.names, values, strict=True)
    }
    head = read_right_handed_degrees(*pose[:3])
    eyes = (read_right_handed_degrees(*pose[at : at + 3])[:2] for at in (6, 9))
    return TrackerFrame(weights, head, average_eyes(eyes), found=bool(message.flags & (TRACKED | RECORDED)))
