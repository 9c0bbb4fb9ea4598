"""Draws sheets of the cast into docs/pictures, by the stage's own page as `omote render` does."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from omote.interchange.formats.atomic_file import write_whole
from omote.model.cast import Cast
from omote.server.headless.chromium import open_chromium
from omote.server.headless.picture_renderer import open_picture_page, serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Setting
from omote.stage_data.pose_parser import parse_pose, pose_of
from tools.browser import SENTENCE, find_browser

PICTURES = Path(__file__).resolve().parents[2] / "docs" / "pictures"

Words = dict[str, str]
"""A pose as `omote render` takes it: face, expression, channel, turn, gaze, light, pose."""


@dataclass(frozen=True)
class Picture:
    """A sheet in its setting; the name of its file, without `.jpg`, and the folder of that."""

    name: str
    sheet: PictureGrid
    setting: Setting
    folder: Path = PICTURES


def grid_of(cast: Cast, rows: Sequence[tuple[str, Sequence[tuple[str, Words]]]]) -> PictureGrid:
    """Rows of (name, pictures), each picture a caption and the words of its pose."""
    return PictureGrid(
        [[pose_of(cast, parse_pose(cast, **words)) for _, words in row] for _, row in rows],
        rows=[name for name, _ in rows],
        captions=[[caption for caption, _ in row] for _, row in rows],
        paper="#000",
        kind="image/jpeg",
    )


def draw_wanted(pictures: Sequence[Picture], names: Sequence[str]) -> int:
    """Draws the pictures, or those of the names given; the exit status."""
    wanted = [picture for picture in pictures if picture.name in names or not names]
    browser = find_browser()
    if not wanted or browser is None:
        print(SENTENCE if wanted else f"expected some of {', '.join(picture.name for picture in pictures)}")
        return 1
    asyncio.run(_draw(wanted, browser))
    return 0


async def _draw(pictures: Sequence[Picture], browser: Path) -> None:
    """Draws the pictures into their files, one after the other."""
    async with serve_pages(built_in_documents(), read_pages()) as address, open_chromium(browser) as tools:
        for picture in pictures:
            page = await open_picture_page(tools, address, picture.setting)
            target = picture.folder / f"{picture.name}.jpg"
            write_whole(target, (await page.draw(picture.sheet)).data)
            await page.close()
            print(f"{target.name}: {target.stat().st_size // 1000} kB", file=sys.stderr, flush=True)
