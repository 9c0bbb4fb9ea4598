"""What a cue does beside moving parts: it sends OSC and MIDI to others, and has somebody speak. None of it is tracked.

Everything is text, as people write it in other programs for shows; it is read here alone.
"""

from __future__ import annotations

import json
import math
import re
import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from omote.perform.cues.show_control import LIGHTING, ShowControl, encode_show_control
from omote.perform.limits import LONGEST_CALL, check_known, check_within
from omote.perform.speech.speaking import LONGEST_KEY

Does = Literal["osc", "midi", "say"]
LONGEST_TO = 120
LONGEST_WHAT = 1000
"""Characters."""
MOST_ACTIONS = 16
"""Of a cue."""
HIGHEST_PORT = 65535
LONGEST_MIDI = 512
"""Bytes of one action."""

_WORD = re.compile(r'\s*("(?:[^"\\]|\\.)*"|[^\s"]+)(?=\s|$)')
_WHOLE = re.compile(r"[-+]?\d+")
_DECIMAL = re.compile(r"[-+]?(\d+\.\d*|\.\d+|\d+)([eE][-+]?\d+)?")
_ADDRESS = re.compile(r"/[!-~]*")
_HOST = re.compile(r"[A-Za-z0-9._-]+|\[[0-9A-Fa-f:.]+\]")
_BYTES = re.compile(r"([0-9A-Fa-f]{2})(\s+[0-9A-Fa-f]{2})*")
_SHOW_CONTROL = re.compile(
    r"msc\s+((?P<device>\d{1,3})\s+)?(?P<command>[a-z]+)(\s+(?P<number>[0-9.]+))?", re.IGNORECASE
)


@dataclass(frozen=True)
class OscSend:
    """A message of OSC for a host and a port, over UDP. arguments: each of the type that it was written as."""

    host: str
    port: int
    address: str
    arguments: tuple[int | float | str | bool, ...] = ()


@dataclass(frozen=True)
class MidiSend:
    """Bytes for a MIDI device at a page, by its name there."""

    device: str
    data: bytes


@dataclass(frozen=True)
class SpokenLine:
    """A text that a character (*: all) says; voice: who speaks it, "" where another plays the sound; sound: the key of
    that which the stage plays, without lips where there is no text."""

    character: str
    text: str
    voice: str = ""
    sound: str = ""


@dataclass(frozen=True)
class CueAction:
    """What a cue does once when it is called: a message to another program, or a line that somebody says.

    Parameters
    ----------
    does : {"osc", "midi", "say"}
        Sends OSC, sends MIDI, or has a character speak.
    to : str
        The host and the port of OSC (`10.0.0.2:53000`), the name of a MIDI device at a page, or the character.
    what : str
        The address with its arguments (`/cue/12/start 1 0.5 "a text" true`), bytes (`90 3C 7F`) or a message of MIDI
        Show Control (`msc go 12.5`), or the text that is said.
    delay : float
        Seconds after the cue has begun, 0 to 3600.
    voice : str
        Who speaks the text, as of `GET /voices`; "": the lips move, and another plays the sound.
    sound : str
        The key of a sound of the show, which is heard instead of a voice; lips move to the text, for its length, and
        are left to who plays the mouth where there is none.

    Raises
    ------
    ValueError
        On what cannot be sent or said.
    TypeError
        On a delay that is no number.

    Examples
    --------
    >>> action = omote.CueAction("osc", "10.0.0.2:53000", '/cue/12/start 1 0.5 "loud"', delay=0.5)
    >>> action.meant.arguments
    (1, 0.5, 'loud')

    References
    ----------
    docs/method.md, "Cues".
    """

    does: Does
    to: str
    what: str
    delay: float = 0.0
    voice: str = ""
    sound: str = ""

    def __post_init__(self) -> None:
        """Rejects what cannot be sent or said."""
        check_known(self.does, get_args(Does), "action of a cue")
        delay = check_within(self.delay, 0.0, LONGEST_CALL, "the delay of an action (seconds)")
        object.__setattr__(self, "delay", delay)
        for name, most in (("to", LONGEST_TO), ("what", LONGEST_WHAT), ("voice", LONGEST_TO), ("sound", LONGEST_KEY)):
            if len(getattr(self, name)) > most:
                raise ValueError(f"{name!r} of an action has more than {most} characters; shorten it")
        if self.voice and self.does != "say":
            raise ValueError(f"the voice {self.voice[:40]!r} speaks nothing: only what is said has a voice")
        if self.sound and (self.does != "say" or self.voice):
            raise ValueError(f"the sound {self.sound!r} is not heard: only what is said without a voice has a sound")
        READERS[self.does](self)

    @property
    def meant(self) -> OscSend | MidiSend | SpokenLine:
        """What it asks for, read."""
        return READERS[self.does](self)


def check_actions(actions: object) -> tuple[CueAction, ...]:
    """Returns the actions of a cue; ValueError where there are too many."""
    listed = tuple(actions) if isinstance(actions, tuple | list) else ()
    if len(listed) > MOST_ACTIONS:
        raise ValueError(
            f"the cue has {len(listed)} actions; it has {MOST_ACTIONS} at most, make another cue of the rest"
        )
    return listed


def _read_osc(action: CueAction) -> OscSend:
    host, _, port = action.to.strip().rpartition(":")
    if not _HOST.fullmatch(host) or not (port.isascii() and port.isdecimal() and 0 < int(port[:9]) <= HIGHEST_PORT):
        raise ValueError(f"OSC cannot be sent to {action.to[:60]!r}; give a host and a port, such as 10.0.0.2:53000")
    words = _words(action.what)
    if not words or not _ADDRESS.fullmatch(words[0]):
        raise ValueError(
            f"{action.what[:60]!r} is no message of OSC; give an address and its arguments, such as /cue/12/start 1 0.5"
        )
    return OscSend(host.strip("[]"), int(port), words[0], tuple(_argument(word) for word in words[1:]))


def _words(text: str) -> list[str]:
    """The words of a message, those in quotes with them; none where it is not a row of words."""
    words: list[str] = []
    at = 0
    text = text.strip()
    while at < len(text):
        found = _WORD.match(text, at)
        if found is None:
            return []
        words.append(found[1])
        at = found.end()
    return words


def _argument(word: str) -> int | float | str | bool:
    """An argument by how it is written: 1 is whole, 1.0 decimal, "1" a text."""
    if word.startswith('"'):
        try:
            text = str(json.loads(word))
        except ValueError as error:
            raise ValueError(f"{word[:60]} is no text in quotes ({error})") from error
        return _without_zero(text)
    if word in ("true", "false"):
        return word == "true"
    if _WHOLE.fullmatch(word):
        return _in_range(int(word), word, -(2**63) <= int(word[:21]) < 2**63)
    if _DECIMAL.fullmatch(word):
        return _in_range(float(word), word, abs(float(word)) <= _HIGHEST_SINGLE)
    return _without_zero(word)


def _without_zero(text: str) -> str:
    if "\0" in text:
        raise ValueError(f"{text[:60]!r} has a zero byte, which ends a text of OSC")
    return text


_HIGHEST_SINGLE: float = struct.unpack(">f", b"\x7f\x7f\xff\xff")[0]
Number = int | float


def _in_range(number: Number, word: str, fits: bool) -> Number:
    if not fits or not math.isfinite(number):
        raise ValueError(f"{word[:40]} is more than a number of OSC can be; write it in quotes to send it as a text")
    return number


def _read_midi(action: CueAction) -> MidiSend:
    device = action.to.strip()
    if not device:
        raise ValueError("the action names no MIDI device; give its name as the page of devices shows it")
    what = action.what.strip()
    control = _SHOW_CONTROL.fullmatch(what)
    if control is not None:
        form = {"device": int(control["device"])} if control["device"] else {}
        message = ShowControl(control["command"].lower(), form=LIGHTING, number=control["number"] or "", **form)  # type: ignore[arg-type]
        return MidiSend(device, encode_show_control(message))
    if not _BYTES.fullmatch(what):
        raise ValueError(
            f"{action.what[:60]!r} is no MIDI; give bytes such as 90 3C 7F, or msc go 12.5 for MIDI Show Control"
        )
    data = bytes.fromhex(what)
    if data[0] < 0x80 or len(data) > LONGEST_MIDI or (data[0] == 0xF0) != (data[-1] == 0xF7):
        raise ValueError(
            f"{what[:60]!r} is no whole message of MIDI: it begins with 80 or more, and one of F0 ends with F7"
        )
    return MidiSend(device, data)


def _read_line(action: CueAction) -> SpokenLine:
    if not action.to.strip() or not (action.what.strip() or action.sound):
        raise ValueError(
            "a line has nothing that is said or nobody who says it; give a character (* for all) and a text or a sound"
        )
    return SpokenLine(action.to.strip(), action.what.strip(), action.voice.strip(), action.sound)


READERS: Mapping[str, Callable[[CueAction], OscSend | MidiSend | SpokenLine]] = {
    "osc": _read_osc, "midi": _read_midi, "say": _read_line,
}  # fmt: skip
