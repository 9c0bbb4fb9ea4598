"""Memories: whole looks of a scene, kept from what shows and called back in one breath."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from omote.perform.frame import Gaze, Head
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known, check_within
from omote.perform.mappings.mapping import MACRO_LIMITS
from omote.perform.newest_entries import with_newest
from omote.perform.pads.blend_space import AXES, PLACE_RANGE, PadPlace
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.perform.scene.goals import CHARACTER_PARTS, SCENE_PARTS, TURN_LIMITS, Goal, Part, check_goal
from omote.perform.scene.movement import Movement, Ranges, check_movement, values

MOST_MEMORIES = 32
LONGEST_MEMORY_NAME = 40
MOST_PARTS = MOST_CHARACTERS * len(CHARACTER_PARTS) + len(SCENE_PARTS)
CHANNELS = "channels"
MACRO_WAY = "macro:"
"""What the way of a macro is called by, before its name."""
VALUE = "value"
"""The one number of it."""
PAD_WAY = "pad:"
"""What the way of a pad's point is called by, before the pad's name."""
CHANNEL_LIMITS = (CHANNEL_LOWEST, CHANNEL_HIGHEST)
MOST_REPLACED = 16
"""Memories that were kept anew or deleted and can be brought back."""


@dataclass(frozen=True)
class Memory:
    """A whole look: the goals of its parts, as they showed."""

    goals: Mapping[Part, Goal]


@dataclass(frozen=True)
class Replaced:
    """What a name stood for before it was kept anew or deleted; None for nothing."""

    name: str
    memory: Memory | None


@dataclass(frozen=True)
class Memories:
    """The memories of a scene by name, and by key what was replaced, the oldest first."""

    kept: Mapping[str, Memory] = field(default_factory=dict)
    replaced: Mapping[str, Replaced] = field(default_factory=dict)


NO_MEMORIES = Memories()


@dataclass(frozen=True)
class Turning:
    """Head, gaze, macros and points of pads on their way to where a memory or a cue has them, channels to where preview
    had them, begun after so many panics; a hand that moves one ends its way."""

    ways: Mapping[str, Movement]
    panics: int


def with_memory(memories: Memories, name: object, memory: Memory, key: str) -> Memories:
    """The memories with one more, or with another under its name; ValueError for a bad name and for too many.

    name: 1 to 40 letters; memory: what it is from now on; key: what `with_restored` finds the one before by.
    """
    named = check_memory_name(name)
    if named not in memories.kept and len(memories.kept) >= MOST_MEMORIES:
        raise ValueError(f"there are {MOST_MEMORIES} memories, which is as many as a show keeps; delete one")
    return _replaced(memories, named, memory, key)


def without_memory(memories: Memories, name: str, key: str) -> Memories:
    """The memories without one; ValueError where there is none of the name.

    name: of the memory; key: what `with_restored` finds it by.
    """
    return _replaced(memories, check_known(name, memories.kept, "memory"), None, key)


def with_restored(memories: Memories, key: str) -> Memories:
    """The memories as before one was kept anew or deleted; asked again, as after it.

    key: what that was given; ValueError where there is none.
    """
    before = memories.replaced[check_known(key, memories.replaced, "change of a memory")]
    return _replaced(memories, before.name, before.memory, key)


def _replaced(memories: Memories, name: str, memory: Memory | None, key: str) -> Memories:
    before = Replaced(name, memories.kept.get(name))
    kept = {**memories.kept, name: memory}
    return Memories(
        {other: each for other, each in kept.items() if each is not None},
        with_newest(memories.replaced, key, before, MOST_REPLACED),
    )


def check_memory_name(name: object) -> str:
    """Returns the name of a memory without spaces around it; ValueError for none, or one that is too long."""
    text = name.strip() if isinstance(name, str) else ""
    if not 0 < len(text) <= LONGEST_MEMORY_NAME:
        raise ValueError(f"the name of a memory is {name!r:.100}; give 1 to {LONGEST_MEMORY_NAME} letters")
    return text


def limits_of_way(part: str, way: Movement) -> Ranges:
    """The range of each number of a way. part: head, gaze, channels, a macro's or a pad's; way: its numbers."""
    if part.startswith(MACRO_WAY):
        return dict.fromkeys(way.goal, MACRO_LIMITS)
    if part.startswith(PAD_WAY):
        return dict.fromkeys(way.goal, PLACE_RANGE)
    return TURN_LIMITS.get(part) or dict.fromkeys(way.goal, CHANNEL_LIMITS)


def turn_at(part: str, way: Movement) -> Head | Gaze | dict[str, float] | PadPlace | float:
    """Where a part is on its way. part: head, gaze, channels, a macro's or a pad's; way: its numbers."""
    at = values(way, limits_of_way(part, way))
    if part.startswith(MACRO_WAY):
        return at[VALUE]
    if part.startswith(PAD_WAY):
        return tuple(at[axis] for axis in AXES if axis in at)
    if part == CHANNELS:
        return {name: weight for name, weight in sorted(at.items()) if weight}
    return Head(**at) if part == "head" else Gaze(**at)


def check_memories(memories: Memories) -> None:
    """Rejects memories that no scene has kept; whether a cast can play one is asked when it is called."""
    check_within(len(memories.kept), 0, MOST_MEMORIES, "the number of memories")
    check_within(len(memories.replaced), 0, MOST_REPLACED, "the number of memories that can be brought back")
    for name, memory in memories.kept.items():
        _check_memory(check_memory_name(name), memory)
    for change in memories.replaced.values():
        if change.memory is not None:
            _check_memory(check_memory_name(change.name), change.memory)


def check_turning(turning: Turning | None) -> None:
    """Rejects a way of head, gaze and channels that none can be."""
    if turning is not None:
        for part, way in turning.ways.items():
            if not part.startswith((PAD_WAY, MACRO_WAY)):
                check_known(part, (*TURN_LIMITS, CHANNELS), "part that turns")
            check_movement(way, limits_of_way(part, way), f"the way of the {part}:")


def _check_memory(name: str, memory: Memory) -> None:
    check_within(len(memory.goals), 0, MOST_PARTS, f"the number of parts of the memory {name}")
    for part, goal in memory.goals.items():
        try:
            check_goal(part, goal)
        except ValueError as error:
            raise ValueError(f"the memory {name}: {error}") from error
