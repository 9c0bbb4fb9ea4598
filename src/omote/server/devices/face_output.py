"""Sends the faces on air to other programs once a tick; never waits, whoever hears it."""

from __future__ import annotations

import socket
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from omote.builtin import load_cast
from omote.inputs.face_output.face_target import FaceTarget, encode_face, find_sent
from omote.inputs.face_output.figure_bones import FigureBones
from omote.inputs.face_output.unit_weights import UnitWeights
from omote.inputs.trackers.head_angles import BoneTurn
from omote.interchange.formats.error_reasons import explain_error
from omote.model.body.pose import Pose
from omote.model.known_names import GENERIC
from omote.server.devices.device_source import DeviceSource
from omote.show.objects.state import CharacterState, State
from omote.show.session import ShowSession

FAULT_SECONDS = 2.0
"""For which a fault is told after it was seen last: of two packets to nobody every other one is answered."""


def _open() -> socket.socket:
    datagrams = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    datagrams.setblocking(False)
    return datagrams


@dataclass(eq=False)
class FaceReceiver:
    """A program that a face is sent to, by a socket of its own, which hears that nobody is there (ICMP).

    sent: packets; fault: why they do not arrive, or "", and since when it was not seen; character: whose face, "" where
    nobody is called so; absence_told: whether that was said.
    """

    target: FaceTarget
    sent: int = 0
    fault: str = ""
    character: str = ""
    absence_told: bool = False
    seen: float = 0.0
    datagrams: socket.socket = field(default_factory=_open)

    def send(self, packets: Sequence[bytes], now: float) -> str:
        """Sends packets; returns a fault that is new, or "". packets: of one face; now: seconds, monotonic."""
        before = self.fault
        if self.fault and now - self.seen > FAULT_SECONDS:
            self.fault = ""
        for packet in packets:
            try:
                if not self.sent:
                    self.datagrams.connect((self.target.host, self.target.port))
                self.datagrams.send(packet)
                self.sent += 1
            except BlockingIOError:
                pass  # the network is slower than we are
            except OSError as error:
                self.fault = _explain(self.target, error)
                self.seen = now
        return self.fault if self.fault and not before else ""


class FaceOutput(DeviceSource):
    """The programs that faces are sent to. session: the one that plays; report: says on the terminal what is wrong."""

    def __init__(
        self,
        targets: Sequence[FaceTarget],
        session: Callable[[], ShowSession],
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        self._session = session
        self._report = report
        self.receivers = [FaceReceiver(target) for target in targets]
        self._units: tuple[object, UnitWeights] | None = None

    def add(self, target: FaceTarget) -> None:
        """Sends a face there from now on."""
        self.receivers.append(FaceReceiver(target))
        if target.protocol == "vmc":
            _figure_bones()

    def remove(self, word: str) -> None:
        """Sends a target no more."""
        for receiver in [receiver for receiver in self.receivers if receiver.target.word == word]:
            self.receivers.remove(receiver)
            receiver.datagrams.close()

    def tell(self, state: State, now: float) -> None:
        """Sends each target its character; one that has gone is not sent.

        state: the newest; now: seconds, monotonic.
        """
        weights: dict[int, Mapping[str, float]] = {}
        for receiver in self.receivers:
            character = find_sent(receiver.target.character, state.characters)
            receiver.character = character.label if character else ""
            if character is None:
                self._tell_absence(receiver, state)
                continue
            receiver.absence_told = False
            if id(character) not in weights:
                weights[id(character)] = self.weigh(character)
            packets = encode_face(receiver.target, character, weights[id(character)], now, self.pose)
            if fault := receiver.send(packets, now):
                self._report(f"{fault}.")

    async def close(self) -> None:
        """Closes the sockets."""
        for receiver in self.receivers:
            receiver.datagrams.close()

    def _tell_absence(self, receiver: FaceReceiver, state: State) -> None:
        """Says once that nobody is called as a target says, with those who are there."""
        if receiver.absence_told or not receiver.target.character:
            return
        receiver.absence_told = True
        names = ", ".join(character.label or name for name, character in state.characters.items())
        self._report(
            f"nothing is sent to {receiver.target.word}: no character is called {receiver.target.character[:40]}, or "
            f"several are; there are {names}."
        )

    def pose(self, character: CharacterState) -> Mapping[str, BoneTurn]:
        """The bones of a character's figure; none while nothing is called of it. character: as stages get it."""
        if character.figure is None:  # nearly always
            return {}
        poses = {name: pose for name, pose in self._session().cast.poses.items() if isinstance(pose, Pose)}
        return _figure_bones().turns(character, poses) if poses else {}

    def weigh(self, character: CharacterState) -> Mapping[str, float]:
        """What a character has on air, as weights of all of ARKit's units."""
        cast = self._session().cast
        if self._units is None or self._units[0] is not cast:
            self._units = cast, UnitWeights(cast.expressions)
        return self._units[1].weigh(character.expressions, character.channels)


@cache
def _figure_bones() -> FigureBones:
    """Of the built-in figures, whose skeleton all have; made when the first target has a body, since that takes some
    frames."""
    cast = load_cast()
    assert cast.figures is not None
    return FigureBones(cast.figures, cast.faces[GENERIC].positions.astype(np.float64))


def _explain(target: FaceTarget, error: OSError) -> str:
    if isinstance(error, ConnectionRefusedError):
        return f"nobody hears the face that is sent to {target.word}: is the program there, and its receiver on"
    return f"the face cannot be sent to {target.word} ({explain_error(error)})"
