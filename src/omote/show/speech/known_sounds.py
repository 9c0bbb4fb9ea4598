"""The sounds that a show has: a speech may name them by their keys."""

from __future__ import annotations

from collections.abc import Collection
from typing import TypeVar

from msgspec import structs

from omote.show.objects.speech import PlaySound, Say

Sounding = TypeVar("Sounding", Say, PlaySound)

NO_SOUND = "there is no sound"
"""How the reason begins that a speech is rejected for, where its sound is not there."""


class KnownSounds:
    """The keys of all sounds with their lengths in seconds."""

    def __init__(self) -> None:
        self._seconds: dict[str, float] = {}

    def set(self, seconds: dict[str, float]) -> None:
        """Notes the sounds that are there now, and no others, with their seconds."""
        self._seconds = dict(seconds)

    def seconds(self) -> dict[str, float]:
        """The sounds that there are, with their seconds."""
        return dict(self._seconds)

    @property
    def keys(self) -> Collection[str]:
        """The keys of all sounds."""
        return self._seconds.keys()

    def check(self, key: str) -> str:
        """Returns the key of a sound that is there; ValueError for another."""
        if key not in self._seconds:
            raise ValueError(f"{NO_SOUND} {key!r} any more, or not yet: send it to /sounds first")
        return key

    def complete(self, message: Sounding) -> Sounding:
        """A speech with the length of its sound, where it gives none; ValueError where that is not there."""
        if not message.sound:
            return message
        self.check(message.sound)
        if message.seconds is not None:
            return message
        return structs.replace(message, seconds=self._seconds[message.sound])
