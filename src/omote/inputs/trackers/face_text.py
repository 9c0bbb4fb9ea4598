"""Frames of iFacialMocap and Facemotion3D: a text with a name and a number for each coefficient, then angles.

`name-value|...|=head#rx,ry,rz,px,py,pz|rightEye#rx,ry,rz|leftEye#rx,ry,rz|`, in version 2 `name&value`; values in
percent, angles in degrees. Source: ifacialmocap.com/for-developer and facemotion3d.net/for-developer. Real frames lack
coefficients, hold others and loose ends: what is unknown is left out, what is missing is kept. Strangers write spaces,
commas for points, names in any case and angles before coefficients: what is not as the vendors write it is read so.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

from omote.inputs.trackers.decimal_commas import join_decimals
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, average_eyes, read_right_handed_degrees
from omote.inputs.trackers.loose_json import read_text
from omote.inputs.trackers.tracker_frame import MOST_SHAPES, LeftOut, TrackerError, TrackerFrame

IFACIALMOCAP_START = b"iFacialMocap_sahuasouryya9218sauhuiayeta91555dy3719|sendDataVersion=v2"
IFACIALMOCAP_STREAM = IFACIALMOCAP_START.replace(b"Mocap_", b"Mocap_UDPTCP_", 1)
FACEMOTION3D_START = b"FACEMOTION3D_OtherStreaming"
FACEMOTION3D_STREAM = FACEMOTION3D_START + b"|protocol=tcp"
"""What asks the apps for frames: over UDP, and over TCP, which they open to us."""
LONGEST_FRAME = 16384
STATUS = "trackingstatus"
TURNS: Mapping[str, int] = {"head": 6, "leftEye": 3, "rightEye": 3}
"""What turns, and how many numbers each has: the head has a place too."""
_SPELLED = {name.lower(): name for name in TURNS}
_LOOSE = re.compile(r"\s*([^\W\d][\w .-]*?)\s*[&-]\s*([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?)\s*")
_NAMED = re.compile(r"\s*([^\W\d]\w*)\s*[&-](.*)", re.DOTALL)


def decode_face_text(data: bytes, *, cut: bool = False) -> list[TrackerFrame]:
    """The frame of a packet; TrackerError where it is none. data: its bytes; cut: whether it ends within a field."""
    if len(data) > LONGEST_FRAME:
        raise TrackerError(f"the frame has {len(data)} bytes, but at most {LONGEST_FRAME} are read")
    try:
        text = data.decode("ascii")
    except UnicodeDecodeError:
        text = read_text(data)
    left_out: list[LeftOut] = []
    if cut:
        text, _, rest = text.rpartition("|")
        left_out.append(LeftOut("", f"a packet ends within {rest[:40]!r}"))
    shapes, _, turns = text.partition("=")
    if "#" in shapes or turns.count("#") < turns.count("|"):  # fields in another order
        turns = text.replace("=", "|")
        shapes = "|".join(field for field in turns.split("|") if "#" not in field)
    fields = [field for field in shapes.split("|") if field]
    if len(fields) > MOST_SHAPES:
        left_out.append(LeftOut("", f"the frame has {len(fields)} fields, of which {MOST_SHAPES} are read"))
        del fields[MOST_SHAPES:]
    weights = dict(shape for field in fields if (shape := _read_shape(field, left_out)) is not None)
    angles = _read_turns(turns, "," in shapes and "." not in text, left_out)
    if not weights and not angles and len(left_out) == int(cut):  # only a field that is cut off: of another protocol
        raise TrackerError(_explain(data))
    status = next((name for name in weights if name.lower() == STATUS), "")
    found = not status or weights.pop(status) != 0.0
    gaze = average_eyes(None if (eye := angles.get(name)) is None else eye[:2] for name in ("leftEye", "rightEye"))
    return [TrackerFrame(weights, angles.get("head"), gaze, found=found, left_out=tuple(left_out))]


def encode_face_text(weights: dict[str, float], head: HeadAngles, gaze: GazeAngles) -> bytes:
    """The frame of version 2 for weights by their names, whole percents. head, gaze: radians."""
    shapes = "|".join(f"{name}&{round(100.0 * value)}" for name, value in weights.items())
    turn = ",".join(f"{math.degrees(angle):.6f}" for angle in (-head[1], head[0], -head[2]))
    eye = f"{-math.degrees(gaze[1]):.6f},{math.degrees(gaze[0]):.6f},0"
    return f"{shapes}|=head#{turn},0,0,0|rightEye#{eye}|leftEye#{eye}|".encode("ascii")


def _explain(data: bytes) -> str:
    """Why a packet is no frame."""
    if not data.isascii():
        return f"the frame is no text: {data[:16].hex(' ')}"
    return "the frame has no coefficient, such as jawOpen-25"


def _read_shape(field: str, left_out: list[LeftOut]) -> tuple[str, float] | None:
    """A coefficient by its name; None for what is none. A sign belongs to the number: `jawLeft--3`, `jawLeft&-3`."""
    mark = "&" if "&" in field else "-"
    name, separator, number = field.partition(mark)
    if separator and name.replace("_", "").isalnum():
        try:
            return name, 0.01 * float(number)
        except ValueError:
            pass
    if loose := _LOOSE.fullmatch(field):
        return loose[1], 0.01 * float(loose[2].replace(",", "."))
    if named := _NAMED.fullmatch(field):
        left_out.append(LeftOut(named[1], f"{named[1][:40]} is {named[2][:20]!r}, which is no number"))
    return None


def _read_turns(text: str, commas: bool, left_out: list[LeftOut]) -> dict[str, HeadAngles]:
    """The angles of each that turns, by name. commas: whether decimals stand behind commas elsewhere in the frame."""
    said: dict[str, list[str]] = {}
    for field in text.split("|"):
        name, mark, numbers = field.partition("#")
        if mark and (name := name if name in TURNS else _SPELLED.get(name.strip().lower(), "")):
            said[name] = numbers.split(",")
    commas = commas or ("." not in text and any(len(parts) > TURNS[name] for name, parts in said.items()))
    turns = {}
    for name, parts in said.items():
        turn = _read_turn(_join_parts(parts, TURNS[name]) if commas else parts)
        if turn is None:
            left_out.append(LeftOut(name, f"{name} is {','.join(parts)[:60]!r}; expected three angles in degrees"))
        else:
            turns[name] = turn
    return turns


def _read_turn(parts: Sequence[str]) -> HeadAngles | None:
    try:
        x, y, z = (float(part) for part in parts[:3])
    except ValueError:
        return None
    return read_right_handed_degrees(x, y, z)


def _join_parts(parts: Sequence[str], most: int) -> Sequence[str]:
    """The first three of the numbers whose decimals stand behind commas; none where that can be read in several ways.
    most: how many there can be."""
    readings = {tuple(joined[:3]) for count in {most, 3} if (joined := join_decimals(parts, count)) is not None}
    return readings.pop() if len(readings) == 1 else ()
