"""Hair on a large screen: luminance along mixes, and skin between strands at the temples (issue 33, item 5).

* **Luminance**: the mean of a picture on the way between all pairs of styles, bald among them, as their first wearers
  have them, in their own colours and a theatre's light: nowhere outside of its two ends by more than 3 %, so that
  hair that comes or goes flashes nowhere.
* **Gaps**: pixels of skin with hair close on all sides, at the temples of all people who wear hair, in thousandths of
  the hair's there: none. Hair is dyed green, the light is flat, heads stand straight and turned.

`--levels high` for some levels, `--size 640x360` for other pictures, `--pairs N` for some pairs by chance (`--seed`).
"""

from __future__ import annotations

import argparse
import asyncio
import base64
import sys
from collections.abc import Mapping, Sequence
from itertools import combinations
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from playwright.async_api import Browser, Page, async_playwright
from scipy import ndimage

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.hair import LOOK, OPEN, STUBBLE, dyed, first_wearers, green_of
from benchmarks.stage import CHROMIUM
from omote.builtin import load_cast, load_mask, load_meshes
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http import static_pages
from omote.server.http.cast_documents import CastDocuments
from tools.browser import SENTENCE, find_browser

STEPS = 8
"""Of the way between two faces."""
OUTSIDE = 0.03
"""Of the luminance of an end, that a step may lie beyond it."""
CLOSE = 6
"""Pixels of 1080 rows: skin with hair nearer than this on all sides lies between strands."""
TEMPLES = (0.18, 0.52)
"""Of the height of a head in the picture, from its top."""
TURNS = (0.0, 0.7)
PEOPLE = ("generic", "kaori", "round", "child", "old", "man", "gaunt", "heavy", "doll", "auntie", "count")
SEEN = np.array([0.2126, 0.7152, 0.0722])


class Wall:
    """A stage of one level of quality that draws what it is told to hold."""

    def __init__(self, page: Page) -> None:
        self._page = page

    @classmethod
    async def open(cls, browser: Browser, address: str, query: str, size: tuple[int, int]) -> Wall:
        """Opens a stage at an address."""
        page = await browser.new_page(viewport={"width": size[0], "height": size[1]})
        page.set_default_timeout(600_000)
        await page.goto(f"{address}/stage?{query}")
        await page.wait_for_function(OPEN)
        await page.evaluate("() => { window.requestAnimationFrame = () => 0; }")
        return cls(page)

    async def look(self, faces: Mapping[str, float], turn: float = 0.0) -> NDArray[np.uint8]:
        """The picture of a mix (height, width, 4)."""
        pose = {"faces": {name: part for name, part in faces.items() if part > 0.0}, "head": [turn, 0, 0]}
        width, height, text = await self._page.evaluate(LOOK, pose)
        return np.frombuffer(base64.b64decode(text), np.uint8).reshape(height, width, 4)

    async def close(self) -> None:
        """Closes the page."""
        await self._page.close()


def luminance(picture: NDArray[np.uint8]) -> float:
    """The mean relative luminance of a picture, 0 to 1."""
    code = picture[..., :3] / 255.0
    light = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    return float((light @ SEEN).mean())


def gaps(picture: NDArray[np.uint8]) -> tuple[int, int]:
    """Pixels of skin with hair on all sides at the temples, and pixels of hair there."""
    hair = green_of(picture, STUBBLE)
    rows = np.flatnonzero((picture[..., 3] > 127).any(axis=1))
    top = rows[0]
    height = rows[-1] - top
    here = np.zeros(hair.shape, bool)
    here[top + int(TEMPLES[0] * height) : top + int(TEMPLES[1] * height)] = True
    reach = max(1, round(CLOSE * picture.shape[0] / 1080))
    closed = ndimage.binary_closing(hair, np.ones((3, 3), bool), iterations=reach)
    skin = closed & ~hair & (picture[..., 3] > 127) & here
    return int(skin.sum()), int((hair & here).sum())


async def flashes(wall: Wall, pairs: Sequence[tuple[str, str]], level: str) -> bool:
    """Prints the pairs on whose way the luminance leaves its ends; whether none does by more than is allowed."""
    worst = 0.0
    for one, other in pairs:
        ways = [step / STEPS for step in range(STEPS + 1)]
        seen = [luminance(await wall.look({one: 1.0 - way, other: way})) for way in ways]
        low, high = sorted((seen[0], seen[-1]))
        outside = max(max(seen) / high, low / min(seen)) - 1.0
        worst = max(worst, outside)
        if outside > OUTSIDE:
            told = " ".join(f"{value / seen[0]:.3f}" for value in seen)
            print(f"{level}: {one} to {other} leaves its ends by {100 * outside:.1f} %: {told}")
    print(f"{level}: {len(pairs)} pairs leave the luminance of ends by {100 * worst:.1f} % (bar {100 * OUTSIDE:.0f})")
    return worst <= OUTSIDE


async def skin_between(wall: Wall, level: str) -> bool:
    """Prints the pixels of skin between strands; whether there are none."""
    found = {}
    for face in PEOPLE:
        counts = [gaps(await wall.look({face: 1.0}, turn)) for turn in TURNS]
        skin, hair = (sum(count[part] for count in counts) for part in (0, 1))
        found[face] = 1000 * skin / max(hair, 1)
    print(f"{level}: skin between strands at the temples, thousandths of their hair:", end=" ")
    print(", ".join(f"{face} {share:.1f}" for face, share in found.items()))
    return max(found.values()) < 1.0


async def measure(levels: Sequence[str], size: tuple[int, int], count: int, seed: int) -> bool:
    """Everything; whether all bars hold."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    cast = load_cast()
    pairs = list(combinations(first_wearers(cast), 2))
    if count:
        pairs = [pairs[at] for at in np.random.default_rng(seed).permutation(len(pairs))[:count]]
    held = []
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        pages = static_pages.read_pages()
        documents = [CastDocuments(each, load_meshes(), load_mask()) for each in (cast, dyed(cast))]
        async with serve_pages(documents[0], pages) as own, serve_pages(documents[1], pages) as green:
            for level in levels:
                wall = await Wall.open(browser, own, f"quality={level}&light=theatre&transparent", size)
                held.append(await flashes(wall, pairs, level))
                await wall.close()
                wall = await Wall.open(browser, green, f"quality={level}&light=flat&transparent", size)
                held.append(await skin_between(wall, level))
                await wall.close()
        await browser.close()
    return all(held)


def main() -> int:
    """Measures, prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--levels", default="good,high")
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--pairs", type=int, default=0)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    options = parser.parse_args()
    print(f"seed {options.seed}")
    width, height = map(int, options.size.split("x"))
    return 0 if asyncio.run(measure(options.levels.split(","), (width, height), options.pairs, options.seed)) else 1


if __name__ == "__main__":
    sys.exit(main())
