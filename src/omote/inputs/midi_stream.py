"""Decodes a stream of MIDI 1.0 into readings: controllers of 7 and 14 bits, notes, pitch bend, pressure, programs.

Real-time bytes may stand within any message; of system messages MIDI Show Control alone is read. NRPN is not read: its
four controllers in a row are told from plain ones by their order alone, and a control surface sends plain ones.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from omote.inputs.reading import Reading
from omote.perform.cues.show_control import END, LONGEST, ShowControl, decode_show_control

STATUS = 0x80
REAL_TIME = 0xF8
SYSTEM = 0xF0
END_OF_SYSTEM = 0xF7
NOTE_OFF, NOTE_ON, KEY_PRESSURE, CONTROL, PROGRAM, PRESSURE, BEND = range(0x80, 0xF0, 0x10)
LENGTHS = {NOTE_OFF: 2, NOTE_ON: 2, KEY_PRESSURE: 2, CONTROL: 2, PROGRAM: 1, PRESSURE: 1, BEND: 2}
"""Data bytes of a message, by its status without the channel."""
SYSTEM_LENGTHS = {0xF1: 1, 0xF2: 2, 0xF3: 1}
FINE = 32
"""A controller below it may have its fine part at the number that is so much higher."""
PAIRED = 3
"""Times in a row that a fine part must come right behind its controller until the two are taken for one control of
14 bits: most desks have plain keys and dials at both numbers."""
MOST_CONTROLS = 16
"""Messages of MIDI Show Control of one time."""
HIGHEST_7 = 127.0
HIGHEST_14 = 16383.0


class MidiDecoder:
    """Bytes of one device as they come, cut anywhere. is_bound: whether somebody has bound a control of 14 bits, which
    is then known to be one. rejected: bytes that belong to no message. show_control: what has come of MIDI Show Control
    and was not taken, the newest; what of it has no cue's number is a sentence."""

    def __init__(self, device: str, is_bound: Callable[[str], bool] = lambda _: False) -> None:
        self._device = device
        self._is_bound = is_bound
        self._status = 0
        self._data: list[int] = []
        self._system: bytearray | None = None
        self.show_control: deque[ShowControl | str] = deque(maxlen=MOST_CONTROLS)
        self._coarse: dict[tuple[int, int], int] = {}
        self._paired: dict[tuple[int, int], int] = {}
        self._before: tuple[int, int] | None = None  # the controller of the last message
        self.rejected = 0

    def feed(self, data: bytes) -> list[Reading]:
        """The readings that are whole with these bytes: `1/cc7`, `1/cc7+39` (14 bits), `1/note60`, `1/bend`,
        `1/pressure`, `1/pressure60`, `1/program5`; channels as people count them, from 1."""
        readings: list[Reading] = []
        for byte in data:
            if byte >= REAL_TIME:
                continue
            if byte >= STATUS:
                self._begin(byte)
            else:
                readings += self._add(byte)
        return readings

    def _begin(self, status: int) -> None:
        self.rejected += len(self._data)  # of a message that is cut short
        self._data = []
        if status == END_OF_SYSTEM and self._system is not None:
            self._read_system(bytes(self._system) + END)
        self._system = bytearray([SYSTEM]) if status == SYSTEM else None
        self._status = 0 if status in (SYSTEM, END_OF_SYSTEM) else status

    def _add(self, byte: int) -> list[Reading]:
        if self._system is not None:
            if len(self._system) < LONGEST:
                self._system.append(byte)
            return []
        kind = self._status & 0xF0 if self._status < SYSTEM else self._status
        length = LENGTHS.get(kind) or SYSTEM_LENGTHS.get(kind, 0)
        if not length:
            self.rejected += 1
            return []
        self._data.append(byte)
        if len(self._data) < length:
            return []
        if kind != CONTROL and kind < SYSTEM:
            self._before = None
        message = self._data
        self._data = []  # the status stays: the next may leave it out (running status)
        if kind >= SYSTEM:
            self._status = 0
            return []
        return self._read(kind, (self._status & 0xF) + 1, message)

    def _read_system(self, data: bytes) -> None:
        """Notes a message of MIDI Show Control; every other system message is passed over."""
        try:
            control = decode_show_control(data)
        except ValueError as error:
            self.rejected += 1
            self.show_control.append(str(error))
            return
        if control is not None:
            self.show_control.append(control)

    def _read(self, kind: int, channel: int, message: list[int]) -> list[Reading]:
        first = message[0]
        last = message[-1]
        match kind:
            case 0x80 | 0x90:
                velocity = last if kind == NOTE_ON else 0
                return [self._reading(channel, f"note{first}", velocity / HIGHEST_7, key=True)]
            case 0xA0:
                return [self._reading(channel, f"pressure{first}", last / HIGHEST_7)]
            case 0xB0:
                return self._read_control(channel, first, last)
            case 0xC0:
                return [self._reading(channel, f"program{first}", value, key=True) for value in (1.0, 0.0)]
            case 0xD0:
                return [self._reading(channel, "pressure", first / HIGHEST_7)]
        return [self._reading(channel, "bend", (last << 7 | first) / HIGHEST_14)]

    def _read_control(self, channel: int, number: int, value: int) -> list[Reading]:
        readings = [self._reading(channel, f"cc{number}", value / HIGHEST_7)]
        before = self._before
        self._before = (channel, number)
        if number < FINE:
            self._coarse[channel, number] = value
        elif number < 2 * FINE and self._is_fine_part(channel, number, before):
            whole = self._coarse[channel, number - FINE] << 7 | value
            readings.append(self._reading(channel, f"cc{number - FINE}+{number}", whole / HIGHEST_14))
        return readings

    def _is_fine_part(self, channel: int, number: int, before: tuple[int, int] | None) -> bool:
        """Whether a controller is the fine part of another: it came right behind that one each time, or is bound so. A
        pair that is known may send its fine part alone, while the other stays."""
        coarse = channel, number - FINE
        count = self._paired.get(coarse, 0)
        if count < PAIRED:
            count = self._paired[coarse] = count + 1 if before == coarse else 0
        return count >= PAIRED or (coarse in self._coarse and self._is_bound(f"{channel}/cc{number - FINE}+{number}"))

    def _reading(self, channel: int, control: str, value: float, *, key: bool = False) -> Reading:
        return Reading(self._device, f"{channel}/{control}", value, key)
