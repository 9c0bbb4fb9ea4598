"""MIDI Show Control (MMA RP-002): the bytes of GO and its kin, as lighting and sound desks send and hear them.

`F0 7F device 02 format command number F7`: the number of a cue is ASCII digits and points, behind it a zero byte and
the list, and another one and the path.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal, get_args

from omote.perform.limits import check_known

Command = Literal["go", "stop", "resume", "load"]
COMMANDS: dict[Command, int] = {"go": 1, "stop": 2, "resume": 3, "load": 5}
"""The four that play a list; the standard has twenty more, of rooms, machines and clocks."""
ALL_DEVICES = 0x7F
ALL_TYPES = 0x7F
LIGHTING = 0x01
BEGINNING = b"\xf0\x7f"
SHOW_CONTROL = 0x02
END = b"\xf7"
LONGEST = 128
"""Bytes that the standard gives a message at most."""
NUMBERED = re.compile(rb"[0-9.]*(\0[0-9.]*(\0[0-9.]*)?)?")


@dataclass(frozen=True)
class ShowControl:
    """A message of MIDI Show Control.

    command: what it asks for; device: whom it is for, 0 to 111, groups to 126, 127 all; form: the kind of equipment, 1
    lighting, 127 all kinds; number, cue_list, path: of the cue, "" where the message has none.
    """

    command: Command
    device: int = ALL_DEVICES
    form: int = LIGHTING
    number: str = ""
    cue_list: str = ""
    path: str = ""

    def __post_init__(self) -> None:
        """Rejects what no message has."""
        check_known(self.command, get_args(Command), "command of MIDI Show Control")
        for name in ("device", "form"):
            if not 0 <= getattr(self, name) <= 127:
                raise ValueError(f"the {name} of MIDI Show Control is {getattr(self, name)}; give 0 to 127")
        for name in ("number", "cue_list", "path"):
            if not re.fullmatch(r"[0-9.]{0,32}", getattr(self, name)):
                raise ValueError(f"the {name} {getattr(self, name)[:40]!r} has more than 32 digits and points")


def encode_show_control(message: ShowControl) -> bytes:
    """The bytes of a message, from F0 to F7."""
    texts = [message.number, message.cue_list, message.path]
    while texts and not texts[-1]:
        texts.pop()
    head = bytes([message.device, SHOW_CONTROL, message.form, COMMANDS[message.command]])
    return BEGINNING + head + b"\0".join(text.encode() for text in texts) + END


def decode_show_control(data: bytes) -> ShowControl | None:
    """The message that bytes from F0 to F7 are; None for another message of system exclusive, and for another command
    of MIDI Show Control; ValueError for one whose number is none."""
    if not data.startswith(BEGINNING) or data[3:4] != bytes([SHOW_CONTROL]) or len(data) < 7 or data[-1:] != END:
        return None
    commands = {code: command for command, code in COMMANDS.items()}
    command = commands.get(data[5])
    if command is None:
        return None
    numbered = data[6:-1]
    if len(data) > LONGEST or not NUMBERED.fullmatch(numbered):
        raise ValueError(f"the cue of a MIDI Show Control {command} is {numbered[:40]!r}; expected digits and points")
    number, cue_list, path = [text.decode() for text in (*numbered.split(b"\0"), b"", b"")[:3]]
    return ShowControl(command, data[2], data[4], number, cue_list, path)
