"""Parses untrusted clouds of points as text: XYZ, PTS, CSV and what scanners write like them."""

from __future__ import annotations

import re

import numpy as np

from omote.arrays import Values
from omote.interchange.formats.file_content import describe_content
from omote.interchange.scans.scan_parts import LARGEST, MOST_POINTS, bytes_of_colours, make_scan, refuse_many
from omote.interchange.scans.text_table import TextTable
from omote.model.fitting.scan import Scan

NAMES = {
    "x": "x", "y": "y", "z": "z", "r": "r", "g": "g", "b": "b", "red": "r", "green": "g", "blue": "b",
    "cx": "r", "cy": "g", "cz": "b", "px": "x", "py": "y", "pz": "z", "posx": "x", "posy": "y", "posz": "z",
}  # fmt: skip
"""What columns are called, in small letters and without punctuation."""
_COMMENTS = (ord("#"), ord("/"), ord("!"))
_UNNAMED = {6: (3, 6), 7: (4, 7), 9: (3, 6), 10: (4, 7)}
"""Where the colours lie in rows of this many numbers without names: x y z [intensity] r g b [normal]."""


def read_cloud(data: bytes, /) -> Scan:
    """The cloud in a text of one point a line, by white space, commas or semicolons; ValueError for another file."""
    refuse_many(len(data), "bytes", LARGEST)
    if b"\0" in data[:4096]:
        raise ValueError(f"the file is no cloud of points, but {describe_content(data)}; export it as .ply or .xyz")
    table = TextTable(_plain(data.removeprefix(b"\xef\xbb\xbf")))
    lines = np.flatnonzero(~np.isin(table.initials[:, 0], _COMMENTS))
    names: list[str] = []
    while len(lines) and (not _is_row(table.line(int(lines[0]))) or table.words[lines[0]] == 1):
        names = names or table.line(int(lines[0])).split()
        lines = lines[1:]
        if len(table) - len(lines) > 100:
            break
    refuse_many(len(lines), "points", MOST_POINTS)
    if not len(lines) or table.words[lines].min() < 3:
        bad = table.line(int(lines[table.words[lines].argmin()])) if len(lines) else ""
        what = f"the line {bad!r} is no point" if bad else f"the file is no cloud, but {describe_content(data)}"
        raise ValueError(f"{what}; expected x y z in each line: export it anew")
    return _make(table.numbers(lines, "a point of the cloud"), names)


def _make(rows: Values, names: list[str]) -> Scan:
    columns = {
        NAMES[plain]: at for at, name in enumerate(names) if (plain := re.sub(r"[\W_\d]", "", name.lower())) in NAMES
    }
    if {"x", "y", "z"} <= columns.keys() and max(columns.values()) < rows.shape[1]:
        colours = rows[:, [columns[name] for name in "rgb"]] if {"r", "g", "b"} <= columns.keys() else None
        points = rows[:, [columns[name] for name in "xyz"]]
    else:
        begin, end = _UNNAMED.get(rows.shape[1], (0, 0))
        points = rows[:, :3]
        colours = rows[:, begin:end] if end else None
    if colours is not None and not names and not _looks_coloured(colours):
        colours = None
    return make_scan(points, None, None if colours is None else bytes_of_colours(colours))


def _looks_coloured(values: Values) -> bool:
    """Whether numbers are colours rather than a normal: whole ones to 255, or parts of one that are no unit vectors."""
    if not np.isfinite(values).all() or values.min() < 0.0 or values.max() > 65535.0:
        return False
    lengths = np.linalg.norm(values, axis=1)
    return bool((values == np.rint(values)).all() or np.abs(lengths - 1.0).max() > 0.01)


def _plain(data: bytes) -> bytes:
    """Columns by white space and decimals by points, whichever way they are written."""
    begin = data[: 2**16].replace(b"\r", b"\n").split(b"\n")
    sample = next((line for line in begin if re.match(rb"\s*[-+.\d]+[,;.\s\deE+-]*$", line) and len(line) > 4), b"")
    if b";" in sample or (b"," in sample and len(sample.split()) >= 3 and not re.search(rb",\s|\s,", sample)):
        data = data.replace(b",", b".")  # a decimal comma: something else parts the columns
    return data.replace(b";", b" ").replace(b",", b" ").replace(b'"', b" ")


def _is_row(line: str) -> bool:
    try:
        [float(word) for word in line.split()]
    except ValueError:
        return False
    return True
