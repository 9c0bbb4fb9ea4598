"""Hands that other programs send by OSC, gloves, Leap and telephones: each a device, its axes the controls.

`/omote/{character}/hand/{right or left}/{axis}` with one number; a bundle a frame. `opening` and `curl1` to `curl4`
(from the index to the little finger) are 0 to 1, `yaw`, `pitch` and `roll` radians.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterator

from omote.inputs.osc_packet import OscError, OscMessage
from omote.inputs.reading import Reading
from omote.show.osc import ROOT

SIDES = ("right", "left")
FINGERS = ("opening", "curl1", "curl2", "curl3", "curl4")
ANGLES = ("yaw", "pitch", "roll")
HAND_AXES = (*FINGERS, *ANGLES)
"""The controls of a hand. What sends them sends them all the time, so none is picked up as a fader is."""
FARTHEST = math.pi / 2
"""Radians of a wrist, either way; at rest such an axis reads one half."""


class OscHands:
    """The newest value of each axis, until it is taken."""

    def __init__(self) -> None:
        self._newest: dict[tuple[str, str], tuple[float, str]] = {}

    def hear(self, message: OscMessage, host: str, characters: Container[str]) -> bool:
        """Takes a message, where it is of a hand; OscError with what was expected for one that cannot be read.

        host: of its sender; characters: the names of those that there are.
        """
        parts = message.address.split("/")
        if len(parts) < 4 or parts[1] != ROOT or parts[3] != "hand":
            return False
        if len(parts) != 6 or parts[4] not in SIDES or parts[5] not in HAND_AXES:
            axes = ", ".join(HAND_AXES)
            raise OscError(f"{message.address[:80]}: expected /{ROOT}/CHARACTER/hand/right or left/ one of {axes}")
        if parts[2] not in characters:
            raise OscError(f"{message.address[:80]}: there is no character {parts[2][:40]!r}")
        value = _number(message)
        position = value if parts[5] in FINGERS else 0.5 + 0.5 * value / FARTHEST
        self._newest[f"Hand {parts[2]} {parts[4]}", parts[5]] = min(1.0, max(0.0, position)), host
        return True

    def take(self) -> Iterator[tuple[str, Reading]]:
        """What has come since the last call, each with the host that sent it: of an axis the newest alone."""
        newest = self._newest
        self._newest = {}
        for (device, axis), (position, host) in newest.items():
            yield host, Reading(device, axis, position)


def _number(message: OscMessage) -> float:
    value = message.arguments[0] if len(message.arguments) == 1 else None
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise OscError(f"{message.address[:80]} {str(message.arguments)[:60]}: expected one finite number")
    return float(value)
