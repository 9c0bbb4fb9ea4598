"""Parses untrusted PLY files, ascii and binary: clouds and meshes of polygons, with colours and texture coordinates."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Rows, Values
from omote.interchange.formats.file_content import MARKS, describe_content, strip_mark
from omote.interchange.scans.atlas import join_textures
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.scan_parts import (
    LARGEST,
    MOST_POINTS,
    MOST_TRIANGLES,
    bytes_of_colours,
    fan_polygons,
    make_scan,
    refuse_many,
    weld_scan,
)
from omote.interchange.scans.text_table import parse_numbers
from omote.model.fitting.scan import Scan

LONGEST = 2**16
"""Bytes of a header at most."""
TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}  # fmt: skip
FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
"""The formats, and how NumPy calls their byte order."""
MOST_ROWS = 100_000_000
"""Of one element; more would overflow what is counted with them."""
COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
TEXCOORDS = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"), ("texture_s", "texture_t"))
CORNERS = ("vertex_indices", "vertex_index")
TEXTURE = "texturefile"
"""What a comment calls the picture of the file, in any capitals."""
MOST_TEXTURES = 64
MOST_VALUES = 2**28
"""Of one list of all rows together."""
_UNPACKED = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f8": "d"}


@dataclass(frozen=True)
class Property:
    """A column of an element; length: the type of the count before a list's values, "" for a single value."""

    name: str
    type: str
    length: str = ""


@dataclass
class Element:
    """Rows of one kind: vertex, face, and what other programs add."""

    name: str
    count: int
    properties: list[Property] = field(default_factory=list)


@dataclass(frozen=True)
class Header:
    """What a file declares; order: byte order, "" for text; body: where rows begin; textures: names of pictures."""

    order: str
    elements: list[Element]
    body: int
    textures: tuple[str, ...] = ()


def parse_header(data: bytes, /) -> Header:
    """Parses the header of a PLY file; ValueError for an invalid one."""
    if data[:3] != b"ply" or data[3:4] not in (b"\n", b"\r", b" "):
        raise ValueError(f"the file is no PLY, but {describe_content(data)}; export the scan as .ply, .obj or .glb")
    end = data.find(b"end_header", 0, LONGEST)
    newline = data.find(b"\n", end, end + 100) if data.find(b"\n", 0, end) >= 0 else data.find(b"\r", end, end + 100)
    if end < 0 or newline < 0:
        raise ValueError("the header of the PLY has no end (end_header); the file is cut off: copy or export it anew")
    return _parse_lines(data[:end].decode("latin-1").splitlines()[1:], newline + 1)


def _parse_lines(lines: list[str], body: int) -> Header:
    order = "?"
    textures = list[str]()
    elements = list[Element]()
    for line in lines:
        words = line.split()
        match words[:1]:
            case ["format"]:
                order = _format(words)
            case ["comment" | "obj_info"]:
                textures += _texture(line)
            case ["element"]:
                elements.append(_element(words, line))
            case ["property"]:
                _add_property(elements, words, line)
            case [_]:
                raise ValueError(f"the PLY's header has the line {line[:80]!r}; expected format, element or property")
    if order == "?":
        raise ValueError(f"the header of the PLY names no format; expected one of {', '.join(FORMATS)}: export it anew")
    return Header(order, elements, body, tuple(textures[:MOST_TEXTURES]))


def _texture(line: str) -> list[str]:
    """The name of the picture that a comment names, if it does."""
    words = line.split(None, 2)
    return [words[2].strip()] if len(words) > 2 and words[1].lower() == TEXTURE else []


def _format(words: list[str]) -> str:
    if len(words) < 2 or words[1] not in FORMATS:
        raise ValueError(f"the PLY has the format {' '.join(words[1:])[:80]!r}; expected one of {', '.join(FORMATS)}")
    return FORMATS[words[1]]


def _element(words: list[str], line: str) -> Element:
    digits = words[2] if len(words) == 3 else ""
    if not (digits.isascii() and digits.isdigit() and len(digits) < 12 and int(digits) <= MOST_ROWS):
        raise ValueError(f"the header of the PLY has the line {line[:80]!r}; expected element, a name and a count")
    return Element(words[1].lower(), int(digits))


def _add_property(elements: list[Element], words: list[str], line: str) -> None:
    single = len(words) == 3
    listed = len(words) == 5 and words[1] == "list"
    if not elements or not (single or listed) or any(word not in TYPES for word in words[1 + listed : -1]):
        raise ValueError(f"the header of the PLY has the line {line[:80]!r}; expected property, a type and a name")
    kinds = [TYPES[word] for word in words[1 + listed : -1]]
    if listed and kinds[0][0] == "f":
        raise ValueError(f"the header of the PLY counts a list by {words[2]}; expected whole numbers: export it anew")
    elements[-1].properties.append(Property(words[-1].lower(), kinds[-1], kinds[0] if listed else ""))


@dataclass
class ElementTable:
    """The columns of an element: single values by name, and lists as their counts and all values in a row."""

    columns: dict[str, NDArray[np.generic]] = field(default_factory=dict)
    lists: dict[str, tuple[Rows, NDArray[np.generic]]] = field(default_factory=dict)


def read_ply(data: bytes, beside: Companions, /) -> Scan:
    """The scan in a PLY file; beside: reads the texture that a comment names.

    ValueError for an invalid file.

    data: the file.
    """
    refuse_many(len(data), "bytes", LARGEST)
    if data.startswith(MARKS):  # before a text; in other bytes such a mark is a number
        data = data.removeprefix(MARKS[0]) if data.startswith(MARKS[0]) else strip_mark(data)
    header = parse_header(data)
    tables = _read_tables(data, header)
    vertices = tables.get("vertex", ElementTable())
    if any(name not in vertices.columns for name in "xyz"):
        raise ValueError("the PLY has no vertices with x, y and z; expected a cloud or a mesh: export it anew")
    points = np.stack([np.asarray(vertices.columns[name], np.float64) for name in "xyz"], axis=1)
    triangles, of, texcoords, doubled = _faces(tables, vertices)
    colours = _colours(vertices)
    if colours is None and triangles is not None:
        colours = _colours_of_faces(tables.get("face", ElementTable()), triangles, of, len(points))
    texture = None
    if header.textures and texcoords is not None:
        numbers = tables["face"].columns.get("texnumber", np.zeros(len(of), np.int64))
        chosen = np.clip(np.asarray(numbers, np.float64), -1, MOST_TEXTURES).astype(np.int64)[of]
        texture, texcoords = join_textures([beside.picture(name) for name in header.textures], texcoords, chosen)
    scan = make_scan(points, triangles, colours, texture, texcoords, beside=beside)
    return weld_scan(scan) if doubled else scan


def _colours(table: ElementTable) -> NDArray[np.uint8] | None:
    """The colours of vertices, or of faces."""
    for names in COLOURS:
        if all(name in table.columns for name in names):
            return bytes_of_colours(np.stack([table.columns[name] for name in names], axis=1))
    return None


def _colours_of_faces(faces: ElementTable, triangles: Rows, of: Rows, count: int) -> NDArray[np.uint8] | None:
    """The colours of vertices where faces alone have some: the mean of those around each, white where there is none."""
    tones = _colours(faces)
    if tones is None or not len(triangles) or triangles.min() < 0 or triangles.max() >= count:
        return None
    corners = triangles.reshape(-1)
    around = np.bincount(corners, minlength=count)
    sums = [np.bincount(corners, np.repeat(tones[of, at], 3), minlength=count) for at in range(3)]
    means = np.where(around > 0, np.stack(sums) / np.maximum(around, 1), 255.0)
    return np.asarray(np.rint(means.T), np.uint8)


def _faces(tables: dict[str, ElementTable], vertices: ElementTable) -> tuple[Rows | None, Rows, Values | None, bool]:
    """Triangles, the face that each is of, texture coordinates of their corners, and whether vertices are doubled for
    these."""
    faces = tables.get("face", ElementTable())
    polygons = next((faces.lists[name] for name in CORNERS if name in faces.lists), None)
    if polygons is None:
        return _strips(tables), np.zeros(0, np.int64), None, False
    counts, corners = polygons
    places = fan_polygons(counts)
    triangles = np.asarray(corners).astype(np.int64)[places]
    of = np.repeat(np.arange(len(counts)), np.maximum(counts - 2, 0))
    if "texcoord" in faces.lists:
        lengths, values = faces.lists["texcoord"]
        if (lengths == 2 * counts).all():
            return triangles, of, _from_below(np.asarray(values, np.float64).reshape(-1, 2)[places]), False
    for names in TEXCOORDS:
        if all(name in vertices.columns for name in names):
            pairs = np.stack([np.asarray(vertices.columns[name], np.float64) for name in names], axis=1)
            if len(triangles) and 0 <= triangles.min() <= triangles.max() < len(pairs):
                return triangles, of, _from_below(pairs[triangles]), True
    return triangles, of, None, False


def _strips(tables: dict[str, ElementTable]) -> Rows | None:
    """Triangles of strips, as range scanners' archives have them; -1 ends a strip."""
    lists = tables.get("tristrips", ElementTable()).lists
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


def _read_tables(data: bytes, header: Header) -> dict[str, ElementTable]:
    rows = _Rows(data, header)
    tables = {}
    for element in header.elements:
        if element.name in ("vertex", "face", "tristrips") and element.name not in tables:
            refuse_many(element.count, element.name, MOST_POINTS if element.name == "vertex" else MOST_TRIANGLES)
            tables[element.name] = rows.table(element)
        elif {"vertex", "face", "tristrips"} & {listed.name for listed in header.elements} <= tables.keys():
            break  # what follows says nothing of the shape
        else:
            rows.table(element)
    return tables


def _cut_off(element: Element) -> ValueError:
    return ValueError(
        f"the PLY declares {element.count} of {element.name!r} and does not hold them; it is cut off or written wrong: "
        "copy or export it anew"
    )


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


class _Rows:
    """The rows of a file, taken element by element; the numbers of a text are read as one row of doubles."""

    def __init__(self, data: bytes, header: Header) -> None:
        self.text = not header.order
        self.order = header.order or "="
        self.data: bytes | memoryview = data
        self.at = header.body
        if self.text:
            self.data = parse_numbers(data[header.body :], "the PLY").view(np.uint8).data
            self.at = 0

    def table(self, element: Element) -> ElementTable:
        """Its rows: at once where all lists are as long as those of the first row, as in meshes of triangles."""
        kind = self._first_row(element)
        size = kind.itemsize * element.count
        if size <= len(self.data) - self.at:
            taken = np.frombuffer(self.data, kind, element.count, self.at) if size else np.zeros(0, kind)
            counts = {at: taken[f"{at}n"] for at, column in enumerate(element.properties) if column.length}
            if all((lengths == lengths[:1]).all() for lengths in counts.values()):
                self.at += size
                table = ElementTable()
                for at, column in enumerate(element.properties):
                    self._keep(table, column, counts.get(at, taken[f"{at}"]), taken[f"{at}"].reshape(-1))
                return table
        if not any(column.length for column in element.properties):
            raise _cut_off(element)
        return self._walk(element)

    def _type(self, kind: str) -> str:
        """How numbers of a declared type lie in the file."""
        return "f8" if self.text else kind

    def _keep(
        self, table: ElementTable, column: Property, counts: NDArray[np.generic], values: NDArray[np.generic]
    ) -> None:
        kept = _typed(np.asarray(values, np.float64), column.type) if self.text else values
        if column.length:
            table.lists[column.name] = counts.astype(np.int64), kept
        else:
            table.columns[column.name] = kept

    def _first_row(self, element: Element) -> np.dtype[np.void]:
        """The layout of rows whose lists are as long as those of the first."""
        at = self.at
        fields = list[tuple[str, str, tuple[int, ...]]]()
        for number, column in enumerate(element.properties):
            count, at = self._count(element, column, at) if element.count else (0, at)
            fields += [(f"{number}n", self.order + self._type(column.length), ())] if column.length else []
            fields.append((f"{number}", self.order + self._type(column.type), (count,) if column.length else ()))
            at += count * int(self._type(column.type)[1])
        return np.dtype(fields)

    def _count(self, element: Element, column: Property, at: int) -> tuple[int, int]:
        """How many values begin where; one where the property is no list."""
        if not column.length:
            return 1, at
        length = self._type(column.length)
        try:
            count = int(struct.unpack_from(self.order + _UNPACKED[length], self.data, at)[0])
        except (struct.error, OverflowError, ValueError):
            raise _cut_off(element) from None
        at += int(length[1])
        if not 0 <= count * int(self._type(column.type)[1]) <= len(self.data) - at:
            raise _cut_off(element)
        return count, at

    def _walk(self, element: Element) -> ElementTable:
        """Rows with lists of several lengths: where each begins is known from the one before."""
        ranges: list[list[tuple[int, int]]] = [[] for _ in element.properties]
        sizes = [int(self._type(column.type)[1]) for column in element.properties]
        for _ in range(element.count):
            for place, column in enumerate(element.properties):
                count, self.at = self._count(element, column, self.at)
                ranges[place].append((self.at, count))
                self.at += count * sizes[place]
        if self.at > len(self.data):
            raise _cut_off(element)
        table = ElementTable()
        raw = np.frombuffer(self.data, np.uint8)
        for column, size, spans in zip(element.properties, sizes, ranges, strict=True):
            begins, counts = np.array(spans, np.int64).reshape(-1, 2).T
            values = np.frombuffer(raw[_spread(begins, counts * size)].tobytes(), self.order + self._type(column.type))
            self._keep(table, column, counts, values)
        return table
