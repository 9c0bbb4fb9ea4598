"""A device at a page: what it sends becomes readings, and what it is sent back is kept beside it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.page_devices.device_feedback import DeviceFeedback
from omote.inputs.page_devices.device_health import DeviceHealth
from omote.inputs.presets.preset import Preset
from omote.inputs.reading import Reading
from omote.perform.cues.show_control import ShowControl
from omote.show.objects.bindings import SourceKind
from omote.show.objects.devices import DeviceState

KEY = "button"
"""A control of a pad whose name begins so is a key."""
STICKS = ("axis", "x", "y", "z", "rx", "ry", "rz")
REST = 0.5
DEAD = 0.06
"""Where an axis rests, and how far from there it counts as resting: sticks do not come back exactly."""


class PluggedDevice:
    """A device by its name. who: the client that has it, "" where it is gone; where: what that is called; heard: when
    something of it came last, of a hand by OSC; is_bound: whether a control of it is."""

    def __init__(
        self,
        name: str,
        kind: SourceKind,
        who: str,
        where: str,
        now: float,
        preset: Preset | None,
        is_bound: Callable[[str], bool] = lambda _: False,
    ) -> None:
        self._is_bound = is_bound
        self.name = name
        self.kind = kind
        self.who = who
        self.where = where
        self.health = DeviceHealth(now)
        self.newest: Reading | None = None
        self.heard = now
        self.came = 0  # readings that the log was not told of yet
        self.plug(kind, who, where, preset)

    def plug(self, kind: SourceKind, who: str, where: str, preset: Preset | None) -> None:
        """Notes that it is there, for the first time or again: nothing is known of how its controls and lamps are.
        kind: midi, gamepad or space_mouse, or osc of a hand that a program sends; who: the page's client; where: what
        that is called; preset: how it is shown."""
        self.kind = kind
        self.who = who
        self.where = where
        self._decoder = MidiDecoder(self.name, self._is_bound)
        self._stood: dict[str, float] = {}
        self.use(preset)

    def use(self, preset: Preset | None) -> None:
        """Shows what is on air as a preset has it."""
        self.preset = preset
        made = (preset.lamps, preset.touches, preset.greeting) if preset else ()
        self.feedback = DeviceFeedback(*made)

    def feed(self, data: bytes) -> list[Reading]:
        """The readings of bytes of MIDI."""
        before = self._decoder.rejected
        readings = self._decoder.feed(data)
        self.health.note(0, self._decoder.rejected - before)
        return readings

    def take_show_control(self) -> list[ShowControl | str]:
        """Returns and clears what has come of MIDI Show Control; a sentence for what of it is wrong."""
        taken = [*self._decoder.show_control]
        self._decoder.show_control.clear()
        return taken

    def read(self, values: Mapping[str, float]) -> list[Reading]:
        """The readings of controls that stand elsewhere now; ValueError for a value that is no position."""
        for control, value in values.items():
            if not (math.isfinite(value) and 0.0 <= value <= 1.0):
                raise ValueError(f"{control} of {self.name} is {value}; give 0 to 1, a stick at rest is {REST}")
        rested = {control: _rested(control, value) for control, value in values.items()}
        moved = {control: value for control, value in rested.items() if self._stood.get(control) != value}
        self._stood |= moved
        return [Reading(self.name, control, value, control.startswith(KEY)) for control, value in moved.items()]

    def state(self, now: float, waiting: Mapping[str, float], bank: str, banks: list[str]) -> DeviceState:
        """What pages are told of it.

        now: seconds of the show's clock; waiting: controls to be picked up, and where they will be; bank: the one it is
        turned to; banks: all that it has.
        """
        health = self.health
        return DeviceState(
            name=self.name,
            kind=self.kind,
            where=self.where,
            plugged=bool(self.who),
            rate=round(health.rate(now), 1) if self.who else 0.0,
            heard=health.heard,
            rejected=health.rejected,
            values=dict(health.values),
            waiting=dict(waiting),
            bank=bank,
            banks=banks,
            preset=self.preset.name if self.preset else "",
        )


def _rested(control: str, value: float) -> float:
    """The position of a stick with a middle in which it rests, and an even way on from there to both ends."""
    if control.rstrip("0123456789") not in STICKS:
        return value
    way = (value - REST) / REST
    beyond = max(0.0, abs(way) - DEAD / REST) / (1.0 - DEAD / REST)
    return REST + math.copysign(beyond, way) * REST
