"""Clips as the CSV files of the app Live Link Face: a time code, 52 weights and nine angles a row, at 60 frames."""

from __future__ import annotations

import csv
import io

import numpy as np

from omote.arrays import Values
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.clips.clip_frames import USUAL_RATE, ClipFrames
from omote.perform.limits import CHANNEL_HIGHEST

SWAPPED = {"jawLeft": "jawRight", "jawRight": "jawLeft", "mouthLeft": "mouthRight", "mouthRight": "mouthLeft"}
"""The app's columns of these stand the other way round than its packets have them."""
COLUMNS = tuple(SWAPPED.get(name, name) for name in ARKIT_NAMES)
ANGLES = tuple(f"{who}{axis}" for who in ("Head", "LeftEye", "RightEye") for axis in ("Yaw", "Pitch", "Roll"))
DIGITS = 10
EYES_REST = 3.77
"""Degrees by which each eye of ARKit's is turned out where its weights are 0."""
EYE_RANGES = {"Up": 26.0, "Down": 35.0, "In": 35.5, "Out": 33.4}
"""Degrees that an eye of ARKit's turns from its rest at the weight 1, by where to."""


def live_link_csv(frames: ClipFrames) -> tuple[str, tuple[str, ...]]:
    """The text of a clip, and what of it the format has no column for, in sentences.

    Parameters
    ----------
    frames : ClipFrames
        At 60 frames a second.

    Returns
    -------
    tuple of (str, tuple of str)
        Weights from 0 to 1.5, those of a gaze to 1. Angles are Unreal's: + yaw is right, + pitch down.

    Raises
    ------
    ValueError
        On another rate.
    """
    if frames.rate != USUAL_RATE:
        raise ValueError(f"Live Link Face counts {USUAL_RATE:g} frames a second, not {frames.rate:g}")
    weights = {**frames.weights, **_turn_eyes(frames)}
    lost = sorted(name for name, values in weights.items() if name not in COLUMNS and values.any())
    notes = [*frames.notes, *(f"{name} is no coefficient of ARKit, and is left out" for name in lost)]
    still = np.zeros(len(frames.times))
    table = np.column_stack([weights.get(name, still) for name in COLUMNS])
    below = sorted(name for name, values in zip(COLUMNS, table.T, strict=True) if values.min() < 0.0)
    notes += [f"{name} goes below 0, where the format ends" for name in below]
    eye = np.column_stack([-frames.gaze, still])
    angles = np.column_stack([frames.head * [-1.0, -1.0, 1.0], eye, eye])
    rows = np.column_stack([np.clip(table, 0.0, CHANNEL_HIGHEST), angles]) + 0.0
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["Timecode", "BlendShapeCount", *(name[0].upper() + name[1:] for name in COLUMNS), *ANGLES])
    for number, row in enumerate(rows.tolist()):
        writer.writerow([time_code(number), len(COLUMNS) + len(ANGLES), *(f"{value:.{DIGITS}f}" for value in row)])
    return text.getvalue(), tuple(notes)


def _turn_eyes(frames: ClipFrames) -> dict[str, Values]:
    """The weights by which ARKit says how the eyes are turned, those of the clip beside its gaze added to them; none
    of a clip without a gaze."""
    if not frames.gaze.any():
        return {}
    left, up = np.degrees(frames.gaze).T
    angles = {
        "UpLeft": up, "DownLeft": -up, "InLeft": EYES_REST - left, "OutLeft": left - EYES_REST,
        "UpRight": up, "DownRight": -up, "InRight": EYES_REST + left, "OutRight": -left - EYES_REST,
    }  # fmt: skip
    still = np.zeros(len(left))
    weights = {}
    for way, angle in angles.items():
        name = f"eyeLook{way}"
        own = frames.weights.get(name, still)
        turned = np.maximum(angle, 0.0) / EYE_RANGES[way.removesuffix("Left").removesuffix("Right")]
        weights[name] = np.minimum(own + turned, 1.0)
    return weights


def time_code(frame: int) -> str:
    """The time code of a frame, counted at 60 a second from midnight."""
    seconds, part = divmod(frame, round(USUAL_RATE))
    minutes, second = divmod(seconds, 60)
    return f"{minutes // 60:02}:{minutes % 60:02}:{second:02}:{part:02}.000"
