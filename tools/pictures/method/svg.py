"""The sheet of paper of a figure: shapes and words in, one SVG out, the same bytes for the same figure."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

PAPER = "#14161a"
PANEL = "#1c2026"
RULE = "#3a3f48"
INK = "#e4e6eb"
GREY = "#9aa1ad"
GREEN = "#6fc3a8"
RED = "#e8705a"
AMBER = "#e2a23c"
BLUE = "#6ea8e0"
VIOLET = "#b493e0"

Box = tuple[float, float, float, float]
"""Left, top, width and height, in the units of a figure."""
Points = NDArray[np.floating] | Sequence[tuple[float, float]]


class Figure:
    """A dark card that is readable on light and on dark pages."""

    def __init__(self, width: int, height: int, title: str) -> None:
        self._size = width, height
        self._title = title
        self._shapes: list[str] = []

    def add(self, shape: str) -> None:
        """Adds a shape that is written already."""
        self._shapes.append(shape)

    def text(
        self, x: float, y: float, words: str, *, colour: str = GREY, anchor: str = "start", size: float = 13.0,
        weight: str = "normal",
    ) -> None:  # fmt: skip
        """Words, their base line at y."""
        self.add(
            f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size:g}" '
            f'font-weight="{weight}">{escape(words)}</text>'
        )

    def rect(self, x: float, y: float, width: float, height: float, *, fill: str = PANEL, stroke: str = "none") -> None:
        """A box."""
        self.add(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="4" fill="{fill}" '
            f'stroke="{stroke}"/>'
        )

    def line(
        self, points: Points, colour: str, *, width: float = 1.5, dash: str = "", closed: bool = False,
        fill: str = "none", fill_opacity: float = 1.0, arrow: bool = False,
    ) -> None:  # fmt: skip
        """A line through points, closed and filled if wanted, with a head at its end if wanted."""
        places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        tag = "polygon" if closed else "polyline"
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        seen = f' fill-opacity="{fill_opacity:g}"' if fill_opacity < 1.0 else ""
        self.add(
            f'<{tag} points="{places}" fill="{fill}" stroke="{colour}" stroke-width="{width:g}" '
            f'stroke-linejoin="round"{dashes}{seen}/>'
        )
        if arrow:
            self._head(np.asarray(points, np.float64)[-2:], colour, 3.0 + 2.0 * width)

    def dot(self, at: Sequence[float] | NDArray[np.floating], colour: str, *, radius: float = 4.0) -> None:
        """A point with a rim that sets it off."""
        x, y = at
        self.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:g}" fill="{colour}" stroke="{PAPER}"/>')

    def label(self, x: float, y: float, words: str, *, colour: str = INK, anchor: str = "start") -> None:
        """Words with a dark rim, for pictures."""
        self.add(
            f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" stroke="{PAPER}" stroke-width="3.5" paint-order="stroke" '
            f'stroke-linejoin="round" text-anchor="{anchor}" font-size="13" font-weight="bold">{escape(words)}</text>'
        )

    def legend(self, x: float, y: float, entries: Iterable[tuple[str, str]]) -> None:
        """Coloured words beside each other."""
        for words, colour in entries:
            self.line([(x, y - 4), (x + 16, y - 4)], colour, width=3)
            self.text(x + 22, y, words, colour=colour)
            x += 44 + 6.9 * len(words)

    def svg(self) -> str:
        """The file."""
        width, height = self._size
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'font-family="system-ui, sans-serif">',
            f"<title>{escape(self._title)}</title>",
            f'<rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>',
            *self._shapes,
            "</svg>",
            "",
        ])  # fmt: skip

    def _head(self, ends: NDArray[np.float64], colour: str, size: float) -> None:
        way = ends[1] - ends[0]
        way /= max(float(np.hypot(*way)), 1e-9)
        side = np.array([-way[1], way[0]])
        foot = ends[1] - size * way
        self.line([*map(tuple, (ends[1], foot + 0.5 * size * side, foot - 0.5 * size * side))], colour, width=0.5,
                  closed=True, fill=colour)  # fmt: skip


class Chart:
    """A pair of axes inside a figure; draws its frame at once."""

    def __init__(
        self, figure: Figure, box: Box, *, x: tuple[float, float], y: tuple[float, float]
    ) -> None:  # fmt: skip
        self.figure = figure
        self._box = box
        self._x = x
        self._y = y
        figure.rect(*box)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Where a value lies in the figure."""
        left, top, width, height = self._box
        across = (x - self._x[0]) / (self._x[1] - self._x[0])
        up = (y - self._y[0]) / (self._y[1] - self._y[0])
        return left + width * across, top + height * (1.0 - up)

    def curve(
        self, xs: Iterable[float], ys: Iterable[float], colour: str, *, width: float = 2.0, dash: str = ""
    ) -> None:
        """A curve."""
        self.figure.line([self.at(x, y) for x, y in zip(xs, ys, strict=True)], colour, width=width, dash=dash)

    def ticks_x(self, values: Iterable[float], form: str = "g", unit: str = "") -> None:
        """Numbers below."""
        bottom = self._box[1] + self._box[3]
        for value in values:
            x, _ = self.at(value, self._y[0])
            self.figure.line([(x, self._box[1]), (x, bottom)], RULE, width=0.5)
            self.figure.text(x, bottom + 16, f"{value:{form}}{unit}", anchor="middle", size=12)

    def ticks_y(self, values: Iterable[float], form: str = "g", unit: str = "") -> None:
        """Numbers at the left; form "log": powers of ten."""
        for value in values:
            _, y = self.at(self._x[0], value)
            self.figure.line([(self._box[0], y), (self._box[0] + self._box[2], y)], RULE, width=0.5)
            words = f"{10.0**value:g}" if form == "log" else f"{value:{form}}"
            self.figure.text(self._box[0] - 6, y + 4, words + unit, anchor="end", size=12)
