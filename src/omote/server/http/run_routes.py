"""What was recorded, for pages that compare two runs and list the notes of directors: spans, curves, markers."""

from __future__ import annotations

import asyncio
import sqlite3
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Protocol, TypeVar

import msgspec
from aiohttp import web

from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.access_guard import visitor_in
from omote.server.http.document_routes import NO_CACHE
from omote.server.persistence.recorded_runs import describe_recordings, describe_run
from omote.show.access.access_role import role_allows
from omote.show.objects.recordings import (
    CURVES_PATH,
    MARKER_PATH,
    MARKERS_PATH,
    RECORDINGS_PATH,
    MarkerRequest,
    RecordingsDocument,
)
from omote.showfile.recording_file import SUFFIX, RecordingFile, open_recording
from omote.showfile.schema import ShowFileError

LONGEST_REQUEST = 4096
Alter = Callable[[RecordingFile], None]
Read = TypeVar("Read")


class RecordedFiles(Protocol):
    """The recordings that pages look at (`recording/recording_thread.py`, `recording/replay_server.py`)."""

    @property
    def paths(self) -> Sequence[Path]:
        """Where they lie: the first is the one that is marked."""

    def alter(self, work: Alter, answer: Callable[[str], None]) -> None:
        """Does some work on the first, which raises ValueError for what cannot be done. answer: told why it was
        refused, "" for done, on any thread."""


class RunRoutes:
    """The addresses. clock: seconds, monotonic, of the show that plays."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._files: RecordedFiles | None = None
        self._plays = False

    def enable(self, files: RecordedFiles, *, plays: bool) -> None:
        """Reads and marks these from now on. files: the recordings; plays: whether the first is of a show that plays
        now."""
        self._files = files
        self._plays = plays

    def add_routes(self, application: web.Application) -> None:
        """Adds the addresses to an application."""
        application.router.add_get(RECORDINGS_PATH, self.list_recordings)
        application.router.add_get(CURVES_PATH, self.tell_run)
        application.router.add_post(MARKERS_PATH, self.mark)
        application.router.add_post(MARKER_PATH, self.rename)
        application.router.add_delete(MARKER_PATH, self.delete)

    async def list_recordings(self, request: web.Request) -> web.Response:
        """Responds with what is recorded (JSON); 204 where the show is not recorded."""
        files = self._files
        if files is None:
            return web.Response(status=204, headers={"Cache-Control": NO_CACHE})
        visitor = visitor_in(request)
        document = await self._read(request, describe_recordings)
        document = msgspec.structs.replace(
            document,
            files=[path.name.removesuffix(SUFFIX) for path in files.paths],
            name=visitor.name,
            role=visitor.role,
            now=self._now(document) if self._plays else None,
        )
        return _json(document)

    async def tell_run(self, request: web.Request) -> web.Response:
        """Responds with the curves and cues of a part of a recording (MessagePack); 400 where the question is none."""
        try:
            start = int(request.query.get("start", ""))
            first, last = (float(request.query.get(name, "")) for name in ("first", "last"))
        except ValueError:
            raise web.HTTPBadRequest(text="a run is asked for by start, first and last, as numbers.") from None
        run = await self._read(request, lambda file: describe_run(file, start, first, last))
        body = msgspec.msgpack.encode(run)
        return web.Response(body=body, content_type="application/msgpack", headers={"Cache-Control": NO_CACHE})

    async def mark(self, request: web.Request) -> web.Response:
        """Marks a moment and responds with nothing; 400 with the reason for what cannot be done."""
        asked = await self._asked(request)
        visitor = visitor_in(request)
        live = self._plays and asked.start == 0
        start = None if live else asked.start
        at = self._clock() - asked.before if live else asked.at
        who = visitor.name if visitor.person is not None else asked.who.strip()
        return await self._alter(lambda file: file.mark(start, at, asked.name.strip(), who))

    async def rename(self, request: web.Request) -> web.Response:
        """Gives a marker other words; responds as `mark`."""
        asked = await self._asked(request)
        number, by = self._meant(request)
        return await self._alter(lambda file: file.rename_marker(number, asked.name.strip(), by))

    async def delete(self, request: web.Request) -> web.Response:
        """Deletes a marker; responds as `mark`."""
        number, by = self._meant(request)
        return await self._alter(lambda file: file.delete_marker(number, by))

    def _meant(self, request: web.Request) -> tuple[int, str | None]:
        """The marker of a request, and whose it has to be: None where its sender may change all."""
        try:
            number = int(request.match_info["id"])
        except ValueError:
            raise web.HTTPNotFound(text="there is no such note.") from None
        visitor = visitor_in(request)
        return number, None if role_allows(visitor.role, "operate") else visitor.name

    async def _asked(self, request: web.Request) -> MarkerRequest:
        body = await request.content.read(LONGEST_REQUEST)
        try:
            asked = msgspec.json.decode(body, type=MarkerRequest)
            if not asked.name.strip():
                raise ValueError("a note of no words says nothing; write some")
        except (ValueError, TypeError) as error:
            raise web.HTTPBadRequest(text=f"{explain_error(error)}. Nothing was noted.") from error
        return asked

    async def _alter(self, work: Alter) -> web.Response:
        files = self._files
        if files is None:
            raise web.HTTPBadRequest(
                text="this show is not recorded, so nothing can be noted: start it without --no-record."
            )
        loop = asyncio.get_running_loop()
        done: asyncio.Future[str] = loop.create_future()
        files.alter(work, lambda refusal: _answer(loop, done, refusal))
        if refusal := await done:
            raise web.HTTPBadRequest(text=f"{refusal}. Nothing was changed.")
        return web.Response(status=204)

    async def _read(self, request: web.Request, read: Callable[[RecordingFile], Read]) -> Read:
        """What is read of the recording that a request asks for, in another thread; 404 where there is none."""
        paths = () if self._files is None else self._files.paths
        wanted = request.query.get("file", "0")
        if not wanted.isdecimal() or int(wanted) >= len(paths):
            raise web.HTTPNotFound(text=f"there is no file {wanted[:20]!r}: there are {len(paths)}.")
        path = paths[int(wanted)]
        loop = asyncio.get_running_loop()
        try:
            return await loop.run_in_executor(None, lambda: _read_file(path, read))
        except (sqlite3.Error, ShowFileError, ValueError) as error:
            raise web.HTTPServiceUnavailable(text=f"the recording cannot be read now ({error}); try again.") from error

    def _now(self, document: RecordingsDocument) -> float | None:
        """The seconds since 1970 that a note of now gets, by the clock of the last span."""
        if not document.spans:
            return None
        span = document.spans[-1]
        return span.written - span.first + self._clock()


def _read_file(path: Path, read: Callable[[RecordingFile], Read]) -> Read:
    file = open_recording(path)
    try:
        return read(file)
    finally:
        file.close()


def _answer(loop: asyncio.AbstractEventLoop, done: asyncio.Future[str], refusal: str) -> None:
    def tell() -> None:
        if not done.done():
            done.set_result(refusal)

    with suppress(RuntimeError):  # a loop that has ended answers nobody
        loop.call_soon_threadsafe(tell)


def _json(document: msgspec.Struct) -> web.Response:
    body = msgspec.json.encode(document)
    return web.Response(body=body, content_type="application/json", headers={"Cache-Control": NO_CACHE})
