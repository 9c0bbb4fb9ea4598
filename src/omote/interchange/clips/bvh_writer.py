"""Clips as BVH, the text format of motion capture: a hierarchy of joints, and angles by frames; of a whole humanoid
where a clip has a body, else of head and eyes."""

from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.interchange.clips.body_motion import AnimatedBody
from omote.interchange.clips.clip_frames import ClipFrames
from omote.interchange.clips.humanoid_motion import HIPS, parent_among

HIERARCHY = """HIERARCHY
ROOT Head
{
\tOFFSET 0 0 0
\tCHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation
\tJOINT LeftEye
\t{
\t\tOFFSET 3.2 6.6 9.3
\t\tCHANNELS 3 Yrotation Xrotation Zrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 0 0 1.2
\t\t}
\t}
\tJOINT RightEye
\t{
\t\tOFFSET -3.2 6.6 9.3
\t\tCHANNELS 3 Yrotation Xrotation Zrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 0 0 1.2
\t\t}
\t}
}
"""
"""Centimetres, y up, the face along z: eyes of a grown head from where it turns on the neck."""
CENTIMETRES = 100.0
ENDS = {
    "head": (0.0, 0.2, 0.0), "Toes": (0.0, 0.0, 0.06), "ThumbDistal": (0.02, 0.0, 0.02), "": (0.02, 0.0, 0.0),
}  # fmt: skip
"""Where bones end on which no other hangs, metres from where they begin, x away from the middle; toes end on the
floor."""


def bvh_text(frames: ClipFrames) -> str:
    """The text of head and eyes; angles in degrees about y, then x, then z, each right-handed: + is to the character's
    left, down, and to its right."""
    still = np.zeros((len(frames.times), 1))
    head = frames.head * [1.0, -1.0, -1.0]
    eye = np.column_stack([frames.gaze * [1.0, -1.0], still])
    rows = np.column_stack([np.zeros((len(still), 3)), *(np.degrees(turns) for turns in (head, eye, eye))]) + 0.0
    return HIERARCHY + _motion(rows, frames.rate)


def humanoid_bvh(body: AnimatedBody, rate: float) -> str:
    """The text of a whole humanoid, at rest in T-pose on the floor; centimetres, and degrees about y, then x, then z.

    body: what its bones do, and where they are at rest; rate: frames of a second.
    """
    motion = body.motion
    places = body.places
    text = io.StringIO()
    text.write("HIERARCHY\n")
    order: list[int] = []
    _write_joint(text, motion.names, places * CENTIMETRES, HIPS, 0, order)
    turns = Rotation.from_quat(motion.turns[:, order].reshape(-1, 4)).as_euler("YXZ", degrees=True)
    hips = (motion.hips * body.leg + places[motion.names.index(HIPS)] * [0.0, 1.0, 0.0]) * CENTIMETRES
    return text.getvalue() + _motion(np.column_stack([hips, turns.reshape(len(hips), -1)]), rate)


def _write_joint(
    text: io.StringIO, names: Sequence[str], offsets: Points, name: str, depth: int, order: list[int]
) -> None:
    """Writes a joint with all that hang on it, and notes the order in which they come."""
    place = names.index(name)
    order.append(place)
    indent = "\t" * depth
    moves = "6 Xposition Yposition Zposition" if depth == 0 else "3"
    kind = "ROOT" if depth == 0 else "JOINT"
    at = np.zeros(3) if depth == 0 else offsets[place]
    text.write(f"{indent}{kind} {name[0].upper()}{name[1:]}\n{indent}{{\n{indent}\tOFFSET {_numbers(at)}\n")
    text.write(f"{indent}\tCHANNELS {moves} Yrotation Xrotation Zrotation\n")
    below = [each for each in names if each != HIPS and parent_among(each, names) == name]
    for each in below:
        _write_joint(text, names, offsets, each, depth + 1, order)
    if not below:
        end = _end(name)
        if name.endswith("Toes"):
            end = end - [0.0, _height(name, names, offsets), 0.0]
        text.write(f"{indent}\tEnd Site\n{indent}\t{{\n{indent}\t\tOFFSET {_numbers(end)}\n{indent}\t}}\n")
    text.write(f"{indent}}}\n")


def _height(name: str, names: Sequence[str], offsets: Points) -> float:
    """How high a bone begins above the floor, centimetres."""
    height = 0.0
    while name:
        height += float(offsets[names.index(name), 1])
        name = parent_among(name, names)
    return height


def _end(name: str) -> Points:
    """Where a bone ends on which no other hangs, centimetres from where it begins."""
    end = next(np.array(at) for of, at in ENDS.items() if name.endswith(of))
    return end * CENTIMETRES * ([-1.0, 1.0, 1.0] if name.startswith("right") else [1.0, 1.0, 1.0])


def _motion(rows: Values, rate: float) -> str:
    """The frames of a file, a row (c,) each."""
    text = io.StringIO()
    text.write(f"MOTION\nFrames: {len(rows)}\nFrame Time: {1.0 / rate:.9f}\n")
    for row in (rows + 0.0).tolist():
        text.write(" ".join(f"{value:.6f}" for value in row) + "\n")
    return text.getvalue()


def _numbers(values: Points) -> str:
    return " ".join(f"{value:.6f}" for value in (values + 0.0).tolist())
