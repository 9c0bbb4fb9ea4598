"""Memories: whole looks of the scene, kept from what shows and called back in one breath."""

from __future__ import annotations

from typing import Annotated, ClassVar

import msgspec

from omote.perform.easing import DEFAULT_EASING
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.perform.scene.memories import LONGEST_MEMORY_NAME
from omote.perform.scene.scene import Scene
from omote.show.declaration import (
    CallId,
    ClientMessage,
    Name,
    OptionalCallId,
    Outgoing,
    SceneCommand,
    Seconds,
    ServerMessage,
    Session,
)
from omote.show.osc import PRESS, Value, osc

MemoryName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_MEMORY_NAME), Value("text")]


class KeepMemory(ClientMessage, frozen=True):
    """Keeps the whole look that shows to its sender, on air or in preview, under a name: faces, expressions, poses,
    head and gaze of all characters, light and framing. One of that name is kept anew; `restore_memory` with the `key`
    (the name without one) takes that back. It is kept with the show. An `id` executes once, as of those below."""

    access = "operate"
    method = ""
    reads_preview = True
    osc = (osc("keep_memory", "keeps the whole look that shows under this name", "name", of_show=True),)

    id: CallId
    name: MemoryName
    key: OptionalCallId = ""

    def act(self, session: Session, who: str, now: float) -> tuple[Outgoing, ...]:
        """Keeps it. session: the show; who: the client; now: seconds, monotonic."""
        session.scene.keep_look_of(session.scene_of(who), self.name, key=self.key)
        return ()


class CallMemory(SceneCommand, frozen=True):
    """Brings a memory on air in `seconds`, all its parts in the same time, from whatever shows. Where others hold one
    of them, it is rejected whole; it holds none of them afterwards."""

    plays = ("face", "expression", "pose", "head", "gaze", "light", "framing")
    holds = False
    osc = (
        osc("memory", "brings the whole look of this name on air", "name", "seconds", of_show=True),
        osc("memory/{name}", "the same for a button, when it is pressed", PRESS, "seconds", of_show=True),
    )

    character: ClassVar[str] = ALL

    id: CallId
    name: MemoryName
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING

    def check_names(self, session: Session) -> None:
        """Raises ValueError for a memory that there is not. session: the show."""
        check_known(self.name, session.scene.snapshot().memories.kept, "memory")

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.call_memory(self.name, seconds=self.seconds, easing=self.easing)


class DeleteMemory(SceneCommand, frozen=True):
    """Forgets a memory; `restore_memory` with the `key` (the name without one) takes that back."""

    follows_bus = False
    osc = (osc("delete_memory", "forgets the whole look of this name", "name", of_show=True),)

    id: CallId
    name: MemoryName
    key: OptionalCallId = ""

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.delete_memory(self.name, key=self.key)


class RestoreMemory(SceneCommand, frozen=True):
    """Takes back that a memory was kept or deleted under this `key`; asked again, it is as after that."""

    follows_bus = False

    id: CallId
    key: Annotated[str, msgspec.Meta(min_length=1, max_length=64)]

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.restore_memory(self.key)


class MemoryState(msgspec.Struct, frozen=True):
    """A memory as its picture shows it. `goals`: of the faces and expressions of its characters, by part, as cues have
    them."""

    name: str
    goals: dict[str, dict[str, float]]


class MemoryList(ServerMessage, frozen=True):
    """What the memories of the show look like, in the order in which they came: complete, to consoles after the welcome
    and with each change. Their names alone stand in each state."""

    memories: list[MemoryState]
