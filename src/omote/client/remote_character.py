"""A character of a running show as a program plays it: the calls of a performer, each one message on the wire."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar, get_args

from msgspec import structs

from omote.client.derived_methods import add_methods, named
from omote.client.message_check import pack_numbers
from omote.client.remote_frame import frame_in
from omote.client.sounds import split_sound
from omote.inputs.voices.spoken_text import WantedSpeech, check_wanted
from omote.model.body.pose import Pose
from omote.model.body.pose_regions import POSE_REGIONS, check_pose_region
from omote.model.known_names import check_play_region
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.packed_pose import pack_pose, pose_numbers
from omote.perform.frame import Frame, check_target_kind
from omote.perform.layers.layer_names import check_driven, check_layer, check_part
from omote.perform.limits import check_known, check_switch
from omote.perform.scene.character_names import ALL
from omote.perform.speech.speech_timing import TIMING_KINDS
from omote.perform.speech.spelling import check_language
from omote.show.declaration import CharacterCommand, ClientMessage
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.calls import CallExpression, CallFace, CallPose
from omote.show.objects.hand.pads import MovePad
from omote.show.objects.layers import SetLayer
from omote.show.objects.motion import LookAt
from omote.show.objects.sources import Drive, Source, StreamKind
from omote.show.objects.speech import USUAL_VOICE, Say
from omote.show.objects.state import CharacterState, Place, State

STREAM_KINDS: tuple[StreamKind, ...] = get_args(StreamKind)
Sent = TypeVar("Sent")
"""What a call gives: None where it blocks until the show has obeyed, something to await under asyncio."""
Said = TypeVar("Said")
"""What `say` gives: something to wait for, under asyncio after it was awaited."""


class CharacterLink(Protocol[Sent, Said]):
    """What a character needs of the show that it is in."""

    send: Callable[[ClientMessage], Sent]
    next_id: Callable[[], str]
    drive: Callable[[Source, Drive], Sent]
    speak: Callable[[Say, bytes | WantedSpeech | None], Said]

    @property
    def state(self) -> State:
        """The newest state."""

    def find_character(self, name: str) -> str:
        """The name of the character that a name or a label means."""


class RemoteCharacter(Generic[Sent, Said]):
    """A character of a running show: what `omote.Performer` has, over the wire.

    Each call raises ValueError with the show's reason where it is rejected, ConnectionError where the show does not
    come back.
    """

    def __init__(self, name: str, show: CharacterLink[Sent, Said]) -> None:
        self.name = name
        self._show = show

    @property
    def frame(self) -> Frame:
        """What it has on air, in the newest state; ValueError where it is no longer in the scene."""
        state = self._show.state
        return frame_in(state, self._state())

    @property
    def place(self) -> Place:
        """Where it is; ValueError as `frame`."""
        return self._state().place

    @property
    def presence(self) -> float:
        """How much of it is on the stage, 0..1; ValueError as `frame`."""
        return self._state().presence

    def call_face(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> Sent:
        """Brings a face of this name on air from whatever is showing; `math.inf` seconds wait for `fade_face`. easing:
        the name of the curve."""
        return self._show.send(CallFace(self.name, self._show.next_id(), name, _or_by_hand(seconds), easing))

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
        of it, 0 to 1. name: of the expression; easing: the name of the curve."""
        where = None if region is None else check_play_region(region)
        by_hand = _or_by_hand(seconds)
        return self._show.send(CallExpression(self.name, self._show.next_id(), name, by_hand, easing, where, strength))

    def call_pose(
        self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING, region: str | None = None
    ) -> Sent:
        """Brings a pose on air from whatever the figure does, all of it or in one region alone; `math.inf` seconds wait
        for `fade_pose`. name: of the pose; easing: the name of the curve; region: of the figure."""
        where = None if region is None else check_pose_region(region)
        return self._show.send(CallPose(self.name, self._show.next_id(), name, _or_by_hand(seconds), easing, where))

    def drive(
        self,
        channels: Mapping[str, float],
        *,
        layer: str = "playback",
        head: tuple[float, float, float] | None = None,
        gaze: tuple[float, float] | None = None,
        found: bool = True,
        smoothing: float = 0.0,
        body: Pose | None = None,
    ) -> Sent:
        """One frame of a source of this program: the newest wins, and the layer follows it without a jump. The same
        names in each frame; radians for head and gaze; after half a second without a frame the layer fades out.
        smoothing: seconds, to 2, in which a step is followed, 0 as its layer is. channels: weights by name; found:
        whether the source finds a face now; body: the pose of the performer's body, in place of what is called of the
        figure."""
        if not isinstance(channels, Mapping):
            raise TypeError(f"the channels are {channels!r}; give their weights by name, as {{'jawOpen': 0.5}}")
        kind = next(stream_kind for stream_kind in STREAM_KINDS if stream_kind == check_driven(layer))
        source = Source(f"{layer} {self.name}", kind, list(channels), [self.name], smoothing=smoothing)
        values = pack_numbers(channels.values(), "the weight of a channel")
        whole = (b"", []) if body is None else (pack_pose(pose_numbers(body)), [*POSE_REGIONS])
        packed, seen = whole
        return self._show.drive(source, Drive(0, values, head, gaze, found, body=packed, seen=seen))

    def move_pad(self, name: str, x: float | None = None, y: float | None = None, z: float | None = None) -> Sent:
        """Moves the point of a pad of the show (name), -1 to 1 for each of its dimensions: what it plays shows the
        mixture of its looks there. What is not given of x, y and z stays."""
        return self._show.send(MovePad(self.name, name, x, y, z))

    def set_layer(
        self, layer: str, *, region: str | None = None, influence: float | None = None, on: bool | None = None
    ) -> Sent:
        """Sets how much of a layer shows (influence, 0 to 1), in a region or everywhere, or switches it; what is on air
        follows."""
        part = None if region is None else check_part(region)
        return self._show.send(SetLayer(self.name, check_layer(layer), part, influence, on))

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
        by name a `gaze_point`, a `character`, the camera of a `stage`. kind: one of these words; yaw, pitch: of a
        direction; x, y, z: of a point."""
        target = self._show.find_character(name) if kind == "character" else name
        return self._show.send(LookAt(self.name, check_target_kind(kind), target, yaw, pitch, x, y, z))

    def say(
        self,
        text: str = "",
        *,
        timing: str = "text",
        marks: Sequence[str] = (),
        times: Sequence[float] = (),
        language: str = "en",
        seconds: float | None = None,
        sound: str | bytes | Path | None = "",
        delay: float = 0.0,
        offset: float = 0.0,
        queue: bool = False,
        key: str = "",
        voice: str = "",
    ) -> Said:
        """Speaks: lips move in time with a sound that something else plays, or, where `sound` is one (the bytes of a
        WAV, MP3 or Ogg, the Path of its file, or the key that `send_sound` gave), a stage. Marks are words, characters,
        or mouth shapes (visemes, azure, rhubarb), each with the time at which it begins; with text alone the times are
        estimated. `wait()` of what it gives waits until it is over; `frame.speech` tells how far it is. timing: the
        kind of timing; times, seconds, delay and offset: seconds; language: of the text; queue: whether it waits for
        what is said now; marks: those words, characters or shapes; key: what to call the speech; voice: the name of a
        voice of the show that speaks the text, whose phones give the times (`en-gb`, `de+f2`)."""
        kind = check_known(timing, TIMING_KINDS, "kind of timing")
        packed = pack_numbers(times, "a time (seconds)")
        after = check_switch(queue, "the switch queue")
        sent, data = split_sound(sound)
        wanted = _wanted_of(voice, text, marks, sound)
        if text == "" and not marks and not sound:
            raise ValueError("there is nothing to say; give a text, marks or a sound")
        message = Say(self.name, name := self._show.next_id(), text, kind, _listed(marks), packed)
        rest = {"seconds": seconds, "sound": sent, "delay": delay, "offset": offset, "queue": after}
        spoken = structs.replace(message, language=check_language(language), key=key or name, **rest)
        return self._show.speak(spoken, wanted or data)

    def build(self, command: type[ClientMessage], fields: Mapping[str, Any]) -> Sent:
        """Sends a command to it. command: its kind; fields: their values by name, without the character and the id."""
        return self._show.send(command(character=self.name, **named(command, self._show.next_id), **fields))

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Callable[..., Sent]:
            """The methods that commands declare."""

    def __repr__(self) -> str:
        """Which character it is."""
        return f"<character {self.name!r} of a running show>"

    def _state(self) -> CharacterState:
        characters = self._show.state.characters
        if self.name == ALL:
            raise ValueError(f"{ALL} means all characters; what is on air is of one: {', '.join(characters)}")
        return characters[check_known(self.name, characters, "character")]


def _or_by_hand(seconds: object) -> float | None:
    if isinstance(seconds, bool) or not isinstance(seconds, Real):
        raise TypeError(f"seconds is {seconds!r:.80}; give a number, or math.inf, which waits for the T-bar")
    return None if seconds == math.inf else float(seconds)


def _wanted_of(voice: object, text: str, marks: Sequence[str], sound: object) -> WantedSpeech | None:
    """What a voice is to say; None without one. ValueError where marks or a sound say already how it is said."""
    if not isinstance(voice, str):
        raise TypeError(f"the voice is {voice!r:.80}; give its name, such as {USUAL_VOICE!r}")
    if voice and (marks or sound):
        raise ValueError("a voice came with marks or a sound; give one of them: a voice makes its own sound and times")
    return check_wanted(WantedSpeech(text, voice)) if voice else None


def _listed(marks: Sequence[str]) -> list[str]:
    """Marks as a list; TypeError for a text, which would be its letters."""
    if isinstance(marks, str):
        raise TypeError(f"marks is the text {marks[:80]!r}; give a list, such as {marks.split()[:3]!r}")
    return list(marks)


OF_CHARACTERS = [kind for kind in CLIENT_MESSAGES if issubclass(kind, CharacterCommand)]
add_methods(RemoteCharacter, OF_CHARACTERS, filled=["character"])
