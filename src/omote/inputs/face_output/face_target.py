"""Where the face on air is sent, as it is typed after `--send`, and the packets for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.head_angles import BoneTurn, GazeAngles
from omote.inputs.trackers.live_link_face import FRAME_RATE, encode_live_link_face
from omote.inputs.trackers.tracker_protocols import API_NAME
from omote.inputs.trackers.vmc_messages import encode_vmc
from omote.inputs.trackers.vtube_studio.api_message import API_PORT
from omote.perform.scene.character_names import find_character
from omote.show.objects.state import CharacterState

SURFACE = "osc"
"""A surface that is told by OSC what is on air, as one that has subscribed."""
SEND_PORTS: Mapping[str, int] = {"vmc": 39539, "livelink": 11111, API_NAME: API_PORT, SURFACE: 9001}
"""What can be sent, and the port where receivers usually hear it."""
SEND_TITLES: Mapping[str, str] = {
    "vmc": "VMC (VSeeFace, Warudo, Unity)", "livelink": "Live Link Face (Unreal)", API_NAME: "VTube Studio PC",
    SURFACE: "OSC",
}  # fmt: skip
"""The same for people."""
HIGHEST_PORT = 65535
DEVICE = "OMOTE000-0000-0000-0000-000000000000"
"""The id by which a receiver of Live Link Face knows this sender."""


@dataclass(frozen=True)
class FaceTarget:
    """A program that the face on air is sent to: by which protocol, where, and whose face; "" for the first one's."""

    protocol: str
    host: str
    port: int
    character: str = ""

    @property
    def word(self) -> str:
        """The target as it is typed."""
        return f"{self.protocol}:{self.host}:{self.port}" + (f"={self.character}" if self.character else "")


def mean_gaze(character: CharacterState) -> GazeAngles:
    """Where both eyes look in the mean."""
    left_yaw, left_pitch, right_yaw, right_pitch = character.eyes
    return 0.5 * (left_yaw + right_yaw), 0.5 * (left_pitch + right_pitch)


def find_sent(name: str, characters: Mapping[str, CharacterState]) -> CharacterState | None:
    """The character that a target names, by name or label in any case, the first where it names none; None where there
    is none, or several are meant.

    characters: those on air, by name.
    """
    if not name:
        return next(iter(characters.values()), None)
    try:
        return characters[find_character(name, {key: state.label for key, state in characters.items()})]
    except ValueError:
        return None


def read_targets(text: str) -> tuple[FaceTarget, ...]:
    """The targets of a list as it is typed, `vmc:10.0.0.5,livelink:10.0.0.6:11111=dog`; none for ""; ValueError with
    what is wrong."""
    return tuple(_read_target(word.strip()) for word in text.split(",")) if text.strip() else ()


def _read_target(word: str) -> FaceTarget:
    where, _, character = word.partition("=")
    protocol, _, place = where.partition(":")
    protocol = protocol.strip().lower()
    if protocol not in SEND_PORTS:
        raise ValueError(f"there is no way to send a face {protocol[:60]!r}; there are {', '.join(SEND_PORTS)}")
    host, colon, port = place.partition(":")
    if not host.strip():
        raise ValueError(f"{word[:60]!r} names no receiver; give its address, such as {protocol}:127.0.0.1")
    if colon and not (port.isascii() and port.isdecimal() and 0 < int(port[:9]) <= HIGHEST_PORT):
        raise ValueError(
            f"the port of {word[:60]!r} is {port[:10] or 'left out'}; give a number from 1 to {HIGHEST_PORT}, such as "
            f"{protocol}:{host}:{SEND_PORTS[protocol]}"
        )
    return FaceTarget(protocol, host.strip(), int(port) if colon else SEND_PORTS[protocol], character.strip())


def encode_face(
    target: FaceTarget,
    character: CharacterState,
    weights: Mapping[str, float],
    time: float,
    figure: Callable[[CharacterState], Mapping[str, BoneTurn]] = lambda _: {},
) -> list[bytes]:
    """The packets of a character for a target; none where it is told otherwise. weights: of all of ARKit's units; time:
    seconds, as frames are numbered by; figure: gives the bones of its figure, for targets that have a body."""
    gaze = mean_gaze(character)
    if target.protocol == "vmc":
        return encode_vmc(
            {name[0].upper() + name[1:]: weights[name] for name in ARKIT_NAMES},
            character.head,
            gaze,
            time,
            figure(character),
        )
    if target.protocol == "livelink":
        values = [weights[name] for name in ARKIT_NAMES]
        frame = round(time * FRAME_RATE)
        packet = encode_live_link_face(
            values, character.head, gaze, device=DEVICE, subject=character.label, frame=frame
        )
        return [packet]
    return []
