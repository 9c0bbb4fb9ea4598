"""How long a table of 33 pictures at 400x450 takes, beside the way of before (issue 10).

* Before: the pages of the last commit with shadows on hair per pixel, one sheet drawn on one page (`omote grid` then).
* Now: `omote grid`, each picture into a file of its own with a sidecar, then the table; by one browser, and by two.
* A browser for each picture: a page and a full settle for every one, as `omote render` in a loop; from one of them.

Each table with a fresh cast, by turns in one run, from the cast until the file is written; the least of the rounds.
Seconds, and seconds of the processors (of this process and all below it), which other programs change less.
`--runs N` for other than one round, `--table N` for one of the tables.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Self

from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.beauty import build_pages
from omote.interchange.formats.atomic_file import write_whole
from omote.server.headless.chromium import find_chromium, open_chromium
from omote.server.headless.picture_renderer import OPENED, open_picture_page, serve_pages
from omote.server.headless.picture_run import PictureStudio, draw_run
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import Page
from omote.stage_data.picture_grid import lay_out
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
ALONE = "a browser for each"
PICTURES = 33
TICKS = os.sysconf("SC_CLK_TCK")


def draw_before(pages: dict[str, Page], request: GridRequest, path: Path) -> None:
    """Draws a table as before: one sheet, one page, one file at the end."""
    documents = built_in_documents()
    setting = request.setting
    sheet = lay_out(request, documents.cast).on_paper(setting, "image/png")

    async def run() -> bytes:
        async with serve_pages(documents, pages) as address, open_chromium(find_chromium()) as tools:
            page = await open_picture_page(tools, address, setting, ready=OPENED)
            return (await page.draw(sheet)).data

    write_whole(path, asyncio.run(run()))


def draw_now(request: GridRequest, path: Path, jobs: int) -> None:
    """Draws a table as `omote grid` does."""
    studio = PictureStudio()
    draw_run(studio, studio.plan(request, path, fresh=True), lambda _: None, jobs=jobs)


def draw_one_by_one(pages: dict[str, Page], request: GridRequest, path: Path) -> None:
    """Draws one picture in a browser of its own."""
    draw_before(pages, GridRequest(faces="kaori=0.5+man=0.5", expressions="smile", size=request.size), path)


class ProcessorTime:
    """Counts the processors' seconds of this process and all below it while it is open; Linux only, else 0.

    What the counting itself takes is left out: it lasts as long as the work waits for a processor.
    """

    def __enter__(self) -> Self:
        self._spent: dict[int, float] = {}
        self._first = self._look()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
        self.seconds = self._look() - self._first - self._counting

    def _watch(self) -> None:
        while not self._ended.wait(0.1):
            self._look()
        self._counting = time.thread_time()

    def _look(self) -> float:
        """Processes that have ended count as they were last seen."""
        parents = dict[int, int]()
        spent = dict[int, float]()
        for stat in Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                words = stat.read_text().rpartition(")")[2].split()
                number = int(stat.parent.name)
                parents[number] = int(words[1])
                spent[number] = (int(words[11]) + int(words[12])) / TICKS
        for number in spent:
            above = number
            while above in parents and above != os.getpid():
                above = parents[above]
            if above == os.getpid():
                self._spent[number] = spent[number]
        return sum(self._spent.values())


def spend(work: Callable[[], None]) -> tuple[float, float]:
    """How long something takes, and the processors' time."""
    began = time.perf_counter()
    with ProcessorTime() as processors:
        work()
    return time.perf_counter() - began, processors.seconds


def measure(pages: dict[str, Page], request: GridRequest, folder: Path, runs: int) -> dict[str, tuple[float, float]]:
    """Seconds and processors' seconds for a table in every way, the least of the rounds."""
    path = folder / "table.png"
    ways: dict[str, Callable[[], None]] = {
        "before": lambda: draw_before(pages, request, path),
        "now": lambda: draw_now(request, path, 1),
        "now, two browsers": lambda: draw_now(request, path, 2),
        ALONE: lambda: draw_one_by_one(pages, request, path),
    }
    rounds = [{name: spend(way) for name, way in ways.items()} for _ in range(runs)]
    least = {name: (min(found[name][0] for found in rounds), min(found[name][1] for found in rounds)) for name in ways}
    return least | {ALONE: (PICTURES * least[ALONE][0], PICTURES * least[ALONE][1])}


def rows(found: Mapping[str, tuple[float, float]]) -> Iterator[tuple[str, ...]]:
    """Each way with its figures and their ratios to the way of before."""
    for way, values in found.items():
        ratios = (value / former for value, former in zip(values, found["before"], strict=True))
        yield way, *(text for pair in zip(values, ratios, strict=True) for text in (f"{pair[0]:.1f}", f"{pair[1]:.2f}"))


def main() -> int:
    """Measures and prints; the exit status says whether one browser keeps the bar in seconds of the processors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--table", type=int, choices=range(len(TABLES)))
    chosen = parser.parse_args()
    table = Table("table", "way", "seconds", "/ before", "processors", "/ before", box=None)
    worst = 0.0
    with tempfile.TemporaryDirectory() as name:
        pages = build_pages(BEFORE, Path(name))
        if pages is None:
            print(f"git has no commit {BEFORE} here: nothing to compare with")
            return 0
        for number, (title, request) in enumerate(TABLES.items()):
            if chosen.table in (None, number):
                found = measure(pages, request, Path(name), chosen.runs)
                worst = max(worst, found["now"][1] / found["before"][1])
                for row in rows(found):
                    table.add_row(title, *row)
    Console(width=120).print(table)
    print(f"{'holds' if worst <= MOST else 'MISSED'}: {worst:.2f} of the processors' time before, {MOST:g} at most")
    return int(worst > MOST)


if __name__ == "__main__":
    sys.exit(main())
