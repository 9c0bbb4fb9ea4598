"""Serves a layout for TouchOSC that plays the show as it is: its characters, and the names of its cast."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from aiohttp import web

from omote.perform.snapshot import Playable

TOUCHOSC_PATH = "/touchosc/omote.tosc"
Played = Callable[[], tuple[Playable, tuple[str, ...]]]


class TouchoscLayout:
    """The layout over HTTP. played: gives the cast and the names of the characters."""

    def __init__(self, played: Played) -> None:
        self._played = played
        self._built: tuple[Playable, tuple[str, ...], bytes] | None = None

    async def respond(self, _: web.Request) -> web.Response:
        """Responds with the file, built off the event loop and kept as long as cast and characters are."""
        cast, characters = self._played()
        if self._built is None or self._built[0] is not cast or self._built[1] != characters:
            self._built = cast, characters, await asyncio.to_thread(_build, cast, characters)
        headers = {"Cache-Control": "no-cache", "Content-Disposition": 'attachment; filename="omote.tosc"'}
        return web.Response(body=self._built[2], content_type="application/octet-stream", headers=headers)


def _build(cast: Playable, characters: tuple[str, ...]) -> bytes:
    from omote.inputs.presets.touchosc_layout import build_touchosc_layout  # a tenth of a second that a start saves

    return build_touchosc_layout(cast, characters)
