"""Exports that a page downloads, made in a process beside the show (`workers.file_jobs`), one at a time: no tick waits
for it, and what it makes is what `omote export` and `omote file export` write."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec
from aiohttp import web

from omote.server.http.long_requests import CancelledRequestError, LongRequests, request_id
from omote.server.http.uploads import CANCELLED, RunFileJob
from omote.server.workers.file_jobs import ExportExpression, ExportFace
from omote.server.workers.job_server import Follow, JobError
from omote.stage_data.playing_cast import PlayingCast

GLB = "model/gltf-binary"
JSON = "application/json"
FACES = {
    "glb": ("glb", GLB),
    "vrm": ("vrm", GLB),
    "usdz": ("usdz", "model/vnd.usdz+zip"),
    "obj": ("zip", "application/zip"),
}
"""What faces go out as, by the ending that is asked for: the ending and the type of the file."""
NEUTRAL = "neutral"
KINDS = ("arkit", "performed", "makehuman", "all")


@dataclass(frozen=True)
class Download:
    """What is to be made: the job, and the name and type of the file."""

    job: ExportExpression | ExportFace
    file: str
    content_type: str


class Downloads:
    """Makes exports of a show file's own work and of the cast, and responds with them.

    show: where the file lies; run_job: does a `FileJob`.
    """

    def __init__(self, show: Callable[[], Path], run_job: RunFileJob, long_requests: LongRequests) -> None:
        self._show = show
        self._run_job = run_job
        self._long_requests = long_requests

    async def respond(self, request: web.Request, playing: PlayingCast) -> web.Response:
        """Responds with the file; 404 or 503 with a sentence for the person who asked, 204 where the page ended it.

        request: names the file; playing: the cast that plays.
        """
        try:
            wanted = plan_download(self._show(), request.match_info["file"], request.query, playing)
        except ValueError as error:
            raise web.HTTPNotFound(text=f"{error}.") from error
        try:
            data = await self._long_requests.run(request_id(request), partial(self._make, wanted))
        except CancelledRequestError:
            return web.Response(status=CANCELLED)
        except (ValueError, JobError) as error:
            raise web.HTTPServiceUnavailable(text=str(error)) from error
        headers = {"Content-Disposition": f'attachment; filename="{wanted.file}"', "Cache-Control": "no-store"}
        return web.Response(body=data, content_type=wanted.content_type, headers=headers)

    async def _make(self, wanted: Download, follow: Follow) -> bytes:
        async with self._long_requests.turn("export", follow, "it waits until another export is made"):
            return await self._run_job(msgspec.msgpack.encode(wanted.job), follow)


def plan_download(show: Path, file: str, query: Mapping[str, str], playing: PlayingCast) -> Download:
    """What a page asks for by the name of a file: `crooked_smile.json`, `my_aunt.glb`, `dog.glb?expressions=smile`,
    `my_aunt.vrm?author=Ann&licence=strict`, `my_aunt.usdz`, `my_aunt.obj?expressions=neutral` (a ZIP).

    ValueError with a message for a name that does not play, or is not saved yet, and for another format. show: its
    file; file: the name; query: of the address; playing: the cast that plays.
    """
    name, _, suffix = file.rpartition(".")
    if suffix == "json":
        _check(name, "expression", playing.expression_sources)
        return Download(ExportExpression(str(show), name), f"{name}.json", JSON)
    if suffix not in FACES:
        endings = ", ".join(f".{ending}" for ending in FACES)
        raise ValueError(f"{file[:80]!r} is no export; there are .json for expressions and {endings} for faces")
    _check(name, "face", playing.faces)
    expressions = query.get("expressions", "arkit")
    authors = tuple(filter(None, map(str.strip, query.get("author", "").split(","))))
    if expressions not in (*KINDS, NEUTRAL):
        for expression in expressions.split(","):
            _check(expression, "expression", playing.expression_sources)
    whole = name if expressions == "arkit" else f"{name}-{expressions[:60].replace(',', '-')}"
    ending, content_type = FACES[suffix]
    job = ExportFace(str(show), name, expressions, f".{suffix}", authors, query.get("licence", ""))
    return Download(job, f"{whole}.{ending}", content_type)


def _check(name: str, what: str, names: Mapping[str, str]) -> None:
    if name not in names:
        raise ValueError(f"there is no {what} {name[:80]!r} in this show; save it first: only what is saved goes out")
