"""The leases of a running show as a program takes, releases and switches them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar, get_args

from omote.perform.limits import check_known
from omote.show import messages as wire

Sent = TypeVar("Sent")
"""What a call gives: None where it blocks until the show has obeyed, something to await under asyncio."""


class RemoteLeases(Generic[Sent]):
    """Who may command what. Parts: `face`, `expression`, `brows`, `eyes`, `mouth`, `channels`, `head`, `gaze`, `place`
    of a character, `light` and `framing` of the character `*`, which is the scene; `*` is all parts."""

    def __init__(self, send: Callable[[wire.FromClient], Sent], next_id: Callable[[], str]) -> None:
        self.send, self.next_id = send, next_id

    def lease(self, character: str, part: wire.LeasePart = "*", *, take_over: bool = False) -> Sent:
        """Holds a part of a character, so that nobody else plays it. ValueError where another holds it, with its name,
        but for `take_over`; where leases are off; and for a part that there is not."""
        return self.send(wire.Lease(self.next_id(), character, _checked(part), take_over))

    def release_lease(self, character: str, part: wire.LeasePart = "*") -> Sent:
        """Releases a part; `*`: all that this program holds. ValueError where another holds it."""
        return self.send(wire.ReleaseLease(self.next_id(), character, _checked(part)))

    def set_leases(self, on: bool) -> Sent:
        """Switches leases on, which makes this program the stage manager, or off. ValueError where another is that."""
        return self.send(wire.SetLeases(self.next_id(), on))


def _checked(part: wire.LeasePart) -> wire.LeasePart:
    check_known(part, get_args(wire.LeasePart), "part")
    return part
