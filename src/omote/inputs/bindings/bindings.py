"""Controls played: readings of devices and the state on air in, messages of OSC out."""

from __future__ import annotations

import math
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from omote.inputs.bindings.control_binding import MIDDLE, Binding, binding_after_rename
from omote.inputs.character_patterns import characters_meant
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.inputs.reading import Reading
from omote.perform.scene.character_names import ALL


class AddressValues(Protocol):
    """The values of addresses in a state, as surfaces are told them (`osc_feedback.AddressValues`, or a mapping)."""

    def get(self, path: str, default: tuple[Argument, ...], /) -> tuple[Argument, ...]:
        """The values of an address. path: the address; default: what is given where it has none."""


MOVED = 1e-3
"""Of a range: a value on air that is further from what a fader has sent was moved by somebody else."""
NEAR = 0.04
"""Of its way: a fader whose first reading is so near to the value stood there, and sends what it is moved to alone."""
PRESSED = 0.5
"""From where on a level counts as a button that is pressed."""


@dataclass(slots=True)
class _Played:
    """What is known of one binding: where its control stood, whether it acts, whether a panic took it out of the hand,
    what it sent last."""

    last: float | None = None
    engaged: bool = False
    is_off: bool = False
    pressed: bool = False
    sent: float | None = None


@dataclass(frozen=True, slots=True)
class _Fader:
    """What of a binding a fader needs at each reading. alone: its address has no other axis, and is no switch; near:
    how far a value on air may be from what it has sent last.
    """

    path: str
    axis: int
    alone: bool
    low: float
    span: float
    curve: float
    pick_up: bool
    near: float
    has_dead_zone: bool


class Bindings:
    """Bindings, and where their controls stand. A device's bindings belong to its name, whenever it is there."""

    def __init__(self, bindings: Sequence[Binding] = ()) -> None:
        self.bindings: tuple[Binding, ...] = ()
        self._banks: dict[str, str] = {}
        self._played: list[_Played] = []
        self._faders: list[_Fader | None] = []
        self._of: dict[tuple[str, str], list[int]] = {}
        self._sent: dict[str, tuple[int, tuple[Argument, ...]]] = {}
        self.replace(bindings)

    def replace(self, bindings: Sequence[Binding], renamed: tuple[str, str] | None = None) -> None:
        """Plays other bindings from now on; those that stay go on as they were.

        renamed: what a pad was called that they move, and what it is called now.
        """
        was = self.bindings
        if renamed is not None:
            was = tuple(binding_after_rename(binding, *renamed) for binding in was)
        before = dict(zip(was, self._played, strict=True))
        self.bindings = tuple(bindings)
        self._played = [before.get(binding) or _Played() for binding in self.bindings]
        self._faders = [_fader_of(binding) if self._is_fader(binding) else None for binding in self.bindings]
        self._of = {}
        for index, binding in enumerate(self.bindings):
            self._of.setdefault((binding.device, binding.control), []).append(index)
        paths = {binding.target.path for binding in self.bindings}
        self._sent = {path: sent for path, sent in self._sent.items() if path in paths}

    def bank_of(self, device: str) -> str:
        """The bank that a device is turned to; "" for none."""
        return self._banks.get(device, "")

    def banks_of(self, device: str) -> list[str]:
        """The banks in which controls of a device play, in their order."""
        return [*dict.fromkeys(binding.bank for binding in self.bindings if binding.device == device and binding.bank)]

    def choose_bank(self, device: str, bank: str) -> None:
        """Turns a device to a bank, whose faders are to be picked up anew."""
        self._banks[device] = bank
        for binding, played in zip(self.bindings, self._played, strict=True):
            if binding.device == device:  # and where they stand in the other bank is not known
                played.engaged = False
                played.last = None

    def positions(self, device: str, on_air: AddressValues, shown: Container[str] = ()) -> dict[str, float]:
        """Where the controls of a device would stand that show what is on air: levels in 0..1, a call that is on air 1;
        the last binding of a control counts. shown: encoders that have a ring of lamps; others are left out; on_air:
        the values of addresses."""
        mine = (
            binding
            for binding in self.bindings
            if binding.device == device and binding.bank in ("", self.bank_of(device))
        )
        mine = (binding for binding in mine if binding.relative is None or binding.control in shown)
        positions = ((binding.control, self._position(binding, on_air)) for binding in mine)
        return {control: position for control, position in positions if position is not None}

    def _position(self, binding: Binding, on_air: AddressValues) -> float | None:
        if binding.target.bank is not None:
            return float(self.bank_of(binding.device) == binding.target.bank)
        values = on_air.get(binding.target.path, ())
        if not binding.target.is_level:
            return float(values[0] == binding.target.arguments[0]) if values and binding.target.arguments else None
        value = values[binding.target.axis] if binding.target.axis < len(values) else None
        return binding.position_of(float(value)) if isinstance(value, int | float) else None

    def take_off(self, panicked: Container[str], labels: Mapping[str, str]) -> None:
        """Takes the faders of characters out of the hands that hold them, after a panic: a stick that is held must not
        undo it. Each acts again once it crosses the value on air; without one, or without pick-up, once it is at rest.

        panicked: the characters by name; labels: what people call each of all characters, by name.
        """
        for binding, played in zip(self.bindings, self._played, strict=True):
            if played.last is not None and self._is_fader(binding) and _plays(binding, panicked, labels):
                played.engaged = False
                played.is_off = True

    def is_bound(self, device: str, control: str) -> bool:
        """Whether a control of a device plays anything, in whichever bank."""
        return (device, control) in self._of

    @property
    def controls(self) -> list[tuple[str, str]]:
        """The controls that are bound, each with its device."""
        return list(self._of)

    @property
    def waiting(self) -> dict[tuple[str, str], float]:
        """Where controls stand that wait to be picked up."""
        return {
            (binding.device, binding.control): played.last
            for binding, played in zip(self.bindings, self._played, strict=True)
            if played.last is not None and not played.engaged and self._is_fader(binding)
            if binding.pick_up or played.is_off
            if binding.bank in ("", self.bank_of(binding.device))
        }

    def crossings(self, device: str, on_air: AddressValues) -> dict[str, float]:
        """The controls of a device that wait to be picked up or to come to rest, and where each will act again.

        on_air: the values of addresses.
        """
        waiting = self.waiting
        positions = self.positions(device, on_air)
        for binding, played in zip(self.bindings, self._played, strict=True):
            is_there = binding.device == device and binding.bank in ("", self.bank_of(device))
            if played.is_off and is_there and not (binding.pick_up and binding.control in positions):
                positions[binding.control] = binding.position_of(0.0)
        return {control: positions[control] for name, control in waiting if name == device and control in positions}

    def hear(self, reading: Reading, on_air: AddressValues, number: int) -> list[OscMessage]:
        """What a reading plays. on_air: the values of addresses in a state, as surfaces are told them; number: the
        state's. A reading that is no number from 0 to 1 plays nothing."""
        if not 0.0 <= reading.value <= 1.0:  # NaN too
            return []
        messages = list[OscMessage]()
        for index in self._of.get((reading.device, reading.control), ()):
            binding = self.bindings[index]
            held = self._played[index].pressed and binding.button == "momentary"  # let go in another bank
            if held or not binding.bank or binding.bank == self.bank_of(reading.device):
                fader = self._faders[index]
                if fader is not None:
                    messages += self._move(index, fader, reading.value, on_air, number)
                else:
                    messages += self._play(index, reading, on_air, number)
        return messages

    def stand(self, reading: Reading, on_air: AddressValues, number: int) -> None:
        """Notes that a fader stands where the value on air is, as its device was told to: it acts when it is moved.

        reading: of the fader; on_air, number: as of `hear`.
        """
        for index in self._of.get((reading.device, reading.control), ()):
            binding = self.bindings[index]
            played = self._played[index]
            current = self._current(binding, on_air, number) if self._is_fader(binding) else None
            if current is not None and abs(binding.position_of(current) - reading.value) <= NEAR:
                played.last = reading.value
                played.sent = current
                played.engaged = True
                played.is_off = False

    def unplug(self, device: str, on_air: AddressValues, number: int) -> list[OscMessage]:
        """Forgets where a device's controls stand, and lets go of the buttons that were held; they wait for it.

        on_air, number: as of `hear`.
        """
        messages = []
        for index, binding in enumerate(self.bindings):
            if binding.device == device:
                if binding.button == "momentary" and self._played[index].pressed:
                    messages += self._send(index, binding.low, self._values(binding, on_air, number), number)
                self._played[index] = _Played()
        return messages

    def _play(self, index: int, reading: Reading, on_air: AddressValues, number: int) -> list[OscMessage]:
        binding = self.bindings[index]
        played = self._played[index]
        was_pressed = played.pressed
        played.pressed = reading.value > 0.0 if reading.key else reading.value >= PRESSED
        if binding.relative is not None:
            return self._turn(index, binding.steps(reading.value), on_air, number)
        if played.pressed == was_pressed:
            return []
        if binding.target.is_level:
            return self._switch(index, on_air, number)
        return self._call(binding) if played.pressed else []

    @staticmethod
    def _is_fader(binding: Binding) -> bool:
        return binding.target.is_level and binding.button is None and binding.relative is None

    def _call(self, binding: Binding) -> list[OscMessage]:
        if binding.target.bank is not None:
            self.choose_bank(binding.device, binding.target.bank)
            return []
        return [OscMessage(binding.target.path, binding.target.arguments)]

    def _move(
        self, index: int, fader: _Fader, position: float, on_air: AddressValues, number: int
    ) -> tuple[OscMessage, ...] | list[OscMessage]:
        """A fader is moved: it acts from the moment at which it crosses the value on air."""
        played = self._played[index]
        sent = self._sent.get(fader.path)
        before = played.last
        played.last = position
        values = sent[1] if sent is not None and sent[0] >= number else on_air.get(fader.path, ())
        current = _level(values, fader.axis)
        if played.is_off:
            played.is_off = not _comes_back(self.bindings[index], before, position, current)
            played.engaged = not played.is_off
        elif not fader.pick_up or current is None:
            played.engaged = True
        elif played.engaged and played.sent is not None:
            played.engaged = abs(current - played.sent) <= fader.near
        if not played.engaged and not played.is_off and current is not None:
            played.engaged = _reaches(before, position, self.bindings[index].position_of(current))
        if not played.engaged:
            return ()
        counts = self.bindings[index].leave_middle(position) if fader.has_dead_zone else position
        value = fader.low + fader.span * (counts if fader.curve == 1.0 else math.pow(counts, fader.curve))
        if not fader.alone:
            return self._send(index, value, values, number)
        self._sent[fader.path] = number, (value,)
        played.sent = value
        return (OscMessage(fader.path, (value,)),)

    def _turn(self, index: int, steps: int, on_air: AddressValues, number: int) -> list[OscMessage]:
        binding = self.bindings[index]
        values = self._values(binding, on_air, number)
        current = _level(values, binding.target.axis)
        lowest, highest = sorted((binding.low, binding.high))
        turned = (binding.low if current is None else current) + steps * binding.step * (binding.high - binding.low)
        return self._send(index, min(highest, max(lowest, turned)), values, number)

    def _switch(self, index: int, on_air: AddressValues, number: int) -> list[OscMessage]:
        """A button that moves a level is pressed or let go."""
        binding = self.bindings[index]
        played = self._played[index]
        values = self._values(binding, on_air, number)
        if binding.button == "momentary":
            return self._send(index, binding.high if played.pressed else binding.low, values, number)
        if not played.pressed:
            return []
        current = _level(values, binding.target.axis)
        is_high = current is not None and abs(current - binding.high) < abs(current - binding.low)
        return self._send(index, binding.low if is_high else binding.high, values, number)

    def _current(self, binding: Binding, on_air: AddressValues, number: int) -> float | None:
        """The value that a binding moves, as it is on air or was sent since."""
        return _level(self._values(binding, on_air, number), binding.target.axis)

    def _values(self, binding: Binding, on_air: AddressValues, number: int) -> tuple[Argument, ...]:
        path = binding.target.path
        sent = self._sent.get(path)
        return sent[1] if sent is not None and sent[0] >= number else on_air.get(path, ())

    def _send(self, index: int, value: float, now: tuple[Argument, ...], number: int) -> list[OscMessage]:
        """The message that moves one axis of a target and leaves its others where they are now."""
        target = self.bindings[index].target
        axis = target.axis
        needed = sum(not each.may_be_left_out for each in target.values)
        count = max(needed, axis + 1, len(now) if needed < len(target.values) else 0)
        if target.values[axis].kind == "switch":
            value = float(value >= PRESSED)
        values: tuple[Argument, ...] = (value,)
        if count > 1:
            others = now if len(now) == count else (*now, *(0.0,) * count)[:count] if needed < count else (0.0,) * count
            values = (*others[:axis], value, *others[axis + 1 :])
        self._sent[target.path] = number, values
        self._played[index].sent = value
        return [OscMessage(target.path, values)]


def _fader_of(binding: Binding) -> _Fader:
    target = binding.target
    span = binding.high - binding.low
    alone = len(target.values) == 1 and target.values[0].kind != "switch"
    near = MOVED * abs(span)
    return _Fader(
        target.path,
        target.axis,
        alone,
        binding.low,
        span,
        binding.curve,
        binding.pick_up,
        near,
        binding.dead_zone > 0.0,
    )


def _plays(binding: Binding, characters: Container[str], labels: Mapping[str, str]) -> bool:
    """Whether a binding plays one of these characters. labels: what people call each of all characters, by name."""
    if not binding.target.character:
        return False
    try:
        meant = characters_meant(binding.target.character, labels)
    except OscError:  # nobody who is there
        return False
    return any(name in characters for name in (labels if meant == (ALL,) else meant))


def _comes_back(binding: Binding, before: float | None, position: float, current: float | None) -> bool:
    """Whether a fader that a panic took off is where it may act again: at the value on air, or at rest.

    before: where it stood, None where that is not known; position: where it is; current: the value on air.
    """
    at = binding.position_of(0.0)
    if binding.pick_up and current is not None:
        at = binding.position_of(current)
    elif abs(position - at) <= NEAR or abs(position - MIDDLE) < binding.dead_zone:
        return True
    return _reaches(before, position, at)


def _reaches(before: float | None, position: float, at: float) -> bool:
    """Whether a control goes across a position of its way (at), or stands near it where it was not read before.

    before: where it stood; position: where it is.
    """
    return abs(position - at) <= NEAR if before is None else (before - at) * (position - at) <= 0.0


def _level(values: tuple[Argument, ...], axis: int) -> float | None:
    """The number that an axis stands at; None where it has none."""
    value = values[axis] if axis < len(values) else None
    if type(value) is float and math.isfinite(value):
        return value  # what nearly all are
    return float(value) if isinstance(value, int | float) and math.isfinite(value) else None
