"""Channels, head and gaze under a hand, and whose hands move what."""

from __future__ import annotations

from typing import Annotated

from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS
from omote.perform.performer import Performer
from omote.show.declaration import ChannelName, CharacterCommand, ServerMessage
from omote.show.objects.state import held_by_hands, in_degrees
from omote.show.osc import Osc, Value, angle


class SetChannel(CharacterCommand, frozen=True):
    """The weight of one channel (a blendshape weight; any expression's name), -0.5..1.5."""

    plays = "channels"
    hand = "plays"
    osc = (
        Osc(
            "channel/{name}",
            "sets the weight of a unit or of any expression, beside the calls",
            ("value",),
            on_air=lambda state, name: (held_by_hands(state).channels.get(name, 0.0),),
            reported=lambda state: ((name,) for name in held_by_hands(state).channels),
        ),
    )

    name: ChannelName
    value: Annotated[float, Value(low=CHANNEL_LOWEST, high=CHANNEL_HIGHEST, name="weight")]

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_channel(self.name, self.value)

    def control(self, character: str) -> str:
        """The fader of a channel."""
        return f"{super().control(character)}:{self.name}"


class SetHead(CharacterCommand, frozen=True):
    """The head's direction in radians: + is the character's left, up, tilt to its left."""

    plays = "head"
    hand = "plays"
    osc = (
        Osc(
            "head",
            "turns the head",
            ("yaw", "pitch", "roll"),
            on_air=lambda state: in_degrees(*held_by_hands(state).head),
        ),
    )

    yaw: Annotated[float, angle(HEAD_LIMITS["yaw"])]
    pitch: Annotated[float, angle(HEAD_LIMITS["pitch"])]
    roll: Annotated[float, angle(HEAD_LIMITS["roll"])]

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_head(self.yaw, self.pitch, self.roll)


class SetGaze(CharacterCommand, frozen=True):
    """The gaze relative to the head in radians: + is the character's left, up.

    At most 0.698 sideways, 0.524 up or down: beyond, the iris would go out of sight.
    """

    plays = "gaze"
    hand = "plays"
    osc = (
        Osc(
            "gaze",
            "turns the eyes, relative to the head",
            ("yaw", "pitch"),
            on_air=lambda state: in_degrees(*held_by_hands(state).gaze),
        ),
    )

    yaw: Annotated[float, angle(GAZE_LIMITS["yaw"])]
    pitch: Annotated[float, angle(GAZE_LIMITS["pitch"])]

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_gaze(self.yaw, self.pitch)


class Hands(ServerMessage, frozen=True):
    """What hands at other consoles have moved within the last second, and the name of the console: complete, to each
    console when it changes, and once a second. Keys are a character and the tag of a message
    (`one/fade_face`, `one/set_head`), of a channel with its name (`one/set_channel:jawOpen`), of a layer with its name
    and its region (`one/set_layer:tracker:mouth`)."""

    hands: dict[str, str]
