"""The figure of one vertex: extracted on one face, applied on another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry.cylinder import wrap
from omote.model.cast import Cast
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import apply_paper_map, compile_expression, project_to_surface
from tools.pictures.method.svg import AMBER, BLUE, GREY, INK, RED, Box, Figure
from tools.pictures.method.unrolled import Unrolled, sheet_or_membrane
from tools.pictures.method.view import MARK, SKIN, Eye, Surface, picture

Values = NDArray[np.float64]

TEACHER = "kaori"
LEARNER = "old"
SMILE = "mouthSmileLeft"


def draw_transfer(cast: Cast) -> Figure:
    """Extract on one face, apply on another: the same triangle, the same weights (paper, section 2.2)."""
    space = cast.space.under("paper")
    vertex, moved = _corner(cast)
    figure = Figure(960, 372, "One vertex: extracted on one face, applied on another")
    boxes = [(16.0 + 316 * n, 60.0, 300.0, 270.0) for n in range(3)]
    teacher = cast.faces[TEACHER]
    learner = cast.faces[LEARNER]
    landing = project_to_surface(space, teacher.positions.astype(np.float64), moved[None], np.array([vertex], np.int32))
    triangle = int(landing.triangles[0])
    weights = landing.weights[0]
    _on_face(figure, boxes[0], space, teacher, (vertex, triangle), weights, moved, "1")
    _on_s(figure, boxes[1], space, (vertex, triangle), weights)
    _on_face(figure, boxes[2], space, learner, (vertex, triangle), weights, _worn(cast, LEARNER)[vertex], "2")
    for box, words in zip(boxes, _STEPS, strict=True):
        figure.text(box[0], 26, words[0], colour=INK)
        figure.text(box[0], 46, words[1])
    figure.legend(16, 356, [("where the vertex is", BLUE), ("where it goes", RED), ("slid along the radius", AMBER),
                            ("the triangle it lands in, the same on all three", "#f4be46")])  # fmt: skip
    return figure


_STEPS = (
    (f"1. extract on {TEACHER}", "P11 slides onto the skin: P11' in triangle Q11"),
    ("S", "the same weights b in Q01: (dtheta, dh)"),
    (f"2. apply on {LEARNER}", "the same b in Q21: P21', radius R r(P2): P21"),
)


def _corner(cast: Cast) -> tuple[int, Values]:
    """The vertex that a smile moves most on the first face, and where it goes by the paper's map."""
    here = cast.faces[TEACHER].positions.astype(np.float64)
    worn = _worn(cast, TEACHER)
    away = np.linalg.norm(worn - here, axis=1) * cast.space.on_sheet
    vertex = int(away.argmax())
    return vertex, worn[vertex]


def _worn(cast: Cast, face: str) -> Values:
    old = cast.under("paper")
    compiled = compile_expression(old.space, old.expressions[SMILE])
    worn: Values = apply_paper_map(old.space, fit(old.space, old.faces[face]), compiled).astype(np.float64)
    return worn


def _on_face(
    figure: Figure, box: Box, space: ParameterSpace, face: Face, where: tuple[int, int], weights: Values, goal: Values,
    name: str,
) -> None:  # fmt: skip
    vertex, triangle = where
    points = face.positions.astype(np.float64)
    corners = space.location_triangles[triangle]
    start = points[vertex]
    on_skin = weights @ points[corners]
    eye = Eye(tuple((start + goal) / 2), 0.032, yaw=68.0, pitch=14.0)
    material = np.where(np.arange(len(space.location_triangles)) == triangle, MARK, SKIN)
    figure.rect(*box)
    figure.add(picture(eye, box, [Surface(points, space.location_triangles, material)]))
    axis = np.array([space.cylinder.x, on_skin[1], space.cylinder.z])
    ray = eye.seen(np.stack([on_skin + 0.004 * _unit(axis - on_skin), on_skin - 0.008 * _unit(axis - on_skin)]), box)
    a, b, c = (tuple(eye.seen(p[None], box)[0, :2]) for p in (start, on_skin, goal))
    figure.line(ray[:, :2], AMBER, width=1.2, dash="4 3")
    figure.line([a, c], RED, width=2, arrow=True)
    for place, colour, words, side in (
        (a, BLUE, f"P{name}", 1),
        (b, AMBER, f"P{name}1'", -1),
        (c, RED, f"P{name}1", 1),
    ):
        figure.dot(place, colour)
        figure.label(place[0] + 9 * side, place[1] + 16, words, colour=colour, anchor="start" if side > 0 else "end")


def _unit(vector: Values) -> Values:
    result: Values = vector / np.linalg.norm(vector)
    return result


def _on_s(figure: Figure, box: Box, space: ParameterSpace, where: tuple[int, int], weights: Values) -> None:
    vertex, triangle = where
    corners = space.location_triangles[triangle]
    theta = space.theta[corners[0]] + weights @ wrap(space.theta[corners] - space.theta[corners[0]])
    h = float(weights @ space.h[corners])
    middle = ((space.theta[vertex] + theta) / 2, (space.h[vertex] + h) / 2)
    flat = Unrolled(space, box, middle=middle, width=0.032)
    figure.rect(*box)
    material = sheet_or_membrane(space)
    material[triangle] = MARK
    figure.add(flat.picture(material))
    a, b = flat.at(space.theta[vertex], space.h[vertex]), flat.at(theta, h)
    figure.line([tuple(a), (b[0], a[1])], GREY, width=1.2, dash="4 3")
    figure.line([(b[0], a[1]), tuple(b)], GREY, width=1.2, dash="4 3")
    figure.line([tuple(a), tuple(b)], RED, width=2, arrow=True)
    figure.dot(a, BLUE)
    figure.dot(b, RED)
    figure.label((a[0] + b[0]) / 2, a[1] + 18, "dtheta", colour=INK, anchor="middle")
    figure.label(b[0] + 8, (a[1] + b[1]) / 2, "dh", colour=INK)
    figure.label(a[0] - 8, a[1] + 18, "P0", colour=BLUE, anchor="end")
    figure.label(b[0] + 8, b[1] - 8, "P01", colour=RED)
