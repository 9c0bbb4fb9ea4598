"""Parses untrusted PLY files, ascii and binary: clouds and meshes of polygons, with colours and texture coordinates."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.ply_header import Element, Header, Property, parse_header
from omote.interchange.scans.scan_parts import (
    LARGEST,
    MOST_POINTS,
    MOST_TRIANGLES,
    Rows,
    Values,
    bytes_of_colours,
    fan_polygons,
    make_scan,
    refuse_many,
    weld_scan,
)  # fmt: skip
from omote.interchange.scans.text_table import parse_numbers
from omote.model.fitting.scan import Scan

COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
TEXCOORDS = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"), ("texture_s", "texture_t"))
CORNERS = ("vertex_indices", "vertex_index")
MOST_VALUES = 2**28
"""Of one list of all rows together."""
_UNPACKED = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I"}


@dataclass
class Table:
    """The columns of an element: single values by name, and lists as their counts and all values in a row."""

    columns: dict[str, NDArray[np.generic]] = field(default_factory=dict)
    lists: dict[str, tuple[Rows, NDArray[np.generic]]] = field(default_factory=dict)


def read_ply(data: bytes, beside: Companions, /) -> Scan:
    """The scan in a PLY file; beside: reads the texture that a comment names.

    ValueError for an invalid file.
    """
    refuse_many(len(data), "bytes", LARGEST)
    header = parse_header(data)
    tables = _read_tables(data, header)
    vertices = tables.get("vertex", Table())
    if any(name not in vertices.columns for name in "xyz"):
        raise ValueError("the PLY has no vertices with x, y and z; expected a cloud or a mesh: export it anew")
    points = np.stack([np.asarray(vertices.columns[name], np.float64) for name in "xyz"], axis=1)
    triangles, texcoords, doubled = _faces(tables, vertices)
    texture = beside.picture(header.texture) if header.texture and texcoords is not None else None
    scan = make_scan(points, triangles, _colours(vertices), texture, texcoords)
    return weld_scan(scan) if doubled else scan


def _colours(vertices: Table) -> NDArray[np.uint8] | None:
    for names in COLOURS:
        if all(name in vertices.columns for name in names):
            return bytes_of_colours(np.stack([vertices.columns[name] for name in names], axis=1))
    return None


def _faces(tables: dict[str, Table], vertices: Table) -> tuple[Rows | None, Values | None, bool]:
    """Triangles, the texture coordinates of their corners, and whether vertices are doubled for these."""
    faces = tables.get("face", Table())
    found = next((faces.lists[name] for name in CORNERS if name in faces.lists), None)
    if found is None:
        return _strips(tables), None, False
    counts, corners = found
    places = fan_polygons(counts)
    triangles = np.asarray(corners).astype(np.int64)[places]
    if "texcoord" in faces.lists:
        lengths, values = faces.lists["texcoord"]
        if (lengths == 2 * counts).all():
            return triangles, _from_below(np.asarray(values, np.float64).reshape(-1, 2)[places]), False
    for names in TEXCOORDS:
        if all(name in vertices.columns for name in names):
            pairs = np.stack([np.asarray(vertices.columns[name], np.float64) for name in names], axis=1)
            if len(triangles) and 0 <= triangles.min() <= triangles.max() < len(pairs):
                return triangles, _from_below(pairs[triangles]), True
    return triangles, None, False


def _strips(tables: dict[str, Table]) -> Rows | None:
    """Triangles of strips, as range scanners' archives have them; -1 ends a strip."""
    lists = tables.get("tristrips", Table()).lists
    if "vertex_indices" not in lists:
        return None
    row = np.asarray(lists["vertex_indices"][1]).astype(np.int64)
    whole = np.lib.stride_tricks.sliding_window_view(row, 3) if len(row) >= 3 else np.empty((0, 3), np.int64)
    ends = np.flatnonzero(row < 0)
    since = np.arange(len(row)) - np.concatenate([[0], ends + 1])[np.searchsorted(ends, np.arange(len(row)))]
    odd = (since[: len(whole)] % 2 == 1)[:, None]
    return np.where(odd, whole[:, [1, 0, 2]], whole)[(whole >= 0).all(axis=1)]


def _from_below(texcoords: Values) -> Values:
    """PLY counts v from the bottom of the picture."""
    return texcoords * [1.0, -1.0] + [0.0, 1.0]


def _read_tables(data: bytes, header: Header) -> dict[str, Table]:
    rows: _TextRows | _BinaryRows
    rows = _BinaryRows(data, header) if header.order else _TextRows(parse_numbers(data[header.body :], "the PLY"))
    tables = {}
    for element in header.elements:
        if element.name in ("vertex", "face", "tristrips") and element.name not in tables:
            refuse_many(element.count, element.name, MOST_POINTS if element.name == "vertex" else MOST_TRIANGLES)
            tables[element.name] = rows.table(element)
        elif {"vertex", "face", "tristrips"} & {each.name for each in header.elements} <= tables.keys():
            break  # what follows says nothing of the shape
        else:
            rows.table(element)
    return tables


def _cut_off(element: Element) -> ValueError:
    return ValueError(
        f"the PLY declares {element.count} of {element.name!r} and does not hold them; it is cut off or written wrong: "
        "copy or export it anew"
    )


class _TextRows:
    """The numbers of a text, taken element by element."""

    def __init__(self, numbers: Values) -> None:
        self.numbers, self.at = numbers, 0

    def table(self, element: Element) -> Table:
        width = len(element.properties)
        if not any(each.length for each in element.properties):
            taken = self._take(element, element.count * width).reshape(element.count, width)
            return Table({each.name: _typed(taken[:, at], each.type) for at, each in enumerate(element.properties)})
        return self._walk(element)

    def _walk(self, element: Element) -> Table:
        """Rows with lists: where each begins is known from the one before."""
        numbers, at = self.numbers[self.at :].tolist(), 0
        ranges: list[list[tuple[int, int]]] = [[] for _ in element.properties]
        try:
            for _ in range(element.count):
                for place, each in enumerate(element.properties):
                    count = int(numbers[at]) if each.length else 1
                    at += bool(each.length)
                    if not 0 <= count <= len(numbers) - at:
                        raise _cut_off(element)
                    ranges[place].append((at, count))
                    at += count
        except (IndexError, OverflowError, ValueError):
            raise _cut_off(element) from None
        whole = self.numbers[self.at : self.at + at]
        self.at += at
        table = Table()
        for each, found in zip(element.properties, ranges, strict=True):
            begins, counts = np.array(found, np.int64).reshape(-1, 2).T
            values = _typed(whole[_spread(begins, counts)], each.type)
            if each.length:
                table.lists[each.name] = counts, values
            else:
                table.columns[each.name] = values
        return table

    def _take(self, element: Element, count: int) -> Values:
        if count > len(self.numbers) - self.at:
            raise _cut_off(element)
        self.at += count
        return self.numbers[self.at - count : self.at]


def _typed(values: Values, kind: str) -> NDArray[np.generic]:
    """Numbers of a text in the type that the header says, so that colours are told apart as in binary files."""
    if kind[0] == "f":
        return values
    limits = np.iinfo(np.dtype(kind))
    kept = np.clip(np.nan_to_num(values), float(limits.min), float(limits.max))
    return kept.astype(np.dtype(kind))


def _spread(begins: Rows, counts: Rows) -> Rows:
    """The places begin, begin + 1, ... of each range, one after another."""
    refuse_many(int(counts.sum()), "values in lists", MOST_VALUES)
    starts = np.cumsum(counts) - counts
    places: Rows = np.arange(int(counts.sum())) + np.repeat(begins - starts, counts)
    return places


class _BinaryRows:
    """The bytes of a file, taken element by element."""

    def __init__(self, data: bytes, header: Header) -> None:
        self.data, self.order, self.at = data, header.order, header.body

    def table(self, element: Element) -> Table:
        if not any(each.length for each in element.properties):
            taken = self._take(element, self._kind(element.properties))
            return Table({each.name: taken[f"{at}"] for at, each in enumerate(element.properties)})
        return self._uniform(element) or self._walk(element)

    def _kind(self, properties: list[Property], lengths: tuple[int, ...] = ()) -> np.dtype[np.void]:
        """The layout of a row whose lists have these lengths."""
        left, fields = list(lengths), list[tuple[str, str] | tuple[str, str, tuple[int, ...]]]()
        for at, each in enumerate(properties):
            if each.length:
                fields += [(f"{at}n", self.order + each.length), (f"{at}", self.order + each.type, (left.pop(0),))]
            else:
                fields.append((f"{at}", self.order + each.type))
        return np.dtype(fields)

    def _take(self, element: Element, kind: np.dtype[np.void]) -> NDArray[np.void]:
        size = kind.itemsize * element.count
        if size > len(self.data) - self.at:
            raise _cut_off(element)
        self.at += size
        if not size:
            return np.zeros(element.count if kind.itemsize else 0, kind)
        return np.frombuffer(self.data, kind, element.count, self.at - size)

    def _uniform(self, element: Element) -> Table | None:
        """The rows where all lists are as long as those of the first row, as in meshes of triangles; else None."""
        begin = self.at
        if not element.count:
            return Table()
        lengths = self._lengths_of_first(element)
        kind = self._kind(element.properties, lengths)
        if kind.itemsize * element.count > len(self.data) - begin:
            return None
        taken, table = self._take(element, kind), Table()
        for at, each in enumerate(element.properties):
            if not each.length:
                table.columns[each.name] = taken[f"{at}"]
                continue
            counts = taken[f"{at}n"].astype(np.int64)
            if (counts != counts[0]).any():
                self.at = begin
                return None
            table.lists[each.name] = counts, taken[f"{at}"].reshape(-1)
        return table

    def _lengths_of_first(self, element: Element) -> tuple[int, ...]:
        at, lengths = self.at, []
        for each in element.properties:
            count, at = self._count(element, each, at)
            if each.length:
                lengths.append(count)
            at += count * int(each.type[1])
        return tuple(lengths)

    def _count(self, element: Element, each: Property, at: int) -> tuple[int, int]:
        """How many values begin where; one where the property is no list."""
        if not each.length:
            return 1, at
        try:
            (count,) = struct.unpack_from(self.order + _UNPACKED[each.length], self.data, at)
        except struct.error:
            raise _cut_off(element) from None
        at += int(each.length[1])
        if not 0 <= count * int(each.type[1]) <= len(self.data) - at:
            raise _cut_off(element)
        return count, at

    def _walk(self, element: Element) -> Table:
        """Rows with lists of several lengths: where each begins is known from the one before."""
        ranges: list[list[tuple[int, int]]] = [[] for _ in element.properties]
        for _ in range(element.count):
            for place, each in enumerate(element.properties):
                count, self.at = self._count(element, each, self.at)
                ranges[place].append((self.at, count))
                self.at += count * int(each.type[1])
        if self.at > len(self.data):
            raise _cut_off(element)
        table, raw = Table(), np.frombuffer(self.data, np.uint8)
        for each, found in zip(element.properties, ranges, strict=True):
            begins, counts = np.array(found, np.int64).reshape(-1, 2).T
            places = _spread(begins, counts * int(each.type[1]))
            values = np.frombuffer(raw[places].tobytes(), np.dtype(self.order + each.type))
            if each.length:
                table.lists[each.name] = counts, values
            else:
                table.columns[each.name] = values
        return table
