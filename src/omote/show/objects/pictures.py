"""Light and framing of the picture."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.perform.easing import DEFAULT_EASING
from omote.perform.limits import LONGEST_CALL
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.perform.scene.scene import Scene
from omote.show.declaration import CallId, CharacterName, Name, SceneCommand, Seconds
from omote.show.objects.calls import seconds_of
from omote.show.objects.state import named_most
from omote.show.osc import Osc, Value


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
    """Brings a framing on air in `seconds`, from whatever the picture shows: a shot of these characters, or of all that
    are on the stage where none is named."""

    plays = "framing"
    osc = (
        Osc(
            "framing",
            "brings a shot of these characters on air",
            (Value("framing", name="characters"), "seconds"),
            of_show=True,
            on_air=lambda state: (named_most(state.framing, state.framing_call),),
        ),
    )

    id: CallId
    characters: Annotated[list[CharacterName], msgspec.Meta(max_length=MOST_CHARACTERS)]
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.call_framing(self.characters, seconds=self.seconds, easing=self.easing)
