"""What leaves a session: messages for clients, and requests that the server carries out."""

from __future__ import annotations

from dataclasses import dataclass

from omote.show import messages as wire


@dataclass(frozen=True)
class Outgoing:
    """A message for one client."""

    who: str
    message: wire.FromServer


@dataclass(frozen=True)
class KeepRequest:
    """A console's request to change the show file; the server carries it out."""

    who: str
    message: wire.KeepMessage
