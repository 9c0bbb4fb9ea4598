"""Figures of the mix: the four compounds of eq. 3, and weights through interrupted calls."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.perform.axis import Axis, advanced, called, rates, weights
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.easing import DECAY_SECONDS, DEFAULT_EASING, bump
from omote.perform.frame import Frame
from tools.pictures.method.smooth_map import part_surfaces
from tools.pictures.method.svg import AMBER, BLUE, GREEN, GREY, INK, RED, VIOLET, Chart, Figure
from tools.pictures.method.view import INNER, SKIN, Eye, Surface, picture

Values = NDArray[np.float64]

# ---- eq. 3


FACES = ("kaori", "dog")
EXPRESSIONS = ("neutral", "joy")
SHARES = (0.0, 0.5, 1.0)


def draw_grid(cast: Cast) -> Figure:
    """The four compounds of two faces and two expressions, and what lies between them."""
    figure = Figure(960, 572, "Eq. 3: four compounds and their weighted mean")
    material = np.where(cast.space.on_sheet[cast.space.triangles].all(axis=1), SKIN, INNER)
    eye = Eye((0.0, -0.015, 0.03), 0.3, yaw=18.0, pitch=3.0)
    for column, s in enumerate(SHARES):
        for row, t in enumerate(SHARES):
            box = (150.0 + 186 * column, 20.0 + 172 * row, 180.0, 166.0)
            frame = Frame(_two(FACES, s), _two(EXPRESSIONS, t))
            parts = evaluate_parts(cast, frame)
            figure.rect(*box)
            skin = Surface(evaluate(cast, frame), cast.space.triangles, material)
            figure.add(picture(eye, box, [skin, *part_surfaces(cast.space, parts)], edges=False))
            name = _NAMES.get((s, t), "")
            figure.label(box[0] + 8, box[1] + 20, name, colour=AMBER)
    _grid_words(figure)
    return figure


def _grid_words(figure: Figure) -> None:
    for number, (face, expression) in enumerate(zip(FACES, EXPRESSIONS, strict=True)):
        figure.text(240 + 372 * number, 562, f"face {number + 1}: {face}", colour=INK, anchor="middle")
        words = f"expression {number + 1}: {expression}"
        figure.text(140, 106 + 344 * number, words, colour=INK, anchor="end", size=12)
    for share in SHARES:
        figure.text(240 + 372 * share, 546, f"s2 = {share:g}", anchor="middle", size=12)
        figure.text(140, 122 + 344 * share, f"t2 = {share:g}", anchor="end", size=12)
    for number, (line, colour) in enumerate(_FORMULA):
        figure.text(724, 40 + 22 * number, line, colour=colour)


_NAMES = {(0.0, 0.0): "P11", (1.0, 0.0): "P21", (0.0, 1.0): "P12", (1.0, 1.0): "P22", (0.5, 0.5): "P"}
_FORMULA = (
    ("Four compounds are made once:", INK),
    ("Pij = face i wearing expression j.", GREY),
    ("", INK),
    ("Every frame in between is (eq. 3)", INK),
    ("P = s1 (t1 P11 + t2 P12)", AMBER),
    ("  + s2 (t1 P21 + t2 P22),", AMBER),
    ("s1 + s2 = t1 + t2 = 1.", AMBER),
    ("", INK),
    ("A call brings a third face or", INK),
    ("expression in from anywhere on", INK),
    ("this square, without a jump.", INK),
)


def _two(names: Sequence[str], share: float) -> dict[str, float]:
    return {name: weight for name, weight in zip(names, (1.0 - share, share), strict=True) if weight}


# ---- interrupted calls

CALLS = ((0.2, "old", 1.6), (0.85, "child", 1.2), (1.5, "dog", 1.4))
NAMES = {"generic": BLUE, "old": AMBER, "child": VIOLET, "dog": GREEN}
RATE = 240
LENGTH = 3.2


@dataclass(frozen=True, eq=False)
class Log:
    """Weights and rates (n, names) over the seconds (n,) of a log of calls."""

    times: Values
    weights: Values
    rates: Values

    @property
    def speed(self) -> Values:
        """Half the sum of absolute rates, per second: how fast the mix moves."""
        result: Values = 0.5 * np.abs(self.rates).sum(axis=1)
        return result


def played(*, inertial: bool) -> Log:
    """The log of CALLS on one axis; not inertial: a call forgets the velocity, as in the paper."""
    axis = Axis("generic")
    waiting = list(CALLS)
    times = np.arange(int(LENGTH * RATE)) / RATE
    found_weights = []
    found_rates = []
    for time in times:
        if waiting and time >= waiting[0][0]:
            _, name, seconds = waiting.pop(0)
            axis = called(axis, name, seconds, DEFAULT_EASING)
            if not inertial and axis.call is not None:
                axis = replace(axis, call=replace(axis.call, velocity={}, decay=0.0))
        found_weights.append([weights(axis).get(name, 0.0) for name in NAMES])
        found_rates.append([rates(axis).get(name, 0.0) for name in NAMES])
        axis = advanced(axis, 1 / RATE)
    return Log(times, np.array(found_weights), np.array(found_rates))


def draw_calls(cast: Cast) -> Figure:
    """Weights through interrupted calls, frozen and with their velocity taken over; their speeds; the quintic."""
    del cast  # weights need no face
    figure = Figure(960, 452, "Weights through interrupted calls")
    for column, (words, inertial) in enumerate(_WAYS):
        log = played(inertial=inertial)
        chart = Chart(figure, (48.0 + 322 * column, 44.0, 292.0, 186.0), x=(0.0, LENGTH), y=(-0.1, 1.1))
        chart.ticks_x((0, 1, 2, 3), unit=" s")
        chart.ticks_y((0.0, 0.5, 1.0))
        for number, colour in enumerate(NAMES.values()):
            chart.curve(log.times, log.weights[:, number], colour)
        figure.text(48 + 322 * column, 30, words, colour=INK)
        _marks(chart, (-0.1, 1.1))
    _speeds(figure)
    figure.legend(48, 440, [*NAMES.items(), ("a call", GREY)])
    _quintic(figure)
    return figure


_WAYS = (("as in the paper: a call freezes the blend", False), ("here: and takes its velocity over", True))


def _speeds(figure: Figure) -> None:
    speed = Chart(figure, (48.0, 274.0, 614.0, 126.0), x=(0.0, LENGTH), y=(0.0, 2.0))
    speed.ticks_x((0, 1, 2, 3), unit=" s")
    speed.ticks_y((0, 1, 2))
    _marks(speed, (0.0, 2.0))
    for inertial, colour in ((False, RED), (True, GREEN)):
        log = played(inertial=inertial)
        speed.curve(log.times, log.speed, colour)
    figure.text(48, 262, "how fast the mix moves, per second", colour=INK)
    figure.legend(330, 262, [("frozen: stops dead", RED), ("taken over: no break", GREEN)])


def _marks(chart: Chart, height: tuple[float, float]) -> None:
    for time, _, _ in CALLS:
        chart.curve((time, time), height, GREY, width=1.0, dash="4 3")


def _quintic(figure: Figure) -> None:
    chart = Chart(figure, (720.0, 44.0, 212.0, 186.0), x=(0.0, 1.0), y=(0.0, 0.2))
    chart.ticks_x((0.0, 0.5, 1.0))
    chart.ticks_y((0.0, 0.1, 0.2))
    share = np.linspace(0.0, 1.0, 101)
    chart.curve(share, [bump(u) for u in share], GREEN)
    figure.text(720, 30, "the quintic B(u), slope 1 at 0", colour=INK)
    words = ("B(u) = u (1 - u)³ (1 + 3u)", "", "weight = (1 - y) start + y target",
             "… + velocity · d · B(t / d)", "", "d: one time for the whole axis,",
             f"at most {DECAY_SECONDS:g} s, short enough that", "no weight leaves -0.1 ... 1.1")  # fmt: skip
    for number, line in enumerate(words):
        figure.text(720, 284 + 18 * number, line, colour=AMBER if number in (0, 2, 3) else GREY, size=12.5)
