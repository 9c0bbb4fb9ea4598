"""Stimuli from a table: a row is a picture or a clip, its columns are the words of `omote render`; all of it is checked
before anything is drawn."""

from __future__ import annotations

import csv
import difflib
import io
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import msgspec

from omote.perform.clips.clip import FASTEST as FASTEST_MOTION
from omote.perform.clips.clip import LONGEST_SHIFT, Clip
from omote.perform.clips.clip import SLOWEST as SLOWEST_MOTION
from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.limits import check_known
from omote.stage_data.clip_poses import MOST_FRAMES, ClipPoses, count_frames
from omote.stage_data.picture_grid import lay_out
from omote.stage_data.picture_request import RenderRequest, check_request, file_name
from omote.stage_data.picture_setting import CONTRASTS, LUMINANCES
from omote.stage_data.playing_cast import PlayingCast
from omote.stage_data.pose_parser import find_pose

if TYPE_CHECKING:
    from omote.model.cast import Cast

NAME = "name"
BEGINNINGS = {"from_face": "face", "from_expression": "expression"}
"""Where a clip begins, by the column of where it ends."""
TRANSITION = ("seconds", "easing", *BEGINNINGS)
"""What a clip has that goes from one face or expression to another."""
MOTION = ("from", "to", "speed")
"""What a motion clip has: the seconds of it that are drawn, and how fast it goes."""
FILMED = ("fps", "format")
"""What both have."""
PICTURES = "png"
FORMATS = (PICTURES, "mov", "webm")
"""What a clip becomes: pictures, and a film of them too."""
RENDERED = tuple(field for field in RenderRequest.__struct_fields__ if field != "show")
COLUMNS = (NAME, *RENDERED, *TRANSITION, *MOTION, *FILMED)
SECONDS = (0.0, LONGEST_SHIFT)
NUMBERS = {"luminance": LUMINANCES, "contrast": CONTRASTS, "at": SECONDS}
"""Columns of numbers, with the least and the largest."""
MIXES = ("face", "expression", "channel")
"""Columns of which a request holds tuples."""
FPS = 25.0
FASTEST = 240.0
LONGEST = 60.0
"""Seconds from one expression to another."""
OF_CLIPS = {
    "seconds": (0.01, LONGEST),
    "fps": (1.0, FASTEST),
    "from": SECONDS,
    "to": SECONDS,
    "at": SECONDS,
    "speed": (SLOWEST_MOTION, FASTEST_MOTION),
}
"""Columns of numbers that are of clips."""
MOST_PICTURES = MOST_FRAMES
LEAST_WEIGHT = 1e-9
SAME_TIME = 1e-6
"""Seconds by which an end that was typed may lie behind the clip's own."""
TYPO = 0.75
"""A heading as near as this to a column's is a slip, and nothing of the experiment's own."""
YES = ("1", "yes", "true", "on")
NO = ("0", "no", "false", "off")
SEPARATORS = ",;\t"


class TableError(ValueError):
    """What is wrong with a table: sentences, each with its row as a spreadsheet counts, and its column."""

    def __init__(self, sentences: Sequence[str]) -> None:
        super().__init__("; ".join(sentences))
        self.sentences = tuple(sentences)


@dataclass(frozen=True)
class Stimulus:
    """One row: its name, what is drawn frame by frame (one, of a picture), frames a second of a clip, else 0.

    row: its number, as a spreadsheet counts; cells: the row as it stands in the table, by heading; format: of
    `FORMATS`; clip: the motion that is drawn, trimmed and at its speed; None: no motion clip.
    """

    name: str
    frames: tuple[RenderRequest, ...]
    fps: float
    row: int
    cells: Mapping[str, str]
    format: str = PICTURES
    clip: Clip | None = None

    @property
    def film(self) -> str:
        """The name of its film, "" for none."""
        return "" if self.format == PICTURES else f"{self.name}.{self.format}"

    @property
    def files(self) -> list[str]:
        """The names of its pictures, below the folder of all."""
        if not self.fps:
            return [f"{self.name}.png"]
        return [f"{self.name}/{number:04d}.png" for number in range(1, len(self.frames) + 1)]


def read_stimuli(
    data: bytes, cast: Cast | PlayingCast, /, *, show: str = "", clips: ClipPoses | None = None
) -> tuple[list[Stimulus], list[str]]:
    """The rows of a CSV, and the headings that are the experiment's own and say nothing here.

    data: the file; cast, clips: which faces, expressions and motion clips may be named; show: the show file of both, ""
    for none. TableError with everything that is wrong.
    """
    heading, rows = _read_rows(data)
    own = [name for name in heading if name and name not in COLUMNS]
    wrong = [_explain_heading(name, near) for name in own if (near := _nearest(name))]
    wrong += [f"row 1: the heading {name!r} comes twice" for name in COLUMNS if heading.count(name) > 1]
    if not rows:
        wrong.append("row 2: there is no row below the headings; write one for each picture")
    reader = _Rows(cast, clips or ClipPoses(cast, {}), show, wrong)
    stimuli = []
    for number, cells in rows:
        row = dict(zip(heading, [*cells, *[""] * len(heading)], strict=False))
        if len(cells) > len(heading):
            reader.wrong.append(f"row {number}: it has {len(cells)} cells, and there are {len(heading)} headings")
        if made := reader.read(number, row):
            stimuli.append(made)
    if (count := sum(len(stimulus.frames) for stimulus in stimuli)) > MOST_PICTURES:
        reader.wrong.append(f"the table has {count} pictures; give {MOST_PICTURES} at most, or several tables")
    if reader.wrong:
        raise TableError(reader.wrong)
    return stimuli, own


def _read_rows(data: bytes) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The headings, lower case, and the rows that are not empty, with their numbers."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise TableError(["the table is no text in UTF-8; save it as CSV UTF-8"]) from None
    first = text.partition("\n")[0]
    separator = max(SEPARATORS, key=first.count)
    try:
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True))
    except csv.Error as error:
        raise TableError([f"the table is no CSV ({error}); save it as CSV UTF-8"]) from None
    heading = [cell.strip().lower().replace(" ", "_") for cell in lines[0]] if lines else []
    if not set(heading) & set(COLUMNS):
        raise TableError([f"row 1: none of the headings is known; there are {', '.join(COLUMNS)}"])
    rows = [(number, [cell.strip() for cell in line]) for number, line in enumerate(lines[1:], 2) if any(line)]
    return heading, rows


def _nearest(name: str) -> str:
    return next(iter(difflib.get_close_matches(name, COLUMNS, n=1, cutoff=TYPO)), "")


def _explain_heading(name: str, near: str) -> str:
    return f"row 1: there is no column {name!r}; write {near}, or another heading where it is your own"


class _Rows:
    """Reads rows one after another, and gathers what is wrong with them."""

    def __init__(self, cast: Cast | PlayingCast, clips: ClipPoses, show: str, wrong: list[str]) -> None:
        self.wrong = wrong
        self._cast = cast
        self._clips = clips
        self._show = show
        self._names: dict[str, int] = {}
        self._known: dict[tuple[str, str], str] = {}
        """What is wrong with a cell, by its column, "" for nothing."""

    def read(self, number: int, row: Mapping[str, str]) -> Stimulus | None:
        """The stimulus of a row, None where something is wrong with it."""
        before = len(self.wrong)
        name = self._read_name(number, row.get(NAME) or f"{number - 1:04d}")
        filled = {column: cell for column in COLUMNS if column != NAME and (cell := row.get(column))}
        for column, cell in filled.items():
            if why := self._check(column, cell):
                self.wrong.append(f"row {number}, {column}: {why}")
        moves = "clip" in filled and "at" not in filled
        self.wrong += _out_of_place(number, filled, moves=moves)
        if len(self.wrong) > before:
            return None
        try:
            clip = _trimmed(self._clips.find(filled["clip"]), filled) if moves else None
            frames = tuple(_frames(filled, self._cast, self._show, clip))
            check_request(frames[0], "image/png")
            _ = [lay_out(frame, self._cast, self._clips) for frame in (frames[0], frames[-1])]
        except ValueError as error:  # cells that are right alone and wrong together
            self.wrong.append(f"row {number}: {error}")
            return None
        fps = float(filled.get("fps", FPS)) if moves or "seconds" in filled else 0.0
        return Stimulus(name, frames, fps, number, dict(row), filled.get("format", PICTURES), clip)

    def _read_name(self, number: int, name: str) -> str:
        if name != file_name(name) or name.strip(".") == "":
            self.wrong.append(
                f"row {number}, {NAME}: {name[:80]!r} is no name of a file everywhere; write letters, digits, - and _"
            )
        if (former := self._names.setdefault(name.casefold(), number)) != number:
            self.wrong.append(f"row {number}, {NAME}: {name!r} is the name of row {former} already; give it another")
        return name

    def _check(self, column: str, cell: str) -> str:
        """What is wrong with a cell alone."""
        if (column, cell) not in self._known:
            try:
                self._try(column, cell)
                self._known[column, cell] = ""
            except ValueError as error:
                self._known[column, cell] = str(error)
        return self._known[column, cell]

    def _try(self, column: str, cell: str) -> None:
        if column in OF_CLIPS:
            _read_number(cell, *OF_CLIPS[column])
        elif column == "easing":
            check_known(cell, EASINGS, column)
        elif column == "format":
            check_known(cell, FORMATS, column)
        else:
            alone = {"mask": {"transparent": "yes"}}.get(column, {})  # a mask needs something around it
            request = _request({**alone, BEGINNINGS.get(column, column): cell}, "")
            check_request(request, "image/png")
            lay_out(request, self._cast, self._clips)


def _read_number(text: str, least: float, most: float) -> float:
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not least <= number <= most:
        example = float(f"{math.sqrt(least * most):.1g}")
        raise ValueError(f"{text!r} is no number from {least:g} to {most:g}; write for instance {example:g}")
    return number


def _read_switch(text: str) -> bool:
    if text.lower() not in (*YES, *NO):
        raise ValueError(f"{text!r} is neither yes nor no; write one of them")
    return text.lower() in YES


def _request(cells: Mapping[str, str], show: str) -> RenderRequest:
    """The request of the cells of a picture; ValueError where one is neither yes nor no, or no number."""
    plain = RenderRequest()
    words: dict[str, object] = {"show": show}
    for column, cell in cells.items():
        before = getattr(plain, column)
        if column in MIXES:
            words[column] = (cell,)
        elif isinstance(before, bool):
            words[column] = _read_switch(cell)
        elif column in NUMBERS:
            words[column] = _read_number(cell, *NUMBERS[column])
        else:
            words[column] = cell
    return RenderRequest(**words)  # type: ignore[arg-type]


def _out_of_place(number: int, cells: Mapping[str, str], *, moves: bool) -> Iterator[str]:
    """What is wrong with cells of a row that belong to another kind of row than it is. moves: it is a motion clip."""
    if moves:
        wrong = dict.fromkeys(TRANSITION, "a motion clip has its own motion; leave it empty")
    elif "seconds" in cells:
        wrong = dict.fromkeys((*MOTION, "at"), "this is of a motion clip; name the clip, and leave seconds empty")
    else:
        wrong = dict.fromkeys(MOTION, "this is of a motion clip; name the clip (and leave at empty)")
        wrong |= dict.fromkeys(TRANSITION, "this is of a clip; say its seconds too, or leave it empty")
        wrong |= dict.fromkeys(FILMED, "this is of a clip; say its seconds or name a motion clip, or leave it empty")
    for column, why in wrong.items():
        if column in cells:
            yield f"row {number}, {column}: {why}"


def _trimmed(clip: Clip, cells: Mapping[str, str]) -> Clip:
    """What a row draws of a motion clip."""
    begin = float(cells.get("from", 0.0))
    end = float(cells.get("to", clip.seconds))
    if not begin < end <= clip.seconds + SAME_TIME:
        raise ValueError(
            f"the clip {cells['clip']} has {clip.seconds:g} s, and nothing from {begin:g} s to {end:g} s; give seconds "
            "of it that rise"
        )
    speed = float(cells.get("speed", clip.speed))
    return replace(clip, start=clip.start + begin, stop=clip.start + min(end, clip.seconds), speed=speed)


def _frames(
    cells: Mapping[str, str], cast: Cast | PlayingCast, show: str, clip: Clip | None
) -> Iterator[RenderRequest]:  # fmt: skip
    """The pictures of a row: one, or those of a clip: as a motion clip has them (`clip`), or from its first to its
    last, each at its share of the way."""
    last = _request({column: cell for column, cell in cells.items() if column in RENDERED}, show)
    if clip is not None:
        begin = float(cells.get("from", 0.0))
        fps = float(cells.get("fps", FPS))
        for number in range(count_frames(clip, fps)):
            yield msgspec.structs.replace(last, at=begin + number / fps * clip.speed)
        return
    if "seconds" not in cells:
        yield last
        return
    at_rest = {"face": last.face, "expression": ()}
    begun = {end: (cells[column],) if column in cells else at_rest[end] for column, end in BEGINNINGS.items()}
    first, end = (find_pose(cast, request.words) for request in (msgspec.structs.replace(last, **begun), last))
    easing = EASINGS[cells.get("easing", DEFAULT_EASING)]
    steps = max(1, round(float(cells["seconds"]) * float(cells.get("fps", FPS))))
    for step in range(steps + 1):
        share = easing.value(step / steps)
        face = _mix(first.faces, end.faces, share)
        yield msgspec.structs.replace(last, face=(face,), expression=(_mix(first.expressions, end.expressions, share),))


def _mix(first: Mapping[str, float], last: Mapping[str, float], share: float) -> str:
    """The words of a mix that lies at a share of the way between two."""
    weights = {name: (1.0 - share) * first.get(name, 0.0) + share * last.get(name, 0.0) for name in {**first, **last}}
    return "+".join(f"{name}={weight:.9f}" for name, weight in weights.items() if abs(weight) > LEAST_WEIGHT)
