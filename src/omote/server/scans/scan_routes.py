"""The addresses of a scan: it is brought, fitted anew by points, taken as a face, thrown away; photographs too.

A job beside the show does the work (`workers.scan_jobs`), one scan at a time.
"""

from __future__ import annotations

import asyncio
import tempfile
import time
from collections.abc import Awaitable, Callable, Coroutine
from functools import partial
from pathlib import Path

import msgspec
from aiohttp import web

from omote.edit.session.brought_items import take_made
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.scans.picture_reader import LARGEST_PICTURE
from omote.server.http.editor_link import NO_FILE
from omote.server.http.long_requests import CancelledRequestError, LongRequests, request_id
from omote.server.http.uploads import CANCELLED, AddItems, RunFileJob
from omote.server.scans.scan_previews import Preview, ScanPreviews
from omote.server.scans.scan_upload import (
    LARGEST_PHOTOGRAPH,
    LARGEST_SIDE,
    MOST_PHOTOGRAPHS,
    POINTS_FILE,
    choose_scan,
    read_photographs,
    receive_files,
    receive_points,
)
from omote.server.workers.file_jobs import Imported
from omote.server.workers.job_server import Follow, JobError
from omote.server.workers.scan_jobs import FILES, FitPhotographs, FitScan, ShowPhotograph, TakeScan

SCANS_PATH = "/scans"
PHOTOGRAPHS_PATH = "/photographs"
PICTURE_PATH = "/photographs/picture"
MSGPACK = "application/msgpack"

Point = tuple[float, float, float]
FitPreview = Callable[[Preview], Awaitable[web.Response]]
Work = Callable[[web.Request, Follow], Coroutine[object, object, web.Response]]
FileWork = tuple[Callable[[], Path], RunFileJob]


class Points(msgspec.Struct, frozen=True):
    """What an editor says of a scan: points by name, in its own frame; whether its eyes are shut, null: look."""

    points: dict[str, Point]
    shut: bool | None = None


class Taking(msgspec.Struct, frozen=True):
    """As what a face is taken: its name, its hair, and the item that it replaces, null: none."""

    label: str
    hair_style: str = ""
    hair: str = "#3a2a20"
    replaced: int | None = None


class ScanRoutes:
    """Answers editors who bring scans; work: where the show file lies, and what does a `FileJob`, None where there is
    no file; add_items: keeps items in the show."""

    def __init__(
        self, work: FileWork | None, long_requests: LongRequests, add_items: AddItems, previews: ScanPreviews
    ) -> None:
        self._work = work
        self._long_requests = long_requests
        self._add_items = add_items
        self.previews = previews

    def add_routes(self, application: web.Application) -> None:
        """Adds where scans and photographs are brought to, and where each is fitted, taken and thrown away."""
        posts = {
            PICTURE_PATH: self._show_photograph,  # before the addresses of tokens
            PHOTOGRAPHS_PATH: self._bring_photographs,
            f"{PHOTOGRAPHS_PATH}/{{token}}": self._fit_photographs_again,
            SCANS_PATH: self._bring,
            f"{SCANS_PATH}/{{token}}": self._fit_again,
            f"{SCANS_PATH}/{{token}}/face": self._take,
        }
        for path, work in posts.items():
            application.router.add_post(path, partial(self._answer, work))
        application.router.add_delete(f"{SCANS_PATH}/{{token}}", self.drop)

    async def drop(self, request: web.Request) -> web.Response:
        """Throws a scan away."""
        self.previews.drop(request.match_info["token"])
        return web.Response(status=204)

    async def _answer(self, work: Work, request: web.Request) -> web.Response:
        """Responds with what a work gives; 400 or 503 with a sentence, 204 where the page ended it."""
        try:
            return await self._long_requests.run(request_id(request), partial(work, request))
        except (ValueError, JobError, msgspec.DecodeError) as error:
            raise web.HTTPBadRequest(text=str(error)) from error
        except CancelledRequestError:
            return web.Response(status=CANCELLED)
        except OSError as error:
            raise web.HTTPServiceUnavailable(text=f"nothing was done ({explain_error(error)}).") from error

    async def _bring(self, request: web.Request, follow: Follow) -> web.Response:
        """Fits the scan in a form of files; responds with a `ScanPreview` (MessagePack)."""

        async def fit(preview: Preview) -> web.Response:
            preview.file = choose_scan(sorted(path.name for path in (preview.folder / FILES).iterdir()))
            return await self._fit(preview, Points({}), follow)

        return await self._receive(request, follow, fit)

    async def _show_photograph(self, request: web.Request, follow: Follow) -> web.Response:
        """Responds with the one photograph in a form of files as a JPEG that browsers show, upright; nothing is
        kept."""
        if self._work is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be taken in: {NO_FILE}")
        follow(0, 0, "the file is sent")
        with tempfile.TemporaryDirectory(prefix="omote-") as place:
            folder = Path(place)
            await receive_files(request, folder, most=LARGEST_PICTURE)
            paths = sorted(folder.iterdir())
            if len(paths) != 1:
                raise ValueError(f"{len(paths)} files came; bring one photograph at a time.")
            body = await self._do(ShowPhotograph(str(paths[0]), LARGEST_SIDE), follow)
        return web.Response(body=body, content_type="image/jpeg", headers={"Cache-Control": "no-store"})

    async def _bring_photographs(self, request: web.Request, follow: Follow) -> web.Response:
        """Fits the photographs in a form of files, their landmarks among them (`scan_upload.POINTS_FILE`); responds
        with a `PhotographPreview` (MessagePack)."""

        async def fit(preview: Preview) -> web.Response:
            described = preview.folder / FILES / POINTS_FILE
            if not described.exists():
                raise ValueError("these photographs came without their landmarks; bring them to the editor's page.")
            return await self._fit_photographs(preview, described.read_bytes(), follow)

        return await self._receive(request, follow, fit, MOST_PHOTOGRAPHS * LARGEST_PHOTOGRAPH)

    async def _receive(
        self, request: web.Request, follow: Follow, fit: FitPreview, most: int | None = None
    ) -> web.Response:
        """Keeps the files of a form in a preview of their own as long as they can be fitted."""
        if self._work is None:
            raise web.HTTPServiceUnavailable(text=f"nothing can be taken in: {NO_FILE}")
        preview = self.previews.add()
        try:
            follow(0, 0, "the file is sent")
            (preview.folder / FILES).mkdir()
            await receive_files(request, preview.folder / FILES, most=most)
            response = await fit(preview)
        except BaseException:
            self.previews.drop(preview.token)
            raise
        if request.transport is None or request.transport.is_closing():  # nobody knows of it
            self.previews.drop(preview.token)
        return response

    async def _fit_again(self, request: web.Request, follow: Follow) -> web.Response:
        """Fits a scan by points that an editor gives (JSON); responds as `_bring`."""
        preview = self.previews.find(request.match_info["token"])
        return await self._fit(preview, msgspec.json.decode(await request.read(), type=Points), follow)

    async def _fit_photographs_again(self, request: web.Request, follow: Follow) -> web.Response:
        """Fits photographs by landmarks that an editor moved (JSON); responds as `_bring_photographs`."""
        preview = self.previews.find(request.match_info["token"])
        return await self._fit_photographs(preview, await receive_points(request), follow)

    async def _fit_photographs(self, preview: Preview, described: bytes, follow: Follow) -> web.Response:
        sizes = {path.name: path.stat().st_size for path in (preview.folder / FILES).iterdir()}
        job = FitPhotographs(str(preview.folder), preview.token, read_photographs(described, sizes))
        return await self._respond(preview, job, follow)

    async def _fit(self, preview: Preview, said: Points, follow: Follow) -> web.Response:
        job = FitScan(str(preview.folder), preview.file, preview.token, said.points, said.shut)
        return await self._respond(preview, job, follow)

    async def _respond(self, preview: Preview, job: FitScan | FitPhotographs, follow: Follow) -> web.Response:
        """What a fit shows, of a preview that is kept for another while."""
        fitted = await self._do(job, follow)
        self.previews.touch(preview)
        return web.Response(body=fitted, content_type=MSGPACK, headers={"Cache-Control": "no-store"})

    async def _take(self, request: web.Request, follow: Follow) -> web.Response:
        """Keeps the fitted face in the show, as the body says (JSON), and throws the scan away; responds with what was
        taken (JSON)."""
        preview = self.previews.find(request.match_info["token"])
        wanted = msgspec.json.decode(await request.read(), type=Taking)
        assert self._work is not None  # a preview is there
        wall = time.time()  # noqa: TID251  (dates the revision)
        show = str(self._work[0]())
        job = TakeScan(show, str(preview.folder), wanted.label, wanted.hair_style, wanted.hair, wall)
        data = await self._do(job, follow)
        decode = partial(msgspec.msgpack.decode, data, type=Imported)
        imported = await asyncio.get_running_loop().run_in_executor(None, decode)
        taken = await self._add_items(partial(take_made, brought=imported.items, replaced=wanted.replaced))
        if isinstance(taken, str):
            raise web.HTTPServiceUnavailable(text=taken)
        self.previews.drop(preview.token)
        return web.json_response(body=msgspec.json.encode({"items": taken, "said": imported.said}))

    async def _do(self, job: FitScan | FitPhotographs | ShowPhotograph | TakeScan, follow: Follow) -> bytes:
        """What a job makes, once no other scan is worked on."""
        assert self._work is not None  # a preview is there
        async with self._long_requests.turn("scan", follow, "it waits until another scan is fitted"):
            return await self._work[1](msgspec.msgpack.encode(job), follow)
