"""Messages of VMC (protocol.vmc.info, 3.1), read and written: expressions, and the turns of head and eyes, over OSC.

A sender says a value at a time and then `/VMC/Ext/Blend/Apply`; it may spread that over several packets, so there is a
decoder for each sender. Bones are local rotations of Unity (left-handed, y up, z out of the face).
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from types import MappingProxyType

from omote.inputs.osc_packet import (
    BUNDLE,
    Argument,
    OscError,
    OscMessage,
    decode_packet,
    encode_bundle,
    encode_message,
    split_bundle,
)
from omote.inputs.rejection import PacketError
from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS
from omote.inputs.trackers.body_bones import BodyBones
from omote.inputs.trackers.head_angles import (
    LEAST_LENGTH,
    BoneTurn,
    GazeAngles,
    HeadAngles,
    Quaternion,
    average_eyes,
    mirror_quaternion,
    multiply_quaternions,
    normalize_quaternion,
    read_unity_quaternion,
    rotate,
    write_unity_quaternion,
)
from omote.inputs.trackers.tracker_frame import LeftOut, TrackerError, TrackerFrame, read_weight

VALUE = "/VMC/Ext/Blend/Val"
APPLY = "/VMC/Ext/Blend/Apply"
BONE = "/VMC/Ext/Bone/Pos"
ROOT = "/VMC/Ext/Root/Pos"
OK = "/VMC/Ext/OK"
TIME = "/VMC/Ext/T"
MOST_NAMES = 256
"""Expressions of one sender that are kept, of those that a face has and of others; beyond, the oldest makes room."""
MOST_NEW = 512
"""Of one packet, values of names that are not known yet which are read; the others have their turn in later packets."""
IN_FULL = 8
"""Values that take as long as one message that is none."""
MOST_FAULTS = 8
"""Of one frame, which are said."""
MOST_VALUES = 26
"""Values of one bundle that we send: it stays below 1,500 bytes, which the protocol asks for."""
MOST_BONES = 16
"""The same, of bones."""
LONGEST_NAME = 80
FLOAT = struct.Struct(">f")
BEGIN = encode_message(VALUE, "", 0.0)[:24]
"""How a value begins that comes as a float."""
APPLIES = frozenset({encode_message(APPLY), encode_message(APPLY)[:-4]})
"""What ends a frame, with tags of no arguments and without tags: it waits for no turn."""
TURN_FLOATS = b",sfffffff\0\0\0"
"""The tags of a name with a place and a turn, as bones have them."""
Place = tuple[float, float, float]
NOWHERE: Place = (0.0, 0.0, 0.0)
HIPS = "hips"
MODEL = "root"
"""The model itself, which senders move through their room."""
NO_TURN: Quaternion = (0.0, 0.0, 0.0, 1.0)
BONES: Mapping[str, str] = MappingProxyType(
    {"head": "Head", "neck": "Neck", "lefteye": "LeftEye", "righteye": "RightEye"}
)

BODY_BONE = struct.Struct(">7f")
LEG_BONES = ("leftLowerLeg", "leftFoot", "rightLowerLeg", "rightFoot")
LEAST_LEG = 0.1
"""Metres of two legs, of a sender that says where its knees and ankles are."""
FACE_BONES = frozenset(name.encode() for name in BONES)


@dataclass
class _Said:
    """What a sender has said: its values and bones, as it said them last. turned: whether a bone is another than
    before; body: its newest bones as they came, by VRM's names, known: those that were read; root: where its model was
    first; left_out: what could not be read since the last frame."""

    weights: dict[str, float] = field(default_factory=dict)
    bones: dict[str, Quaternion] = field(default_factory=dict)
    body: dict[str, bytes] = field(default_factory=dict)
    known: dict[str, tuple[float, ...]] = field(default_factory=dict)
    heard: dict[str, bytes] = field(default_factory=dict)
    root: tuple[Quaternion, Place] | None = None
    found: bool = True
    time: float | None = None
    complete: bool = False
    turned: bool = False
    left_out: list[LeftOut] = field(default_factory=list)

    def hear(self, message: OscMessage) -> None:
        """Notes a message; those of addresses that are not for a face are left out."""
        if message.address == VALUE:
            name, value = _read(message, 2)
            self.weights[_name(name, message)] = read_weight(str(name), value)
        elif message.address == BONE:
            self._note_bone(message)
        elif message.address == OK:
            self.found = _is_found(message)
            self.complete = self.complete or not self.found
        elif message.address == TIME:
            self.time = _number(_read(message, 1)[0], message)
        elif message.address == APPLY:
            self.complete = True

    def _note_bone(self, message: OscMessage) -> None:
        name, *numbers = _read(message, 8)
        if (bone := BONES.get(_name(name, message).lower())) is not None:
            x, y, z, w = (_number(number, message) for number in numbers[3:])
            turn = normalize_quaternion((x, y, z, w))
            self.turned = self.turned or self.bones.get(bone) != turn
            self.bones[bone] = turn

    def frame(self) -> TrackerFrame:
        """The face as it is said."""
        head = None
        bones = self.bones
        if "Head" in bones or "Neck" in bones:
            head = read_unity_quaternion(multiply_quaternions(bones.get("Neck", NO_TURN), bones.get("Head", NO_TURN)))
        eyes = [read_unity_quaternion(bones[eye])[:2] for eye in ("LeftEye", "RightEye") if eye in bones]
        body = self._read_body()
        left_out = tuple(self.left_out)
        self.left_out.clear()
        return TrackerFrame(
            dict(self.weights), head, average_eyes(eyes), self.found, self.time, left_out=left_out, bones=body
        )

    def _read_body(self) -> BodyBones | None:
        """The body as it is said; one bone that is none stays where it was."""
        for name, data in self.body.items():
            numbers = BODY_BONE.unpack(data)
            if all(map(math.isfinite, numbers)) and math.hypot(*numbers[3:]) > LEAST_LENGTH:
                self.known[name] = numbers
            elif len(self.left_out) < MOST_FAULTS:
                self.left_out.append(LeftOut("", f"the bone {name} is no rotation, or nowhere"))
        self.body.clear()
        if not self.known.keys() - {MODEL}:
            return None
        turns = {name: mirror_quaternion(normalize_quaternion(_turn(at))) for name, at in self.known.items()}
        places = {name: (-x, y, z) for name, (x, y, z, *_) in self.known.items()}
        model = turns.pop(MODEL, NO_TURN), places.get(MODEL, NOWHERE)
        self.root = self.root or model
        turns, hips = _on_model(turns, places.get(HIPS), self.root, model)
        leg = 0.5 * sum(math.hypot(*places[name]) for name in LEG_BONES if name in places)
        return BodyBones(turns, hips, leg if leg > 0.5 * LEAST_LEG else 0.0, "Head" in self.bones)


class VmcDecoder:
    """Reads the packets of one sender."""

    def __init__(self) -> None:
        self._said = _Said()
        self._names: dict[bytes, str] = {}
        self._begins: tuple[dict[str, bytes], dict[str, bytes]] = ({}, {})
        self._window = 0

    def decode(self, data: bytes) -> list[TrackerFrame]:
        """The frame that a packet completes, if it does; what of it cannot be read is left out. TrackerError or
        OscError where nothing of it can."""
        said = self._said
        said.complete = said.turned = False
        elements, fault = split_bundle(data) if data.startswith(BUNDLE) else ([data], None)
        faults: list[PacketError] = [] if fault is None else [fault]
        names = self._names
        bones = body_bones()
        weights = said.weights
        read = FLOAT.unpack
        unknown = 0
        for element in elements:
            name = names.get(element[:-4])
            if name is not None:
                (weights[name],) = read(element[-4:])
            elif element in APPLIES:
                said.complete = True
            elif (bone := bones.get(element[:-28])) is not None:
                said.turned = said.turned or element[-28:] != said.heard.get(bone)
                said.body[bone] = said.heard[bone] = element[-28:]
            elif element[20:32] != TURN_FLOATS or element[32:-28].rstrip(b"\0").lower() in FACE_BONES:
                if self._window <= unknown < self._window + MOST_NEW:
                    self._hear(element, faults)
                unknown += 1 if element.startswith(BEGIN) else IN_FULL
        self._window = self._window + MOST_NEW if self._window + MOST_NEW < unknown else 0
        if faults:
            self._leave_out(faults, len(elements) + (fault is not None))
        turned = said.turned and not weights  # who sends bones alone never says that it is complete
        return [said.frame()] if said.complete or turned else []

    def _hear(self, element: bytes, faults: list[PacketError]) -> None:
        """Notes the messages of an element, which is a bundle rarely; why some cannot be read is added to faults."""
        if (name := _name_of_value(element)) is not None:
            self._said.weights[name] = FLOAT.unpack(element[-4:])[0]
            self._remember(name, element[:-4])
            return
        wrong: list[OscError] = []
        messages = decode_packet(element, wrong)
        faults += wrong
        for message in messages:
            try:
                self._said.hear(message)
            except PacketError as error:
                faults.append(error)
            else:
                if message.address == VALUE:
                    self._remember(str(message.arguments[0]), b"")

    def _remember(self, name: str, begin: bytes) -> None:
        """What stands before the number of a value is read once: it comes again with each frame. A name that is new
        makes the oldest one go, of those that no face has or of those of faces.

        begin: b"" for a value that came as another number.
        """
        if begin:
            self._names[begin] = name
        begins = self._begins[bool(ARKIT_CHANNELS.find(name))]
        begins[name] = begin or begins.get(name, b"")
        if len(begins) > MOST_NAMES:
            oldest = next(iter(begins))
            self._names.pop(begins.pop(oldest), None)
            del self._said.weights[oldest]

    def _leave_out(self, faults: list[PacketError], elements: int) -> None:
        if len(faults) >= elements:
            raise faults[0]
        listed = self._said.left_out
        listed += [LeftOut("", str(fault)) for fault in faults[: MOST_FAULTS - len(listed)]]


def _name_of_value(element: bytes) -> str | None:
    """The name of a value that comes as a float; None for what is not exactly that, which is read in full."""
    name = element[len(BEGIN) : -4].rstrip(b"\0")
    if not element.startswith(BEGIN) or b"\0" in name or len(element) != len(BEGIN) + 8 + len(name) - len(name) % 4:
        return None
    return name.decode() if name.isascii() and 0 < len(name) <= LONGEST_NAME else None


@cache
def body_bones() -> Mapping[bytes, str]:
    """How messages of bones begin, the body's and the model's own, with their VRM names."""
    from omote.interchange.avatar.humanoid_figure import humanoid_bones
    from omote.interchange.avatar.vrm0_extension import unity_name

    names = {unity_name(name): name for name in humanoid_bones() if name not in ("neck", "head")}
    begins = {_encode_bone(BONE, name, NO_TURN)[:-28]: bone for name, bone in names.items()}
    return begins | {_encode_bone(ROOT, name, NO_TURN)[:-28]: MODEL for name in ("root", "Root")}


def _turn(numbers: tuple[float, ...]) -> Quaternion:
    x, y, z, w = numbers[3:]
    return x, y, z, w


def _on_model(
    turns: dict[str, Quaternion], hips: Place | None, first: tuple[Quaternion, Place], now: tuple[Quaternion, Place]
) -> tuple[dict[str, Quaternion], Place | None]:
    """Bones and hips as they are where the model was first, which has gone and turned since.

    turns: by VRM's names; hips: on the model, metres; first, now: how the model is turned, and where it is.
    """
    before, place = first
    after, there = now
    if first == now or HIPS not in turns:
        return turns, hips
    back = (-before[0], -before[1], -before[2], before[3])
    turned = multiply_quaternions(back, after)
    x, y, z = rotate(back, (there[0] - place[0], there[1] - place[1], there[2] - place[2]))
    if hips is not None:
        a, b, c = rotate(turned, hips)
        hips = (x + a, y + b, z + c)
    return {**turns, HIPS: multiply_quaternions(turned, turns[HIPS])}, hips


def encode_vmc(
    weights: Mapping[str, float],
    head: HeadAngles,
    gaze: GazeAngles,
    time: float,
    figure: Mapping[str, BoneTurn] = MappingProxyType({}),
) -> list[bytes]:
    """The packets of a face. weights: by the names that the receiver's model has; time: seconds; head, gaze: radians;
    figure: the bones of a body by Unity's names, the head among them, none for a head alone."""
    eye = write_unity_quaternion((*gaze, 0.0))
    values = [encode_message(VALUE, name, float(value)) for name, value in weights.items()]
    bones = [_encode_bone(BONE, "LeftEye", eye), _encode_bone(BONE, "RightEye", eye)]
    if figure:
        root = _encode_bone(ROOT, "root", NO_TURN)
        bones += [root, *(_encode_bone(BONE, name, mirror_quaternion(turn), at) for name, (at, turn) in figure.items())]
    else:
        bones.append(_encode_bone(BONE, "Head", write_unity_quaternion(head)))
    begin = [encode_message(OK, 1), encode_message(TIME, float(time)), *bones[:MOST_BONES]]
    more = [bones[at : at + MOST_BONES] for at in range(MOST_BONES, len(bones), MOST_BONES)]
    parts = [values[at : at + MOST_VALUES] for at in range(0, len(values), MOST_VALUES)]
    return [encode_bundle(part) for part in _ended([begin, *more, *parts])]


def _ended(parts: Iterable[list[bytes]]) -> list[list[bytes]]:
    *first, last = parts
    return [*first, [*last, encode_message(APPLY)]]


def _encode_bone(
    address: str, name: str, turn: Quaternion, place: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> bytes:  # fmt: skip
    """The message of a bone. turn: as Unity has it; place: along our axes, metres."""
    x, y, z = place
    return encode_message(address, name, -x, y, z, *(float(component) for component in turn))


def _read(message: OscMessage, count: int) -> tuple[Argument, ...]:
    """So many arguments of a message; what stands behind them is for newer versions."""
    if len(message.arguments) < count:
        raise TrackerError(f"{message.address} has {len(message.arguments)} arguments, expected {count}")
    return message.arguments[:count]


def _number(value: Argument, message: OscMessage) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not -1e12 < value < 1e12:
        raise TrackerError(f"{message.address} has {_shown(value)} where a number is expected")
    return float(value)


def _name(value: Argument, message: OscMessage) -> str:
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST_NAME:
        raise TrackerError(f"{message.address} has {_shown(value)} where a name is expected")
    return value


def _is_found(message: OscMessage) -> bool:
    """Whether the sender has a model and sees its performer: the first number, and since 2.7 the fourth."""
    loaded, *more = (_number(number, message) for number in message.arguments[:4] or _read(message, 1))
    return loaded != 0.0 and (len(more) < 3 or more[2] != 0.0)


def open_vmc() -> Callable[[bytes], list[TrackerFrame]]:
    """A decoder for another sender."""
    return VmcDecoder().decode


def _shown(value: Argument) -> str:
    """A value as it is quoted; of a long text its beginning."""
    return repr(value[:36] if isinstance(value, str | bytes) else value)
