"""Pads (blend spaces): looks at places, and a point moved among them whose mixture a character shows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated

import msgspec

from omote.perform.mappings.renamed_pads import plays_pad
from omote.perform.pads.blend_space import (
    LONGEST_PAD_NAME,
    MOST_LOOKS,
    PLACE_RANGE,
    Pad,
    PadLook,
    PadPart,
)
from omote.perform.scene.scene import Scene
from omote.show.declaration import (
    CallId,
    CharacterCommand,
    OptionalCallId,
    Outgoing,
    SceneCommand,
    ServerMessage,
    Session,
    characters_of,
)
from omote.show.osc import Osc, Value

PadName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_PAD_NAME), Value("pad")]
NewPadName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_PAD_NAME)]
_ALONG = Value(low=PLACE_RANGE[0], high=PLACE_RANGE[1])
_ALONG_ONE = Value(low=PLACE_RANGE[0], high=PLACE_RANGE[1], optional=True)
PAD_LIMIT = 32768
"""Bytes: twelve looks of 24 names."""
MOST_NAMED = 8
"""That a notice of a pad that is gone names."""


# --- what is kept of them ---


class PadCommand(SceneCommand, frozen=True):
    """A change of the pads of a show: what they play follows it without a jump, in preview too. `restore_pad` with its
    `key` takes it back. An `id` executes once."""

    follows_bus = False

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Changes the pads; cues, macros and bindings follow one that has another name, and the crew is told what needs
        one that is gone. session: the show; who: the client; now: seconds, monotonic."""
        before = session.scene.pads
        renamed = self.change_pads(session.scene)
        for name, to in renamed.items():
            session.cues.rename_pad(name, to, who)
        session.renamed_pads += renamed.items()
        for name in before:
            gone = name not in renamed and name not in session.scene.pads
            if gone and (needed_by := [*session.cues.who_moves_pad(name), *_macros_of(session.scene, name)]):
                session.lost.append(said_of_gone(name, needed_by))
        return ()

    def change_pads(self, scene: Scene) -> Mapping[str, str]:
        """Changes the pads of a scene; returns what a pad is called now, by what it was called."""
        self.change(scene)
        return {}


def said_of_gone(pad: str, needed_by: Sequence[str]) -> str:
    """What the crew is told of a pad that is gone. pad: its name; needed_by: what moves it, in words."""
    listed = ", ".join(needed_by[:MOST_NAMED]) + (", ..." if len(needed_by) > MOST_NAMED else "")
    return f"the pad {pad} is gone, and these move it, which does nothing now: {listed}."


def _macros_of(scene: Scene, pad: str) -> list[str]:
    """The macros that move a pad (by its name), in words."""
    return [
        f"the macro {mapping.name} of {scene.labels[character]}"
        for character in scene
        for mapping in scene[character].mappings.values()
        if plays_pad(mapping, pad)
    ]


class SetPad(PadCommand, frozen=True):
    """Keeps a pad: the `part` that it plays (`face`, `expression`, a region of that, or `pose`), 1 to 3 `dimensions`, 2
    to 12 `looks` at places -1..1 for each dimension, 0.06 apart at least; each is a mix by name whose weights sum to 1.
    One of its name makes way, and what that plays follows the new one without a jump. It is kept with the show.
    `restore_pad` with the `key` (the name without one) takes it back; with a key several changes, one after the other,
    together. An `id` executes once, as of those below."""

    longest = PAD_LIMIT

    id: CallId
    name: NewPadName
    part: PadPart
    dimensions: int
    looks: Annotated[list[PadLook], msgspec.Meta(max_length=MOST_LOOKS)]
    key: OptionalCallId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.set_pad(Pad(self.name, self.part, self.dimensions, tuple(self.looks)), key=self.key)


class RenamePad(PadCommand, frozen=True):
    """Gives a pad another name (`to`); what it plays it plays on. Cues that move it follow, as one edit of cues,
    and macros, bindings and set-ups."""

    id: CallId
    name: PadName
    to: NewPadName
    key: OptionalCallId = ""

    def change_pads(self, scene: Scene) -> Mapping[str, str]:
        """Renames it in a scene; returns its new name by its old one."""
        scene.rename_pad(self.name, self.to, key=self.key)
        return {self.name: self.to}


class CopyPad(PadCommand, frozen=True):
    """Keeps a copy of a pad under another name (`to`)."""

    id: CallId
    name: PadName
    to: NewPadName
    key: OptionalCallId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.copy_pad(self.name, self.to, key=self.key)


class DropPad(PadCommand, frozen=True):
    """Forgets a pad; what it shows stays on air. A notice names the cues, macros and bindings that move it."""

    id: CallId
    name: PadName
    key: OptionalCallId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.drop_pad(self.name, key=self.key)


class AddCastPads(PadCommand, frozen=True):
    """Keeps the pads that come with the cast, as a new show has them; pads of the same names make way. Without a `key`
    `restore_pad` finds those before by `cast pads`."""

    id: CallId
    key: OptionalCallId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.add_cast_pads(key=self.key)


class RestorePad(PadCommand, frozen=True):
    """Takes the change of pads back that was made under this `key`; asked again, it is as after that. Cues follow a
    name."""

    id: CallId
    key: Annotated[str, msgspec.Meta(min_length=1, max_length=64)]

    def change_pads(self, scene: Scene) -> Mapping[str, str]:
        """Restores them in a scene; returns what a pad is called again, by what it was called."""
        return scene.restore_pad(self.key)


# --- what is told of them ---


class PadState(msgspec.Struct, frozen=True):
    """A pad, as of `set_pad`. `missing`: the names of its looks that the cast does not have; they count as neutral."""

    name: str
    part: PadPart
    dimensions: int
    looks: list[PadLook]
    missing: list[str] = []


class PadList(ServerMessage, frozen=True):
    """The pads of the show, in the order in which they came: complete, to consoles after the welcome and with each
    change, ten times a second at most. Where the points of a character are stands in its state."""

    pads: list[PadState]


# --- what plays them ---


class MovePad(CharacterCommand, frozen=True):
    """Moves the point of a pad on a character, -1..1 for each of its dimensions; `None` leaves one where it is. What
    the pad plays shows the mixture of its looks there, from whatever shows, without a jump. It needs all parts that the
    pad plays."""

    hand = "plays"
    osc = (
        Osc(
            "pad/{name}",
            "moves the point of a pad of this name, in as many dimensions as it has",
            ("x", "y", "z"),
            on_air=lambda state, name: tuple(state.pads[name].place) if name in state.pads else (),
            reported=lambda state: ((name,) for name in state.pads),
        ),
    )

    name: PadName
    x: Annotated[float | None, _ALONG] = None
    y: Annotated[float | None, _ALONG_ONE] = None
    z: Annotated[float | None, _ALONG_ONE] = None

    def act(self, session: Session, who: str, now: float) -> tuple[Outgoing, ...]:
        """Moves it: the scene knows the pad of a name. session: the show; who: the client; now: seconds, monotonic."""
        for character in characters_of(session.scene, self.character):
            session.scene.move_pad(character, self.name, self.x, self.y, z=self.z)
        return ()

    def check_names(self, session: Session) -> None:
        """Raises ValueError for a pad that there is not. session: the show."""
        session.scene.find_pad(self.name)

    def parts_played(self, scene: Scene) -> tuple[str, ...]:
        """The part that the pad plays; none where there is none of the name. scene: that has it."""
        try:
            part = scene.find_pad(self.name).part
        except ValueError:
            return ()
        return ("expression",) if part == "rest" else (part,)

    def control(self, character: str) -> str:
        """The point of one pad."""
        return f"{super().control(character)}:{self.name}"
