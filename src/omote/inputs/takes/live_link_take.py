"""The CSV files of the app Live Link Face: one row a frame, found by its header, never by the place of a column.

`Timecode` is `hours:minutes:seconds:frame.part`. The app counts frames at 60 a second, whatever rate it records at; a
time code of its own or of a Tentacle counts at 24, 25, 30 or others, and drops numbers with `;` (SMPTE 12M). So the
rate is read from where the seconds change, and is 60 where they do not. Rows of dropped frames have no values; they are
left out.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from omote.inputs.takes.take import Take
from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS
from omote.inputs.trackers.head_angles import HeadAngles, average_eyes, read_unreal_radians
from omote.inputs.trackers.live_link_face import FRAME_RATE
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame

TIME = "Timecode"
COUNT = "BlendShapeCount"
DAY = 86400.0
MOST_ROWS = 1_000_000
RATES = (24, 25, 30, 48, 50, 60, 120)
"""Frames that a time code counts in a second."""
NEAR = 2.0
"""Frames by which what was counted may be off a rate; where it is further from all, frames are missing."""
ANGLES = {who: tuple(f"{who}{axis}" for axis in ("Yaw", "Pitch", "Roll")) for who in ("Head", "LeftEye", "RightEye")}
_TIME_CODE = re.compile(r"(\d{1,2}):(\d{1,2}):(\d{1,2})([:;])(\d{1,3}(?:\.\d+)?)")


def read_live_link_take(text: str) -> Take:
    """The recording of a file's text; ValueError with the row and what is wrong."""
    rows = csv.DictReader(io.StringIO(text.lstrip("\ufeff")))
    columns = rows.fieldnames or []
    names = {column: ARKIT_CHANNELS.find(column)[0] for column in columns if ARKIT_CHANNELS.find(column)}
    if TIME not in columns or not names:
        raise ValueError(f"the file has no column {TIME} or none of ARKit's; expected one of Live Link Face")
    codes = list[TimeCode]()
    frames = list[TrackerFrame]()
    for number, row in enumerate(rows, 2):
        if number > MOST_ROWS:
            raise ValueError(f"the file has more than {MOST_ROWS} rows")
        if all(row[column] for column in names) and None not in row.values():  # such a row is cut off
            try:
                codes.append(read_time_code(row[TIME] or ""))
                frames.append(_read_row(row, names))
            except (TrackerError, ValueError) as error:
                raise ValueError(f"row {number}: {error}") from error
    rate = find_rate(codes)
    return _make_take(tuple(names.values()), [code.at(rate) for code in codes], frames)


def is_table_cut(text: str) -> bool:
    """Whether a file ends within a row: the last has fewer columns than its header."""
    rows = [row for row in csv.reader(io.StringIO(text.lstrip("\ufeff"))) if row]
    return len(rows) > 1 and len(rows[-1]) < len(rows[0]) and not text.endswith("\n")


class TimeCode(NamedTuple):
    """A time code: whole seconds of the day, frames with their part, and whether it drops numbers."""

    seconds: int
    frame: float
    drops: bool = False

    def at(self, rate: int) -> float:
        """The seconds of the day; rate: frames of a second, which are 1000 of 1001 where it drops numbers."""
        if not self.drops:
            return self.seconds + self.frame / rate
        minutes = self.seconds // 60
        dropped = rate // 15 * (minutes - minutes // 10)
        return (self.seconds * rate + self.frame - dropped) * 1.001 / rate


def find_rate(codes: Sequence[TimeCode]) -> int:
    """The frames that time codes count in a second: what lies between two, where the second changes; 60 where none
    does."""
    pairs = list(pairwise(codes))
    steps = sorted(later.frame - before.frame for before, later in pairs if later.seconds == before.seconds)
    turns = [before.frame - later.frame for before, later in pairs if later.seconds == before.seconds + 1]
    if not steps or not turns:
        return FRAME_RATE
    counted = sorted(turns)[len(turns) // 2] + steps[len(steps) // 2]
    most = max(code.frame for code in codes)
    near = [rate for rate in RATES if rate > most and abs(rate - counted) <= NEAR]
    return min(near, key=lambda rate: abs(rate - counted), default=FRAME_RATE)


def read_time_code(text: str) -> TimeCode:
    """A time code as it is written; ValueError where it is none."""
    match = _TIME_CODE.fullmatch(text.strip())
    if match is None:
        raise ValueError(f"{text[:40]!r} is no time code such as 13:13:04:31.652")
    hours, minutes, seconds = (int(match[part]) for part in (1, 2, 3))
    return TimeCode(3600 * hours + 60 * minutes + seconds, float(match[5]), match[4] == ";")


def _read_row(row: Mapping[str, str | None], names: Mapping[str, str]) -> TrackerFrame:
    weights = {name: float(row[column] or 0.0) for column, name in names.items()}
    head, left, right = (_read_angles(row, columns) for columns in ANGLES.values())
    return TrackerFrame(weights, head, average_eyes((left[:2], right[:2])))


def _read_angles(row: Mapping[str, str | None], columns: tuple[str, ...]) -> HeadAngles:
    yaw, pitch, roll = (float(row.get(column) or 0.0) for column in columns)
    return read_unreal_radians(yaw, pitch, roll)


def _make_take(names: tuple[str, ...], times: list[float], frames: list[TrackerFrame]) -> Take:
    """The recording; angles that are never other than 0 were not recorded."""
    since = [0.0]
    for before, now in pairwise(times):
        step = now - before if now - before > -DAY / 2 else now - before + DAY  # over midnight
        since.append(since[-1] + max(0.0, step))
    heads = [frame.head or (0.0, 0.0, 0.0) for frame in frames]
    gazes = [frame.gaze or (0.0, 0.0) for frame in frames]
    return Take(
        names,
        since[: len(frames)],
        [tuple(frame.weights.values()) for frame in frames],
        heads if any(map(any, heads)) else (),
        gazes if any(map(any, gazes)) else (),
    )
