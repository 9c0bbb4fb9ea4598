"""The characters of the scene: who is there, where, and how it comes and goes."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Annotated

from omote.perform.limits import check_known
from omote.perform.motion.automatic_motion import AutomaticMotion
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import PLACE_LIMITS
from omote.show.declaration import (
    CallId,
    CharacterName,
    Name,
    Outgoing,
    RequestId,
    SceneCommand,
    Seconds,
    Session,
    characters_of,
)
from omote.show.objects.state import in_degrees
from omote.show.osc import Osc, Value, angle, osc
from omote.show.validation import Refusal


class AddCharacter(SceneCommand, frozen=True):
    """Adds a character, which waits off stage at a free place until it enters; it is as lively as the liveliest there.
    `character`: its name for ever, lower case letters, digits, `_` and `-`; `label`: what people call it. `face` is its
    home face too. An `id` executes once, as of the messages below."""

    follows_bus = False
    method = "add"

    id: CallId
    character: CharacterName
    label: Name
    face: Name

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Adds it, and forgets what was of another of the same name, which is gone. session: the show; who: the client;
        now: seconds, monotonic."""
        super().act(session, who, now)
        session.forget_character(self.character)
        return ()

    def change(self, scene: Scene) -> None:
        """Adds it; one of the same name that is still on its way out stays, with the label and the face that are asked
        for."""
        characters = scene.snapshot().characters
        there = characters.get(self.character)
        if there is None or not there.standing.leaves:
            motions = [(each.performer.motion or AutomaticMotion()).settings for each in characters.values()]
            liveliness = max(motion.liveliness for motion in motions)
            seeds = {motion.seed for motion in motions}
            own = next(seed for seed in itertools.count() if seed not in seeds)  # two of one seed may blink together
            scene.add(self.character, face=self.face, label=self.label).set_motion(liveliness, seed=own)
            return
        scene[self.character].call_face(self.face)
        scene.rename(self.character, self.label)
        scene.enter(self.character)


class RemoveCharacter(SceneCommand, frozen=True):
    """Takes a character out of the scene: it leaves the stage first, in `seconds`, and no shot holds it any more; until
    it is gone an `enter_character` keeps it. The last one stays. `key`: what `restore_character` finds it by, "" for
    its name."""

    follows_bus = False
    method = "remove"
    plays = ALL
    holds = False

    id: CallId
    character: CharacterName
    seconds: float = 1.0
    key: RequestId = ""

    def change(self, scene: Scene) -> None:
        """Takes it out, but for the last one."""
        standing = {name: character.standing for name, character in scene.snapshot().characters.items()}
        check_known(self.character, standing, "character")
        if all(other.leaves for name, other in standing.items() if name != self.character):
            raise Refusal(f"{standing[self.character].label} is the last character: add another one first.")
        scene.remove(self.character, seconds=self.seconds, key=self.key)


class RestoreCharacter(SceneCommand, frozen=True):
    """Brings back a character that was removed, one of the last sixteen: all that it had on air, its place, rank and
    shot, unless another was called since. It enters in `seconds`, if it was on the stage."""

    follows_bus = False
    method = "restore"

    id: CallId
    key: CallId
    seconds: float = 1.0

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.restore(self.key, seconds=self.seconds)


class RenameCharacter(SceneCommand, frozen=True):
    """Gives a character another label."""

    follows_bus = False
    method = "rename"

    id: CallId
    character: CharacterName
    label: Name

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.rename(self.character, self.label)


class PlaceCharacter(SceneCommand, frozen=True):
    """Moves a character to a place in `seconds`, from wherever it is: the fields are those of `Place`. A hand that
    drags sends many, the newest wins."""

    method = "place"
    plays = "place"
    hand = "moves"
    osc = (
        Osc(
            "place",
            "moves it: to the picture's right, behind the front line, larger, turned",
            ("x", "depth", "size", "turn", "seconds"),
            on_air=lambda state: (state.place.x, state.place.depth, state.place.size, *in_degrees(state.place.turn)),
        ),
    )

    character: CharacterName
    x: Annotated[float, Value(low=PLACE_LIMITS["x"][0], high=PLACE_LIMITS["x"][1], unit="m")]
    depth: Annotated[float, Value(low=PLACE_LIMITS["depth"][0], high=PLACE_LIMITS["depth"][1], unit="m")]
    size: Annotated[float, Value(low=PLACE_LIMITS["size"][0], high=PLACE_LIMITS["size"][1], unit="")]
    turn: Annotated[float, angle(PLACE_LIMITS["turn"][1])]
    seconds: Seconds = 1.0
    id: RequestId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        for name in characters_of(scene, self.character):
            scene.place(name, x=self.x, depth=self.depth, size=self.size, turn=self.turn, seconds=self.seconds)


class EnterCharacter(SceneCommand, frozen=True):
    """Brings a character onto the stage in `seconds`."""

    method = "enter"
    plays = "place"
    osc = (osc("enter", "brings it onto the stage", "seconds"),)

    id: CallId
    character: CharacterName
    seconds: Seconds = 1.0

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        for name in characters_of(scene, self.character):
            scene.enter(name, seconds=self.seconds)


class LeaveCharacter(SceneCommand, frozen=True):
    """Takes a character off the stage in `seconds`; it stays in the scene."""

    method = "leave"
    plays = "place"
    osc = (osc("leave", "takes it off the stage", "seconds"),)

    id: CallId
    character: CharacterName
    seconds: Seconds = 1.0

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        for name in characters_of(scene, self.character):
            scene.leave(name, seconds=self.seconds)
