"""What consoles are told of the memories of a show, beside the states: mixes that rarely change."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.scene.memories import Memory
from omote.show.objects.memories import MemoryList, MemoryState

SHOWN = ("/face", "/expression")
"""The ends of the parts that a picture of a memory shows."""


def list_memories(kept: Mapping[str, Memory]) -> MemoryList:
    """The list of some memories. kept: by name."""
    return MemoryList(
        [
            MemoryState(name, {part: dict(goal) for part, goal in memory.goals.items() if part.endswith(SHOWN)})
            for name, memory in kept.items()
        ]
    )


class MemoryListing:
    """What consoles were told of memories last. kept: those of the begin, which a welcome tells."""

    def __init__(self, kept: Mapping[str, Memory]) -> None:
        self._told = kept

    def news(self, kept: Mapping[str, Memory]) -> MemoryList | None:
        """The list, where it is new. kept: those of the scene."""
        if self._told is kept:
            return None
        self._told = kept
        return list_memories(kept)
