"""Sends the faces on air to other programs once a tick; never waits, whoever hears it."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Callable, Mapping, Sequence

from omote.inputs.face_output.face_target import FaceTarget, encode_face
from omote.inputs.face_output.unit_weights import UnitWeights
from omote.inputs.page_devices.device_health import SourceCounts
from omote.show.messages import CharacterState, State
from omote.show.session import ShowSession


class FaceOutput:
    """The programs that faces are sent to. session: the one that plays."""

    def __init__(self, targets: Sequence[FaceTarget], session: Callable[[], ShowSession]) -> None:
        self._targets, self._session = tuple(targets), session
        self._datagrams = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._datagrams.setblocking(False)
        self._units: tuple[object, UnitWeights] | None = None

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """None: it is no source."""
        return []

    def hear(self, now: float) -> None:
        """There is nothing to hear."""

    def tell(self, state: State, now: float) -> None:
        """Sends each target its character; one that has gone is not sent."""
        weights: dict[str, Mapping[str, float]] = {}
        for target in self._targets:
            name = target.character or next(iter(state.characters), "")
            character = state.characters.get(name)
            if character is None:
                continue
            if name not in weights:
                weights[name] = self._weigh(character)
            for packet in encode_face(target, character, weights[name], now):
                with contextlib.suppress(OSError):  # full, or there is no way to that host
                    self._datagrams.sendto(packet, (target.host, target.port))

    async def close(self) -> None:
        """Closes the socket."""
        self._datagrams.close()

    def _weigh(self, character: CharacterState) -> Mapping[str, float]:
        cast = self._session().cast
        if self._units is None or self._units[0] is not cast:
            self._units = cast, UnitWeights(cast.expressions)
        return self._units[1].weigh(character.expressions, character.channels)
