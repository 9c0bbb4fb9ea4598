"""Heads whose place is known: random people of two makers, the cast, a scanned head, whole bodies, animals."""

from __future__ import annotations

import functools
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.random_faces import ORDINARY, PeopleMaker, draw_person
from benchmarks.scans import perry_smith as perry_smith_scan
from omote.model.cast import Cast
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from tools.baking.heads.head import split_quads
from tools.baking.heads.person import person_points

Values = NDArray[np.float64]
Triangles = NDArray[np.int64]

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
ICT = DATA / "ict_facekit"
ANIMALS_AT = DATA / "quaternius_animals_cc0"
# iBUG's numbers of the seven.
ICT_SEVEN = (45, 42, 39, 36, 30, 54, 48)
ICT_STRENGTH = 0.9
EYES_APART = 0.088
"""Metres between the outer corners of a man's eyes."""
ANIMALS: Mapping[str, str] = {"Fox": "Fox_4", "Husky": "Cube_3", "ShibaInu": "ShibaInu_3", "Wolf": "Wolf_2"}
"""Each animal's file, and the mesh of it that is its eyes."""


@dataclass(frozen=True, eq=False)
class TrueHead:
    """A head upright and facing +z, metres: points (n, 3), triangles (t, 3), the seven landmarks (3,) by name."""

    name: str
    points: Values
    triangles: Triangles
    landmarks: Mapping[str, Values]


def ict_person(draw: np.random.Generator) -> TrueHead:
    """Somebody of ICT-FaceKit: skin, eyeballs, teeth and lashes as published."""
    points, triangles, modes, scale, rows = _read_ict()
    weights = ICT_STRENGTH * draw.normal(size=len(modes))
    shape = points + np.tensordot(weights * scale, modes.astype(np.float64), 1)
    return TrueHead("ICT", shape, triangles, {name: shape[row] for name, row in zip(SEVEN, rows, strict=True)})


@functools.cache
def _read_ict() -> tuple[Values, Triangles, NDArray[np.int16], float, list[int]]:
    points, triangles = read_obj(ICT / "generic_neutral_mesh.obj")
    modes = np.load(ICT / "identities_i16.npz")
    rows = json.loads((ICT / "vertex_indices.json").read_text())["idx_to_landmark_verts"]
    return 0.01 * points, triangles, modes["q"], 0.01 * float(modes["scale"]), [rows[number] for number in ICT_SEVEN]


def perry_smith() -> TrueHead:
    """Lee Perry-Smith's scan, of no unit that its maker names: here so large that his eyes are a person's apart."""
    points, triangles = perry_smith_scan.read_scan()
    marks = perry_smith_scan.clicks(points)
    size = EYES_APART / float(np.linalg.norm(marks["left_eye_outer"] - marks["right_eye_outer"]))
    found = {name: size * place for name, place in marks.items()}
    return TrueHead("Lee Perry-Smith", size * points, triangles.astype(np.int64), found)


def cast_head(cast: Cast, name: str) -> TrueHead:
    """Somebody of the cast, skin and eyeballs."""
    face = cast.faces[name]
    return _of_cast(cast, name, face.positions.astype(np.float64), face.parts)


def random_person(cast: Cast, maker: PeopleMaker, draw: np.random.Generator) -> TrueHead:
    """Somebody new of the package's sliders."""
    face = maker.make("person", draw_person(draw, ORDINARY))
    return _of_cast(cast, "MakeHuman", face.positions.astype(np.float64), face.parts)


def _of_cast(cast: Cast, name: str, skin: Values, parts: Mapping[str, NDArray[np.floating]]) -> TrueHead:
    points = [skin]
    triangles = [cast.space.triangles.astype(np.int64)]
    for part, values in parts.items():
        if cast.space.parts[part].eye:
            triangles.append(cast.space.parts[part].triangles.astype(np.int64) + sum(map(len, points)))
            points.append(values.astype(np.float64))
    landmarks = {mark: skin[row] for mark, row in find_landmarks(cast.space).items()}
    return TrueHead(name, np.concatenate(points), np.concatenate(triangles), landmarks)


def random_body(cast: Cast, maker: PeopleMaker, draw: np.random.Generator) -> TrueHead:
    """The whole body of somebody new."""
    package = maker._package
    base = maker._base
    head = maker.head
    points = head.unit_metres * person_points(draw_person(draw, ORDINARY), package, base, head)
    corners, _ = split_quads(base.points, base.groups["body"])
    used, triangles = np.unique(corners, return_inverse=True)
    rows = {name: head.skin.vertices[row] for name, row in find_landmarks(cast.space).items()}
    marks = {name: points[row] for name, row in rows.items()}
    return TrueHead("body", points[used], triangles.reshape(-1, 3), marks)


def animal(name: str) -> TrueHead:
    """The whole body of an animal with seven clicks: corners of its eyes' meshes, nose, sides of the muzzle."""
    import trimesh

    scene: Any = trimesh.load(ANIMALS_AT / f"{name}.glb", process=False)
    whole = scene.to_geometry()
    place, mesh = scene.graph[
        next(node for node in scene.graph.nodes_geometry if scene.graph[node][1] == ANIMALS[name])
    ]
    eyes = trimesh.transform_points(scene.geometry[mesh].vertices, place)
    points = np.array(whole.vertices)
    tip = points[points[:, 2].argmax()]
    marks = {"nose_tip": tip * [0, 1, 1]}
    for side, sign in (("left", 1), ("right", -1)):
        eye = eyes[sign * eyes[:, 0] > 0]
        marks[f"{side}_eye_outer"] = eye[np.abs(eye[:, 0]).argmax()]
        marks[f"{side}_eye_inner"] = eye[np.abs(eye[:, 0]).argmin()]
        goal = tip * [0, 1, 1] + [0.12 * sign, -0.12, -0.25]
        marks[f"mouth_{side}"] = points[np.linalg.norm(points - goal, axis=1).argmin()]
    return TrueHead(name, points, np.array(whole.faces), {mark: marks[mark] for mark in SEVEN})


def read_obj(path: Path) -> tuple[Values, Triangles]:
    """Points and triangles of an OBJ."""
    points = []
    triangles = []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "v":
            points.append([float(value) for value in rest.split()[:3]])
        if kind == "f":
            polygon = [int(corner.split("/")[0]) - 1 for corner in rest.split()]
            triangles += [[polygon[0], polygon[i], polygon[i + 1]] for i in range(1, len(polygon) - 1)]
    return np.array(points), np.array(triangles)
