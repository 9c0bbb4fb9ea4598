"""Draws the figures of docs/method.md from the code's own numbers.

Usage: python -m tools.pictures.draw_method [NAME ...]. Writes docs/pictures/method-NAME.svg; without names all of them.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import omote
from omote.model.cast import Cast
from tools.pictures.method.control_net import draw_net
from tools.pictures.method.mix import draw_calls, draw_grid
from tools.pictures.method.one_vertex import draw_transfer
from tools.pictures.method.smooth_map import draw_closure, draw_correctives, draw_stages
from tools.pictures.method.solve import draw_solve
from tools.pictures.method.space import draw_space
from tools.pictures.method.svg import Figure

PICTURES = Path(__file__).resolve().parents[2] / "docs" / "pictures"

FIGURES: Mapping[str, Callable[[Cast], Figure]] = {
    "space": draw_space,
    "transfer": draw_transfer,
    "stages": draw_stages,
    "closure": draw_closure,
    "correctives": draw_correctives,
    "grid": draw_grid,
    "calls": draw_calls,
    "net": draw_net,
    "solve": draw_solve,
}


def main(names: list[str]) -> int:
    """Draws the figures named, or all; the exit status."""
    strange = [name for name in names if name not in FIGURES]
    if strange:
        print(f"there is no figure {strange[0]!r}; expected some of {', '.join(FIGURES)}", file=sys.stderr)
        return 2
    cast = omote.load_cast()
    for name in names or FIGURES:
        path = PICTURES / f"method-{name}.svg"
        path.write_text(FIGURES[name](cast).svg(), encoding="utf-8")
        print(f"docs/pictures/{path.name}: {path.stat().st_size / 1000:.0f} kB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
