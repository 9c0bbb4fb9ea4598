"""A character of a running show as a program plays it: the calls of a performer, each one message on the wire."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from numbers import Real
from typing import Protocol, TypeVar, get_args

from omote.model.known_names import check_play_region
from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import Frame, check_target_kind
from omote.perform.layers.layer_names import check_driven, check_layer, check_part
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.server.client.remote_frame import frame_in
from omote.server.client.remote_speech import RemoteSpeech
from omote.server.client.single_floats import pack_numbers
from omote.show import messages as wire

STREAM_KINDS: tuple[wire.StreamKind, ...] = get_args(wire.StreamKind)
Sent = TypeVar("Sent")
"""What a call gives: None where it blocks until the show has obeyed, something to await under asyncio."""
Said = TypeVar("Said")
"""What `say` gives: something to wait for, under asyncio after it was awaited."""


class CharacterLink(Protocol[Sent, Said]):
    """What a character needs of the show that it is in."""

    send: Callable[[wire.FromClient], Sent]
    next_id: Callable[[], str]
    drive: Callable[[wire.Source, wire.Drive], Sent]
    speak: Callable[[wire.Say, bytes | None], Said]

    @property
    def state(self) -> wire.State:
        """The newest state."""

    def find_character(self, name: str) -> str:
        """The name of the character that a name or a label means."""


class RemoteCharacter(RemoteSpeech[Sent, Said]):
    """A character of a running show: what `omote.Performer` has, over the wire.

    Each call raises ValueError with the show's reason where it is rejected, ConnectionError where the show does not
    come back.
    """

    def __init__(self, name: str, show: CharacterLink[Sent, Said]) -> None:
        super().__init__(name, show.next_id, show.send, show.speak)
        self._show = show

    @property
    def frame(self) -> Frame:
        """What it has on air, in the newest state; ValueError where it is no longer in the scene."""
        state = self._show.state
        return frame_in(state, self._state())

    @property
    def place(self) -> wire.Place:
        """Where it is; ValueError as `frame`."""
        return self._state().place

    @property
    def presence(self) -> float:
        """How much of it is on the stage, 0..1; ValueError as `frame`."""
        return self._state().presence

    def call_face(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> Sent:
        """Brings a face on air from whatever is showing; `math.inf` seconds wait for `fade_face`."""
        return self._send(wire.CallFace(self.name, self._show.next_id(), name, _or_by_hand(seconds), easing))

    def call_expression(
        self,
        name: str,
        *,
        seconds: float = 1.0,
        easing: str = DEFAULT_EASING,
        region: str | None = None,
        strength: float = 1.0,
    ) -> Sent:
        """Brings an expression on air from whatever is showing, on the whole face or in one region of it alone;
        `math.inf` seconds wait for `fade_expression`, which moves no region that goes its own way. strength: how much
        of it, 0 to 1."""
        where = None if region is None else check_play_region(region)
        by_hand = _or_by_hand(seconds)
        return self._send(wire.CallExpression(self.name, self._show.next_id(), name, by_hand, easing, where, strength))

    def fade_face(self, x: float) -> Sent:
        """Moves the T-bar of the faces, 0 to 1."""
        return self._send(wire.FadeFace(self.name, x))

    def fade_expression(self, x: float) -> Sent:
        """Moves the T-bar of the expressions, 0 to 1."""
        return self._send(wire.FadeExpression(self.name, x))

    def release_face(self) -> Sent:
        """Lets go of the T-bar of the faces."""
        return self._send(wire.ReleaseFace(self.name))

    def release_expression(self) -> Sent:
        """Lets go of the T-bar of the expressions."""
        return self._send(wire.ReleaseExpression(self.name))

    def set_channel(self, name: str, value: float) -> Sent:
        """Adds an expression to the mix at once, -0.5 to 1.5; 0 takes it out."""
        return self._send(wire.SetChannel(self.name, name, value))

    def set_head(self, yaw: float, pitch: float, roll: float) -> Sent:
        """Turns the head, radians: + is the character's left, up, tilt to its left."""
        return self._send(wire.SetHead(self.name, yaw, pitch, roll))

    def set_gaze(self, yaw: float, pitch: float) -> Sent:
        """Turns the eyes relative to the head, radians: + is the character's left, up."""
        return self._send(wire.SetGaze(self.name, yaw, pitch))

    def drive(
        self,
        channels: Mapping[str, float],
        *,
        layer: str = "playback",
        head: tuple[float, float, float] | None = None,
        gaze: tuple[float, float] | None = None,
        found: bool = True,
        smoothing: float = 0.0,
    ) -> Sent:
        """One frame of a source of this program: the newest wins, and the layer follows it without a jump. The same
        names in each frame; radians for head and gaze; after half a second without a frame the layer fades out.
        smoothing: seconds, to 2, in which a step is followed, 0 as its layer is."""
        if not isinstance(channels, Mapping):
            raise TypeError(f"the channels are {channels!r}; give their weights by name, as {{'jawOpen': 0.5}}")
        kind = next(each for each in STREAM_KINDS if each == check_driven(layer))
        source = wire.Source(f"{layer} {self.name}", kind, list(channels), [self.name], smoothing=smoothing)
        values = pack_numbers(channels.values(), "the weight of a channel")
        return self._show.drive(source, wire.Drive(0, values, head, gaze, found))

    def set_layer(
        self, layer: str, *, region: str | None = None, influence: float | None = None, on: bool | None = None
    ) -> Sent:
        """Sets how much of a layer shows, 0 to 1, in a region or everywhere, or switches it; what is on air follows."""
        part = None if region is None else check_part(region)
        return self._send(wire.SetLayer(self.name, check_layer(layer), part, influence, on))

    def set_motion(
        self,
        liveliness: float | None = None,
        *,
        blinks: float | None = None,
        gaze: float | None = None,
        breath: float | None = None,
        seed: int | None = None,
        idle: bool | None = None,
    ) -> Sent:
        """Sets how much the character moves by itself: 0 nothing, 0.5 as people move, 1 lively; the details 0 to 2;
        idle: whether it moves as people do while its tracker is lost."""
        return self._send(wire.SetMotion(self.name, liveliness, blinks, gaze, breath, seed, idle=idle))

    def look_at(
        self,
        kind: str,
        name: str = "",
        *,
        yaw: float = 0.0,
        pitch: float = 0.0,
        x: float = 0.0,
        y: float = 0.0,
        z: float = 2.0,
    ) -> Sent:
        """Chooses whom or what the eyes look at: `ahead`, a `direction` of the house (radians), a `point` (metres), or
        by name a `gaze_point`, a `character`, the camera of a `stage`."""
        found = self._show.find_character(name) if kind == "character" else name
        return self._send(wire.LookAt(self.name, check_target_kind(kind), found, yaw, pitch, x, y, z))

    def set_home(self, face: str, *, seconds: float = 2.0) -> Sent:
        """Chooses the face that a second panic brings on air."""
        return self._send(wire.SetHome(self.name, face, seconds))

    def panic(self) -> Sent:
        """Goes neutral and holds still, now; again: brings the home face."""
        return self._send(wire.Panic(self.name))

    def __repr__(self) -> str:
        """Which character it is."""
        return f"<character {self.name!r} of a running show>"

    def _state(self) -> wire.CharacterState:
        characters = self._show.state.characters
        if self.name == ALL:
            raise ValueError(f"{ALL} means all characters; what is on air is of one: {', '.join(characters)}")
        return characters[check_known(self.name, characters, "character")]


def _or_by_hand(seconds: object) -> float | None:
    if isinstance(seconds, bool) or not isinstance(seconds, Real):
        raise TypeError(f"seconds is {seconds!r:.80}; give a number, or math.inf, which waits for the T-bar")
    return None if seconds == math.inf else float(seconds)
