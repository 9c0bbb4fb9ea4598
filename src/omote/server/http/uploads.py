"""Imports that pages upload: read in a process beside the show (`workers.file_jobs`), then saved in the show.

A file is parsed in that process's sandbox, and the show loses nothing by one that is no face and no expression.
"""

from __future__ import annotations

import asyncio
import tempfile
import time
from collections.abc import Awaitable, Callable
from functools import partial
from pathlib import Path

import msgspec
from aiohttp import web

from omote.edit.session.brought_items import Adding, TakenIn, take_in
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.file_kinds import suffix_of
from omote.interchange.formats.file_names import AS, IMPORTS, advise_import
from omote.interchange.formats.gltf_document import LARGEST
from omote.server.http.long_requests import CancelledRequestError, LongRequests, request_id
from omote.server.workers.file_jobs import Imported, ImportFile
from omote.server.workers.job_server import Follow, JobError
from omote.show.validation import name_escapes
from omote.showfile.changes import Kind

KINDS = tuple(IMPORTS)
CHUNK = 2**18
CANCELLED = 204
"""The status of a request that its page ended: there is nothing, and browsers log no error."""

RunFileJob = Callable[[bytes, Follow], Awaitable[bytes]]
AddItems = Callable[[Adding], Awaitable[list[TakenIn] | str]]
"""Saves items in the show; returns what became of each, once they are stored and play, or why not."""


class Uploads:
    """Takes in the files that pages send, one at a time; show: where the show file lies; run_job: does a `FileJob`."""

    def __init__(self, show: Callable[[], Path], run_job: RunFileJob, long_requests: LongRequests) -> None:
        self._show = show
        self._run_job = run_job
        self._long_requests = long_requests

    async def respond(self, request: web.Request, add_items: AddItems) -> web.Response:
        """Responds with what was taken in and what is to be said of it (JSON); 400 or 503 with a sentence, 204 where
        the page ended it.

        request: carries the file; add_items: saves what it holds.
        """
        name = ""
        try:
            name, kind = plan_upload(request.match_info["file"], request.query.get("as", KINDS[0]))
            read = partial(self._read, request, name, kind)
            imported = await self._long_requests.run(request_id(request), read)
        except (ValueError, JobError) as error:
            raise web.HTTPBadRequest(text=name_escapes(str(error).removeprefix(f"{name}: "))) from error
        except CancelledRequestError:
            return web.Response(status=CANCELLED)
        except OSError as error:
            raise web.HTTPServiceUnavailable(text=f"nothing was taken in ({explain_error(error)}).") from error
        taken = await add_items(partial(take_in, brought=imported.items))
        if isinstance(taken, str):
            raise web.HTTPServiceUnavailable(text=taken)
        return web.json_response(body=msgspec.json.encode({"items": taken, "said": imported.said}))

    async def _read(self, request: web.Request, name: str, kind: Kind, follow: Follow) -> Imported:
        with tempfile.TemporaryDirectory(prefix="omote-") as folder:
            path = Path(folder) / name
            follow(0, 0, "the file is sent")
            await _receive(request, path)
            async with self._long_requests.turn("import", follow, "it waits until another file is taken in"):
                job = ImportFile(str(self._show()), str(path), kind, time.time())  # noqa: TID251  (dates revisions)
                data = await self._run_job(msgspec.msgpack.encode(job), follow)
        return await asyncio.get_running_loop().run_in_executor(
            None, partial(msgspec.msgpack.decode, data, type=Imported)
        )


def plan_upload(file: str, kind: str) -> tuple[str, Kind]:
    """The name under which a file is read, and what it is; ValueError for what nothing can be made of.

    file: the name that a page gives; kind: as what it is taken in.
    """
    name = "".join(letter for letter in Path(file).name if letter.isprintable())[-80:].lstrip("-.")
    if kind not in KINDS:
        raise ValueError(f"a file is taken in as {' or '.join(KINDS)}, not as {kind[:80]!r}.")
    if suffix_of(name) not in IMPORTS[kind]:
        raise ValueError(
            f"{file[:80]!r} cannot be taken in as {AS[kind]}: {advise_import(name, kind)}. Nothing has changed."
        )
    return name, "face" if kind == "face" else "expression"


async def _receive(request: web.Request, path: Path) -> None:
    """Writes what a page sends into a file; ValueError where it is too large."""
    size = 0
    with path.open("wb") as file:
        async for chunk in request.content.iter_chunked(CHUNK):
            size += len(chunk)
            if size > LARGEST:
                raise ValueError(f"{path.name} has more than {LARGEST} bytes, which no face has; export a smaller one.")
            file.write(chunk)
