"""A motion curve: what was recorded of a character, frame by frame with exact times, and a cubic between frames."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from omote.arrays import Values
from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.perform.channels import GAZE_UNITS
from omote.perform.clips.body_columns import BODY_COLUMN, TRAVEL_COLUMNS, range_of
from omote.perform.clips.clip_parts import BODY, CLIP_PARTS, ClipPart
from omote.perform.clips.sample import AT_REST, CHANNEL, GAZE_COLUMNS, HEAD_COLUMNS, Layout, layout_of
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS, check_within
from omote.perform.mix import HIGHEST, LOWEST

LONGEST_CURVE = 3600.0
"""Seconds."""
MOST_NUMBERS = 2**24
"""In a curve: an hour of sixty columns, sixty times a second, has thirteen million."""
MOST_COLUMNS = 1000
Numbers = Sequence[float] | Values
"""One for each frame."""
NEAR = 1e-7
"""Seconds by which a time may be off a frame and still be it: the sums of time steps of an hour are nearer."""
HEAD_PLACE = LAYER_PARTS.index("head")
GAZE_PLACE = LAYER_PARTS.index("gaze")


@dataclass(frozen=True, eq=False)
class MotionCurve:
    """What a character did: a table of numbers, a row for each frame.

    Parameters
    ----------
    times : sequence of float
        Seconds, rising; those of the recording, or from its beginning.
    layout : Layout
        The columns, each with its part.
    table : array of float64
        (frames, columns): weights of channels, -0.5 to 1.5, and of expressions, -0.1 to 1.1; radians.

    Raises
    ------
    ValueError
        On a table of another shape, on times that do not rise or last too long, and on numbers out of range.
    """

    times: Values
    layout: Layout
    table: Values
    _at: list[float] = field(init=False)

    def __post_init__(self) -> None:
        times = np.asarray(self.times, np.float64)
        table = np.asarray(self.table, np.float64)
        for name, value in {"times": times, "table": table, "_at": times.tolist()}.items():
            object.__setattr__(self, name, value)
        columns = len(self.layout.columns)
        if times.ndim != 1 or not len(times) or table.shape != (len(times), columns) or columns > MOST_COLUMNS:
            raise ValueError(
                f"a motion of {times.shape} times has a table {table.shape}; expected a row for each time and "
                f"{columns} columns, {MOST_COLUMNS} at most"
            )
        if table.size > MOST_NUMBERS:
            raise ValueError(f"a motion has {table.size} numbers; expected at most {MOST_NUMBERS}: cut it into two")
        if not (np.isfinite(times).all() and (np.diff(times) > NEAR).all()):
            raise ValueError("the times of a motion do not rise; give each frame once, in their order, in seconds")
        check_within(float(times[-1] - times[0]), 0.0, LONGEST_CURVE, "the length of a motion (seconds)")
        self._check_columns()

    def _check_columns(self) -> None:
        if not set(AT_REST) <= set(self.layout.columns):
            raise ValueError(f"a motion has no column {', '.join(sorted(set(AT_REST) - set(self.layout.columns)))}")
        for turns in (HEAD_COLUMNS, GAZE_COLUMNS, TRAVEL_COLUMNS):
            if 0 < len(set(turns) & set(self.layout.columns)) < len(turns):
                raise ValueError(f"a motion that has one of {', '.join(turns)} has all of them")
        low, high = (np.array(ends) for ends in zip(*map(_range_of, self.layout.columns), strict=True))
        wrong = ~((self.table >= low - 1e-6) & (self.table <= high + 1e-6)).all(axis=0)
        if wrong.any():
            place = int(np.argmax(wrong))
            column = self.table[:, place]
            worst = float(column[np.argmax(np.abs(np.nan_to_num(column, nan=np.inf)))])
            check_within(worst, low[place], high[place], f"{self.layout.columns[place]} of a motion")

    @property
    def start(self) -> float:
        """The time of the first frame, seconds."""
        return self._at[0]

    @property
    def stop(self) -> float:
        """The time of the last frame, seconds."""
        return self._at[-1]

    @cached_property
    def parts(self) -> tuple[ClipPart, ...]:
        """The parts that it moves: the four regions, head, gaze and body where it has them."""
        first = {"head": HEAD_COLUMNS[0], "gaze": GAZE_COLUMNS[0], "body": TRAVEL_COLUMNS[0]}
        return tuple(part for part in CLIP_PARTS if first.get(part, AT_REST[0]) in self.layout.columns)

    def values(self, time: float) -> Values:
        """The numbers of all columns at a time; at that of a frame its own to the bit, outside those of the nearest.

        Parameters
        ----------
        time : float
            Seconds, as `times`.

        Returns
        -------
        array of float64
            (columns,). Between frames a cubic whose slope at each frame is that of the parabola through it and its two
            neighbours (Catmull and Rom 1974, of unequal steps), so speed is continuous; it is linear in the values, so
            mixes go on to sum to one.
        """
        at = self._at
        place = bisect_right(at, time + NEAR) - 1
        if place < 0:
            return np.asarray(self.table[0])
        if place == len(at) - 1 or time - at[place] <= NEAR:
            return np.asarray(self.table[place])
        step = at[place + 1] - at[place]
        u = (time - at[place]) / step
        left = 1.0 - u
        before = self.table[place]
        after = self.table[place + 1]
        bend = u * left * step
        mixed = before + (u * u * (3.0 - 2.0 * u)) * (after - before)
        return np.asarray(mixed + bend * (left * self._slope(place) - u * self._slope(place + 1)))

    def _slope(self, place: int) -> Values:
        """How fast all columns change at a frame, per second."""
        at = self._at
        last = len(at) - 1
        if last == 0:
            return np.zeros(self.table.shape[1])
        if place == 0 or place == last:
            first = min(place, last - 1)
            return np.asarray((self.table[first + 1] - self.table[first]) / (at[first + 1] - at[first]))
        earlier = at[place] - at[place - 1]
        later = at[place + 1] - at[place]
        backward = (self.table[place] - self.table[place - 1]) / earlier
        forward = (self.table[place + 1] - self.table[place]) / later
        return np.asarray((later * backward + earlier * forward) / (earlier + later))


def make_curve(
    times: Numbers,
    channels: Mapping[str, Numbers],
    part_of: Mapping[str, int],
    *,
    mixes: Mapping[PlayRegion, Mapping[str, Numbers]] | None = None,
    head: Sequence[Sequence[float]] | Values | None = None,
    gaze: Sequence[Sequence[float]] | Values | None = None,
    body: Mapping[str, Values] | None = None,
) -> MotionCurve:
    """The curve of numbers by name.

    Parameters
    ----------
    times : sequence of float
        Seconds of each frame, rising.
    channels : mapping
        Weights by channel, one for each frame. The eight that turn the eyes are left out where there is a gaze, which
        turns them.
    part_of : mapping of int
        The place of the part of each channel among `LAYER_PARTS`; one that it does not name acts on the whole face.
    mixes : mapping, optional
        Of each play region the weights by expression, one for each frame; neutral where there are none.
    head : sequence, optional
        Yaw, pitch and roll of each frame, radians.
    gaze : sequence, optional
        Yaw and pitch of each frame, radians.
    body : mapping, optional
        Of `body_columns`.

    Returns
    -------
    MotionCurve
        Its columns sorted by name.

    Raises
    ------
    ValueError
        As `MotionCurve`.
    """
    count = len(times)
    columns: dict[str, tuple[int, Numbers]] = {}
    for name, values in channels.items():
        if gaze is None or name not in GAZE_UNITS:
            columns[f"{CHANNEL}/{name}"] = (part_of.get(name, WHOLE), values)
    for place, region in enumerate(PLAY_REGIONS):
        mix = (mixes or {}).get(region) or {NEUTRAL: [1.0] * count}
        whole = mix if NEUTRAL in mix else {**mix, NEUTRAL: [0.0] * count}
        columns |= {f"{region}/{name}": (place, weights) for name, weights in whole.items()}
    for names, place, turns in ((HEAD_COLUMNS, HEAD_PLACE, head), (GAZE_COLUMNS, GAZE_PLACE, gaze)):
        if turns is not None:
            angles = np.asarray(turns, np.float64).reshape(count, len(names))
            columns |= {name: (place, angles[:, at].tolist()) for at, name in enumerate(names)}
    columns |= {name: (BODY, values) for name, values in (body or {}).items()}
    names = tuple(sorted(columns))
    layout = layout_of(names, tuple(columns[name][0] for name in names))
    return MotionCurve(np.asarray(times), layout, np.array([columns[name][1] for name in names], np.float64).T)


def _range_of(column: str) -> tuple[float, float]:
    """The least and the largest number of a column; ValueError for a name that none has."""
    part, _, name = column.partition("/")
    limits = {"head": HEAD_LIMITS, "gaze": GAZE_LIMITS}.get(part, {})
    if name in limits:
        return -limits[name], limits[name]
    if part == CHANNEL and name:
        return CHANNEL_LOWEST, 3.0 if name in GAZE_UNITS else CHANNEL_HIGHEST
    if part in PLAY_REGIONS and name:
        return LOWEST, HIGHEST
    most = range_of(name) if part == BODY_COLUMN else None
    if most is not None:
        return -most, most
    raise ValueError(
        f"there is no column {column[:80]!r} of a motion; expected channel/NAME, REGION/NAME, body/BONE/x or an angle"
    )
