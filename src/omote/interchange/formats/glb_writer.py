"""Writes glTF binaries (GLB): meshes under one root, with named morph targets.

Khronos glTF 2.0: targets are displacements, their names lie in `mesh.extras.targetNames`; an accessor that is mostly
zeros is sparse where that is smaller, and one that is all zeros has no data at all. Every mesh has all targets in the
same order, so that a viewer with one list of weights moves all of them together.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats
from omote.interchange.formats.rig import Rig

Json = dict[str, Any]

MAGIC = 0x46546C67
VERSION = 2
JSON_CHUNK = 0x4E4F534A
BIN_CHUNK = 0x004E4942
UNSIGNED_BYTE = 5121
SHORT = 5122
UNSIGNED_SHORT = 5123
UNSIGNED_INT = 5125
FLOAT = 5126
VERTICES = 34962
TRIANGLES = 34963  # what a buffer view is for
LINEAR = 9729
MIPMAPS = 9987
CLAMP = 33071
ROWS = "_VID"
"""The attribute that says which vertex of the cast a vertex is, for programs that keep what they do not know."""
NO_ROW = -1
"""Of a vertex that is none of the cast's: it is drawn alone."""
RESERVED = frozenset({"", "Basis"})
"""No names of targets: Blender leaves out the empty one and keeps the other for the mesh at rest."""
GENERATOR = "Omote"


@dataclass(frozen=True, eq=False)
class MorphTarget:
    """A morph target: displacements at full weight of positions (n, 3) metres and normals (n, 3)."""

    moves: Floats
    turns: Floats


@dataclass(frozen=True, eq=False)
class Material:
    """A surface: a picture (PNG) or a colour (red, green, blue, linear), how rough, and where alpha cuts holes.

    cut: what lies under this alpha is not there, 0 for all that is half there; None for a surface without holes;
    both: seen from behind too; relief: a picture (PNG) of normals; shown: how much of all of it shows, 0 where an
    avatar's expressions bring it.
    """

    name: str
    picture: bytes | None = None
    colour: tuple[float, float, float] = (1.0, 1.0, 1.0)
    roughness: float = 0.6
    cut: float | None = None
    both: bool = False
    relief: bytes | None = None
    shown: float = 1.0


@dataclass(frozen=True, eq=False)
class Shape:
    """A mesh under the root: points and normals (n, 3), uv (n, 2), triangles (t, 3), targets by name.

    points are metres from `place`; rows (n,): the vertices of the cast that these are, or NO_ROW; shade (n,): what is
    left of the light, 0..1; tangents (n, 4): for the relief, None where programs find them. Raises ValueError where
    arrays do not belong together.
    """

    name: str
    points: Floats
    normals: Floats
    uv: Floats
    triangles: NDArray[np.integer]
    material: Material
    targets: Mapping[str, MorphTarget] = field(default_factory=dict)
    place: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rows: NDArray[np.integer] | None = None
    shade: Floats | None = None
    tangents: Floats | None = None

    def __post_init__(self) -> None:
        count = len(self.points)
        expected = {"points": (count, 3), "normals": (count, 3), "uv": (count, 2), "rows": (count,), "shade": (count,)}
        expected["tangents"] = (count, 4)
        for name, shape in expected.items():
            values = getattr(self, name)
            if values is not None and values.shape != shape:
                raise ValueError(f"{name} of {self.name!r} have shape {values.shape}; expected {shape}")
        for name, target in self.targets.items():
            if not target.moves.shape == target.turns.shape == (count, 3):
                raise ValueError(f"target {name!r} of {self.name!r} has {len(target.moves)} rows; expected {count}")


@dataclass(frozen=True, eq=False)
class ExportScene:
    """A scene: shapes under one root; extras: plain data about it. ValueError where targets differ.

    apart: each shape has targets of its own; who moves them knows which; rig: of a figure, on which the shapes are.
    """

    name: str
    shapes: Sequence[Shape]
    extras: Mapping[str, Any] = field(default_factory=dict)
    apart: bool = False
    rig: Rig | None = None

    def __post_init__(self) -> None:
        names = list(self.shapes[0].targets) if self.shapes else []
        for shape in self.shapes:
            if not self.apart and list(shape.targets) != names:
                raise ValueError(f"{shape.name!r} has other targets than {self.shapes[0].name!r}; give all of them all")
        if reserved := RESERVED.intersection(name for shape in self.shapes for name in shape.targets):
            raise ValueError(f"a target is named {min(reserved)!r}, which Blender keeps for itself: rename it")


def glb_bytes(scene: ExportScene, /) -> bytes:
    """Encodes a scene as a GLB."""
    store = Store()
    return encode_glb(describe_scene(scene, store), store)


def describe_scene(scene: ExportScene, store: Store, /) -> Json:
    """The JSON of a scene, whose numbers and pictures go into the store: node 0 is the root, those of shapes follow."""
    materials = {id(shape.material): shape.material for shape in scene.shapes}
    places = {key: place for place, key in enumerate(materials)}
    root = {"name": scene.name, "children": list(range(1, 1 + len(scene.shapes))), "extras": dict(scene.extras)}
    return {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [root, *(_node(shape, at) for at, shape in enumerate(scene.shapes))],
        "meshes": [_mesh(store, shape, places[id(shape.material)]) for shape in scene.shapes],
        "materials": [_material(store, material) for material in materials.values()],
    }


class Store:
    """Builds the binary chunk with its views, accessors and pictures."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[Json] = []
        self.accessors: list[Json] = []
        self.pictures: list[Json] = []
        self._placed: dict[bytes, int] = {}

    def view(self, data: bytes, target: int | None = None) -> int:
        """Adds bytes, each view on a whole number of four.

        data: what is added; target: what the view is for, None: anything.
        """
        entry = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        self.views.append(entry if target is None else entry | {"target": target})
        self.data += data + bytes(-len(data) % 4)
        return len(self.views) - 1

    def accessor(self, entry: Json) -> int:
        """Adds the form of numbers."""
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def picture(self, data: bytes, name: str) -> int:
        """Adds a picture and the texture that shows it, one that is there already once.

        data: a PNG; name: the picture's.
        """
        if data not in self._placed:
            self._placed[data] = len(self.pictures)
            self.pictures.append({"name": name, "mimeType": "image/png", "bufferView": self.view(data)})
        return self._placed[data]

    def document(self) -> Json:
        """The JSON chunk's entries for all that was added, without empty ones."""
        sampler = {"magFilter": LINEAR, "minFilter": MIPMAPS, "wrapS": CLAMP, "wrapT": CLAMP}
        entries_of: Json = {
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
            "images": self.pictures,
            "textures": [{"sampler": 0, "source": at} for at in range(len(self.pictures))],
            "samplers": [sampler] if self.pictures else [],
        }
        return {name: entries for name, entries in entries_of.items() if entries}


def _node(shape: Shape, mesh: int) -> Json:
    moved = {"translation": list(shape.place)} if any(shape.place) else {}
    return {"name": shape.name, "mesh": mesh, **moved}


def _mesh(store: Store, shape: Shape, material: int) -> Json:
    attributes = {
        "POSITION": _full(store, shape.points, bounds=True),
        "NORMAL": _full(store, shape.normals),
        "TEXCOORD_0": _full(store, shape.uv),
    }
    if shape.tangents is not None:
        attributes["TANGENT"] = _full(store, shape.tangents)
    if shape.rows is not None:  # exact up to 2**24 as floats; the format forbids whole numbers of 4 bytes
        attributes[ROWS] = _full(store, shape.rows.astype(np.float32))
    if shape.shade is not None:
        attributes["COLOR_0"] = _full(store, np.repeat(shape.shade[:, None], 3, axis=1))
    primitive: Json = {"attributes": attributes, "indices": _indices(store, shape), "material": material}
    mesh: Json = {"name": shape.name, "primitives": [primitive]}
    if shape.targets:
        primitive["targets"] = [
            {"POSITION": _delta(store, target.moves, name, bounds=True), "NORMAL": _delta(store, target.turns, name)}
            for name, target in shape.targets.items()
        ]
        mesh |= {"weights": [0.0] * len(shape.targets), "extras": {"targetNames": list(shape.targets)}}
    return mesh


def _indices(store: Store, shape: Shape) -> int:
    small = len(shape.points) < 0xFFFF  # the highest number would restart a strip
    kind = "<u2" if small else "<u4"
    view = store.view(shape.triangles.astype(kind).tobytes(), TRIANGLES)
    entry = {"componentType": UNSIGNED_SHORT if small else UNSIGNED_INT, "count": shape.triangles.size}
    return store.accessor({"bufferView": view, **entry, "type": "SCALAR"})


def _full(store: Store, values: Floats, *, bounds: bool = False) -> int:
    view = store.view(np.ascontiguousarray(values, "<f4").tobytes(), VERTICES)
    return store.accessor({"bufferView": view, **_form(values, bounds=bounds)})


def _delta(store: Store, values: Floats, name: str, *, bounds: bool = False) -> int:
    """An accessor of displacements: without data where nothing moves, sparse where that is smaller."""
    moved = np.flatnonzero(values.any(axis=1))
    form = {"name": name, **_form(values, bounds=bounds)}
    if not len(moved):
        return store.accessor(form)
    small = len(values) <= 0x10000
    if len(moved) * (14 if small else 16) >= values.nbytes:
        return store.accessor(
            {"bufferView": store.view(np.ascontiguousarray(values, "<f4").tobytes(), VERTICES), **form}
        )
    indices = {
        "bufferView": store.view(moved.astype("<u2" if small else "<u4").tobytes()),
        "componentType": UNSIGNED_SHORT if small else UNSIGNED_INT,
    }
    kept = {"bufferView": store.view(np.ascontiguousarray(values[moved], "<f4").tobytes())}
    return store.accessor({**form, "sparse": {"count": len(moved), "indices": indices, "values": kept}})


def _form(values: Floats, *, bounds: bool) -> Json:
    kinds = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
    columns = 1 if values.ndim == 1 else values.shape[1]
    form: Json = {"componentType": FLOAT, "count": len(values), "type": kinds[columns]}
    if bounds:
        ends = values.astype(np.float32)
        form |= {"min": ends.min(axis=0).tolist(), "max": ends.max(axis=0).tolist()}
    return form


def _material(store: Store, material: Material) -> Json:
    shine: Json = {"metallicFactor": 0.0, "roughnessFactor": material.roughness}
    if material.picture is None:
        shine["baseColorFactor"] = [*material.colour, 1.0]
    else:
        shine["baseColorTexture"] = {"index": store.picture(material.picture, material.name)}
    if material.shown < 1.0:
        shine["baseColorFactor"] = [*material.colour, material.shown]
    entry: Json = {"name": material.name, "pbrMetallicRoughness": shine}
    if material.relief is not None:
        entry["normalTexture"] = {"index": store.picture(material.relief, f"{material.name}_relief")}
    if material.cut is not None:
        entry |= {"alphaMode": "MASK", "alphaCutoff": material.cut} if material.cut else {"alphaMode": "BLEND"}
    return entry | {"doubleSided": True} if material.both else entry


def encode_glb(document: Json, store: Store, /) -> bytes:
    """Encodes a document and what it names in the store as a GLB."""
    text = msgspec.json.encode(document | store.document())
    data = bytes(store.data)
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), JSON_CHUNK) + text + struct.pack("<II", len(data), BIN_CHUNK) + data
    return struct.pack("<III", MAGIC, VERSION, 12 + len(chunks)) + chunks
