"""Writes Wavefront OBJ: a face wearing one expression as text, with its surfaces (MTL) and pictures beside it.

Vertices keep the cast's rows and their order, so that what another program shapes finds back; texture coordinates and
normals have indices of their own, so that no mesh is torn at a seam.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from omote.interchange.exports.identifiers import identifiers
from omote.interchange.formats.glb_writer import GENERATOR, ExportScene, Shape
from omote.model.known_names import NEUTRAL

Files = dict[str, bytes]
Values = NDArray[np.floating]

POINTS = "%.8g"
DIRECTIONS = "%.5f"
"""How numbers are written: metres so that float32 comes back within a hundredth of a micrometre of a head."""


def obj_files(scene: ExportScene, stem: str, /) -> Files:
    """A face as STEM.obj, with STEM.mtl and pictures: at rest, or wearing the one expression that the scene has.

    ValueError for several expressions: the format holds one shape.

    scene: with one target at most; stem: of the files' names.
    """
    worn = list(scene.shapes[0].targets)
    require_single(worn)
    text = obj_text(scene, worn[0] if worn else NEUTRAL, f"{stem}.mtl", faces_text(scene))
    return {f"{stem}.obj": text, **_surfaces(scene, stem, "")}


def require_single(expressions: Sequence[str], /) -> None:
    """Refuses several expressions, by ValueError: an OBJ holds one shape."""
    if len(expressions) > 1:
        raise ValueError(
            f"an OBJ holds one shape, and {len(expressions)} expressions are named; name one, or have a folder of "
            "them written: --format obj -o FOLDER"
        )


def obj_folder(scene: ExportScene, stem: str, /) -> Files:
    """A folder STEM of a face: neutral.obj, an OBJ for each expression, and the surfaces that all of them share.

    scene: whose targets become files; stem: the folder's name.
    """
    faces = faces_text(scene)
    names = identifiers([NEUTRAL, *scene.shapes[0].targets])
    shapes = {f"{stem}/{file}.obj": obj_text(scene, name, f"{scene.name}.mtl", faces) for name, file in names.items()}
    return {**shapes, **_surfaces(scene, scene.name, f"{stem}/")}


def obj_text(scene: ExportScene, expression: str, library: str, faces: Mapping[str, str], /) -> bytes:
    """The text of a scene wearing an expression of its own, or none (neutral).

    library: the name of its MTL; faces: `faces_text`.
    """
    notice = f"# {GENERATOR}: {scene.name}, {expression}, metres\n# {scene.extras.get('notice', '')}\n"
    parts = [notice, f"mtllib {library}\n"]
    for shape in scene.shapes:
        target = shape.targets.get(expression)
        points = shape.points + np.asarray(shape.place, np.float32)
        normals = shape.normals
        if target is not None:
            points = points + target.moves
            normals = _unit(normals + target.turns)
        parts += [f"o {shape.name}\nusemtl {shape.material.name}\n", _lines("v", points[_kept(shape)[0]], POINTS)]
        parts += [_lines("vn", normals, DIRECTIONS), faces[shape.name]]
    return "".join(parts).encode()


def faces_text(scene: ExportScene, /) -> dict[str, str]:
    """The lines of texture coordinates and triangles of each mesh: all expressions share them."""
    vertex = 1
    other = 1
    texts = {}
    for shape in scene.shapes:
        kept, place = _kept(shape)
        corners = np.stack([place[shape.triangles] + vertex, shape.triangles + other], axis=-1)
        text = "\n".join(map("f %d/%d/%d %d/%d/%d %d/%d/%d".__mod__, _corner_rows(corners)))
        upwards = np.stack([shape.uv[:, 0], 1.0 - shape.uv[:, 1]], axis=1)
        texts[shape.name] = f"{_lines('vt', upwards, '%.6f')}s 1\n{text}\n"
        vertex = vertex + len(kept)
        other = other + len(shape.points)
    return texts


def _corner_rows(corners: NDArray[np.integer]) -> list[tuple[int, ...]]:
    """Vertex, texture coordinate and normal of the three corners of each triangle; the latter two share an index."""
    return [tuple(row) for row in corners[:, :, [0, 1, 1]].reshape(len(corners), -1).tolist()]


def _kept(shape: Shape) -> tuple[NDArray[np.integer], NDArray[np.integer]]:
    """One vertex of a mesh for each row of the cast, in their order; and where each vertex is among those."""
    if shape.rows is None:
        every = np.arange(len(shape.points))
        return every, every
    _, first, place = np.unique(shape.rows, return_index=True, return_inverse=True)
    return first, place.reshape(-1)


def _lines(word: str, values: Values, form: str) -> str:
    pattern = f"{word} " + " ".join([form] * values.shape[1]) + "\n"
    return "".join(map(pattern.__mod__, map(tuple, values.tolist())))


def _unit(vectors: Values) -> Values:
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(vectors / np.maximum(size, 1e-12))


def _surfaces(scene: ExportScene, stem: str, folder: str) -> Files:
    """The library of materials, STEM.mtl, and the pictures that it names, in a folder ("" or "NAME/")."""
    materials = {shape.material.name: shape.material for shape in scene.shapes}
    lines = [f"# {GENERATOR}: surfaces of {scene.name}"]
    pictures = Files()
    for material in materials.values():
        shine = (30.0 * (1.0 - material.roughness)) ** 2  # as Blender converts them
        colour = " ".join(f"{value:.4g}" for value in material.colour)
        lines += [f"newmtl {material.name}", f"Kd {colour}", f"Ns {shine:.4g}", f"Pr {material.roughness:.4g}"]
        if material.picture is not None:
            name = f"{stem}.{material.name}.png"
            pictures[f"{folder}{name}"] = material.picture
            lines += [f"map_Kd {name}", *([f"map_d {name}"] if material.cut is not None else [])]
    return {f"{folder}{stem}.mtl": ("\n".join(lines) + "\n").encode(), **pictures}
