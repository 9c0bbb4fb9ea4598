"""Handles of the face editor: landmarks of the generic head; dragged, they deform the face and its parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from omote.arrays import Indices, Rows, Values
from omote.geometry import mesh
from omote.model.sculpting.regions import fit_with_lids
from omote.model.sculpting.sculpt import Sculpt, warp
from omote.model.space.eye_socket import ball_heights, move_ball
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace

FARTHEST_MOVE = 0.1
"""How far a handle may be moved, metres."""

_MIRROR = np.array([-1.0, 1.0, 1.0])
_MIDLINE = 1e-6  # What a vertex on the midline may be off it, metres.

# Millimetres on the generic head: x to its left, y up, z ahead; each stands on the vertex that is nearest. Those at the
# back, on the crown and around the neck are there to stay: without them the far side would follow the near side.
_ON_MIDLINE: tuple[tuple[str, tuple[float, float, float]], ...] = (
    ("nose tip", (0, -35, 168)),
    ("under the nose", (0, -48, 157)),
    ("bridge of the nose", (0, -14, 156)),
    ("root of the nose", (0, 4, 151)),
    ("upper lip", (0, -59, 160)),
    ("lower lip", (0, -77, 156)),
    ("chin", (0, -100, 148)),
    ("under the chin", (0, -113, 124)),
    ("between the brows", (0, 24, 153)),
    ("forehead", (0, 63, 145)),
    ("hairline", (0, 101, 117)),
    ("crown", (0, 121, 40)),
    ("back of the head", (0, 18, -39)),
    ("nape", (0, -70, -12)),
    ("front of the neck", (0, -124, 74)),
    ("back of the neck", (0, -134, -23)),
)
_BESIDE: tuple[tuple[str, tuple[float, float, float]], ...] = (
    ("{} nose wing", (14, -41, 152)),
    ("{} inner eye corner", (20.3, -0.9, 137)),
    ("{} outer eye corner", (43.9, 0.3, 136)),
    ("{} upper lid", (31, 4.7, 141)),
    ("{} lower lid", (31, -4.4, 140)),
    ("{} inner brow", (16, 22, 150)),
    ("middle of the {} brow", (33, 25, 144)),
    ("{} outer brow", (49, 23, 129)),
    ("{} temple", (70, 36, 80)),
    ("{} side of the forehead", (41, 65, 124)),
    ("{} cheekbone", (59, -16, 114)),
    ("{} cheek", (44, -41, 130)),
    ("{} mouth corner", (25.3, -67.9, 141.4)),
    ("{} side of the jaw", (40, -90, 113)),
    ("{} jaw corner", (56, -60, 73)),
    ("{} side of the chin", (20, -97, 141)),
    ("{} ear tip", (75, 22, 42)),
    ("{} ear rim", (88, -4, 38)),
    ("{} ear lobe", (73, -46, 58)),
    ("behind the {} ear", (64, -10, 17)),
    ("{} side of the head", (64, 81, 39)),
    ("{} side of the neck", (51, -127, 19)),
)


@dataclass(frozen=True)
class Handle:
    """A landmark: a vertex of the sheet with its label; mirror: the place of its mirror image among the handles, its
    own on the midline."""

    label: str
    row: int
    mirror: int


def default_handles(space: ParameterSpace, /) -> tuple[Handle, ...]:
    """The handles of a head by feature: on the midline, then left and right in turn ("left" is the head's own).

    Features that would stand on one vertex (of a coarse head) share a handle, named after the first.
    """
    sheet = np.unique(space.skin_triangles)
    points = space.points[sheet]
    images = sheet[cKDTree(points).query(points * _MIRROR)[1]]
    middle = np.flatnonzero(np.abs(points[:, 0]) <= _MIDLINE)
    left = np.flatnonzero((points[:, 0] > _MIDLINE) & (images != sheet))
    landmarks: list[tuple[str, int, int]] = []  # label, row, row of the mirror image
    for label, where in _ON_MIDLINE:
        landmarks.append((label, *_nearest(points, sheet, sheet, middle, where)))
    for label, where in _BESIDE:
        row, image = _nearest(points, sheet, images, left, where)
        landmarks += [(label.format("left"), row, image), (label.format("right"), image, row)]
    landmarks = list({row: (label, row, image) for label, row, image in reversed(landmarks)}.values())[::-1]
    places = {row: place for place, (_, row, _) in enumerate(landmarks)}
    return tuple(Handle(label, row, places[image]) for label, row, image in landmarks)


def _nearest(points: Values, rows: Indices, images: Indices, among: Rows, where: Sequence[float]) -> tuple[int, int]:
    distance = np.linalg.norm(points[among] - np.asarray(where) / 1000, axis=1)
    place = among[int(distance.argmin())]
    return int(rows[place]), int(images[place])


def drag_handles(space: ParameterSpace, face: Face, name: str, /, *, rows: ArrayLike, moves: ArrayLike) -> Face:
    """Moves a face's handles (rows of the sheet) by moves (n, 3), metres; the result is named `name`.

    space: the space of the generic head.

    Skin and parts are carried by the sculptor's map; eyeballs stay round, and lids lie on them as before. Raises
    ValueError where rows are no vertices of the sheet, stand twice or all in one plane, or where a move is not finite,
    leads too far or tears the face.
    """
    where = validate_rows(space, rows)
    far = _validate_moves(moves, len(where))
    fitted = fit(space, face)
    before = {part: fitted.parts[part].astype(np.float64) for part in space.parts}
    if not far.any():
        return Face(name, fitted.positions, before, face.gains)
    skin = fitted.positions.astype(np.float64)
    move = warp(Sculpt(name, skin[where], far, symmetric=False))
    parts = {
        part.name: move_ball(ball, ball, move(ball)) if part.eye else move(ball)
        for part, ball in zip(space.parts.values(), before.values(), strict=True)
    }
    wanted = {eye: ball_heights(fitted.positions, fitted.parts[eye]) for eye in space.eyes}
    return fit_with_lids(space, name, move(skin), parts, wanted, face.gains)


def validate_rows(space: ParameterSpace, rows: ArrayLike, /) -> Indices:
    """Validates rows (n,) of the sheet, each once; ValueError for others. space: the space of the generic head."""
    given = np.asarray(rows)
    if given.ndim != 1 or len(given) == 0 or given.dtype.kind not in "iu":
        raise ValueError(f"handles are {rows!r}; expected a list of rows of the generic face's sheet")
    strange = given[~np.isin(given, space.skin_triangles)]
    if len(strange):
        raise ValueError(
            f"a handle stands on row {int(strange[0])}; expected one of the sheet's vertices (rows below "
            f"{space.vertex_count} that lie on the outer skin)"
        )
    kept, counts = np.unique(given, return_counts=True)
    if (counts > 1).any():
        raise ValueError(
            f"two handles stand on row {int(kept[counts.argmax()])}; expected one on each vertex: remove one"
        )
    return given.astype(np.int32)


def _validate_moves(moves: ArrayLike, count: int) -> Values:
    far = mesh.validate_points(moves, name="moves of handles")
    if len(far) != count:
        raise ValueError(f"there are {count} handles and {len(far)} moves; expected as many")
    lengths = np.linalg.norm(far, axis=1)
    if lengths.max() > FARTHEST_MOVE:
        raise ValueError(
            f"handle {int(lengths.argmax())} is moved by {lengths.max():.3g} m; expected at most {FARTHEST_MOVE} m: "
            "move it less far"
        )
    return far
