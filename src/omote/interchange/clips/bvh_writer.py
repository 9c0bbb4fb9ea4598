"""Head and eyes of a clip as BVH, the text format of motion capture: a hierarchy of joints, and angles by frames."""

from __future__ import annotations

import io

import numpy as np

from omote.interchange.clips.clip_frames import ClipFrames

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


def bvh_text(frames: ClipFrames) -> str:
    """The text of head and eyes; angles in degrees about y, then x, then z, each right-handed: + is to the character's
    left, down, and to its right."""
    still = np.zeros((len(frames.times), 1))
    head = frames.head * [1.0, -1.0, -1.0]
    eye = np.column_stack([frames.gaze * [1.0, -1.0], still])
    rows = np.column_stack([np.zeros((len(still), 3)), *(np.degrees(turns) for turns in (head, eye, eye))]) + 0.0
    text = io.StringIO()
    text.write(HIERARCHY)
    text.write(f"MOTION\nFrames: {len(rows)}\nFrame Time: {1.0 / frames.rate:.9f}\n")
    for row in rows.tolist():
        text.write(" ".join(f"{value:.6f}" for value in row) + "\n")
    return text.getvalue()
