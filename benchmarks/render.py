"""How long a table of 33 pictures at 400x450 takes, beside the way of before (issue 10).

* Before: the pages of the last commit with shadows on hair per pixel, one sheet drawn on one page (`omote grid` then).
* Now: `omote grid`'s own run, each picture into a file of its own with a sidecar, then the table; with one browser, and two.
* A browser for each picture: a page and a full settle for every one, as `omote render` in a loop; from three of them.

Each table with a fresh cast, by turns in one run, from the start of the browser until the file is written; the least of
the rounds. `--runs N` for other than one round.
"""

from __future__ import annotations

import argparse
import asyncio
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.beauty import pages_of
from omote.interchange.formats.atomic_file import write_whole
from omote.server.headless.chromium import find_chromium, open_chromium
from omote.server.headless.picture_renderer import OPENED, open_picture_page, serve_pages
from omote.server.headless.picture_run import PictureStudio, draw_run
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import Page
from omote.stage_data.picture_request import GridRequest

BEFORE = "1d92172"
"""The last commit that drew tables in the way of before."""
TABLES = {
    "kaori to man, 11 steps by 3 expressions": GridRequest(
        morph="kaori:man:11", expressions="neutral,smile,angry", size="400x450"
    ),
    "kaori, old and dog by 11 expressions": GridRequest(
        faces="kaori,old,dog",
        expressions="neutral,smile,laugh,sad,angry,surprise,disgust,kiss,cry,doubt,joy",
        size="400x450",
    ),
}
MOST = 0.25


def draw_before(pages: dict[str, Page], request: GridRequest, path: Path) -> None:
    """Draws a table as before: one sheet, one page, one file at the end."""
    documents, setting = built_in_documents(), request.setting
    sheet = request.sheet(documents.cast).on_paper(setting, "image/png")

    async def run() -> bytes:
        async with serve_pages(documents, pages) as address, open_chromium(find_chromium()) as tools:
            return await (await open_picture_page(tools, address, setting, ready=OPENED)).draw(sheet)

    write_whole(path, asyncio.run(run()))


def draw_now(request: GridRequest, path: Path, jobs: int) -> None:
    """Draws a table as `omote grid` does."""
    studio = PictureStudio()
    draw_run(studio, studio.plan(request, path, fresh=True), lambda _: None, jobs=jobs)


def draw_one_by_one(pages: dict[str, Page], request: GridRequest, path: Path) -> None:
    """Draws the first picture of the first three rows, each in a browser of its own."""
    documents = built_in_documents()
    poses = [row[0] for row in request.sheet(documents.cast).poses][:3]
    documents.close()
    for pose in poses:
        face, expression = ("+".join(f"{name}={weight}" for name, weight in pose[kind].items()) for kind in KINDS)
        draw_before(pages, GridRequest(faces=face, expressions=expression, size=request.size), path)


KINDS = ("faces", "expressions")


def seconds(work: Callable[[], None]) -> float:
    """How long something takes."""
    began = time.perf_counter()
    work()
    return time.perf_counter() - began


def measure(pages: dict[str, Page], request: GridRequest, folder: Path, runs: int) -> dict[str, float]:
    """Seconds for a table in every way, the least of the rounds."""
    path = folder / "table.png"
    ways: dict[str, Callable[[], float]] = {
        "before": lambda: seconds(lambda: draw_before(pages, request, path)),
        "now": lambda: seconds(lambda: draw_now(request, path, 1)),
        "now, two browsers": lambda: seconds(lambda: draw_now(request, path, 2)),
        "a browser for each": lambda: 11 * seconds(lambda: draw_one_by_one(pages, request, path)),
    }
    rounds = [{name: way() for name, way in ways.items()} for _ in range(runs)]
    return {name: min(found[name] for found in rounds) for name in ways}


def main() -> int:
    """Measures and prints; the exit status says whether the better of one and two browsers keeps the bar."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1)
    runs = parser.parse_args().runs
    table, good = Table("table", "way", "seconds", "/ before", box=None), True
    with tempfile.TemporaryDirectory() as name:
        pages = pages_of(BEFORE, Path(name))
        if pages is None:
            print(f"git has no commit {BEFORE} here: nothing to compare with")
            return 0
        for title, request in TABLES.items():
            found = measure(pages, request, Path(name), runs)
            good = good and min(found["now"], found["now, two browsers"]) <= MOST * found["before"]
            for way, value in found.items():
                table.add_row(title, way, f"{value:.1f}", f"{value / found['before']:.2f}")
    Console(width=120).print(table)
    print(f"{'holds' if good else 'MISSED'}: a table takes at most {MOST:g} of the time before")
    return int(not good)


if __name__ == "__main__":
    sys.exit(main())
