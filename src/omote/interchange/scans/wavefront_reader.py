"""Parses untrusted Wavefront OBJ files: polygons, colours, textures by the materials beside them; or vertices alone."""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Rows, Values
from omote.interchange.formats.file_content import describe_content, strip_mark
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.scans.atlas import join_textures
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.obj_materials import MOST_MATERIALS, find_material, read_materials, without_comment
from omote.interchange.scans.scan_parts import (
    LARGEST,
    MOST_POINTS,
    MOST_TRIANGLES,
    bytes_of_colours,
    fan_polygons,
    make_scan,
    refuse_many,
)  # fmt: skip
from omote.interchange.scans.text_table import TextTable, cut_comments, parse_numbers
from omote.model.fitting.scan import Scan

SKIN = "skin"
MOST_VERTEX = 7
"""Numbers of a vertex: x y z r g b, and what some programs write after them."""
_COLOURED = (6, 7)
_NUMBERED = b"vVfF0123456789.+-"
"""What lines of numbers begin with, and lines that go on with them; in all others such a sign may belong to a name."""
_CONTINUED_COMMENT = re.compile(rb"(?m)^[ \t]*#[^\n]*\\[ \t]*$")
_CONTINUED = re.compile(rb"\\[ \t]*\n")
_PAINTED = re.compile(rb"(?m)^[ \t]*#MRGB[ \t]+([0-9A-Fa-f]+)")
"""A row of colours as ZBrush keeps them in comments: a mask and a colour of two digits a channel for each vertex."""


def read_wavefront(data: bytes, beside: Companions, /) -> Scan:
    """The scan in an OBJ file, its points in the file's order; beside: reads materials and textures.

    data: the file. ValueError for an invalid one.

    data: the file.
    """
    table, lines, vertices = _read_vertices(data)
    colours = _colours(vertices, data, beside)
    faces = table.lines_of(b"f")
    if not len(faces):
        return make_scan(vertices[:, :3], None, colours, beside=beside)
    corners, of = _corners(table, faces)
    triangles = _absolute(corners[:, :, 0], table, lines, faces[of])
    texture, texcoords = _texture(table, corners[:, :, 1], faces[of], beside)
    return make_scan(vertices[:, :3], triangles, colours, texture, texcoords, beside=beside)


def _colours(vertices: Values, data: bytes, beside: Companions) -> NDArray[np.uint8] | None:
    """The colours of vertices, behind their places or in comments; says where some or all have none."""
    painted = b"".join(_PAINTED.findall(data.replace(b"\r", b"\n"))) if b"#MRGB" in data else b""
    if len(painted) == 8 * len(vertices):
        return np.frombuffer(bytes.fromhex(painted.decode("ascii")), np.uint8).reshape(-1, 4)[:, 1:]
    if vertices.shape[1] not in _COLOURED:
        return None
    tones = vertices[:, 3:6]
    bare = int(np.isnan(tones).any(axis=1).sum())
    colours = bytes_of_colours(tones)
    if colours is None:
        beside.note("the numbers behind its vertices are no colours: they are left out")
    elif bare:
        beside.note(f"{bare} of its {len(vertices)} vertices have no colour: they are white")
    return colours


def read_obj_pieces(data: bytes, /) -> tuple[Piece, ...]:
    """The head in an OBJ file by its vertices alone, in their order; ValueError for an invalid file.

    Where an object is named SKIN, as an export names them, it is the mesh of each; else all of them as one, the skin.
    """
    table, lines, vertices = _read_vertices(data)
    points = vertices[:, :3]
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise ValueError(f"vertex {bad[0] + 1} is {points[bad[0]]}; expected finite numbers: export the file anew")
    starts: dict[str, int] = {}
    objects = table.lines_of(b"o")
    for line, first in zip(objects.tolist(), np.searchsorted(lines, objects).tolist(), strict=True):
        starts.setdefault(without_comment(table.rest(line)), first)
    if SKIN not in starts:
        return (Piece(SKIN, points),)
    ends = [*list(starts.values())[1:], len(points)]
    parts = {name: points[first:end] for (name, first), end in zip(starts.items(), ends, strict=True)}
    return tuple(Piece(name, part) for name, part in parts.items() if len(part))


def _read_vertices(data: bytes) -> tuple[TextTable, Rows, Values]:
    """The lines of an OBJ file, those of its vertices, and the numbers of these (n, 3 or more)."""
    refuse_many(len(data), "bytes", LARGEST)
    table = TextTable(_join_lines(data))
    lines = table.lines_of(b"v")
    refuse_many(len(lines), "points", MOST_POINTS)
    if not len(lines):
        raise ValueError(f"the file is no OBJ with vertices, but {describe_content(data)}; export it as .obj")
    return table, lines, _columns(table, lines, "a vertex of the OBJ", least=3, most=MOST_VERTEX)


def _join_lines(data: bytes) -> bytes:
    """The text without marks, ends of lines as one sign, without comments behind numbers; lines that go on are one."""
    text = strip_mark(data).replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    text = cut_comments(text, _NUMBERED)
    if b"\\" in text:
        text = _CONTINUED.sub(b" ", _CONTINUED_COMMENT.sub(b"#", text))
    return text


def _columns(table: TextTable, lines: Rows, what: str, least: int, most: int = 0) -> Values:
    """The numbers of lines of one keyword, as many of each as the shortest has; up to `most` where another has more."""
    words = table.words[lines] - 1
    if (words < least).any():
        bad = table.line(int(lines[int((words < least).argmax())]))
        raise ValueError(f"the line {bad!r} is no {what[2:]}; expected {least} numbers: export it anew")
    begin = len(table.text[table.begins[lines[0]] : table.ends[lines[0]]].tobytes().split(None, 1)[0])
    return table.numbers(lines, what, skip=begin, most=most)


def _corners(table: TextTable, faces: Rows) -> tuple[Rows, Rows]:
    """The corners of all triangles (t, 3, 2), each a vertex and a texture coordinate as written (0: none), and the
    face, of those given, that each triangle is of."""
    refuse_many(len(faces), "faces", MOST_TRIANGLES)
    text = table.join(faces, skip=1)
    words = np.frombuffer(re.sub(rb"/(?=[/\s])", b"/0", text + b"\n"), np.uint8)
    solid = words > 32
    begins = np.flatnonzero(solid & ~np.concatenate([[False], solid[:-1]]))
    slashes = np.add.reduceat(words == ord("/"), begins) if len(begins) else np.zeros(0, np.int64)
    numbers = parse_numbers(words.tobytes().replace(b"/", b" "), "a face of the OBJ")
    counts = table.words[faces] - 1
    if len(numbers) != int((slashes + 1).sum()) or len(begins) != counts.sum() or (slashes > 2).any():
        raise ValueError("a face of the OBJ is no row of corners such as 1/2/3; export it anew")
    if not (np.abs(numbers) < 2**31).all() or (numbers != np.rint(numbers)).any():
        raise ValueError("a face of the OBJ names corners that are no whole numbers; export it anew")
    whole = numbers.astype(np.int64)
    first = np.cumsum(slashes + 1) - slashes - 1
    second = np.where(slashes > 0, whole[np.minimum(first + 1, len(whole) - 1)], 0) if len(whole) else whole
    places = fan_polygons(counts)
    of = np.repeat(np.arange(len(counts)), np.maximum(counts - 2, 0))
    return np.stack([whole[first], second], axis=1)[places], of


def _absolute(corners: Rows, table: TextTable, lines: Rows, faces: Rows) -> Rows:
    """Rows from 0 of what is named from 1, or backwards from the last one before the face (negative)."""
    before = np.searchsorted(lines, faces)[:, None] if len(corners) and corners.min() < 0 else 0
    rows = np.where(corners < 0, corners + before, corners - 1)
    if len(rows) and (rows.min() < 0 or rows.max() >= len(lines)):
        bad = int(((rows < 0) | (rows >= len(lines))).any(axis=1).argmax())
        raise ValueError(
            f"the line {table.line(int(faces[bad]))!r} names a corner that is not among the {len(lines)} of the OBJ; "
            "expected 1 or more: export it anew"
        )
    return rows


def _texture(
    table: TextTable, corners: Rows, faces: Rows, beside: Companions
) -> tuple[Picture | None, Values | None]:  # fmt: skip
    lines = table.lines_of(b"vt")
    if not len(lines) or not len(corners) or not (corners != 0).any():
        return None, None
    pairs = _columns(table, lines, "a texture coordinate of the OBJ", least=2)[:, :2]
    named = (corners != 0).all(axis=1)
    rows = _absolute(np.where(named[:, None], corners, 1), table, lines, faces)
    switches = np.flatnonzero((table.initials == np.frombuffer(b"use", np.uint8)).all(axis=1))
    names = [table.rest(int(line)) for line in switches[: 10 * MOST_MATERIALS]]
    materials = read_materials(table, beside)
    used = [None, *(find_material(materials, name, beside) for name in names)]
    if not names and len(materials) == 1:  # one material and nobody says that it is used
        used = [*materials.values()]
    of = np.minimum(np.searchsorted(switches, faces), len(used) - 1)
    moves = np.array([(1.0, 1.0, 0.0, 0.0) if each is None else (*each.scale, *each.shift) for each in used])[of]
    moved = pairs[rows] * moves[:, None, :2] + moves[:, None, 2:]
    texcoords = np.nan_to_num(moved * [1.0, -1.0] + [0.0, 1.0], posinf=0.0, neginf=0.0)
    distinct, which = _distinct([None if each is None else each.picture for each in used])
    return join_textures(distinct, texcoords, which[of])


def _distinct(pictures: list[Picture | None]) -> tuple[list[Picture | None], Rows]:
    """Each picture once, and which of them each one is."""
    keys = [id(picture) for picture in pictures]
    order = list(dict.fromkeys(keys))
    return [pictures[keys.index(key)] for key in order], np.array([order.index(key) for key in keys], np.int64)
