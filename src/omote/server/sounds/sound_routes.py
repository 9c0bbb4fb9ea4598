"""The sounds that are sent for characters to speak with; kept in memory while there is room, and in the show file
those that get a name."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING

from aiohttp import web

from omote.inputs.sounds.sound_file import LARGEST_SOUND, SoundFile, read_sound
from omote.server.access.access_guard import visitor_in
from omote.show.access.access_role import explain_missing_role, role_allows
from omote.show.objects.speech import MOST_BYTES, MOST_SOUNDS, SOUNDS_PATH

if TYPE_CHECKING:
    from omote.server.sounds.sound_store import SoundStore

CHUNK = 2**16
"""Bytes that are read at once."""
KEPT = "private, max-age=31536000, immutable"


class Sounds:
    """Takes in sounds and gives them to stages; tell_lengths: is told the keys of those in memory, with their seconds;
    find_other: the bytes of one that is not kept here, by its key, None where there is none; store: keeps those
    that get a name."""

    def __init__(
        self,
        tell_lengths: Callable[[dict[str, float]], None],
        find_other: Callable[[str], bytes | None] = lambda _: None,
        store: SoundStore | None = None,
    ) -> None:
        self._sounds: dict[str, SoundFile] = {}
        self._tell_lengths = tell_lengths
        self._find_other = find_other
        self._store = store

    def add_routes(self, application: web.Application) -> None:
        """Adds where sounds are sent to, and where each is fetched."""
        application.router.add_post(SOUNDS_PATH, self.take_in)
        application.router.add_get(f"{SOUNDS_PATH}/{{key}}", self.respond)

    async def take_in(self, request: web.Request) -> web.Response:
        """Keeps the sound that is the body, where it gets a name (`?name=`) in the show file; responds with its key,
        its seconds and its name (JSON), 400 with a sentence. `&replace=1`: in the place of the one of that name."""
        name = request.query.get("name")
        if name is not None:
            self._check_may_name(request)
        data = bytearray()
        async for chunk in request.content.iter_chunked(CHUNK):
            data += chunk
            if len(data) > LARGEST_SOUND:
                break
        try:
            sound = await asyncio.to_thread(read_sound, bytes(data))
            if name is None or self._store is None:  # which a name has asked for
                self.keep(sound)
            else:
                name = self._store.add(name, sound, replace=request.query.get("replace") == "1")
        except ValueError as error:
            raise web.HTTPBadRequest(text=f"{error}.") from error
        return web.json_response({"sound": sound.key, "seconds": sound.seconds, "type": sound.type, "name": name or ""})

    def _check_may_name(self, request: web.Request) -> None:
        """Refuses what changes the show file to those who may not edit."""
        held = visitor_in(request).role
        if not role_allows(held, "edit"):
            raise web.HTTPForbidden(text=explain_missing_role(held, "edit"))
        if self._store is None:
            raise web.HTTPBadRequest(text="a recording keeps no more sounds: send it to a show.")

    async def respond(self, request: web.Request) -> web.Response:
        """Responds with a sound by its key."""
        key = request.match_info["key"]
        sound = self._sounds.get(key)
        if sound is None and (other := self._find_other(key)) is not None:
            sound = read_sound(other)
        if sound is None:
            raise web.HTTPNotFound(text="there is no such sound any more: send it to /sounds again.")
        return web.Response(body=sound.data, content_type=sound.type, headers={"Cache-Control": KEPT})

    def find(self, key: str) -> bytes | None:
        """The bytes of a sound by its key, None where it is not there."""
        sound = self._sounds.get(key)
        return self._find_other(key) if sound is None else sound.data

    def keep(self, sound: SoundFile) -> None:
        """Keeps a sound as the newest, in the place of the oldest where there is no room."""
        self._sounds.pop(sound.key, None)
        self._sounds[sound.key] = sound
        while len(self._sounds) > MOST_SOUNDS or sum(len(kept.data) for kept in self._sounds.values()) > MOST_BYTES:
            del self._sounds[next(iter(self._sounds))]
        self._tell_lengths({key: kept.seconds for key, kept in self._sounds.items()})
