"""Messages of VMC (protocol.vmc.info, 3.1), read and written: expressions, and the turns of head and eyes, over OSC.

A sender says a value at a time and then `/VMC/Ext/Blend/Apply`; it may spread that over several packets, so there is a
decoder for each sender. Bones are local rotations of Unity (left-handed, y up, z out of the face).
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from omote.inputs.osc_packet import (
    BUNDLE,
    MOST_MESSAGES,
    Argument,
    OscMessage,
    decode_packet,
    encode_bundle,
    encode_message,
    split_bundle,
)
from omote.inputs.trackers.head_angles import (
    GazeAngles,
    HeadAngles,
    Quaternion,
    average_eyes,
    multiply_quaternions,
    normalize_quaternion,
    read_unity_quaternion,
    write_unity_quaternion,
)
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame, check_weight
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST

VALUE = "/VMC/Ext/Blend/Val"
APPLY = "/VMC/Ext/Blend/Apply"
BONE = "/VMC/Ext/Bone/Pos"
OK = "/VMC/Ext/OK"
TIME = "/VMC/Ext/T"
MOST_NAMES = 256
"""Expressions of one sender; a model has no more that a face has."""
MOST_VALUES = 26
"""Values of one bundle that we send: it stays below 1,500 bytes, which the protocol asks for."""
LONGEST_NAME = 80
FLOAT = struct.Struct(">f")
NO_TURN: Quaternion = (0.0, 0.0, 0.0, 1.0)
BONES: Mapping[str, str] = MappingProxyType(
    {"head": "Head", "neck": "Neck", "lefteye": "LeftEye", "righteye": "RightEye"}
)


@dataclass
class _Said:
    """What a sender has said: its values and bones, as it said them last."""

    weights: dict[str, float] = field(default_factory=dict)
    bones: dict[str, Quaternion] = field(default_factory=dict)
    found: bool = True
    time: float | None = None
    complete: bool = False

    def hear(self, message: OscMessage) -> None:
        """Notes a message; those of addresses that are not for a face are left out."""
        if message.address == VALUE:
            name, value = _read(message, 2)
            self.weights[_name(name, message)] = check_weight(str(name), value)
        elif message.address == BONE:
            _note_bone(self.bones, message)
        elif message.address == OK:
            self.found = _is_found(message)
            self.complete = self.complete or not self.found
        elif message.address == TIME:
            self.time = _number(_read(message, 1)[0], message)
        elif message.address == APPLY:
            self.complete = True

    def frame(self) -> TrackerFrame:
        """The face as it is said."""
        head = None
        bones = self.bones
        if "Head" in bones or "Neck" in bones:
            head = read_unity_quaternion(multiply_quaternions(bones.get("Neck", NO_TURN), bones.get("Head", NO_TURN)))
        eyes = [read_unity_quaternion(bones[eye])[:2] for eye in ("LeftEye", "RightEye") if eye in bones]
        return TrackerFrame(dict(self.weights), head, average_eyes(eyes), self.found, self.time)


class VmcDecoder:
    """Reads the packets of one sender."""

    def __init__(self) -> None:
        self._said = _Said()
        self._names: dict[bytes, str] = {}

    def decode(self, data: bytes) -> list[TrackerFrame]:
        """The frame that a packet completes, if it does; TrackerError or OscError where it is none, and nothing has
        changed."""
        before = self._said
        said = _Said(dict(before.weights), dict(before.bones), before.found, before.time)
        elements = split_bundle(data) if data.startswith(BUNDLE) else [data]
        names = self._names
        weights = said.weights
        read = FLOAT.unpack
        for element in elements if len(elements) <= MOST_MESSAGES else [data]:
            name = names.get(element[:-4])
            if name is None:
                self._hear(element, said)
                continue
            (value,) = read(element[-4:])
            weights[name] = value if CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST else check_weight(name, value)
        if len(said.weights) > MOST_NAMES:
            raise TrackerError(
                f"the sender has named {len(said.weights)} expressions, but at most {MOST_NAMES} are kept"
            )
        self._said = said
        turned = said.bones != before.bones and not said.weights  # who sends bones alone never says that it is complete
        return [said.frame()] if said.complete or turned else []

    def _hear(self, element: bytes, said: _Said) -> None:
        """Notes the messages of an element. What stands before the number of a value is read once: it comes again with
        each frame, and reading it takes ten times as long as the number."""
        messages = decode_packet(element)
        for message in messages:
            said.hear(message)
        if len(messages) == 1 and messages[0].address == VALUE and len(self._names) < MOST_NAMES:
            name = str(messages[0].arguments[0])
            before = element[: -FLOAT.size]
            if before == encode_message(VALUE, name, 0.0)[: -FLOAT.size]:  # and no double, whose end is no number
                self._names[before] = name


def encode_vmc(weights: Mapping[str, float], head: HeadAngles, gaze: GazeAngles, time: float) -> list[bytes]:
    """The packets of a face. weights: by the names that the receiver's model has; time: seconds; head, gaze:
    radians."""
    eye = write_unity_quaternion((*gaze, 0.0))
    values = [encode_message(VALUE, name, float(value)) for name, value in weights.items()]
    parts = [values[at : at + MOST_VALUES] for at in range(0, len(values), MOST_VALUES)]
    bones = [
        _encode_bone(name, turn)
        for name, turn in (("Head", write_unity_quaternion(head)), ("LeftEye", eye), ("RightEye", eye))
    ]
    begin = [encode_message(OK, 1), encode_message(TIME, float(time)), *bones]
    return [encode_bundle(part) for part in _ended([begin, *parts])]


def _ended(parts: Iterable[list[bytes]]) -> list[list[bytes]]:
    *first, last = parts
    return [*first, [*last, encode_message(APPLY)]]


def _encode_bone(name: str, turn: Quaternion) -> bytes:
    return encode_message(BONE, name, 0.0, 0.0, 0.0, *(float(component) for component in turn))


def _read(message: OscMessage, count: int) -> tuple[Argument, ...]:
    """So many arguments of a message; what stands behind them is for newer versions."""
    if len(message.arguments) < count:
        raise TrackerError(f"{message.address} has {len(message.arguments)} arguments, expected {count}")
    return message.arguments[:count]


def _number(value: Argument, message: OscMessage) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not -1e12 < value < 1e12:
        raise TrackerError(f"{message.address} has {value!r:.40} where a number is expected")
    return float(value)


def _name(value: Argument, message: OscMessage) -> str:
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST_NAME:
        raise TrackerError(f"{message.address} has {value!r:.40} where a name is expected")
    return value


def _note_bone(bones: dict[str, Quaternion], message: OscMessage) -> None:
    name, *numbers = _read(message, 8)
    if (bone := BONES.get(_name(name, message).lower())) is not None:
        x, y, z, w = (_number(number, message) for number in numbers[3:])
        bones[bone] = normalize_quaternion((x, y, z, w))


def _is_found(message: OscMessage) -> bool:
    """Whether the sender has a model and sees its performer: the first number, and since 2.7 the fourth."""
    loaded, *more = (_number(number, message) for number in message.arguments[:4] or _read(message, 1))
    return loaded != 0.0 and (len(more) < 3 or more[2] != 0.0)


def open_vmc() -> Callable[[bytes], list[TrackerFrame]]:
    """A decoder for another sender."""
    return VmcDecoder().decode
