"""Bindings at a show session: readings and times in, played by the same door as OSC."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable

from omote.inputs.bindings.bindings import Bindings
from omote.inputs.osc_feedback import AddressValues
from omote.inputs.osc_input import OscInput
from omote.inputs.reading import Reading
from omote.show.objects.state import State
from omote.show.session import ShowSession


class BindingInput:
    """Carries out on a session what devices read. osc: has the counts of what was heard and rejected; on_air: what
    faders are picked up by, encoders turn on from and devices show."""

    def __init__(self, bindings: Bindings, session: Callable[[], ShowSession]) -> None:
        self.bindings = bindings
        self.osc = OscInput(session, kind="device", title="")
        self.on_air = AddressValues()
        self._number = 0
        self._panics: dict[str, int] = {}

    def note_state(self, state: State) -> None:
        """Notes what is on air; a panic takes what it rests out of the hands at devices."""
        panics = {name: character.panics for name, character in state.characters.items()}
        if panics != self._panics:
            panicked = [name for name, count in panics.items() if count > self._panics.get(name, count)]
            self.bindings.take_off(panicked, {name: character.label for name, character in state.characters.items()})
            self._panics = panics
        self.on_air = AddressValues(state)
        self._number = state.number

    def hear(self, readings: Iterable[Reading], now: float) -> None:
        """Plays readings in their order; of channels that several set at once the newest counts.

        now: seconds of the show's clock.
        """
        for device, moved in itertools.groupby(readings, lambda reading: reading.device):
            messages = [
                message for reading in moved for message in self.bindings.hear(reading, self.on_air, self._number)
            ]
            if messages:
                self.osc.obey_all((device, 0), messages, now)

    def stand(self, reading: Reading) -> None:
        """Notes where a fader stands that was sent there."""
        self.bindings.stand(reading, self.on_air, self._number)

    def unplug(self, device: str, now: float) -> None:
        """Notes that a device is gone; its bindings wait for it. now: seconds of the show's clock."""
        for message in self.bindings.unplug(device, self.on_air, self._number):
            self.osc.obey((device, 0), message, now)
        self.osc.leave((device, 0))
