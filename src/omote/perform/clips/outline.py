"""What a lane of a clip moves most, as a few curves to be drawn."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.model.known_names import NEUTRAL
from omote.perform.clips.body_columns import BODY_COLUMN, range_of
from omote.perform.clips.clip import Lane
from omote.perform.clips.clip_parts import place_of_part
from omote.perform.clips.motion_curve import MotionCurve
from omote.perform.clips.sample import GAZE_COLUMNS, HEAD_COLUMNS
from omote.perform.layers.layer_names import WHOLE
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS

POINTS = 400
"""Of a curve: as many as a picture of it has pixels."""
MOST_MOVED = 3
_TURNS = {f"head/{name}": limit for name, limit in HEAD_LIMITS.items()}
_TURNS |= {f"gaze/{name}": limit for name, limit in GAZE_LIMITS.items()}


def outline_lane(lane: Lane, points: int = POINTS) -> dict[str, list[float]]:
    """What a lane moves most, by column: of its parts, those that change most first.

    lane: of a clip; points: how many values of each, at equal steps from its first frame to its last. Weights are as
    they are, angles are parts of the most that head, gaze or a bone
    turn, and places of the farthest that hips and feet go.
    """
    times = np.linspace(lane.curve.start, lane.curve.stop, points)
    shown = _values(lane.curve, times)
    for span in lane.spans:
        inside = (times > span.start) & (times < span.stop)
        for column, values in _values(span.curve, times).items():
            shown[column] = np.where(inside, values, shown.get(column, np.zeros(points)))
    given = {place_of_part(part) for part in lane.parts} | {WHOLE}
    curves = (lane.curve, *(span.curve for span in lane.spans))
    place = {
        name: part for curve in curves for name, part in zip(curve.layout.columns, curve.layout.parts, strict=True)
    }
    moved = [name for name in sorted(shown) if place[name] in given and np.any(shown[name]) and not _is_rest(name)]
    moved.sort(key=lambda name: (-np.ptp(shown[name]), -np.max(np.abs(shown[name]))))
    return {name: np.round(shown[name], 3).tolist() for name in moved[:MOST_MOVED]}


def _is_rest(column: str) -> bool:
    """Whether a column is what expressions leave of a region."""
    return column not in (*HEAD_COLUMNS, *GAZE_COLUMNS) and column.partition("/")[2] == NEUTRAL


def _values(curve: MotionCurve, times: Values) -> dict[str, Values]:
    """The numbers of a curve at some times (of the nearest frames), by column; angles as parts of their limits."""
    nearest = np.clip(np.searchsorted(curve.times, times), 0, len(curve.times) - 1)
    table = curve.table[nearest]
    return {name: table[:, at] / _most(name) for at, name in enumerate(curve.layout.columns)}


def _most(column: str) -> float:
    """What a column is drawn as a part of: for weights 1."""
    part, _, name = column.partition("/")
    return (range_of(name) or 1.0) if part == BODY_COLUMN else _TURNS.get(column, 1.0)
