"""Stimuli from a table: a row is a picture or a clip, its columns are the words of `omote render`; all of it is checked
before anything is drawn."""

from __future__ import annotations

import csv
import difflib
import io
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import msgspec

from omote.perform.easing import DEFAULT_EASING, EASINGS
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
CLIP = ("seconds", "fps", "easing")
RENDERED = tuple(field for field in RenderRequest.__struct_fields__ if field != "show")
COLUMNS = (NAME, *RENDERED, *BEGINNINGS, *CLIP)
NUMBERS = {"luminance": LUMINANCES, "contrast": CONTRASTS}
"""Columns of numbers, with the least and the largest."""
MIXES = ("face", "expression", "channel")
"""Columns of which a request holds tuples."""
FPS = 25.0
FASTEST = 240.0
LONGEST = 60.0
"""Seconds of a clip."""
MOST_PICTURES = 20_000
LEAST_WEIGHT = 1e-9
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
    """One row: its name, what is drawn frame by frame (one, of a picture), frames a second of a clip, else 0; cells:
    the row as it stands in the table, by heading."""

    name: str
    frames: tuple[RenderRequest, ...]
    fps: float
    cells: Mapping[str, str]

    @property
    def files(self) -> list[str]:
        """The names of its pictures, below the folder of all."""
        if not self.fps:
            return [f"{self.name}.png"]
        return [f"{self.name}/{number:04d}.png" for number in range(1, len(self.frames) + 1)]


def read_stimuli(data: bytes, cast: Cast | PlayingCast, /, *, show: str = "") -> tuple[list[Stimulus], list[str]]:
    """The rows of a CSV, and the headings that are the experiment's own and say nothing here.

    data: the file; cast: which faces and expressions may be named; show: the show file of that cast, "" for none.
    TableError with everything that is wrong.
    """
    heading, rows = _read_rows(data)
    own = [name for name in heading if name and name not in COLUMNS]
    wrong = [_explain_heading(name, near) for name in own if (near := _nearest(name))]
    wrong += [f"row 1: the heading {name!r} comes twice" for name in COLUMNS if heading.count(name) > 1]
    if not rows:
        wrong.append("row 2: there is no row below the headings; write one for each picture")
    reader = _Rows(cast, show, wrong)
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

    def __init__(self, cast: Cast | PlayingCast, show: str, wrong: list[str]) -> None:
        self.wrong = wrong
        self._cast = cast
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
        clip = [column for column in (*BEGINNINGS, *CLIP) if column in filled]
        if clip and "seconds" not in filled:
            self.wrong.append(f"row {number}, {clip[0]}: this is of a clip; say its seconds too, or leave it empty")
        if len(self.wrong) > before:
            return None
        try:
            frames = tuple(_frames(filled, self._cast, self._show))
            check_request(frames[0], "image/png")
            _ = [lay_out(frame, self._cast) for frame in (frames[0], frames[-1])]
        except ValueError as error:  # cells that are right alone and wrong together
            self.wrong.append(f"row {number}: {error}")
            return None
        fps = float(filled.get("fps", FPS)) if "seconds" in filled else 0.0
        return Stimulus(name, frames, fps, dict(row))

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
        if column == "seconds":
            _read_number(cell, 0.01, LONGEST)
        elif column == "fps":
            _read_number(cell, 1.0, FASTEST)
        elif column == "easing" and cell not in EASINGS:
            raise ValueError(f"there is no easing {cell!r}; give one of {', '.join(EASINGS)}")
        elif column not in CLIP:
            alone = {"mask": {"transparent": "yes"}}.get(column, {})  # a mask needs something around it
            request = _request({**alone, BEGINNINGS.get(column, column): cell}, "")
            check_request(request, "image/png")
            lay_out(request, self._cast)


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


def _frames(cells: Mapping[str, str], cast: Cast | PlayingCast, show: str) -> Iterator[RenderRequest]:
    """The pictures of a row: one, or those of a clip from its first to its last, each at its share of the way."""
    last = _request({column: cell for column, cell in cells.items() if column in RENDERED}, show)
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
