"""The sounds that a show has: a speech may name them by their names, or by their keys."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TypeVar

from msgspec import structs

from omote.show.declaration import ClientMessage
from omote.show.objects.speech import PlaySound, Say

Sounding = TypeVar("Sounding", Say, PlaySound)
WITH_SOUND = (Say, PlaySound)

NO_SOUND = "there is no sound"
"""How the reason begins that a speech is rejected for, where its sound is not there."""


class KnownSounds:
    """The keys of all sounds with their lengths in seconds, and by what names some are known."""

    def __init__(self) -> None:
        self._seconds: dict[str, float] = {}
        self._called: dict[str, str] = {}

    def set(self, seconds: Mapping[str, float], called: Mapping[str, str] | None = None) -> None:
        """Notes the sounds that are there now, and no others, with their seconds. called: keys by name."""
        self._seconds = dict(seconds)
        self._called = dict(called or {})

    def seconds(self) -> dict[str, float]:
        """The sounds that there are, with their seconds."""
        return dict(self._seconds)

    @property
    def keys(self) -> Collection[str]:
        """The keys of all sounds."""
        return self._seconds.keys()

    def called(self) -> dict[str, str]:
        """The keys of the sounds that have names, by these."""
        return dict(self._called)

    def find(self, sound: str) -> str | None:
        """The key of a sound that is there, by its name or its key; None for another."""
        key = self._called.get(sound, sound)
        return key if key in self._seconds else None

    def check(self, sound: str) -> str:
        """Returns the key of a sound that is there, by its name or its key; ValueError for another."""
        key = self.find(sound)
        if key is None:
            raise ValueError(f"{NO_SOUND} {sound!r} any more, or not yet: send it to /sounds first")
        return key

    def by_key(self, message: ClientMessage) -> ClientMessage:
        """A message with the key of its sound instead of its name: a recording needs no names."""
        if not isinstance(message, WITH_SOUND) or not message.sound:
            return message
        key = self.find(message.sound)
        return message if key in (None, message.sound) else structs.replace(message, sound=key)

    def complete(self, message: Sounding) -> Sounding:
        """A speech with the key of its sound, and with its length where it gives none; ValueError where that is not
        there."""
        if not message.sound:
            return message
        key = self.check(message.sound)
        if message.seconds is not None and key == message.sound:
            return message
        seconds = self._seconds[key] if message.seconds is None else message.seconds
        return structs.replace(message, sound=key, seconds=seconds)
