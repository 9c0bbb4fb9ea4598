"""Serves a layout for TouchOSC that plays the show as it is: its characters, and the names of its cast."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine

from aiohttp import web

from omote.perform.snapshot import Playable
from omote.server.workers.file_jobs import BuildTouchoscLayout
from omote.server.workers.job_server import JobError

TOUCHOSC_PATH = "/touchosc/omote.tosc"
Played = Callable[[], tuple[Playable, tuple[str, ...], dict[str, int]]]
Build = Callable[[BuildTouchoscLayout], Coroutine[object, object, bytes]]


class TouchoscLayout:
    """The layout over HTTP. played: gives the cast, the names of the characters and the dimensions of pads; build:
    does the work, seconds of it for many names, in another process."""

    def __init__(self, played: Played, build: Build) -> None:
        self._played = played
        self._build = build
        self._built: tuple[BuildTouchoscLayout, asyncio.Task[bytes]] | None = None

    async def respond(self, _: web.Request) -> web.Response:
        """Responds with the file, built once for all who ask while cast and characters are the same; 503 with a
        sentence where it cannot be built."""
        cast, characters, pads = self._played()
        wanted = BuildTouchoscLayout(tuple(cast.faces), tuple(cast.expressions), characters, pads)
        if self._built is None or self._built[0] != wanted:
            self._built = wanted, asyncio.create_task(self._build(wanted))
        try:
            body = await asyncio.shield(self._built[1])  # one of those who wait may go
        except JobError as error:
            self._built = None
            raise web.HTTPServiceUnavailable(text=f"the layout was not built: {error}") from error
        headers = {"Cache-Control": "no-cache", "Content-Disposition": 'attachment; filename="omote.tosc"'}
        return web.Response(body=body, content_type="application/octet-stream", headers=headers)
