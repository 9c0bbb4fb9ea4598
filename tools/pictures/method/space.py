"""The figure of S: how a head is unrolled, its sheet, membranes, boundary loops and lines."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.cast import Cast
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from tools.pictures.method.svg import AMBER, BLUE, GREEN, INK, PAPER, RED, VIOLET, Box, Figure
from tools.pictures.method.unrolled import Unrolled, sheet_or_membrane
from tools.pictures.method.view import INNER, SKIN, Eye, Surface, picture

Values = NDArray[np.float64]


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
        _unrolled(figure, Unrolled(space, box, middle=(np.deg2rad(theta), h), width=width), near=True)
        figure.text(box[0], box[1] - 10, words, colour=INK)
    figure.text(16, 28, "the generic head M0 on its axis", colour=INK)
    figure.text(286, 28, "S: the skin sheet over (theta, h), membranes amber", colour=INK)
    figure.legend(16, 570, [("skin sheet", "#d6c4b6"), ("inner skin", "#8296b8"),
                            ("membranes, for location only", AMBER), ("lines of lids and lips", GREEN)])  # fmt: skip
    figure.legend(16, 592, [("holes of eyes and mouth", RED), ("other holes", BLUE),
                            ("neck and crown, open, once around the axis", VIOLET)])  # fmt: skip
    return figure


_INSETS = (
    ("the left eye: a membrane like a ladder", 16.5, 0.0, 0.045),
    ("the mouth, nearly closed: a slit", 0.0, -0.068, 0.064),
    ("the left ear: what lies behind it is inner skin", 69.0, -0.012, 0.14),
)


def _unrolled(figure: Figure, flat: Unrolled, *, near: bool = False) -> None:
    """S with its boundary loops and lines; near: with the edges of its membranes."""
    space = flat.space
    figure.rect(*flat.box)
    figure.add(flat.picture(sheet_or_membrane(space)))
    if near:
        _ladder(figure, flat)
    for loop in mesh.boundary_loops(space.sheet_triangles, _plane(space, flat), period=2 * np.pi * flat.metric):
        _path(figure, flat, space.theta[loop], space.h[loop], _LOOPS[_named(space, loop)])
    for line in space.lines:
        _path(figure, flat, space.theta[line.loop], space.h[line.loop], GREEN, width=1.4)


def _ladder(figure: Figure, flat: Unrolled) -> None:
    """The membranes' triangles that lie whole in the box."""
    for corners in flat.corners(flat.space.membranes)[:, :, :2]:
        if len(_within(flat, corners)) == 1 and len(_within(flat, corners)[0]) == 3:
            figure.line(corners, PAPER, width=0.8, closed=True)


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
