"""The sounds that a show has: a speech may name them by their keys."""

from __future__ import annotations

from msgspec import structs

from omote.show import messages as wire

NO_SOUND = "there is no sound"
"""How the reason begins that a speech is rejected for, where its sound is not there."""


class KnownSounds:
    """The keys of all sounds with their lengths in seconds."""

    def __init__(self) -> None:
        self._seconds: dict[str, float] = {}

    def set(self, seconds: dict[str, float]) -> None:
        """These are there now, and no others."""
        self._seconds = dict(seconds)

    def complete(self, message: wire.FromClient) -> wire.FromClient:
        """The message itself; of a speech whose sound is known with its length, where it gives none.

        ValueError where it names a sound that is not there.
        """
        if not isinstance(message, wire.Say) or not message.sound:
            return message
        if message.sound not in self._seconds:
            raise ValueError(f"{NO_SOUND} {message.sound!r} any more, or not yet: send it to /sounds first")
        if message.seconds is not None:
            return message
        return structs.replace(message, seconds=self._seconds[message.sound])
