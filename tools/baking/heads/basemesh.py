"""Reads the MakeHuman base mesh: vertices, texture coordinates per corner and groups of quads; and its targets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tools.baking.package import BakeError

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]


@dataclass(frozen=True)
class Quads:
    """The quads of one group.

    corners: (n, 4) vertex of each corner;  uv_corners: (n, 4) row in the texture coordinates of each corner
    """

    corners: Ints
    uv_corners: Ints


@dataclass(frozen=True)
class BaseMesh:
    """points: (19158, 3), decimetres as published, y up, +z forward;  uvs: (n, 2), v up;  groups: quads by name"""

    points: Floats
    uvs: Floats
    groups: Mapping[str, Quads]


def read_base_mesh(text: str) -> BaseMesh:
    """The base mesh of an OBJ text that consists of quads with texture coordinates; anything else is refused."""
    points: list[list[float]] = []
    uvs: list[list[float]] = []
    faces: dict[str, list[list[int]]] = {}
    group = ""
    for number, line in enumerate(text.splitlines(), start=1):
        words = line.split()
        match words[:1]:
            case ["v"]:
                points.append([float(word) for word in words[1:4]])
            case ["vt"]:
                uvs.append([float(word) for word in words[1:3]])
            case ["g"]:
                group = words[1]
            case ["f"]:
                faces.setdefault(group, []).append(_quad(words[1:], number))
    groups = {name: _quads(rows) for name, rows in faces.items()}
    return BaseMesh(np.array(points), np.array(uvs), groups)


def _quad(corners: list[str], number: int) -> list[int]:
    pairs = [corner.split("/") for corner in corners]
    if len(pairs) != 4 or any(len(pair) < 2 or not pair[1] for pair in pairs):
        raise BakeError(f"line {number} of the base mesh is {corners}, expected four corners with texture coordinates.")
    return [int(pair[0]) for pair in pairs] + [int(pair[1]) for pair in pairs]


def _quads(rows: list[list[int]]) -> Quads:
    table = np.array(rows, dtype=np.int32) - 1
    return Quads(table[:, :4], table[:, 4:])


def read_target(text: str, count: int) -> Floats:
    """A target's displacement (count, 3), in the base mesh's unit, from lines `vertex dx dy dz`; other vertices stay.

    text: of the file; count: vertices of the base mesh.
    """
    rows = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    displacement = np.zeros((count, 3))
    if not rows:
        return displacement
    table = np.loadtxt(rows, ndmin=2)
    vertices = table[:, 0].astype(np.int64)
    if table.shape[1] != 4 or vertices.min() < 0 or vertices.max() >= count:
        raise BakeError(
            f"a target names vertex {vertices.max()} in rows of {table.shape[1]}, expected 4 and under {count}."
        )
    displacement[vertices] = table[:, 1:]
    return displacement
