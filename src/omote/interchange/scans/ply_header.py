"""Parses the header of untrusted PLY files: the elements that follow it, and how each row of them is laid out."""

from __future__ import annotations

from dataclasses import dataclass, field

from omote.interchange.formats.file_content import describe_content

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
    """What a file declares; order: byte order, "" for text; body: where the first row begins; texture: its picture."""

    order: str
    elements: list[Element]
    body: int
    texture: str = ""


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
    order, texture, elements = "?", "", list[Element]()
    for line in lines:
        words = line.split()
        match words[:1]:
            case ["format"]:
                order = _format(words)
            case ["comment" | "obj_info"]:
                texture = texture or (line.partition("TextureFile")[2].strip() if "TextureFile" in words[1:2] else "")
            case ["element"]:
                elements.append(_element(words, line))
            case ["property"]:
                _add_property(elements, words, line)
            case [_]:
                raise ValueError(f"the PLY's header has the line {line[:80]!r}; expected format, element or property")
    if order == "?":
        raise ValueError(f"the header of the PLY names no format; expected one of {', '.join(FORMATS)}: export it anew")
    return Header(order, elements, body, texture)


def _format(words: list[str]) -> str:
    if len(words) < 2 or words[1] not in FORMATS:
        raise ValueError(f"the PLY has the format {' '.join(words[1:])[:80]!r}; expected one of {', '.join(FORMATS)}")
    return FORMATS[words[1]]


def _element(words: list[str], line: str) -> Element:
    digits = words[2] if len(words) == 3 else ""
    if not (digits.isascii() and digits.isdigit() and len(digits) < 12 and int(digits) <= MOST_ROWS):
        raise ValueError(f"the header of the PLY has the line {line[:80]!r}; expected element, a name and a count")
    return Element(words[1], int(digits))


def _add_property(elements: list[Element], words: list[str], line: str) -> None:
    single, listed = len(words) == 3, len(words) == 5 and words[1] == "list"
    if not elements or not (single or listed) or any(word not in TYPES for word in words[1 + listed : -1]):
        raise ValueError(f"the header of the PLY has the line {line[:80]!r}; expected property, a type and a name")
    kinds = [TYPES[word] for word in words[1 + listed : -1]]
    if listed and kinds[0][0] == "f":
        raise ValueError(f"the header of the PLY counts a list by {words[2]}; expected whole numbers: export it anew")
    elements[-1].properties.append(Property(words[-1], kinds[-1], kinds[0] if listed else ""))
