"""The figure of the editor's solve: how a dragged point comes to its target."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.controls.default_net import default_net
from omote.model.controls.inverse_solve import CLOSE, _Drag, _solve_broyden
from omote.model.controls.net_field import NetField, build_net_field
from tools.pictures.method.svg import AMBER, BLUE, GREEN, GREY, INK, VIOLET, Chart, Figure

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Watched(_Drag):
    """A drag that remembers how far each compound left the worst point from its target, metres."""

    goal: Values = field(default_factory=lambda: np.zeros((1, 3)))
    misses: list[float] = field(default_factory=list)

    def positions_at(self, places: Values) -> Values:
        """Where the points lie, as the solve asks for it; written down."""
        found = super().positions_at(places)
        self.misses.append(float(np.linalg.norm(found - self.goal, axis=1).max()))
        return found


def solving(cast: Cast, face: str, point: int, net_field: NetField, way: Values) -> list[float]:
    """How far a dragged point is from its target after each compound of a solve, metres."""
    space = cast.space
    rest = np.tile([0.0, 0.0, 1.0], (len(net_field.rows), 1))
    drag = _Watched(space, cast.faces[face], cast.expressions["smile"], net_field, rest, np.array([point]))
    goal = drag.positions_at(drag.places()) + way
    watched = replace(drag, goal=goal, misses=[])
    _solve_broyden(watched, goal)
    return watched.misses


DRAGGED = {"kaori": BLUE, "old": AMBER, "doll": VIOLET, "dog": GREEN}


def draw_solve(cast: Cast) -> Figure:
    """How the editor's solve comes to its target on four faces, compound by compound."""
    net_field = build_net_field(cast.space, default_net(cast.space))
    goals = _drags(cast, net_field)
    figure = Figure(960, 330, "The editor's solve: distance to the target over compounds")
    for column, (words, point, way) in enumerate(goals):
        chart = Chart(figure, (64.0 + 308 * column, 48.0, 262.0, 216.0), x=(1, 8), y=(-2.5, 1.2))
        chart.ticks_x(range(1, 9))
        chart.ticks_y((-2, -1, 0, 1), form="log")
        for face, colour in DRAGGED.items():
            misses = solving(cast, face, point, net_field, way)[:8]
            heights = np.log10(np.maximum(1000 * np.array(misses), 10**-2.5))
            chart.curve(range(1, len(misses) + 1), heights, colour)
            figure.dot(chart.at(len(misses), heights[-1]), colour, radius=3.5)
        chart.curve((1, 8), (np.log10(1000 * CLOSE),) * 2, GREY, width=1.2, dash="4 3")
        figure.text(64 + 308 * column, 32, words, colour=INK)
    figure.text(64, 300, "compounds computed", size=12)
    figure.text(222, 300, "upwards: distance to the target, mm", size=12)
    figure.legend(480, 300, [*DRAGGED.items(), (f"content: {1000 * CLOSE:g} mm", GREY)])
    return figure


def _drags(cast: Cast, net_field: NetField) -> list[tuple[str, int, Values]]:
    """Three drags: a corner of the mouth, an upper lid and the lower lip; the point of the net and the way, metres."""
    points = cast.space.points[list(net_field.rows)]
    places = (("a corner of the mouth, 14 mm up and out", (0.025, -0.068, 0.141), (0.01, 0.0095, -0.002)),
              ("an upper lid, 9 mm down", (0.031, 0.005, 0.141), (0.0, -0.009, 0.0)),
              ("the lower lip, 12 mm down", (0.0, -0.073, 0.156), (0.0, -0.012, 0.0)))  # fmt: skip
    found = []
    for words, where, way in places:
        found.append((words, int(np.linalg.norm(points - where, axis=1).argmin()), np.array([way])))
    return found
