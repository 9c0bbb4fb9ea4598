"""What is said now, for those who look on."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SpeechStatus:
    """What is said now. number: counts all that was said; text: its beginning; elapsed: seconds since its sound began,
    below 0 before that; seconds: its length; sound: the key of what the stage plays, "" for none; waiting: how many
    speeches come after it, next_sound: the key of the next one's sound. keys: what whoever said them calls this one and
    those that wait, in their order."""

    number: int
    text: str
    elapsed: float
    seconds: float
    sound: str
    waiting: int
    next_sound: str
    keys: tuple[str, ...] = ()
