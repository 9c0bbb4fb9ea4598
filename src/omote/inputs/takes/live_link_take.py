"""The CSV files of the app Live Link Face: one row a frame, found by its header, never by the place of a column.

`Timecode` is `hours:minutes:seconds:frame.part`. The app counts frames at 60 a second, whatever rate it records at; a
time code of its own or of a Tentacle counts at 24, 25, 30 or others, and drops numbers with `;` (SMPTE 12M). So the
rate is read from where the seconds change, and is 60 where they do not. Rows without a face, and of dropped frames,
have no values; they are left out and counted. Spreadsheets of some countries write semicolons between columns and
commas before decimals.
"""

from __future__ import annotations

import csv
import math
import re
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple, TypeVar

from omote.inputs.takes.take import Take, TakeNotes
from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS
from omote.inputs.trackers.head_angles import HeadAngles, average_eyes, read_unreal_radians
from omote.inputs.trackers.live_link_face import FRAME_RATE
from omote.inputs.trackers.loose_json import read_number
from omote.inputs.trackers.tracker_frame import LeftOut, TrackerFrame

T = TypeVar("T")
TIME = "Timecode"
SEPARATORS = ",;\t"
DAY = 86400.0
MOST_ROWS = 1_000_000
RATES = (24, 25, 30, 48, 50, 60, 120)
"""Frames that a time code counts in a second."""
NEAR = 2.0
"""Frames by which what was counted may be off a rate; where it is further from all, frames are missing."""
ANGLES = {who: tuple(f"{who}{axis}" for axis in ("Yaw", "Pitch", "Roll")) for who in ("Head", "LeftEye", "RightEye")}
SEEN_APART = math.radians(1.0)
"""Of the eyes' yaws, what is said."""
_TIME_CODE = re.compile(r"(\d{1,2}):(\d{1,2}):(\d{1,2})([:;])(\d{1,3}(?:\.\d+)?)")


def read_live_link_take(text: str) -> Take:
    """The recording of a file's text; ValueError with what is wrong where no row of it is a frame. What of it is no
    number is as it was before, what is out of range at its end; both are among its notes."""
    header, rows = read_table(text)
    names = {column: found[0] for column in header if len(found := ARKIT_CHANNELS.find(column)) == 1}
    time = next((column for column in header if column.lower() == TIME.lower()), None)
    if time is None or not names:
        raise ValueError(f"the file has no column {TIME} or none of ARKit's; expected one of Live Link Face")
    codes = list[TimeCode]()
    frames = list[TrackerFrame]()
    faceless = list[str]()
    apart = 0.0
    notes = TakeNotes()
    for number, row in enumerate(rows, 2):
        if number > MOST_ROWS:
            raise ValueError(f"the file has more than {MOST_ROWS} rows")
        if not row:
            notes.add("commas", f"row {number} is left out: its commas stand between columns and before decimals")
            continue
        if len(row) < len(header) or not any(row[column] for column in names):
            faceless += _faceless_times(row, time)
            continue  # it is cut off, or has no face
        try:
            codes.append(read_time_code(row[time]))
        except ValueError as error:
            notes.add("row", f"row {number} is left out: {error}")
            continue
        frame = _read_row(row, names)
        notes.add_values(LeftOut(name, f"row {number}: {reason}") for name, reason in frame.left_out)
        frames.append(frame)
        apart = max(apart, _eyes_apart(row))
    if not frames and (said := notes.sentences()):
        raise ValueError(f"the file has no frame: {said[0]}")
    rate = find_rate(codes)
    made = _make_take(tuple(dict.fromkeys(names.values())), [code.at(rate) for code in codes], frames, notes)
    return replace(made, notes=(*_tell_faceless(faceless, codes, rate), *_tell_apart(apart), *made.notes))


def read_table(text: str) -> tuple[list[str], Iterator[dict[str, str]]]:
    """The header and the rows of a table of text, cells by column, whatever separates them."""
    lines = text.lstrip("\ufeff").splitlines()
    first = next((line for line in lines if line.strip()), "")
    separator = max(SEPARATORS, key=first.count)
    table = csv.reader((line for line in lines if line.strip()), delimiter=separator)
    header = [cell.strip() for cell in next(table, [])]
    return header, (dict(zip(header, _cells(row, len(header)), strict=False)) for row in table)


def _cells(row: list[str], columns: int) -> list[str]:
    """The cells of a row. Where commas separate columns and decimals too, each value has two: all but the count of
    them, and the time code in some; none where they cannot be told apart."""
    cells = [cell.strip() for cell in row]
    more = len(cells) - 2 * columns + 3
    if len(cells) <= columns or any("." in cell or not cell for cell in cells[more:]):
        return cells
    values = cells[more + 1 :]
    if more not in (1, 2):
        return []
    joined = (f"{whole}.{part}" for whole, part in zip(values[::2], values[1::2], strict=True))
    return [".".join(cells[:more]), cells[more], *joined]


def is_table_cut(text: str) -> bool:
    """Whether a file ends within a row: the last has fewer columns than its header."""
    header, rows = read_table(text)
    last = next(iter(deque(rows, maxlen=1)), None)
    return last is not None and len(last) < len(header) and not text.endswith(("\n", "\r"))


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
    match = _TIME_CODE.fullmatch(text.strip().replace(",", "."))
    if match is None:
        raise ValueError(f"{text[:40]!r} is no time code such as 13:13:04:31.652")
    hours, minutes, seconds = (int(match[part]) for part in (1, 2, 3))
    return TimeCode(3600 * hours + 60 * minutes + seconds, float(match[5]), match[4] == ";")


def _read_row(row: Mapping[str, str], names: Mapping[str, str]) -> TrackerFrame:
    weights = {name: read_number(row[column]) for column, name in names.items()}
    small = {column.lower(): cell for column, cell in row.items()}
    head, left, right = (_read_angles(small, columns) for columns in ANGLES.values())
    return TrackerFrame(weights, head, average_eyes((left[:2], right[:2])))


def _read_angles(row: Mapping[str, str], columns: tuple[str, ...]) -> HeadAngles:
    yaw, pitch, roll = (read_number(row.get(column.lower()) or "0") for column in columns)
    return read_unreal_radians(yaw, pitch, roll)


def _eyes_apart(row: Mapping[str, str]) -> float:
    """Radians by which one eye is turned farther aside than the other; 0 where only one is known."""
    small = {column.lower(): cell for column, cell in row.items()}
    left, right = (read_number(small.get(columns[0].lower())) for columns in (ANGLES["LeftEye"], ANGLES["RightEye"]))
    return abs(left - right) if math.isfinite(left - right) else 0.0


def _tell_apart(apart: float) -> list[str]:
    """That one gaze has no convergence, in a sentence; none where the eyes were turned alike. apart: radians."""
    if apart < SEEN_APART:
        return []
    return [f"both eyes are turned by their mean; how far they converge (to {math.degrees(apart):.0f} degrees) is lost"]


def _make_take(names: tuple[str, ...], times: list[float], frames: list[TrackerFrame], notes: TakeNotes) -> Take:
    """The recording; angles that are never other than 0 were not recorded."""
    weights = dict.fromkeys(names, 0.0)
    values = [tuple((weights := {**weights, **frame.weights})[name] for name in names) for frame in frames]
    since = [0.0]
    for before, now in pairwise(times):
        since.append(since[-1] + _since(before, now))
    heads = _fill([frame.head for frame in frames], (0.0, 0.0, 0.0))
    gazes = _fill([frame.gaze for frame in frames], (0.0, 0.0))
    return Take(
        names,
        since[: len(frames)],
        values,
        heads if any(map(any, heads)) else (),
        gazes if any(map(any, gazes)) else (),
        notes.sentences(),
    )


def _since(before: float, now: float) -> float:
    """Seconds from one time of the day to a later one, over midnight too; 0 to an earlier one."""
    return max(0.0, now - before if now - before > -DAY / 2 else now - before + DAY)


def _faceless_times(row: Mapping[str, str], time: str) -> list[str]:
    """The time code of a row whose other cells say nothing, as it is written; none of one that is cut off. time: its
    column."""
    cells = [cell for column, cell in row.items() if column != time]
    return [row.get(time, "")] if cells and set(cells) <= {"", "0"} else []


def _tell_faceless(times: Sequence[str], codes: Sequence[TimeCode], rate: int) -> list[str]:
    """How many rows have no face, and when the first has none, in a sentence; none where all have one. times: their
    time codes, as they are written; codes: of the others."""
    if not times or not codes:
        return []
    count = "1 row has" if len(times) == 1 else f"{len(times)} rows have"
    try:
        first = f" (the first at {_since(codes[0].at(rate), read_time_code(times[0]).at(rate)):.1f} s)"
    except ValueError:
        first = ""
    return [f"{count} no face{first}; the motion goes on from the row before to the row after"]


def _fill(angles: Iterable[T | None], before: T) -> list[T]:
    """Angles in which what is missing is as it was before. before: what was before all."""
    filled = []
    for angle in angles:
        before = before if angle is None else angle
        filled.append(before)
    return filled
