"""Small scenes for tests of GLB files: tetrahedra with every kind of target."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.glb_writer import ExportScene, Material, MorphTarget, Shape, glb_bytes

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
SIDES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
NAMES = ("still", "one", "all")


def targets(count: int) -> dict[str, MorphTarget]:
    """One target that moves nothing, one that moves one vertex, one that moves all."""
    moves = np.zeros((3, count, 3), np.float32)
    moves[1, 1] = [0.25, -0.5, 0.125]
    moves[2] = np.arange(3 * count, dtype=np.float32).reshape(count, 3) + 1.0
    return {name: MorphTarget(move, np.zeros_like(move)) for name, move in zip(NAMES, moves, strict=True)}


def tetrahedron(name: str = "tetra", *, size: int = 1, place: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Shape:
    """A tetrahedron, `size` times over, with the targets above; rows count backwards."""
    points = np.concatenate([CORNERS + 2 * step for step in range(size)]).astype(np.float32)
    middles = points.reshape(size, 4, 3).mean(axis=1, keepdims=True)
    away = (points.reshape(size, 4, 3) - middles).reshape(-1, 3)
    return Shape(
        name=name,
        points=points,
        normals=(away / np.linalg.norm(away, axis=1, keepdims=True)).astype(np.float32),
        uv=np.zeros((len(points), 2), np.float32),
        triangles=np.concatenate([SIDES + 4 * step for step in range(size)]),
        material=Material("plain", colour=(0.5, 0.25, 0.125)),
        targets=targets(len(points)),
        place=place,
        rows=np.arange(len(points))[::-1],
    )


def scene(*shapes: Shape) -> ExportScene:
    """A scene of shapes, one tetrahedron where none is given."""
    return ExportScene("head", shapes or (tetrahedron(),), {"notice": "nobody's"})


def taken_apart(data: bytes) -> tuple[dict[str, Any], bytes]:
    """The JSON and the bytes of a GLB."""
    (length,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + length]), data[28 + length :]


def put_together(document: object, binary: bytes = b"") -> bytes:
    """A GLB of any JSON and bytes, right or wrong."""
    text = document if isinstance(document, bytes) else json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def head_glb(name: str, points: NDArray[np.float64], moves: dict[str, NDArray[np.float64]]) -> bytes:
    """A GLB of points alone, as other programs write a head of ours: no normals, no rows."""
    stores = [np.asarray(values, "<f4") for values in (points, *moves.values())]
    views = []
    at = 0
    for values in stores:
        views.append({"buffer": 0, "byteOffset": at, "byteLength": values.nbytes})
        at += values.nbytes
    kind = {"componentType": 5126, "type": "VEC3", "count": len(points)}
    primitive = {"attributes": {"POSITION": 0}, "targets": [{"POSITION": at + 1} for at in range(len(moves))]}
    document = {
        "asset": {"version": "2.0"},
        "nodes": [{"name": name, "mesh": 0}],
        "meshes": [{"name": name, "primitives": [primitive], "extras": {"targetNames": list(moves)}}],
        "accessors": [{"bufferView": place, **kind} for place in range(len(stores))],
        "bufferViews": views,
        "buffers": [{"byteLength": at}],
    }
    return put_together(document, b"".join(values.tobytes() for values in stores))


def plain_glb() -> bytes:
    """The smallest scene as a file."""
    return glb_bytes(scene())
