"""Light and framing of the picture, and its fade to black."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.perform.easing import DEFAULT_EASING, HAND_SECONDS
from omote.perform.limits import LONGEST_CALL
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.perform.scene.framings import ShotSize, framing_of, held_by, size_in
from omote.perform.scene.scene import Scene
from omote.show.declaration import CallId, CharacterName, Name, RequestId, SceneCommand, Seconds, Session
from omote.show.objects.calls import seconds_of
from omote.show.objects.state import State, named_most
from omote.show.osc import Osc, Value, osc


def _shot(state: State) -> str:
    """The framing that is called, or that weighs most."""
    return named_most(state.framing, state.framing_call)


class CallLight(SceneCommand, frozen=True):
    """Brings a light on air in `seconds`, from whatever light shows. An `id` executes once."""

    plays = "light"
    osc = (
        Osc(
            "light",
            "brings a light on air",
            ("name", Value("seconds", high=LONGEST_CALL, unit="s", name="seconds")),
            of_show=True,
            on_air=lambda state: (named_most(state.light, state.light_call),),
        ),
    )

    id: CallId
    name: Annotated[Name, Value("light")]
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.call_light(self.name, seconds=seconds_of(self.seconds), easing=self.easing)


class CallFraming(SceneCommand, frozen=True):
    """Brings a framing on air in `seconds`, from whatever the picture shows: a shot of these characters, of all that
    are on the stage where none is named, of whom it holds now where `characters` is left out; as much of their figures
    as `size` says, heads alone in a portrait, else as much as now."""

    plays = "framing"
    osc = (
        Osc(
            "framing",
            "brings a shot of these characters on air",
            (Value("framing", name="characters"), "seconds"),
            of_show=True,
            on_air=lambda state: (held_by(_shot(state)),),
        ),
        Osc(
            "shot",
            "brings a shot on air that shows so much of whom the picture holds",
            (Value("shot", name="size"), "seconds"),
            of_show=True,
            on_air=lambda state: (size_in(_shot(state)),),
        ),
    )

    id: CallId
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)] | None = None
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING
    size: ShotSize | None = None

    def check_names(self, session: Session) -> None:
        """Raises ValueError for a character that there is not. session: the show."""
        framing_of(self.characters or (), session.scene)

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.call_framing(self.characters, size=self.size, seconds=self.seconds, easing=self.easing)


class CallBlack(SceneCommand, frozen=True):
    """Fades the picture of all stages to black (1) or up again (0) in `seconds`, from whatever shows; 0 seconds are a
    blackout. A fader sends many values between, the newest wins."""

    plays = "black"
    osc = (
        Osc(
            "black",
            "fades all stages to black, as a fader or in seconds; a key makes a blackout",
            ("black", Value("time", high=LONGEST_CALL, unit="s", default=HAND_SECONDS, name="seconds")),
            of_show=True,
            on_air=lambda state: (state.black,),
        ),
        osc("fade_to_black", "fades all stages to black", "seconds", of_show=True, black=1.0),
        osc("fade_up", "fades all stages up from black", "seconds", of_show=True, black=0.0),
    )

    black: Annotated[float, Value()]
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING
    id: RequestId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.call_black(self.black, seconds=self.seconds, easing=self.easing)
