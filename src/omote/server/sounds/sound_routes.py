"""The sounds that programs send for characters to speak with; kept in memory while there is room."""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from omote.inputs.sounds.sound_file import LARGEST_SOUND, SoundFile, read_sound
from omote.show.objects.speech import MOST_BYTES, MOST_SOUNDS, SOUNDS_PATH

CHUNK = 2**16
"""Bytes that are read at once."""
KEPT = "private, max-age=31536000, immutable"


class Sounds:
    """Takes in sounds and gives them to stages; tell_lengths: is told the keys of all that there are, with their
    seconds; find_other: the bytes of one that was not sent here, by its key, None where there is none."""

    def __init__(
        self,
        tell_lengths: Callable[[dict[str, float]], None],
        find_other: Callable[[str], bytes | None] = lambda _: None,
    ) -> None:
        self._sounds: dict[str, SoundFile] = {}
        self._tell_lengths = tell_lengths
        self._find_other = find_other

    def add_routes(self, application: web.Application) -> None:
        """Adds where sounds are sent to, and where each is fetched."""
        application.router.add_post(SOUNDS_PATH, self.take_in)
        application.router.add_get(f"{SOUNDS_PATH}/{{key}}", self.respond)

    async def take_in(self, request: web.Request) -> web.Response:
        """Keeps the sound that is the body; responds with its key and its seconds (JSON), 400 with a sentence."""
        data = bytearray()
        async for chunk in request.content.iter_chunked(CHUNK):
            data += chunk
            if len(data) > LARGEST_SOUND:
                break
        try:
            sound = read_sound(bytes(data))
        except ValueError as error:
            raise web.HTTPBadRequest(text=f"{error}.") from error
        self.keep(sound)
        return web.json_response({"sound": sound.key, "seconds": sound.seconds, "type": sound.type})

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
        return None if sound is None else sound.data

    def keep(self, sound: SoundFile) -> None:
        """Keeps a sound as the newest, in the place of the oldest where there is no room."""
        self._sounds.pop(sound.key, None)
        self._sounds[sound.key] = sound
        while len(self._sounds) > MOST_SOUNDS or sum(len(kept.data) for kept in self._sounds.values()) > MOST_BYTES:
            del self._sounds[next(iter(self._sounds))]
        self._tell_lengths({key: kept.seconds for key, kept in self._sounds.items()})
