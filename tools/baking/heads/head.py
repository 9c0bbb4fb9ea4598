"""Cuts the head out of the base mesh: the skin above the neck and the parts, each a mesh of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.model.space.head_size import HEAD_METRES
from tools.baking.heads.basemesh import BaseMesh, Floats, Ints, Quads

# Rows of the base mesh, whose vertices the package's targets name by number: the crown, and under the chin.
CROWN = 879
CHIN = 991
NECK = 0.11  # of the head's height, which the skin reaches down below the chin (docs/method.md, "The parameter space")
_DIGITS = 12  # no published number has more; further ones are what a subtraction left
PART_GROUPS: Mapping[str, tuple[str, ...]] = {
    "eye_left": ("helper-l-eye",),
    "eye_right": ("helper-r-eye",),
    "teeth_upper": ("helper-upper-teeth",),
    "teeth_lower": ("helper-lower-teeth",),
    "tongue": ("helper-tongue",),
    "lashes": ("helper-l-eyelashes-1", "helper-l-eyelashes-2", "helper-r-eyelashes-1", "helper-r-eyelashes-2"),
}


@dataclass(frozen=True)
class Piece:
    """One mesh of the head.

    vertices: (n,) its rows of the base mesh, rising;  triangles: (m, 3) rows of `vertices`;
    uvs: (k, 2) texture coordinates, v up;  uv_corners: (m, 3) the row of `uvs` at each triangle's corner
    """

    vertices: Ints
    triangles: Ints
    uvs: Floats
    uv_corners: Ints


@dataclass(frozen=True)
class Head:
    """The cut: skin and parts; the height of the eye centres, which becomes y = 0, in the package's unit; and how many
    metres that unit is, so that the generic head gets its declared height."""

    skin: Piece
    parts: Mapping[str, Piece]
    eye_height: float
    unit_metres: float

    def metres(self, points: Floats) -> Floats:
        """Points of the base mesh (..., 3) in its unit, in the head's frame: metres, y = 0 at the generic eyes."""
        return (points - [0.0, self.eye_height, 0.0]) * self.unit_metres

    @property
    def eyes(self) -> Ints:
        """The rows of the base mesh that are eyeballs."""
        return np.concatenate([self.parts["eye_left"].vertices, self.parts["eye_right"].vertices])


def cut_head(base: BaseMesh) -> Head:
    """The head above the neck with its parts."""
    parts = {name: cut_piece(base, join(base, groups)) for name, groups in PART_GROUPS.items()}
    eyes = base.points[np.concatenate([parts["eye_left"].vertices, parts["eye_right"].vertices])]
    eye_height = float((eyes[:, 1].min() + eyes[:, 1].max()) / 2)
    body = base.groups["body"]
    chin = float(base.points[CHIN, 1])
    height = head_height(base)
    above = (base.points[body.corners, 1] > chin - NECK * height).all(axis=1)
    skin = cut_piece(base, Quads(body.corners[above], body.uv_corners[above]))
    return Head(skin, parts, eye_height, HEAD_METRES / height)


def head_height(base: BaseMesh) -> float:
    """How tall the head of the base mesh is from under its chin to its crown, in the mesh's own unit."""
    return round(float(base.points[CROWN, 1] - base.points[CHIN, 1]), _DIGITS)


def join(base: BaseMesh, groups: tuple[str, ...]) -> Quads:
    """The quads of several groups as one.

    base: the base mesh; groups: names of its groups of quads.
    """
    chosen = [base.groups[name] for name in groups]
    return Quads(np.concatenate([g.corners for g in chosen]), np.concatenate([g.uv_corners for g in chosen]))


def cut_piece(base: BaseMesh, quads: Quads) -> Piece:
    """A mesh of its own from some quads of the base mesh."""
    corners, uv_corners = split_quads(base.points, quads)
    vertices, triangles = np.unique(corners, return_inverse=True)
    uv_rows, uv_triangles = np.unique(uv_corners, return_inverse=True)
    return Piece(
        vertices.astype(np.int32),
        triangles.reshape(-1, 3).astype(np.int32),
        base.uvs[uv_rows],
        uv_triangles.reshape(-1, 3).astype(np.int32),
    )


def split_quads(points: Floats, quads: Quads) -> tuple[Ints, Ints]:
    """Two triangles per quad, (2n, 3) vertices and texture corners.

    Each quad is cut along its shorter diagonal; where both are equal within one percent, along the one that touches
    its highest corner. The rule does not know left from right, so a symmetric head is cut symmetrically.

    points (n, 3): in any unit; quads: their corners and texture corners.
    """
    corners = points[quads.corners]
    first = np.linalg.norm(corners[:, 0] - corners[:, 2], axis=1)
    second = np.linalg.norm(corners[:, 1] - corners[:, 3], axis=1)
    alike = np.abs(first - second) < 0.01 * np.maximum(first, second)
    highest_is_odd = corners[:, :, 1].argmax(axis=1) % 2 == 1
    turned = np.where(alike, highest_is_odd, second < first)
    order = np.where(turned[:, None], [1, 2, 3, 1, 3, 0], [0, 1, 2, 0, 2, 3])
    rows = np.arange(len(order))[:, None]
    return quads.corners[rows, order].reshape(-1, 3), quads.uv_corners[rows, order].reshape(-1, 3)
