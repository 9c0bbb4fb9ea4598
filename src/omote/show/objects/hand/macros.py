"""Macros: numbers under a hand that play several targets of a character each, and the mappings that say which."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec

from omote.perform.limits import check_known
from omote.perform.mappings.kept_mappings import MOST_MAPPINGS
from omote.perform.mappings.mapping import (
    CHANNEL,
    LONGEST_MACRO,
    MACRO_LIMITS,
    PAD,
    MacroMapping,
    MacroTarget,
    TargetKind,
    axis_of_pad,
    check_macro_name,
    places_in,
)
from omote.perform.performer import Performer
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.show.declaration import (
    SPEECH_LIMIT,
    CallId,
    CharacterCommand,
    CharacterName,
    ClientMessage,
    OptionalCallId,
    Outgoing,
    ServerMessage,
    Session,
)
from omote.show.osc import Osc, Value

MacroName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_MACRO), Value("macro")]


class SetMapping(CharacterCommand, frozen=True):
    """Says what a macro plays from now on, in the place of the mapping of that name; one that plays goes on without a
    jump. `restore_mapping` with the `key` (the name without one) takes that back. It is kept with the show. An `id`
    executes once, as of those below."""

    follows_bus = False
    longest = SPEECH_LIMIT

    id: CallId
    mapping: MacroMapping
    key: OptionalCallId = ""

    def play(self, performer: Performer) -> None:
        """Sets it."""
        performer.set_mapping(self.mapping, key=self.key)


class SetMappings(CharacterCommand, frozen=True):
    """Changes all mappings of a character at once: macros that are still there stay where they are, what others gave
    fades out in .2 s. `restore_mapping` with the `key` ("*" without one) takes that back."""

    follows_bus = False
    longest = SPEECH_LIMIT

    id: CallId
    mappings: Annotated[list[MacroMapping], msgspec.Meta(max_length=MOST_MAPPINGS)]
    key: OptionalCallId = ""

    def play(self, performer: Performer) -> None:
        """Sets them."""
        performer.set_mappings(self.mappings, key=self.key)


class RenameMapping(CharacterCommand, frozen=True):
    """Gives a macro another name, in the conditions of others too; nothing changes on air."""

    follows_bus = False

    id: CallId
    name: MacroName
    to: MacroName
    key: OptionalCallId = ""

    def play(self, performer: Performer) -> None:
        """Renames it."""
        performer.rename_mapping(self.name, self.to, key=self.key)


class DropMapping(CharacterCommand, frozen=True):
    """Forgets a macro and its mapping; what it gives fades out in .2 s."""

    follows_bus = False

    id: CallId
    name: MacroName
    key: OptionalCallId = ""

    def play(self, performer: Performer) -> None:
        """Drops it."""
        performer.drop_mapping(self.name, key=self.key)


class RestoreMapping(CharacterCommand, frozen=True):
    """Takes back that mappings were set, renamed or dropped under this `key`; asked again, it is as after that."""

    follows_bus = False

    id: CallId
    key: Annotated[str, msgspec.Meta(min_length=1, max_length=64)]

    def play(self, performer: Performer) -> None:
        """Restores them."""
        performer.restore_mapping(self.key)


class MoveMacro(CharacterCommand, frozen=True):
    """Moves a macro, -1..1: all of its targets follow, each by its own curve. Where others hold the part of one of
    them, it is rejected whole."""

    hand = "plays"
    osc = (
        Osc(
            "macro/{name}",
            "moves a macro, which plays several targets",
            ("value",),
            on_air=lambda state, name: (state.macros[name].value,) if name in state.macros else (),
            reported=lambda state: ((name,) for name in state.macros),
        ),
    )

    name: MacroName
    value: Annotated[float, Value(low=MACRO_LIMITS[0], high=MACRO_LIMITS[1])]

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.move_macro(self.name, self.value)

    def control(self, character: str) -> str:
        """The fader of a macro."""
        return f"{super().control(character)}:{self.name}"

    def parts_played(self, scene: Scene) -> tuple[str, ...]:
        """The parts that its targets are of; none where there is no macro of the name. scene: that has it."""
        names = scene if self.character == ALL else [self.character]
        mappings = [scene[name].mappings.get(self.name) for name in names if name in scene]
        places = places_in(mapping for mapping in mappings if mapping is not None)
        return tuple(dict.fromkeys(part for place in places for part in _parts_of(*place, scene)))


def _parts_of(kind: TargetKind, name: str, scene: Scene) -> tuple[str, ...]:
    """The part that a target is of; none of a pad that there is not. kind: of target; name: among those of its kind;
    scene: that has the pads."""
    if kind != PAD:
        return ("channels" if kind == CHANNEL else kind,)
    pad = scene.pads.get(axis_of_pad(name)[0])
    return () if pad is None else ("expression" if pad.part == "rest" else pad.part,)


class LearnMapping(ClientMessage, frozen=True):
    """Learns the targets of a macro by touch: what its sender moves of the character from now on, by faders of
    channels, head and gaze, up to eight, becomes the mapping, each from where it was to where it is left. Ends by
    `finish_mapping`, or after a minute in which nothing is touched. One console teaches at a time."""

    access = "operate"
    recorded = False

    id: CallId
    character: CharacterName
    name: MacroName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Begins it. session: the show; who: the client; now: seconds, monotonic."""
        check_known(self.character, session.scene, "character")
        session.learning.begin(who, self.id, self.character, check_macro_name(self.name), now)
        return ()


class FinishMapping(ClientMessage, frozen=True):
    """Ends what `learn_mapping` began: the macro stands at 1 and holds what was touched, and the faders go back to
    where they were, so that nothing moves on air. Not to `keep` it forgets what was touched, and leaves it there."""

    access = "operate"
    recorded = False

    id: CallId
    keep: bool = True

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Ends it. session: the show; who: the client; now: seconds, monotonic."""
        if not session.learning.is_learner(who):
            raise ValueError("nothing is learned here now: begin with learn_mapping")
        return session.finish_mapping(now, keeps=self.keep)


class MappingLearned(ServerMessage, frozen=True):
    """What is learned by touch now, to consoles with each change: of which macro (`name`, "" while nothing is), at
    whose console (`by`), and the targets that it has so far."""

    character: str
    name: str
    by: str
    targets: list[MacroTarget]


class MappingList(ServerMessage, frozen=True):
    """The mappings of all characters that have some, in their order: complete, to consoles after the welcome and with
    each change. `missing`: by character, the targets of them that there are not, which give nothing."""

    mappings: dict[str, list[MacroMapping]]
    missing: dict[str, list[str]] = {}
