"""Figures of S: how a head is unrolled, what one vertex does on two faces, and the control net."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.cast import Cast
from omote.model.controls.control_net import ControlNet
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import woven
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.skin_sheet import unwrapped
from omote.model.transfer.paper_map import compile_expression, slide, wear
from tools.figures.svg import AMBER, BLUE, GREEN, GREY, INK, RED, VIOLET, Figure
from tools.figures.view import COOL, INNER, MARK, MEMBRANE, SKIN, Eye, Surface, painted, picture

Values = NDArray[np.float64]
Box = tuple[float, float, float, float]

TEACHER, LEARNER, SMILE = "kaori", "old", "mouthSmileLeft"


class Unrolled:
    """S, or a window of it, in a box of a figure: theta to the right, h upward, one scale for both."""

    def __init__(self, space: ParameterSpace, box: Box, *, middle: tuple[float, float] | None = None,
                 width: float | None = None) -> None:  # fmt: skip
        self.space, self.box = space, box
        self.metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
        h = space.h[space.on_sheet]
        self._middle = middle or (0.0, float(h.min() + h.max()) / 2)
        self._scale = box[2] / (width or 2 * np.pi * self.metric)

    def at(self, theta: Values | float, h: Values | float) -> Values:
        """Where points of S lie in the figure: (..., 2)."""
        x = self.box[0] + self.box[2] / 2 + (np.asarray(theta) - self._middle[0]) * self.metric * self._scale
        y = self.box[1] + self.box[3] / 2 - (np.asarray(h) - self._middle[1]) * self._scale
        return np.stack([x, y], axis=-1)

    def corners(self, triangles: NDArray[np.int32]) -> Values:
        """Triangles (t, 3) of S in the figure: (t, 3, 3), none torn at the seam."""
        flat = self.at(unwrapped(self.space.theta, triangles), self.space.h[triangles])
        return np.concatenate([flat, np.zeros((*flat.shape[:2], 1))], axis=2)

    def picture(self, materials: NDArray[np.integer]) -> str:
        """Sheet and membranes with the material of each triangle (l,), lit as the head's slopes lie."""
        corners = self.corners(self.space.location_triangles)
        turn = np.array([2 * np.pi * self.metric * self._scale, 0.0, 0.0])
        light = self._light()[self.space.location_triangles]
        light[len(self.space.skin_triangles) :] = 0.9
        light = np.tile(light, (3, 1))
        return painted(
            self.box, np.concatenate([corners - turn, corners, corners + turn]), light, np.tile(materials, 3)
        )

    def _light(self) -> Values:
        space = self.space
        slope = mesh.normals(space.points, space.triangles)
        away = np.stack([np.sin(space.theta), np.zeros(len(space.theta)), np.cos(space.theta)], axis=1)
        result: Values = 0.3 + 0.7 * np.clip((slope * (0.8 * away + [0.0, 0.45, 0.0])).sum(axis=1), 0.0, 1.0)
        return result


def draw_space(cast: Cast) -> Figure:
    """The generic head and its S: sheet, membranes, boundary loops, lines of lids and lips."""
    space = cast.space
    figure = Figure(960, 604, "The generic head, and its skin sheet unrolled into the parameter space S")
    plane = (286.0, 44.0, 658.0, 316.0)
    _head(figure, space, (16.0, 44.0, 254.0, 316.0))
    _unrolled(figure, Unrolled(space, plane))
    _turns(figure, Unrolled(space, plane))
    for number, (words, theta, h, width) in enumerate(_INSETS):
        box = (16.0 + 312 * number, 396.0, 304.0, 150.0)
        _unrolled(figure, Unrolled(space, box, middle=(np.deg2rad(theta), h), width=width))
        figure.text(box[0], box[1] - 10, words, colour=INK)
    figure.text(16, 28, "the generic head M0 on its axis", colour=INK)
    figure.text(286, 28, "S: the skin sheet over (theta, h), membranes amber", colour=INK)
    figure.legend(16, 570, [("skin sheet", "#d6c4b6"), ("inner skin", "#8296b8"), ("membranes, for location only", AMBER),
                            ("lines of lids and lips", GREEN)])  # fmt: skip
    figure.legend(16, 592, [("holes of eyes and mouth", RED), ("other holes", BLUE),
                            ("neck and crown, open, once around the axis", VIOLET)])  # fmt: skip
    return figure


_INSETS = (
    ("the left eye: a membrane like a ladder", 16.5, 0.0, 0.045),
    ("the mouth, nearly closed: a slit", 0.0, -0.068, 0.064),
    ("the left ear: what lies behind it is inner skin", 69.0, -0.012, 0.14),
)


def _unrolled(figure: Figure, flat: Unrolled) -> None:
    """S with its membranes, boundary loops and lines."""
    space = flat.space
    figure.rect(*flat.box)
    figure.add(flat.picture(_sheet_or_membrane(space)))
    for loop in mesh.boundary_loops(space.sheet_triangles, _plane(space, flat), period=2 * np.pi * flat.metric):
        _path(figure, flat, space.theta[loop], space.h[loop], _LOOPS[_named(space, loop)])
    for line in space.lines:
        _path(figure, flat, space.theta[line.loop], space.h[line.loop], GREEN, width=1.4)


_LOOPS = {"face": RED, "other": BLUE, "rim": VIOLET}


def _plane(space: ParameterSpace, flat: Unrolled) -> Values:
    return np.stack([space.theta * flat.metric, space.h], axis=1)


def _named(space: ParameterSpace, loop: NDArray[np.int32]) -> str:
    if abs(wrap(np.diff(space.theta[[*loop, loop[0]]])).sum()) > np.pi:
        return "rim"
    inside = any(np.isin(_neighbourhood(space, line), loop).any() for line in space.lines)
    return "face" if inside else "other"


def _neighbourhood(space: ParameterSpace, line: Line) -> NDArray[np.int32]:
    """The vertices of the membrane that a line goes around, and those of the line."""
    labels = mesh.components(space.membranes, space.vertex_count)[space.membranes[:, 0]]
    touching = np.isin(space.membranes, line.loop).any(axis=1)
    return np.unique(space.membranes[np.isin(labels, labels[touching])])


def _head(figure: Figure, space: ParameterSpace, box: Box) -> None:
    sheet = {tuple(row) for row in space.skin_triangles.tolist()}
    material = np.array([SKIN if tuple(row) in sheet else INNER for row in space.triangles.tolist()])
    eye = Eye((0.0, -0.005, 0.03), 0.27, yaw=32.0, pitch=8.0)
    figure.rect(*box)
    figure.add(picture(eye, box, [Surface(space.points, space.triangles, material)]))
    axis = np.array([[space.cylinder.x, h, space.cylinder.z] for h in (-0.17, 0.15)])
    figure.line(eye.seen(axis, box)[:, :2], AMBER, width=2, dash="7 4")
    ring = np.linspace(-np.pi, np.pi, 73)
    low = space.cylinder.roll(ring, np.full(73, -0.135), np.full(73, 0.1))
    figure.line(eye.seen(low, box)[:, :2], AMBER, width=1.2, dash="3 3")
    ahead = eye.seen(space.cylinder.roll(np.zeros(2), np.full(2, -0.135), np.array([0.0, 0.1])), box)[:, :2]
    figure.line(ahead, AMBER, width=1.5, arrow=True)
    figure.label(ahead[1, 0] + 4, ahead[1, 1] + 14, "theta = 0", colour=AMBER)
    figure.label(box[0] + 8, box[1] + 20, "axis: h = y, r from it", colour=AMBER)


def _sheet_or_membrane(space: ParameterSpace) -> NDArray[np.int64]:
    return np.where(np.arange(len(space.location_triangles)) < len(space.skin_triangles), SKIN, MEMBRANE)


def _path(figure: Figure, flat: Unrolled, theta: Values, h: Values, colour: str, width: float = 2.2) -> None:
    """A closed way on S, drawn as often as the seam cuts it."""
    around = theta[0] + np.concatenate([[0.0], np.cumsum(wrap(np.diff(theta)))])
    goes_around = abs(float(wrap(theta[0] - theta[-1])) - (theta[0] - around[-1] + 0.0)) > np.pi
    for turn in (-2 * np.pi, 0.0, 2 * np.pi):
        for run in _within(flat, flat.at(around + turn, h)):
            whole = len(run) == len(theta) and not goes_around
            figure.line(run, colour, width=width, closed=whole)


def _within(flat: Unrolled, places: Values) -> list[Values]:
    """The runs of a way that lie in the box."""
    left, top, width, height = flat.box
    x, y = places.T
    inside = (x >= left) & (x <= left + width) & (y >= top) & (y <= top + height)
    starts = np.flatnonzero(np.diff(inside.astype(np.int8)) != 0) + 1
    return [run for run, kept in zip(np.split(places, starts), np.split(inside, starts), strict=True) if kept[0]]


def _turns(figure: Figure, flat: Unrolled) -> None:
    bottom = flat.box[1] + flat.box[3]
    for degrees in (-180, -90, 0, 90, 180):
        x = float(flat.at(np.deg2rad(degrees), 0.0)[0])
        anchor = {-180: "start", 180: "end"}.get(degrees, "middle")
        figure.label(x + {-180: 4, 180: -4}.get(degrees, 0), bottom - 6, f"{degrees}°", anchor=anchor)


# ---- one vertex on two faces


def draw_transfer(cast: Cast) -> Figure:
    """Extract on one face, apply on another: the same triangle, the same weights (paper, section 2.2)."""
    space = cast.space.under("paper")
    vertex, moved = _corner(cast)
    figure = Figure(960, 372, "One vertex: extracted on one face, applied on another")
    boxes = [(16.0 + 316 * n, 60.0, 300.0, 270.0) for n in range(3)]
    teacher, learner = cast.faces[TEACHER], cast.faces[LEARNER]
    landing = slide(space, teacher.positions.astype(np.float64), moved[None], np.array([vertex], np.int32))
    triangle, weights = int(landing.triangles[0]), landing.weights[0]
    _on_face(figure, boxes[0], space, teacher, (vertex, triangle), weights, moved, "1")
    _on_s(figure, boxes[1], space, (vertex, triangle), weights)
    _on_face(figure, boxes[2], space, learner, (vertex, triangle), weights, _applied(cast, vertex), "2")
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


def _applied(cast: Cast, vertex: int) -> Values:
    return _worn(cast, LEARNER)[vertex]


def _worn(cast: Cast, face: str) -> Values:
    old = cast.under("paper")
    compiled = compile_expression(old.space, old.expressions[SMILE])
    return wear(old.space, fit(old.space, old.faces[face]), compiled).astype(np.float64)


def _on_face(
    figure: Figure, box: Box, space: ParameterSpace, face: Face, where: tuple[int, int], weights: Values, goal: Values,
    name: str,
) -> None:  # fmt: skip
    vertex, triangle = where
    points = face.positions.astype(np.float64)
    corners = space.location_triangles[triangle]
    start, on_skin = points[vertex], weights @ points[corners]
    eye = Eye(tuple((start + goal) / 2), 0.032, yaw=68.0, pitch=14.0)  # type: ignore[arg-type]
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
        figure.dot(*place, colour)
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
    material = _sheet_or_membrane(space)
    material[triangle] = MARK
    figure.add(flat.picture(material))
    a, b = flat.at(space.theta[vertex], space.h[vertex]), flat.at(theta, h)
    figure.line([tuple(a), (b[0], a[1])], GREY, width=1.2, dash="4 3")
    figure.line([(b[0], a[1]), tuple(b)], GREY, width=1.2, dash="4 3")
    figure.line([tuple(a), tuple(b)], RED, width=2, arrow=True)
    figure.dot(*a, BLUE)
    figure.dot(*b, RED)
    figure.label((a[0] + b[0]) / 2, a[1] + 18, "dtheta", colour=INK, anchor="middle")
    figure.label(b[0] + 8, (a[1] + b[1]) / 2, "dh", colour=INK)
    figure.label(a[0] - 8, a[1] + 18, "P0", colour=BLUE, anchor="end")
    figure.label(b[0] + 8, b[1] - 8, "P01", colour=RED)


# ---- the control net


def draw_net(cast: Cast) -> Figure:
    """The default control net on S, and how far one of its points reaches, there and on two faces."""
    space = cast.space
    weave = woven(space, default_net(space))
    net = weave.net
    point = _smiling_point(net, space)
    share = np.asarray(net.basis[:, point].toarray()).ravel()
    figure = Figure(960, 400, "The control net on S, and the influence of one control point")
    plane, faces = (16.0, 44.0, 560.0, 316.0), [(592.0 + 180 * n, 44.0, 172.0, 316.0) for n in range(2)]
    flat = Unrolled(space, plane, width=0.46)
    figure.rect(*plane)
    figure.add(flat.picture(_influenced(space, share, space.location_triangles)))
    _net(figure, flat, net, point)
    for box, name in zip(faces, ("kaori", "dog"), strict=True):
        _needles(figure, box, cast, name, net, point, share)
    figure.text(16, 28, f"S: {net.own} control points, joined by a Delaunay net", colour=INK)
    figure.text(592, 28, "the same points on two faces", colour=INK)
    figure.legend(16, 386, [("control point", INK), ("still ring at neck and crown", VIOLET), ("one point", AMBER),
                            ("what it moves: all triangles around it", "#6ea8e0")])  # fmt: skip
    return figure


def _smiling_point(net: ControlNet, space: ParameterSpace) -> int:
    """The point nearest to the left corner of the mouth, beside it on the cheek."""
    goal = np.array([np.deg2rad(30.0), -0.055])
    away = np.hypot((net.theta[: net.own] - goal[0]) * 0.1, net.h[: net.own] - goal[1])
    return int(away.argmin())


def _influenced(space: ParameterSpace, share: Values, triangles: NDArray[np.int32]) -> NDArray[np.int64]:
    moved = share[triangles].mean(axis=1) > 0.02
    plain = np.where(np.arange(len(triangles)) < len(space.skin_triangles), SKIN, MEMBRANE)
    return np.where(moved, COOL, plain)


def _net(figure: Figure, flat: Unrolled, net: ControlNet, point: int) -> None:
    for triangle in net.triangles:
        theta = unwrapped(net.theta, triangle[None])[0]
        places = flat.at(theta, net.h[triangle])
        inside = (places[:, 0] > flat.box[0]) & (places[:, 0] < flat.box[0] + flat.box[2])
        inside &= (places[:, 1] > flat.box[1]) & (places[:, 1] < flat.box[1] + flat.box[3])
        if inside.all():
            bold = point in triangle
            figure.line(places, AMBER if bold else "#0d0f12", width=1.6 if bold else 0.8, closed=True)
    for row, place in enumerate(flat.at(net.theta, net.h)):
        if flat.box[0] < place[0] < flat.box[0] + flat.box[2]:
            colour = AMBER if row == point else INK if row < net.own else VIOLET
            figure.dot(place[0], place[1], colour, radius=5 if row == point else 3)


def _needles(
    figure: Figure, box: Box, cast: Cast, name: str, net: ControlNet, point: int, share: Values
) -> None:  # fmt: skip
    space, face = cast.space, cast.faces[name]
    points = face.positions.astype(np.float64)
    middle = (points[space.on_sheet].min(axis=0) + points[space.on_sheet].max(axis=0)) / 2
    eye = Eye((float(middle[0]), -0.02, float(middle[2])), 0.2 if name == "kaori" else 0.235, yaw=24.0, pitch=2.0)
    shown = space.location_triangles[: len(space.skin_triangles)]
    figure.rect(*box)
    moved = np.where(share[shown].mean(axis=1) > 0.02, COOL, SKIN)
    figure.add(picture(eye, box, [Surface(points, shown, moved)], edges=False))
    roots = net.points_on(face)
    out = roots - [space.cylinder.x, 0.0, space.cylinder.z]
    out[:, 1] = 0.0
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    for row in np.flatnonzero(out @ eye.ahead() > 0.25):
        ends = eye.seen(np.stack([roots[row], roots[row] + 0.011 * out[row]]), box)[:, :2]
        figure.line(ends, AMBER if row == point else INK, width=2.4 if row == point else 1.2)
    figure.dot(*eye.seen(roots[point][None], box)[0, :2], AMBER, radius=5)
    figure.label(box[0] + 8, box[1] + 20, name)
