"""Clips as the CSV files of the app Live Link Face: a time code, 52 weights and nine angles a row, at 60 frames."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

import numpy as np

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.clips.clip_frames import USUAL_RATE, ClipFrames
from omote.model.space.expression import Expression
from omote.perform.limits import CHANNEL_HIGHEST

SWAPPED = {"jawLeft": "jawRight", "jawRight": "jawLeft", "mouthLeft": "mouthRight", "mouthRight": "mouthLeft"}
"""The app's columns of these stand the other way round than its packets have them."""
COLUMNS = tuple(SWAPPED.get(name, name) for name in ARKIT_NAMES)
ANGLES = tuple(f"{who}{axis}" for who in ("Head", "LeftEye", "RightEye") for axis in ("Yaw", "Pitch", "Roll"))
DIGITS = 10
OVERSHOOT = 0.02
"""By which a curve between frames may be below 0 where no frame is."""


def live_link_csv(frames: ClipFrames, expressions: Mapping[str, Expression]) -> tuple[str, tuple[str, ...]]:
    """The text of a clip, and what of it the format has no column for, in sentences.

    Parameters
    ----------
    frames : ClipFrames
        At 60 frames a second.
    expressions : mapping of Expression
        Of the cast: which weights turn the eyes as the gaze does.

    Returns
    -------
    tuple of (str, tuple of str)
        Weights from 0 to 1.5. Angles are Unreal's: + yaw is right, + pitch down.

    Raises
    ------
    ValueError
        On another rate.
    """
    if frames.rate != USUAL_RATE:
        raise ValueError(f"Live Link Face counts {USUAL_RATE:g} frames a second, not {frames.rate:g}")
    weights = frames.turning_eyes(expressions)
    lost = sorted(name for name, values in weights.items() if name not in COLUMNS and values.any())
    notes = [*frames.notes, *(f"{name} is no coefficient of ARKit, and is left out" for name in lost)]
    still = np.zeros(len(frames.times))
    table = np.column_stack([weights.get(name, still) for name in COLUMNS])
    below = sorted(name for name, values in zip(COLUMNS, table.T, strict=True) if values.min() < -OVERSHOOT)
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


def time_code(frame: int) -> str:
    """The time code of a frame, counted at 60 a second from midnight."""
    seconds, part = divmod(frame, round(USUAL_RATE))
    minutes, second = divmod(seconds, 60)
    return f"{minutes // 60:02}:{minutes % 60:02}:{second:02}:{part:02}.000"
