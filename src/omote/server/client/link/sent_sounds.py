"""The sounds that a program has sent: kept, so that a show that has them no more gets them again."""

from __future__ import annotations

from collections.abc import Iterable

from omote.server.sounds.sound_routes import MOST_BYTES, MOST_SOUNDS
from omote.show import messages as wire
from omote.show.speech.known_sounds import NO_SOUND


class SentSounds:
    """The newest sounds by key, as many as a show keeps."""

    def __init__(self) -> None:
        self._sounds: dict[str, bytes] = {}

    def keep(self, key: str, data: bytes) -> None:
        """Keeps a sound as the newest, in the place of the oldest where there is no room."""
        self._sounds.pop(key, None)
        self._sounds[key] = data
        while len(self._sounds) > MOST_SOUNDS or sum(map(len, self._sounds.values())) > MOST_BYTES:
            del self._sounds[next(iter(self._sounds))]

    def find(self, keys: Iterable[str]) -> list[bytes]:
        """Those of these keys that are kept, each once."""
        return [self._sounds[key] for key in dict.fromkeys(keys) if key in self._sounds]

    def missing(self, message: wire.FromClient, reason: str) -> bytes | None:
        """The sound to send again where a show rejected a speech because it has its sound no more, else None."""
        if not isinstance(message, wire.Say) or not reason.startswith(NO_SOUND):
            return None
        return self._sounds.get(message.sound)
