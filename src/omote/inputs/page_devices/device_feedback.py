"""What a device is sent back, so that motor faders, rings and lamps show what is on air; never against a hand."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

from omote.inputs.midi_stream import BEND, CONTROL, HIGHEST_7, HIGHEST_14, NOTE_ON
from omote.inputs.presets.lamp import DeviceLamp
from omote.inputs.reading import Reading

QUIET_SECONDS = 0.4
"""Seconds after a control was moved in which it is sent nothing: a hand is at it, or its motor still runs."""
ECHO_SECONDS = 0.1
"""Seconds in which the very message that was sent is taken for its echo: no hand is so fast."""
MOST_MESSAGES = 32
"""Of one time: 30 times a second are 2,900 bytes a second at most, what a plug of five pins carries."""
FIRST_TOUCH = 103
"""The note of the touch of a fader of pitch bend is so much above its channel, as in Mackie's protocol."""
BENDS = 9


class DeviceFeedback:
    """What one device of MIDI was sent. lamps: how controls are shown that are shown otherwise than they send; touches:
    the control that is touched, by the control that says so."""

    def __init__(
        self,
        lamps: Mapping[str, DeviceLamp] = MappingProxyType({}),
        touches: Mapping[str, str] = MappingProxyType({}),
        greeting: bytes = b"",
    ) -> None:
        bends = {f"1/note{FIRST_TOUCH + channel}": f"{channel}/bend" for channel in range(1, BENDS + 1)}
        self._lamps = lamps
        self._touches = {**bends, **touches}
        self._greeting = greeting
        self._sent: dict[str, tuple[bytes, float]] = {}
        self._shown: dict[str, float] = {}
        self._moved: dict[str, float] = {}
        self._touched: set[str] = set()
        self._knows_touch: set[str] = set()

    def hear(self, reading: Reading, now: float) -> bool:
        """Notes a reading; returns whether no hand made it: a motor's way, or what comes back of what was sent.

        now: seconds of the show's clock.
        """
        control = reading.control
        if control in self._touches:
            touched = self._touches[control]
            (self._touched.add if reading.value > 0.0 else self._touched.discard)(touched)
            self._knows_touch.add(touched)
            self._moved[touched] = now
            return False
        if control in self._knows_touch and control not in self._touched:
            return True
        sent, at = self._sent.get(control, (b"", -math.inf))
        if now - at < ECHO_SECONDS and control not in self._lamps and sent == message_of(control, reading.value):
            return True
        self._moved[control] = now
        self._sent.pop(control, None)  # it stands where its hand has put it
        self._shown.pop(control, None)
        return False

    def news(self, positions: Mapping[str, float], now: float) -> bytes:
        """What the device is to be sent, so that it shows these positions; controls that a hand has wait.

        now: seconds of the show's clock.
        """
        self._moved = {control: at for control, at in self._moved.items() if now - at < QUIET_SECONDS}
        messages = [self._greeting]
        self._greeting = b""
        for control, position in positions.items():
            if self._shown.get(control) == position or control in self._touched or control in self._moved:
                continue
            if len(messages) > MOST_MESSAGES:
                break
            self._shown[control] = position
            lamp = self._lamps.get(control)
            message = lamp.message(position) if lamp else message_of(control, position)
            if message and self._sent.get(control, (b"", 0.0))[0] != message:
                self._sent[control] = message, now
                messages.append(message)
        return b"".join(messages)


def message_of(control: str, position: float) -> bytes:
    """The message that a control itself sends at a position; nothing for one that has none, such as a program."""
    channel, _, name = control.partition("/")
    if not (channel.isdecimal() and 1 <= int(channel) <= 16):
        return b""
    status = int(channel) - 1
    fine = round(position * HIGHEST_14)
    numbers = [int(digits) for digits in name.removeprefix("cc").removeprefix("note").split("+") if digits.isdecimal()]
    if name == "bend":
        return bytes([BEND | status, fine & 0x7F, fine >> 7])
    if any(number > HIGHEST_7 for number in numbers) or len(numbers) != 1 + name.count("+"):
        return b""
    if name.startswith("note"):
        return bytes([NOTE_ON | status, numbers[0], round(position * HIGHEST_7)])
    if not name.startswith("cc"):
        return b""
    if len(numbers) == 2:
        return bytes([CONTROL | status, numbers[0], fine >> 7, CONTROL | status, numbers[1], fine & 0x7F])
    return bytes([CONTROL | status, numbers[0], round(position * HIGHEST_7)])
