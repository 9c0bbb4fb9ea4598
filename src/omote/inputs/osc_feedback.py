"""What a control surface is told by OSC: all that it could have sent, as it is on air now."""

from __future__ import annotations

import math
from collections.abc import Mapping

from omote.inputs.osc_addresses import ROOT
from omote.inputs.osc_packet import Argument
from omote.show.messages import CallState, State

Told = Mapping[str, tuple[Argument, ...]]

QUIET_SECONDS = 0.3
"""Seconds after a surface's own message in which that address is not told to it: its fader is in a hand."""
REST = (0.0,)


def tell_state(state: State, character: str) -> dict[str, tuple[Argument, ...]]:
    """Each address with the values that it has; a channel that has no weight is left out."""
    own = f"/{ROOT}/{character}"
    return {
        f"{own}/face": (_named(state.faces, state.face_call),),
        f"{own}/expression": (_named(state.expressions, state.expression_call),),
        f"{own}/head": tuple(map(_degrees, state.head)),
        f"{own}/gaze": tuple(map(_degrees, state.gaze)),
        f"{own}/fade/face": (state.face_fader,),
        f"{own}/fade/expression": (state.expression_fader,),
        f"/{ROOT}/light": (_named(state.light, state.light_call),),
        **{f"{own}/channel/{name}": (weight,) for name, weight in state.channels.items()},
    }


class Feedback:
    """What one surface was told last, so that it is told what is new alone."""

    def __init__(self) -> None:
        self._told: Told = {}
        self._sent: dict[str, float] = {}

    def note(self, address: str, now: float) -> None:
        """Notes that the surface itself has sent to an address."""
        self._sent[address] = now

    def news(self, values: Told, now: float) -> dict[str, tuple[Argument, ...]]:
        """What has changed since the last call; a channel that is gone stands at rest."""
        self._sent = {address: sent for address, sent in self._sent.items() if now - sent < QUIET_SECONDS}
        gone = {address: REST for address in self._told if address not in values and self._told[address] != REST}
        wanted = {**gone, **values}
        news = {a: v for a, v in wanted.items() if a not in self._sent and self._told.get(a) != v}
        self._told = {**self._told, **news}
        return news


def _named(mix: Mapping[str, float], call: CallState | None) -> str:
    """The name that is called, else the one that weighs most."""
    return call.target if call is not None else max(mix, key=lambda name: mix[name])


def _degrees(angle: float) -> float:
    return round(math.degrees(angle), 4)
