"""What of a device's data could not be obeyed, and why: one kind of error and one record for all inputs."""

from __future__ import annotations

from dataclasses import dataclass


class PacketError(ValueError):
    """What came cannot be obeyed, and why, in words for the operator."""


@dataclass(frozen=True)
class Rejection:
    """A message or packet that was not obeyed: when, whose it was, and why."""

    time: float
    sender: str
    reason: str
