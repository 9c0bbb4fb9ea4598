"""A small cast that no file is needed for: an egg with a nose, a mouth bag, two eyeballs and a lower row of teeth."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from omote.model.body.body import Body
from omote.model.body.figure_space import BONES_OF_A_ROW, FigureSpace
from omote.model.body.figures import Figures
from omote.model.body.pose import Pose
from omote.model.body.skeleton import Skeleton
from omote.model.cast import Cast
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import Part, bind_to_head, bind_to_jaw, eye_rotation

Points = NDArray[np.float64]

COLUMNS = 32
ROWS = 20
MOUTH_ROW = 6
MOUTH_COLUMNS = 3
FACES = ("generic", "broad", "long")
LOOKS = {
    "eyeLookOutLeft": ("left", 0.6, 0.0),
    "eyeLookInLeft": ("left", -0.6, 0.0),
    "eyeLookUpLeft": ("left", 0.0, 0.4),
    "eyeLookDownLeft": ("left", 0.0, -0.5),
    "eyeLookOutRight": ("right", -0.6, 0.0),
    "eyeLookInRight": ("right", 0.6, 0.0),
    "eyeLookUpRight": ("right", 0.0, 0.4),
    "eyeLookDownRight": ("right", 0.0, -0.5),
}
"""Which eyeball each unit turns, by which yaw and pitch."""
EXPRESSIONS = ("neutral", "jawOpen", "browInnerUp", "smile", *LOOKS)
POSES = ("stand", "bow", "wave")
BODIES = ("generic", "broad")


def head() -> tuple[Points, NDArray[np.int32]]:
    """Points (V, 3) metres and triangles (F, 3): rings around the y axis, a crown, and a bag behind the mouth."""
    theta = -np.pi + 2 * np.pi * np.arange(COLUMNS) / COLUMNS
    h = np.linspace(-0.12, 0.115, ROWS)
    radius = 0.085 * np.sqrt(1.0 - (h / 0.13) ** 2 * np.where(h > 0, 1.0, 0.6))
    nose = 0.02 * np.exp(-((theta[None] / 0.25) ** 2) - ((h[:, None] + 0.01) / 0.02) ** 2)
    r = radius[:, None] * (1.0 + 0.08 * np.cos(theta)[None]) + nose
    rings = np.stack([r * np.sin(theta), np.broadcast_to(h[:, None], r.shape), r * np.cos(theta)], axis=-1)
    crown = np.array([[0.0, 0.125, 0.0]])
    loop = _mouth_loop()
    bag = rings.reshape(-1, 3)[loop] * [0.9, 1.0, 0.75]
    back = bag.mean(axis=0, keepdims=True) - [[0.0, 0.0, 0.01]]
    points = np.concatenate([rings.reshape(-1, 3), crown, bag, back])
    return points, _triangles(loop)


def _mouth_loop() -> NDArray[np.int64]:
    """The vertices around the removed quads, in order."""
    left = COLUMNS // 2 - MOUTH_COLUMNS
    right = COLUMNS // 2 + MOUTH_COLUMNS
    lower = MOUTH_ROW * COLUMNS + np.arange(left, right + 1)
    upper = (MOUTH_ROW + 1) * COLUMNS + np.arange(right, left - 1, -1)
    return np.concatenate([lower, upper])


def _triangles(loop: NDArray[np.int64]) -> NDArray[np.int32]:
    row, column = np.meshgrid(np.arange(ROWS - 1), np.arange(COLUMNS), indexing="ij")
    mouth = (row == MOUTH_ROW) & (np.abs(column - COLUMNS // 2 + 0.5) < MOUTH_COLUMNS)
    row = row[~mouth]
    column = column[~mouth]
    a, b = row * COLUMNS + column, row * COLUMNS + (column + 1) % COLUMNS
    c, d = a + COLUMNS, b + COLUMNS
    crown = ROWS * COLUMNS
    last = (ROWS - 1) * COLUMNS + np.arange(COLUMNS)
    bag = crown + 1 + np.arange(len(loop))
    following = np.roll(np.arange(len(loop)), -1)
    back = crown + 1 + len(loop)
    groups = [
        (a, b, d), (a, d, c),
        (last, np.roll(last, -1), np.full(COLUMNS, crown)),
        (loop, loop[following], bag[following]), (loop, bag[following], bag),
        (bag, bag[following], np.full(len(loop), back)),
    ]  # fmt: skip
    return np.concatenate([np.stack(group, axis=1) for group in groups]).astype(np.int32)


def _ball(centre: Points, radius: float) -> tuple[Points, NDArray[np.int32]]:
    corners = np.concatenate([np.eye(3), -np.eye(3)]) * radius + centre
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    return corners, np.array(faces, np.int32)


def _parts(points: Points, sheet: NDArray[np.int32]) -> list[Part]:
    left, triangles = _ball(np.array([0.03, 0.03, 0.065]), 0.012)
    right, _ = _ball(np.array([-0.03, 0.03, 0.065]), 0.012)
    teeth, _ = _ball(np.array([0.0, -0.05, 0.06]), 0.01)
    chin = sheet[np.linalg.norm(points[sheet] - [0.0, -0.07, 0.08], axis=1) < 0.03]
    return [
        bind_to_head("eye_left", left, triangles, points, candidates=sheet, eye="left"),
        bind_to_head("eye_right", right, triangles, points, candidates=sheet, eye="right"),
        bind_to_jaw("teeth_lower", teeth, triangles, points, candidates=sheet, chin=chin),
    ]


@cache
def space() -> ParameterSpace:
    """The parameter space of the egg."""
    points, triangles = head()
    built = ParameterSpace.build(points, triangles)
    return built.with_parts(*_parts(points, np.flatnonzero(built.on_sheet).astype(np.int32)))


def _bump(points: Points, centre: tuple[float, float, float], width: float, move: tuple[float, float, float]) -> Points:
    distance = np.linalg.norm(points - np.array(centre), axis=1, keepdims=True)
    result: Points = np.exp(-((distance / width) ** 2)) * np.array(move)
    return result


def _expressions(face: Face) -> dict[str, Expression]:
    points = face.positions.astype(np.float64)
    jaw = _bump(points, (0.0, -0.08, 0.08), 0.035, (0.0, -0.012, -0.004))
    brow = _bump(points, (0.0, 0.05, 0.085), 0.03, (0.0, 0.008, 0.001))
    smile = sum(_bump(points, (x, -0.04, 0.075), 0.025, (x / 5, 0.006, -0.002)) for x in (0.03, -0.03))
    teeth = {"teeth_lower": np.full((6, 3), [0.0, -0.01, 0.0])}
    found = {
        "neutral": extract(space(), face, np.zeros_like(points)),
        "jawOpen": extract(space(), face, jaw, parts=teeth),
        "browInnerUp": extract(space(), face, brow),
        "smile": extract(space(), face, smile),
    }
    return {**found, **{name: _look(face, name) for name in LOOKS}}


def _look(face: Face, name: str) -> Expression:
    side, yaw, pitch = LOOKS[name]
    ball = fit(space(), face).parts[f"eye_{side}"].astype(np.float64)
    turned = (ball - ball.mean(axis=0)) @ eye_rotation(yaw, pitch).T + ball.mean(axis=0)
    centre = (0.03 if side == "left" else -0.03, 0.03, 0.08)
    lid = _bump(face.positions.astype(np.float64), centre, 0.015, (0.0, 0.004 * np.sign(pitch), 0.0))
    return extract(space(), face, lid, parts={f"eye_{side}": turned - ball})


@cache
def figures() -> Figures:
    """Two bodies of one triangle below the egg, on two bones, and three poses."""
    rows = space().vertex_count
    shape = FigureSpace(
        head_rows=rows,
        triangles=np.array([[0, rows, rows + 1]], np.int32),
        skeleton=Skeleton(("root", "head"), np.array([-1, 0], np.int32)),
        bones=np.zeros((rows + 2, BONES_OF_A_ROW), np.int32),
        weights=np.eye(1, BONES_OF_A_ROW, dtype=np.float32).repeat(rows + 2, axis=0),
        shares=np.ones(rows + 2, np.float32),
        edge=np.array([0], np.int32),
        rim=1,
        joined=np.array([0], np.int32),
        join=np.full((1, 1), 0.5, np.float32),
        head_joint=np.array([0], np.int32),
        head_joint_offset=np.zeros(3),
        uvs=np.zeros((3, 2), np.float32),
        uv_rows=np.array([[0, 1, 2]], np.int32),
    )
    at = np.array([[0.0, -0.3, 0.0], [0.1, -0.3, 0.0]])
    bodies = {name: Body(name, at * wide, at[:1], at, at) for wide, name in enumerate(BODIES, start=1)}
    poses = {name: Pose(name, np.full((2, 3), 0.1 * turn)) for turn, name in enumerate(POSES)}
    return Figures(shape, bodies, poses)


@cache
def cast() -> Cast:
    """Three faces, twelve expressions, three poses; frozen, so all tests share it."""
    points = space().points
    chin = _bump(points, (0.0, -0.09, 0.08), 0.03, (0.0, -0.01, 0.012))
    shapes = (points, points * [1.15, 0.95, 1.05], points * [0.95, 1.2, 1.0] + chin)
    faces = {name: Face(name, shape.astype(np.float32)) for name, shape in zip(FACES, shapes, strict=True)}
    return Cast(space(), faces, _expressions(faces["generic"]), figures=figures())


class Recast:
    """A cast with other names than the one it stands for."""

    def __init__(self, cast: Cast, faces: list[str], expressions: list[str], digest: str = "other") -> None:
        self.faces = {name: name for name in faces}
        self.expressions = {name: cast.expressions.get(name, cast.expressions["smile"]) for name in expressions}
        self.titles = cast.titles
        self.face_labels = cast.face_labels
        self.poses = cast.poses
        self.bones = cast.bones
        self.bodies = cast.bodies
        self.digest = digest
