"""What a picture costs of a renderer that stays open, beside one of `omote grid`, and beside `omote.render` (issue 30).

The same faces by the same expressions, by turns in one run: `omote grid` (its pictures alone, from the first after the
page is open, each with its sidecar), one `omote.Renderer`, and, for one picture, a browser of its own. Of each picture
the least time of the rounds counts; the first of each round, which warms the page, does not.
`--runs N` for other than two rounds, `--expressions N` for fewer pictures, `--size WxH`.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import omote
from omote.server.headless.picture_run import PictureStudio, draw_run
from omote.stage_data.picture_request import GridRequest
from omote.stage_data.picture_setting import read_size

MOST = 1.3
FACES = ("kaori", "old")
EXPRESSIONS = ("neutral", "smile", "joy", "sad", "angry", "surprise", "disgust", "fear")
GRID = "omote grid"
RENDERER = "omote.Renderer"


def time_grid(expressions: tuple[str, ...], size: str) -> list[float]:
    """Seconds of each picture of a table."""
    seconds: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        studio = PictureStudio()
        request = GridRequest(faces=",".join(FACES), expressions=",".join(expressions), size=size)
        run = studio.plan(request, Path(folder) / "grid.png")
        draw_run(studio, run, lambda progress: seconds.append(progress.seconds))
    return seconds


def time_renderer(expressions: tuple[str, ...], size: str) -> list[float]:
    """Seconds of each of the same pictures by one renderer."""
    cast = omote.load_cast()
    frames = [omote.parse_pose(cast, face=face, expression=worn) for face in FACES for worn in expressions]
    seconds = []
    with omote.Renderer(cast, size=read_size(size)) as draw:
        for frame in frames:
            began = time.perf_counter()
            draw(frame)
            seconds.append(time.perf_counter() - began)
    return seconds


def time_alone(size: str) -> float:
    """Seconds of one picture in a browser of its own."""
    cast = omote.load_cast()
    began = time.perf_counter()
    omote.render(cast, omote.parse_pose(cast, face="kaori", expression="smile"), size=read_size(size))
    return time.perf_counter() - began


def main() -> int:
    """Prints the ratios; 0 when the bar is held."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--runs", type=int, default=2)
    parser.add_argument("--expressions", type=int, default=len(EXPRESSIONS))
    parser.add_argument("--size", default="240x270")
    chosen = parser.parse_args()
    worn = EXPRESSIONS[: max(2, chosen.expressions)]
    found: dict[str, list[list[float]]] = {GRID: [], RENDERER: []}
    for number in range(chosen.runs):
        ways = ((GRID, time_grid), (RENDERER, time_renderer))
        for name, measure in ways if number % 2 == 0 else ways[::-1]:
            found[name].append(measure(worn, chosen.size))
    seconds = {name: float(np.min(rounds, axis=0)[1:].mean()) for name, rounds in found.items()}
    seconds["omote.render"] = time_alone(chosen.size)
    table = Table("way", "s a picture", "times a picture of grid")
    for name, each in seconds.items():
        table.add_row(name, f"{each:.2f}", f"{each / seconds[GRID]:.2f}")
    Console(width=100).print(table)
    ratio = seconds[RENDERER] / seconds[GRID]
    print(f"{'holds' if ratio <= MOST else 'MISSED'}: {ratio:.2f} times a picture of grid, {MOST:g} at most")
    return int(ratio > MOST)


if __name__ == "__main__":
    sys.exit(main())
