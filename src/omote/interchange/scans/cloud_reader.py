"""Parses untrusted clouds of points as text: XYZ, PTS, CSV and what scanners write like them."""

from __future__ import annotations

import re

import numpy as np

from omote.arrays import Values
from omote.interchange.formats.file_content import describe_content, strip_mark
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.scan_parts import LARGEST, MOST_POINTS, bytes_of_colours, make_scan, refuse_many
from omote.interchange.scans.text_table import TextTable, cut_comments
from omote.model.fitting.scan import Scan

NAMES = {
    "x": "x", "y": "y", "z": "z", "r": "r", "g": "g", "b": "b", "red": "r", "green": "g", "blue": "b",
    "cx": "r", "cy": "g", "cz": "b", "px": "x", "py": "y", "pz": "z", "posx": "x", "posy": "y", "posz": "z",
    "xcoord": "x", "ycoord": "y", "zcoord": "z", "xcoordinate": "x", "ycoordinate": "y", "zcoordinate": "z",
    "diffusered": "r", "diffusegreen": "g", "diffuseblue": "b", "colorr": "r", "colorg": "g", "colorb": "b",
    "rf": "r", "gf": "g", "bf": "b",
}  # fmt: skip
"""What columns are called, in small letters and without punctuation and units."""
_UNIT = re.compile(r"[\[(].*?[\])]|[_\W](?:m|mm|cm|in|ft)$")
_COMMENTS = (ord("#"), ord("/"), ord("!"))
_NUMBERED = b"0123456789.,;+-"
_UNNAMED = {6: (3, 6), 7: (4, 7), 9: (3, 6), 10: (4, 7)}
"""Where the colours lie in rows of this many numbers without names: x y z [intensity] r g b [normal]."""
_MOST_HEADINGS = 100
"""Lines before the first point at most."""
_ROW = re.compile(rb"\s*[-+.\d]+[,;.\s\deE+-]*$")
_QUOTED = re.compile(rb'"([-+]?\d*),(\d+)"')
_NO_NUMBER = re.compile(rb"(?<=[\s;,])(?:n/?a|#n/a|null|none|nil)(?=[\s;,])", re.IGNORECASE)


def read_cloud(data: bytes, beside: Companions | None = None, /) -> Scan:
    """The cloud in a text of one point a line, by white space, commas or semicolons; ValueError for another file.

    data: the file; beside: is told what is left out.
    """
    refuse_many(len(data), "bytes", LARGEST)
    text = strip_mark(data)
    if b"\0" in text[:4096]:
        raise ValueError(f"the file is no cloud of points, but {describe_content(data)}; export it as .ply or .xyz")
    text = cut_comments(text.replace(b"\r\n", b"\n").replace(b"\r", b"\n"), _NUMBERED)
    separator, plain = _plain(text)
    table = TextTable(plain)
    lines = np.flatnonzero(~np.isin(table.initials[:, 0], _COMMENTS))
    while len(lines) and (not _is_row(table.line(int(lines[0]), 4096)) or table.words[lines[0]] == 1):
        lines = lines[1:]
        if len(table) - len(lines) > _MOST_HEADINGS:
            break
    refuse_many(len(lines), "points", MOST_POINTS)
    if not len(lines) or table.words[lines].min() < 3:
        bad = table.line(int(lines[table.words[lines].argmin()])) if len(lines) else ""
        what = f"the line {bad!r} is no point" if bad else f"the file is no cloud, but {describe_content(data)}"
        raise ValueError(f"{what}; expected x y z in each line: export it anew")
    usual = int(np.bincount(table.words[lines]).argmax())
    rows = table.numbers(lines, "a point of the cloud", most=usual)
    return _make(rows, _headings(text, separator), Companions() if beside is None else beside)


def _headings(text: bytes, separator: bytes | None) -> list[str]:
    """What the columns are called in the lines before the first point, comments among them; those that name x, y and z
    before any others."""
    names = list[str]()
    for line in text[: 2**16].split(b"\n")[:_MOST_HEADINGS]:
        bare = line.strip().lstrip(b"#/!").strip()
        words = [word.strip().strip(b'"').decode("utf-8", "replace") for word in bare.split(separator)]
        if _is_row(" ".join(words).replace(",", ".")) and len(words) > 1:
            break
        if {"x", "y", "z"} <= set(map(_meaning, words)):
            return words
        if bare == line.strip() and len(words) > 1:
            names = names or words
    return names


def _meaning(heading: str) -> str:
    """What a column is, "" for anything else than a place or a colour."""
    name = _UNIT.sub("", heading.strip().lower())
    return NAMES.get(re.sub(r"[\W_\d]", "", name), "")


def _make(rows: Values, names: list[str], beside: Companions) -> Scan:
    columns = {meaning: at for at, name in enumerate(names) if (meaning := _meaning(name))}
    if {"x", "y", "z"} <= columns.keys() and max(columns.values()) < rows.shape[1]:
        colours = rows[:, [columns[name] for name in "rgb"]] if {"r", "g", "b"} <= columns.keys() else None
        points = rows[:, [columns[name] for name in "xyz"]]
    else:
        if len(names) == rows.shape[1]:
            beside.note(f"its columns are named {', '.join(names)[:80]!r}: the first three are taken for x, y and z")
        begin, end = _UNNAMED.get(rows.shape[1], (0, 0))
        points = rows[:, :3]
        colours = rows[:, begin:end] if end and _looks_coloured(rows[:, begin:end]) else None
    return make_scan(points, None, None if colours is None else bytes_of_colours(colours), beside=beside)


def _looks_coloured(values: Values) -> bool:
    """Whether numbers are colours rather than a normal: whole ones to 255, or parts of one that are no unit vectors."""
    known = values[np.isfinite(values).all(axis=1)]
    if not len(known) or known.min() < 0.0 or known.max() > 65535.0:
        return False
    lengths = np.linalg.norm(known, axis=1)
    return bool((known == np.rint(known)).all() or np.abs(lengths - 1.0).max() > 0.01)


def _plain(text: bytes) -> tuple[bytes | None, bytes]:
    """What parts the columns (None: white space), and the text with blanks there and decimals by points, whichever way
    they are written; empty cells, and words for nothing, are nan."""
    if b'"' in text:
        text = _QUOTED.sub(rb"\1.\2", text).replace(b'"', b" ")
    separator = _separator([line for line in text[: 2**16].split(b"\n") if _ROW.match(line) and len(line) > 4])
    if separator == b", ":
        text = re.sub(rb",(?!\s)", b".", text)
        separator = b","
    elif separator != b",":
        text = text.replace(b",", b".")
    if separator is not None:
        text = _fill_cells(text, separator).replace(separator, b" ")
    small = text.lower()
    if any(word in small for word in (b"n/a", b"null", b"none", b"nil")) or re.search(rb"na(?!n)", small):
        text = _NO_NUMBER.sub(b"nan", text)
    return separator, text


def _fill_cells(text: bytes, separator: bytes) -> bytes:
    """The text with nan in empty cells, and without those at the ends of rows."""
    blanks = b"" if separator == b"\t" else b"\t"
    ends = [separator + end for end in (b"\n", b" ", b"\t")]
    if any(end in text for end in ends) or text.endswith(separator):
        text = re.sub(rb"[%b %b]+(?=\n|$)" % (separator, blanks), b"", text)
    empty = [separator + gap + separator for gap in (b"", b" ", blanks)] + [b"\n" + separator, b"\n " + separator]
    if any(cell in text for cell in empty):
        text = re.sub(rb"(?<=[%b\n])[ %b]*(?=%b)" % (separator, blanks, separator), b"nan", text)
    return text


def _separator(rows: list[bytes]) -> bytes | None:
    """What parts the columns of rows of numbers: a semicolon, a tab, a comma, ", " where bare commas are decimals; None
    for white space of any length."""
    if any(b";" in row for row in rows):
        return b";"
    with_comma = [row.strip() for row in rows if b"," in row]
    parted = [row for row in with_comma if re.search(rb",\s|\s,", row)]
    if parted:
        bare = any(re.search(rb",\S", row) for row in parted)
        return b", " if bare and all(len(row.split()) >= 3 for row in parted) else b","
    if with_comma and not all(len(row.split()) >= 3 for row in with_comma):
        return b","
    aligned = [row for row in rows if b"\t\t" in row or row.startswith(b"\t")]
    return b"\t" if rows and all(b"\t" in row.strip() for row in rows) and 2 * len(aligned) < len(rows) else None


def _is_row(line: str) -> bool:
    try:
        [float(word) for word in line.split()]
    except ValueError:
        return False
    return True
