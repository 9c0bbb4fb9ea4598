"""Parses the untrusted materials of OBJ files (MTL): their pictures, and how texture coordinates lie on them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Picture
from omote.interchange.formats.file_content import strip_mark
from omote.interchange.scans.atlas import plain_picture
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.text_table import TextTable

MOST_MATERIALS = 64
MOST_LIBRARIES = 8
LARGEST = 2**20
"""Bytes of a library that are read."""
Pair = tuple[float, float]
UNMOVED: tuple[Pair, Pair] = ((1.0, 1.0), (0.0, 0.0))
_OPTION = re.compile(r"-(imfchan|type|colorspace|[A-Za-z]+)((?:\s+(?:[-+.,\deE]+|on|off))*)\s+")
_WORD_OPTION = re.compile(r"-(?:imfchan|type|colorspace)\s+\S+\s+")
_COMMENT = re.compile(r"\s#.*$")


@dataclass(frozen=True, eq=False)
class ObjMaterial:
    """The picture of a material; texture coordinates are multiplied by `scale` and `shift` is added, v up."""

    picture: Picture
    scale: Pair = UNMOVED[0]
    shift: Pair = UNMOVED[1]


def without_comment(name: str, /) -> str:
    """A name without a comment behind it."""
    return _COMMENT.sub("", name).strip()


def read_materials(table: TextTable, beside: Companions, /) -> dict[str, ObjMaterial]:
    """The materials of the libraries that an OBJ file names, by their names.

    table: the lines of the file; beside: reads the libraries and their pictures.
    """
    materials: dict[str, ObjMaterial] = {}
    lines = np.flatnonzero((table.initials == np.frombuffer(b"mtl", np.uint8)).all(axis=1))
    for line in lines[:MOST_LIBRARIES].tolist():
        for library in _libraries(table.rest(line), beside):
            materials |= _parse(library, beside)
    return materials


def _libraries(named: str, beside: Companions) -> list[bytes]:
    """The bytes of the libraries that a line names: one, whose name may have blanks, or several."""
    plain = without_comment(named).strip('"')
    whole = next((data for name in dict.fromkeys((named, plain)) if (data := _find(name, beside)) is not None), None)
    if whole is not None:
        return [whole]
    found = [data for name in plain.split()[:MOST_LIBRARIES] if (data := _find(name, beside)) is not None]
    if not found:
        beside.note(f"its materials {plain[-80:]!r} do not lie beside it: give both together, with its pictures")
    return found


def _find(name: str, beside: Companions) -> bytes | None:
    try:
        return beside.find(name)
    except (OSError, ValueError):
        return None


def find_material(materials: Mapping[str, ObjMaterial], name: str, beside: Companions, /) -> ObjMaterial | None:
    """The material of a name, else of one that differs by a comment or by capitals; None, and a sentence, for none.

    materials: by their names; name: as the OBJ has it; beside: is told.
    """
    if name in materials:
        return materials[name]
    plain = without_comment(name).casefold()
    for other, material in materials.items():
        if without_comment(other).casefold() == plain:
            return material
    if materials:
        beside.note(f"its material {name[:80]!r} is in none of its files of materials: what is made of it is grey")
    return None


def _parse(data: bytes, beside: Companions) -> dict[str, ObjMaterial]:
    materials: dict[str, ObjMaterial] = {}
    shown: dict[str, Picture | None] = {}
    current = ""
    for line in strip_mark(data)[:LARGEST].decode("utf-8", "replace").splitlines():
        keyword, rest = ([*line.split(None, 1), "", ""])[:2]
        match keyword.lower():
            case "newmtl" if len(materials) < MOST_MATERIALS:
                current = rest.strip()
            case "kd":
                materials.setdefault(current, ObjMaterial(_colour(rest)))
            case "map_kd" if len(shown) < MOST_MATERIALS:
                scale, shift, name = _read_map(rest, beside)
                if name not in shown:
                    shown[name] = beside.picture(name)
                if (picture := shown[name]) is not None:
                    materials[current] = ObjMaterial(picture, scale, shift)
    return materials


def _colour(words: str) -> Picture:
    numbers = _numbers(without_comment(words))[:3]
    return plain_picture(numbers * 3 if len(numbers) == 1 else numbers if len(numbers) == 3 else (0.5, 0.5, 0.5))


def _numbers(words: str) -> list[float]:
    """The numbers at the beginning of a text."""
    numbers = list[float]()
    for word in words.replace(",", ".").split():
        try:
            numbers.append(float(word))
        except ValueError:
            break
    return numbers


def _read_map(rest: str, beside: Companions) -> tuple[Pair, Pair, str]:
    """Scale and shift of a map by its options, and the name behind them (-s 1 1 1 -bm 0.5 name with blanks.jpg)."""
    scale, shift = UNMOVED
    rest = rest.strip()
    while option := _WORD_OPTION.match(rest) or _OPTION.match(rest):
        numbers = _numbers(option[2]) if option.re is _OPTION else []
        if numbers and option[1] == "s":
            scale = numbers[0], (numbers[1:2] or [1.0])[0]
        if numbers and option[1] == "o":
            shift = numbers[0], (numbers[1:2] or [0.0])[0]
        rest = rest[option.end() :]
    name = rest.strip().strip('"')
    return scale, shift, name if _find(name, beside) is not None else without_comment(name).strip('"')
