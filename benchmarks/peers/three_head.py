"""three.js on a head that Omote has exported, with its own morph targets, standard material and shadows.

The page is `three_head.html`: three.js as npm has it, its GLTFLoader, as many lights as a stage has.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from playwright.async_api import Browser, Page, Route

HERE = Path(__file__).resolve().parent
THREE = HERE.parents[1] / "web" / "node_modules" / "three"
ADDRESS = "http://three.test"
EXPORT = (sys.executable, "-c", "from omote.cli import main; main()", "export")


@dataclass(frozen=True)
class Head:
    """A face of the cast, the expressions of it that move, and the file it is exported to."""

    face: str
    channels: Sequence[str]
    file: Path


def export_head(face: str, channels: Sequence[str], folder: Path) -> Head:
    """Writes a face with a morph target for each expression, as a user does."""
    path = folder / f"{face}.glb"
    words = [*EXPORT, face, "--output", str(path), "--expressions", ",".join(channels)]
    subprocess.run(words, check=True, capture_output=True)
    return Head(face, channels, path)


async def open_three(browser: Browser, head: Head, query: str, size: tuple[int, int]) -> Page:
    """A page of its own with that head; an error where it lacks a morph target or wears another material."""

    async def answer(route: Route) -> None:
        name = route.request.url.removeprefix(ADDRESS).partition("?")[0]
        if name.startswith("/three/"):
            await route.fulfill(path=THREE / name.removeprefix("/three/"))
        else:
            await route.fulfill(path=head.file if name == "/head.glb" else HERE / "three_head.html")

    context = await browser.new_context(viewport={"width": size[0], "height": size[1]})
    page = await context.new_page()
    await page.route("**/*", answer)
    await page.goto(f"{ADDRESS}/?{query}")
    await page.wait_for_function("() => Boolean(window.threeHead)", polling=100)
    here = await page.evaluate("[window.threeHead.targets, window.threeHead.materials]")
    if sorted(here[0]) != sorted(head.channels) or here[1] != ["MeshStandardMaterial"]:
        raise RuntimeError(f"the exported head is not what the stage plays: {here}")
    return page
