"""Renders pictures headlessly: the stage's own page, served on loopback to a Chromium without a window."""

from __future__ import annotations

import asyncio
import base64
from collections.abc import AsyncIterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from pathlib import Path
from urllib.parse import urlencode

import msgspec
import numpy as np
from aiohttp import web
from numpy.typing import NDArray

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.file_names import picture_kind
from omote.interchange.formats.png import read_png
from omote.model.cast import Cast
from omote.perform.blending.evaluate import check_playable
from omote.perform.frame import Frame
from omote.server.access.security import own_names
from omote.server.headless.chromium import find_chromium, open_chromium
from omote.server.headless.devtools import BrowserError, DevTools
from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import CastDocuments, built_in_documents
from omote.server.http.static_pages import Page, read_pages
from omote.show.session import ShowSession
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Setting
from omote.stage_data.pose_parser import Pose, pose_of

OPENED = """new Promise((open, refuse) => {
    const look = () => {
        const notice = document.getElementById("notice")?.textContent;
        if (window.omoteStage) open(true);
        else if (notice) refuse(notice);
        else setTimeout(look, 20);
    };
    look();
})"""
RESTING = f"{OPENED}.then(() => window.omoteStage.rest())"
OPENING = 60.0
"""Seconds a page may take to open on a slow machine."""


class PicturePage:
    """A stage page in the headless browser that renders picture grids."""

    def __init__(self, tools: DevTools, target: str, session: str) -> None:
        self._tools, self._target, self._session = tools, target, session

    async def draw(self, sheet: PictureGrid, following: Pose | None = None) -> bytes:
        """Renders a grid and returns the image file's bytes; BrowserError where the browser cannot.

        following: a pose that will be drawn next; what it needs is fetched meanwhile.
        """
        words = [msgspec.json.encode(part).decode() for part in (sheet, following) if part is not None]
        return base64.b64decode(await self._run(f"sheet({', '.join(words)})"))

    async def compose(self, sheet: PictureGrid, pictures: Sequence[Sequence[Path]]) -> bytes:
        """Composes a grid from image files, row by row, and returns the image file's bytes."""
        await self._run(f"beginSheet({msgspec.json.encode(sheet).decode()})")
        for row, paths in enumerate(pictures):
            for column, path in enumerate(paths):
                file = base64.b64encode(path.read_bytes()).decode()
                await self._run(f"pastePicture('{file}', {row}, {column})")
        return base64.b64decode(await self._run("finishSheet()"))

    async def _run(self, call: str) -> str:
        return str(await self._tools.evaluate(self._session, f"window.omoteStage.{call}"))

    async def close(self) -> None:
        """Closes the page."""
        await self._tools.call("Target.closeTarget", targetId=self._target)


def render(
    cast: Cast,
    frame: Frame,
    *,
    size: tuple[int, int] = (640, 720),
    background: str | None = None,
    transparent: bool = False,
    quality: str = "high",
    path: str | Path | None = None,
) -> NDArray[np.uint8]:
    """The picture of a frame, as the stage and `omote render` draw it, without a window.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that the frame names: the built-in ones and any others on its head.
    frame : Frame
        What is on air, its light too: of `Performer.advance` or `parse_pose`.
    size : (int, int)
        Width and height, pixels.
    background : str, optional
        One colour behind the head, "#00b140"; else the light's own.
    transparent : bool
        Nothing behind the head.
    quality : {"lowest", "low", "medium", "good", "high"}
        The level of the stage's quality.
    path : str or Path, optional
        A PNG to be written too, over what is there; the picture of `omote render` has the same bytes. No sidecar.

    Returns
    -------
    ndarray of uint8 (height, width, 4)
        Red, green, blue and alpha, 0 to 255, the first row on top; colours are not multiplied by alpha.

    Raises
    ------
    ValueError
        Where the frame names what the cast has not, or the size, the quality, the cast's head or the path's ending is
        none that can be drawn.
    TypeError
        As `evaluate`.

    Notes
    -----
    FileNotFoundError where there is no Chromium, BrowserError (a RuntimeError) where it does not draw. A browser starts
    and ends with each call, which takes some seconds.

    Examples
    --------
    >>> frame = omote.parse_pose(cast, face="kaori=0.5+dog=0.5", expression="smile=0.7", turn="30,-5")
    >>> picture = omote.render(cast, frame, size=(320, 360))  # doctest: +SKIP
    >>> picture.shape  # doctest: +SKIP
    (360, 320, 4)

    References
    ----------
    docs/conventions.md; the light and the levels are those of docs/gallery.md.
    """
    check_playable(cast, frame)
    if not isinstance(size, Sequence) or len(size) != 2:
        raise ValueError(f"size is {size!r}; give width and height in pixels, as in (640, 720)")
    setting = Setting(*size, background=background, transparent=transparent, quality=quality)
    if len(cast.space.points) != len(load_cast().space.points):
        raise ValueError(
            f"a cast of {len(cast.space.points)} vertices cannot be drawn; give one on the head of omote.load_cast()"
        )
    if not isinstance(path, str | Path | None):
        raise TypeError(f"a picture is named by its path, not by {path!r}; write 'smile.png'")
    target = None if path is None else Path(path)
    if target is not None and picture_kind(target) != "image/png":
        raise ValueError(f"{target.name!r} is no name of a PNG; end it with .png")
    data = draw_grid(PictureGrid([[pose_of(cast, frame)]]).on_paper(setting, "image/png"), setting, cast)
    if target is not None:
        write_whole(target, data)
    return read_png(data)


def draw_grid(sheet: PictureGrid, setting: Setting, cast: Cast | None = None) -> bytes:
    """Renders a grid in a browser that starts and ends with this call; returns the image file's bytes.

    cast: what the poses name, None for the built-in one. Also where an event loop runs, as in a notebook.
    FileNotFoundError where there is no browser, cast or page; BrowserError where the browser does not draw.
    """
    browser = find_chromium()

    async def draw() -> bytes:
        documents = built_in_documents() if cast is None else CastDocuments(cast, load_meshes(), load_mask())
        async with serve_pages(documents, read_pages()) as address, open_chromium(browser) as tools:
            return await (await open_picture_page(tools, address, setting)).draw(sheet)

    with ThreadPoolExecutor(max_workers=1, thread_name_prefix="pictures") as apart:
        return apart.submit(asyncio.run, draw()).result()


@asynccontextmanager
async def serve_pages(documents: CastDocuments, pages: dict[str, Page]) -> AsyncIterator[str]:
    """Serves the pages and the cast on loopback for one browser and yields the address; no show is played."""
    session = ShowSession(documents.playing)
    server = ShowServer(session, documents, pages)
    runner = web.AppRunner(server.application(own_names()), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    try:
        site = web.TCPSite(runner, "127.0.0.1", 0)
        await site.start()
        yield f"http://127.0.0.1:{runner.addresses[0][1]}"
    finally:
        await server.links.close_all()
        await runner.cleanup()
        documents.close()


def query(setting: Setting) -> str:
    """The query string of the stage's address for this setting, from the question mark on."""
    words = {"quality": setting.quality, "background": setting.background}
    if setting.transparent:
        words["transparent"] = "1"
    return "?" + urlencode({name: word for name, word in words.items() if word is not None})


async def open_picture_page(tools: DevTools, address: str, setting: Setting, *, ready: str = RESTING) -> PicturePage:
    """Opens a stage page with this setting; BrowserError with the page's own message where it does not open.

    ready: the script whose promise says that the page is open.
    """
    target = await tools.call("Target.createTarget", url="about:blank")
    attached = await tools.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)
    session = str(attached["sessionId"])
    size = {"width": setting.width, "height": setting.height, "deviceScaleFactor": 1, "mobile": False}
    await tools.call("Emulation.setDeviceMetricsOverride", session=session, **size)
    await tools.call("Page.navigate", session=session, url=f"{address}/stage{query(setting)}")
    try:
        await asyncio.wait_for(tools.evaluate(session, ready), OPENING)
    except TimeoutError:
        raise BrowserError(f"the stage did not open within {OPENING:g} s; try again, or a lower quality") from None
    return PicturePage(tools, str(target["targetId"]), session)
