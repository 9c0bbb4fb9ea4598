"""Renders pictures headlessly: the stage's own page, served on loopback to a Chromium without a window."""

from __future__ import annotations

import asyncio
import base64
import weakref
from collections.abc import AsyncIterator, Sequence
from concurrent.futures import Future
from contextlib import asynccontextmanager, closing
from dataclasses import replace
from pathlib import Path
from threading import Thread
from typing import NamedTuple, Self
from urllib.parse import urlencode

import msgspec
import numpy as np
from aiohttp import web
from numpy.typing import NDArray

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.file_names import picture_kind
from omote.interchange.formats.png import png_bytes, read_png
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
from omote.stage_data.picture_finish import Finished, face_triangles, finish_picture
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Clipped, Setting
from omote.stage_data.playing_cast import PlayingCast
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


class DrawnPicture(NamedTuple):
    """The bytes of an image file, and what of it was cut off to match its luminance; None where that was not asked."""

    data: bytes
    clipped: Clipped | None = None


class PicturePage:
    """A stage page in the headless browser that renders picture grids in one setting."""

    def __init__(self, tools: DevTools, target: str, session: str, setting: Setting) -> None:
        self._tools = tools
        self._target = target
        self._session = session
        self._setting = setting

    async def draw(self, sheet: PictureGrid, following: Pose | None = None) -> DrawnPicture:
        """Renders a grid as an image file; BrowserError where the browser cannot.

        ValueError where the picture cannot have the setting's luminance and contrast. Of a mask, a grid is one picture.
        following: a pose that will be drawn next; what it needs is fetched meanwhile. sheet: the grid.
        """
        drawn = replace(sheet, paper=None) if self._setting.clear else sheet
        words = [msgspec.json.encode(part).decode() for part in (drawn, following) if part is not None]
        data = base64.b64decode(await self._run(f"sheet({', '.join(words)})"))
        if not self._setting.finished:
            return DrawnPicture(data)
        finished = await self._finish(read_png(data))
        return DrawnPicture(png_bytes(finished.picture), finished.clipped)

    async def _finish(self, picture: NDArray[np.uint8]) -> Finished:
        """The picture masked and matched."""
        if not self._setting.mask:
            return finish_picture(picture, self._setting)
        triangles = face_triangles(load_cast().space)
        rows, corners = np.unique(triangles, return_inverse=True)
        answer = await self._tools.evaluate(self._session, f"window.omoteStage.places({rows.tolist()})")
        places = np.array(answer, np.float64)
        return finish_picture(picture, self._setting, places, corners.reshape(-1, 3).astype(np.int32))

    async def compose(self, sheet: PictureGrid, pictures: Sequence[Sequence[Path]]) -> bytes:
        """Composes a grid from image files, row by row, and returns the image file's bytes.

        sheet: the grid; pictures: the files, by row and column.
        """
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


class PictureBrowser:
    """A browser with one stage page, in a thread of its own: also where an event loop runs, as in a notebook.

    It ends when it is closed, and with the interpreter.
    """

    def __init__(
        self, setting: Setting, cast: Cast | None = None, playing: tuple[CastDocuments, PlayingCast] | None = None
    ) -> None:
        """Starts a browser and opens the page in it.

        setting: size and quality of what it draws; cast: what the poses name, None for the built-in one; playing: in
        its place, one with a show file's own work, whose documents end with the browser.
        FileNotFoundError where there is no browser, cast or page; BrowserError where the browser does not open it.
        """
        opened: Future[tuple[asyncio.AbstractEventLoop, PicturePage, asyncio.Event]] = Future()
        work = _keep_open(find_chromium(), setting, cast, playing, opened)
        thread = Thread(target=lambda: asyncio.run(work), name="pictures", daemon=True)
        thread.start()
        self._loop, self._page, closed = opened.result()
        self._end = weakref.finalize(self, _end_thread, self._loop, closed, thread)

    def draw(self, sheet: PictureGrid) -> bytes:
        """The bytes of an image file of a grid; BrowserError where the browser does not draw, RuntimeError where it is
        closed.

        sheet: the grid.
        """
        if not self._end.alive:
            raise RuntimeError("this renderer is closed; open another one")
        return asyncio.run_coroutine_threadsafe(self._page.draw(sheet), self._loop).result().data

    def close(self) -> None:
        """Ends the browser; nothing where it has ended."""
        self._end()


async def _keep_open(
    browser: Path,
    setting: Setting,
    cast: Cast | None,
    playing: tuple[CastDocuments, PlayingCast] | None,
    opened: Future[tuple[asyncio.AbstractEventLoop, PicturePage, asyncio.Event]],
) -> None:
    """Keeps a page open until what it gives with it is set."""
    try:
        if playing is not None:
            documents, full = playing
            await documents.prepare(full)
            documents.play(full)
        else:
            documents = built_in_documents() if cast is None else CastDocuments(cast, load_meshes(), load_mask())
        async with serve_pages(documents, read_pages()) as address, open_chromium(browser) as tools:
            page = await open_picture_page(tools, address, setting)
            closed = asyncio.Event()
            opened.set_result((asyncio.get_running_loop(), page, closed))
            await closed.wait()
    except Exception as error:
        if opened.done():
            raise
        opened.set_exception(error)


def _end_thread(loop: asyncio.AbstractEventLoop, closed: asyncio.Event, thread: Thread) -> None:
    loop.call_soon_threadsafe(closed.set)
    thread.join()


class Renderer:
    """Draws one frame after another in a browser that stays open; `render` starts one for each picture.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that frames name: the built-in ones and any others on its head.
    size : (int, int)
        Width and height, pixels.
    background : str, optional
        One colour behind the head, "#00b140"; else the light's own.
    transparent : bool
        Nothing behind the head.
    quality : {"lowest", "low", "medium", "good", "high"}
        The level of the stage's quality.
    hair : bool
        Whether heads wear their hair.
    mask : {"", "oval", "face"}
        What is left of the picture: an ellipse around the face, or the face from chin to hairline; around it is the
        background, or nothing.
    luminance, contrast : float, optional
        The mean of relative luminance (linear light, 0 to 1) that the picture gets, and its standard deviation over the
        mean; of what the mask leaves and what is not transparent.
    framing : {"", "head", "bust", "half", "full"}
        How much of a figure the pictures show; "" for a head alone.

    Raises
    ------
    ValueError
        Where the size, the quality, the mask, the framing or the cast's head is none that can be drawn.

    Notes
    -----
    FileNotFoundError where there is no Chromium, BrowserError (a RuntimeError) where it does not open. The browser ends
    with `close`, at the end of a `with` block, and with the interpreter.

    Examples
    --------
    >>> with omote.Renderer(cast, size=(320, 360)) as renderer:  # doctest: +SKIP
    ...     pictures = [renderer(performer.advance(1 / 25)) for _ in range(50)]

    References
    ----------
    docs/conventions.md; the light and the levels are those of docs/gallery.md.
    """

    def __init__(
        self,
        cast: Cast,
        *,
        size: tuple[int, int] = (640, 720),
        background: str | None = None,
        transparent: bool = False,
        quality: str = "high",
        hair: bool = True,
        mask: str = "",
        luminance: float | None = None,
        contrast: float | None = None,
        framing: str = "",
    ) -> None:
        if not isinstance(size, Sequence) or len(size) != 2:
            raise ValueError(f"size is {size!r}; give width and height in pixels, as in (640, 720)")
        self._setting = Setting(
            *size, background=background, transparent=transparent, quality=quality, hair=hair, mask=mask,
            luminance=luminance, contrast=contrast, framing=framing,
        )  # fmt: skip
        if len(cast.space.points) != len(load_cast().space.points):
            raise ValueError(
                f"a cast of {len(cast.space.points)} vertices cannot be drawn; give one on the head of "
                "omote.load_cast()"
            )
        self._cast = cast
        self._browser = PictureBrowser(self._setting, cast)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __call__(self, frame: Frame, *, path: str | Path | None = None) -> NDArray[np.uint8]:
        """The picture of a frame, as `render` draws it.

        Parameters
        ----------
        frame : Frame
            What is on air, its light too: of `Performer.advance` or `parse_pose`.
        path : str or Path, optional
            A PNG to be written too, over what is there.

        Returns
        -------
        ndarray of uint8 (height, width, 4)
            Red, green, blue and alpha, 0 to 255, the first row on top; colours are not multiplied by alpha.

        Raises
        ------
        ValueError
            Where the frame names what the cast has not, the path's ending is no PNG's, or the picture cannot have the
            luminance and the contrast.
        TypeError
            As `evaluate`.
        RuntimeError
            Where the renderer is closed, or the browser does not draw (BrowserError).
        """
        check_playable(self._cast, frame)
        target = _picture_path(path)
        sheet = PictureGrid([[pose_of(self._cast, frame)]]).on_paper(self._setting, "image/png")
        data = self._browser.draw(sheet)
        if target is not None:
            write_whole(target, data)
        return read_png(data)

    def close(self) -> None:
        """Ends the browser; nothing where it has ended.

        Examples
        --------
        >>> renderer.close()  # doctest: +SKIP

        References
        ----------
        docs/conventions.md
        """
        self._browser.close()


def _picture_path(path: str | Path | None) -> Path | None:
    """The path of a PNG, None for none; TypeError and ValueError where it is another thing."""
    if path is None:
        return None
    if not isinstance(path, str | Path):
        raise TypeError(f"a picture is named by its path, not by {path!r}; write 'smile.png'")
    if picture_kind(Path(path)) != "image/png":
        raise ValueError(f"{Path(path).name!r} is no name of a PNG; end it with .png")
    return Path(path)


def render(
    cast: Cast,
    frame: Frame,
    *,
    size: tuple[int, int] = (640, 720),
    background: str | None = None,
    transparent: bool = False,
    quality: str = "high",
    hair: bool = True,
    mask: str = "",
    luminance: float | None = None,
    contrast: float | None = None,
    framing: str = "",
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
    hair : bool
        Whether heads wear their hair.
    mask : {"", "oval", "face"}
        What is left of the picture: an ellipse around the face, or the face from chin to hairline; around it is the
        background, or nothing.
    luminance, contrast : float, optional
        The mean of relative luminance (linear light, 0 to 1) that the picture gets, and its standard deviation over the
        mean; of what the mask leaves and what is not transparent. Of more contrast than a face is drawn with (0.2 to
        0.6) the dark parts are cut off to black.
    framing : {"", "head", "bust", "half", "full"}
        How much of a figure the picture shows; "" for a head alone.
    path : str or Path, optional
        A PNG to be written too, over what is there; the picture of `omote render` has the same bytes. No sidecar.

    Returns
    -------
    ndarray of uint8 (height, width, 4)
        Red, green, blue and alpha, 0 to 255, the first row on top; colours are not multiplied by alpha.

    Raises
    ------
    ValueError
        Where the frame names what the cast has not, or the size, the quality, the mask, the cast's head or the path's
        ending is none that can be drawn; where the picture cannot have the luminance and the contrast.
    TypeError
        As `evaluate`.

    Notes
    -----
    FileNotFoundError where there is no Chromium, BrowserError (a RuntimeError) where it does not draw. A browser starts
    and ends with each call, which takes some seconds: `Renderer` keeps one open.

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
    check_playable(cast, frame)  # and the path: before a browser starts
    target = _picture_path(path)
    with Renderer(
        cast, size=size, background=background, transparent=transparent, quality=quality, hair=hair, mask=mask,
        luminance=luminance, contrast=contrast, framing=framing,
    ) as renderer:  # fmt: skip
        return renderer(frame, path=target)


def draw_grid(sheet: PictureGrid, setting: Setting, cast: Cast | None = None) -> bytes:
    """Renders a grid in a browser that starts and ends with this call; returns the image file's bytes.

    cast: what the poses name, None for the built-in one. Also where an event loop runs, as in a notebook.
    FileNotFoundError where there is no browser, cast or page; BrowserError where the browser does not draw. sheet: what
    to draw; setting: size and quality; cast: the built-in one where None.
    """
    with closing(PictureBrowser(setting, cast)) as browser:
        return browser.draw(sheet)


@asynccontextmanager
async def serve_pages(documents: CastDocuments, pages: dict[str, Page]) -> AsyncIterator[str]:
    """Serves the pages and the cast on loopback for one browser and yields the address; no show is played.

    documents: of the cast; pages: the built files.
    """
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
    words = {"quality": setting.quality, "background": None if setting.clear else setting.background}
    if setting.clear:
        words["transparent"] = "1"
    if not setting.hair:
        words["hair"] = "0"
    if setting.framing:
        words["shot"] = setting.framing
    return "?" + urlencode({name: word for name, word in words.items() if word is not None})


async def open_picture_page(tools: DevTools, address: str, setting: Setting, *, ready: str = RESTING) -> PicturePage:
    """Opens a stage page with this setting; BrowserError with the page's own message where it does not open.

    ready: the script whose promise says that the page is open. tools: the browser; address: of the pages; setting: size
    and quality.
    """
    size = setting.width, setting.height
    target, session = await open_stage(tools, f"{address}/stage{query(setting)}", size, ready)
    return PicturePage(tools, target, session, setting)


async def open_stage(
    tools: DevTools, url: str, size: tuple[int, int], ready: str, *, trusted: bool = False
) -> tuple[str, str]:  # fmt: skip
    """Opens a stage page and returns its target and its session; BrowserError with the page's own message where it does
    not open.

    tools: the browser; url: of the page; size: width and height, pixels; ready: the script whose promise says that it
    is open; trusted: whether its certificate has been checked by other means.
    """
    target = await tools.call("Target.createTarget", url="about:blank")
    attached = await tools.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)
    session = str(attached["sessionId"])
    width, height = size
    sizes = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    await tools.call("Emulation.setDeviceMetricsOverride", session=session, **sizes)
    if trusted:
        await tools.call("Security.setIgnoreCertificateErrors", session=session, ignore=True)
    await tools.call("Page.navigate", session=session, url=url)
    try:
        await asyncio.wait_for(tools.evaluate(session, ready), OPENING)
    except TimeoutError:
        raise BrowserError(f"the stage did not open within {OPENING:g} s; try again, or a lower quality") from None
    return str(target["targetId"]), session
