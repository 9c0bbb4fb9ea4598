"""What a program has a character say, and its gestures: each one message on the wire."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Generic, TypeVar

from msgspec import structs

from omote.perform.gestures.gesture_curves import check_gesture
from omote.perform.limits import check_known, check_switch
from omote.perform.speech.speech_timing import TIMING_KINDS
from omote.perform.speech.spelling import check_language
from omote.server.client.link.sound_upload import split_sound
from omote.server.client.single_floats import pack_numbers
from omote.show import messages as wire

Sent = TypeVar("Sent")
Said = TypeVar("Said")


class RemoteSpeech(Generic[Sent, Said]):
    """A character of a running show that speaks. next_id: names a message that is to be obeyed once; send: sends it;
    speak: sends a speech, and its sound before it."""

    def __init__(
        self,
        name: str,
        next_id: Callable[[], str],
        send: Callable[[wire.FromClient], Sent],
        speak: Callable[[wire.Say, bytes | None], Said],
    ) -> None:
        self.name = name
        self._next_id, self._send, self._speak = next_id, send, speak

    def say(
        self,
        text: str = "",
        *,
        timing: str = "text",
        marks: Sequence[str] = (),
        times: Sequence[float] = (),
        language: str = "en",
        seconds: float | None = None,
        sound: str | bytes | Path | None = "",
        delay: float = 0.0,
        offset: float = 0.0,
        queue: bool = False,
        key: str = "",
    ) -> Said:
        """Speaks: lips move in time with a sound that something else plays, or, where `sound` is one (the bytes of a
        WAV, MP3 or Ogg, the Path of its file, or the key that `send_sound` gave), a stage. Marks are words, characters,
        or mouth shapes (visemes, azure, rhubarb), each with the time at which it begins; with text alone the times are
        estimated. `wait()` of what it gives waits until it is over; `frame.speech` tells how far it is."""
        found = check_known(timing, TIMING_KINDS, "kind of timing")
        kind = next(each for each in TIMING_KINDS if each == found)
        packed, after = pack_numbers(times, "a time (seconds)"), check_switch(queue, "the switch queue")
        sent, data = split_sound(sound)
        message = wire.Say(self.name, name := self._next_id(), text, kind, _listed(marks), packed)
        rest = {"seconds": seconds, "sound": sent, "delay": delay, "offset": offset, "queue": after}
        spoken = structs.replace(message, language=check_language(language), key=key or name, **rest)
        return self._speak(spoken, data)

    def stop_speaking(self) -> Sent:
        """Ends what is said, and what would be said after: the mouth goes to rest."""
        return self._send(wire.StopSpeaking(self.name, self._next_id()))

    def gesture(self, name: str, *, amplitude: float = 1.0, seconds: float | None = None) -> Sent:
        """Makes a short motion on top of all that plays: nod, shake, tilt, bow, shrug, brows or wink; amplitude -2 to
        2, below 0 to the other side."""
        known = check_gesture(name)
        return self._send(wire.MakeGesture(self.name, self._next_id(), known, amplitude, seconds))


def _listed(marks: Sequence[str]) -> list[str]:
    """Marks as a list; TypeError for a text, which would be its letters."""
    if isinstance(marks, str):
        raise TypeError(f"marks is the text {marks[:80]!r}; give a list, such as {marks.split()[:3]!r}")
    return list(marks)
