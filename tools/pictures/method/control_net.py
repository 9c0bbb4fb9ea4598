"""The figure of the control net, and of what one of its points moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.controls.control_net import ControlNet
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import build_net_field
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.skin_sheet import unwrap_corners
from tools.pictures.method.smooth_map import part_surfaces
from tools.pictures.method.svg import AMBER, INK, VIOLET, Box, Figure
from tools.pictures.method.unrolled import Unrolled
from tools.pictures.method.view import COOL, MEMBRANE, SKIN, Eye, Surface, picture

Values = NDArray[np.float64]


def draw_net(cast: Cast) -> Figure:
    """The default control net on S, and how far one of its points reaches, there and on two faces."""
    space = cast.space
    net_field = build_net_field(space, default_net(space))
    net = net_field.net
    point = _cheek_point(net)
    share = np.asarray(net.basis[:, point].toarray()).ravel()
    figure = Figure(960, 400, "The control net on S, and the influence of one control point")
    plane = (16.0, 44.0, 560.0, 316.0)
    faces = [(592.0 + 180 * n, 44.0, 172.0, 316.0) for n in range(2)]
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


def _cheek_point(net: ControlNet) -> int:
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
        theta = unwrap_corners(net.theta, triangle[None])[0]
        places = flat.at(theta, net.h[triangle])
        inside = (places[:, 0] > flat.box[0]) & (places[:, 0] < flat.box[0] + flat.box[2])
        inside &= (places[:, 1] > flat.box[1]) & (places[:, 1] < flat.box[1] + flat.box[3])
        if inside.all():
            bold = point in triangle
            figure.line(places, AMBER if bold else "#0d0f12", width=1.6 if bold else 0.8, closed=True)
    for row, place in enumerate(flat.at(net.theta, net.h)):
        if flat.box[0] < place[0] < flat.box[0] + flat.box[2]:
            colour = AMBER if row == point else INK if row < net.own else VIOLET
            figure.dot(place, colour, radius=5 if row == point else 3)


def _needles(
    figure: Figure, box: Box, cast: Cast, name: str, net: ControlNet, point: int, share: Values
) -> None:  # fmt: skip
    space = cast.space
    face = cast.faces[name]
    points = face.positions.astype(np.float64)
    middle = (points[space.on_sheet].min(axis=0) + points[space.on_sheet].max(axis=0)) / 2
    eye = Eye((float(middle[0]), -0.02, float(middle[2])), 0.2 if name == "kaori" else 0.235, yaw=24.0, pitch=2.0)
    figure.rect(*box)
    moved = np.where(share[space.triangles].mean(axis=1) > 0.02, COOL, SKIN)
    parts = part_surfaces(space, fit(space, face).parts)
    figure.add(picture(eye, box, [Surface(points, space.triangles, moved), *parts], edges=False))
    roots = net.points_on(face)
    out = roots - [space.cylinder.x, 0.0, space.cylinder.z]
    out[:, 1] = 0.0
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    for row in np.flatnonzero(out @ eye.ahead() > 0.25):
        ends = eye.seen(np.stack([roots[row], roots[row] + 0.011 * out[row]]), box)[:, :2]
        figure.line(ends, AMBER if row == point else INK, width=2.4 if row == point else 1.2)
    figure.dot(eye.seen(roots[point][None], box)[0, :2], AMBER, radius=5)
    figure.label(box[0] + 8, box[1] + 20, name)
