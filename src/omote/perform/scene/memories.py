"""Memories: whole looks of a scene, kept from what shows and called back in one breath."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from omote.model.known_names import PlayRegion, check_play_region
from omote.perform.axis import LEAST_STANDING, Axis, called
from omote.perform.frame import Gaze, Head
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS, check_known, check_within
from omote.perform.mix import HIGHEST, LOWEST, Weights, normalise
from omote.perform.scene.character_names import MOST_CHARACTERS, check_character_name
from omote.perform.scene.movement import Movement, Ranges, check_movement, values

MOST_MEMORIES = 32
LONGEST_MEMORY_NAME = 40
MOST_REPLACED = 16
"""Memories that were kept anew or deleted and can be brought back."""
TURN_LIMITS: Mapping[str, Ranges] = {
    "head": {name: (-limit, limit) for name, limit in HEAD_LIMITS.items()},
    "gaze": {name: (-limit, limit) for name, limit in GAZE_LIMITS.items()},
}
"""What of a character turns on its way to a memory, radians."""


@dataclass(frozen=True)
class CharacterMemory:
    """What a memory has of a character: the mixes of faces and expressions, those of regions that show another, and
    where hands hold head and gaze."""

    faces: Weights
    expressions: Weights
    regions: Mapping[PlayRegion, Weights] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)


@dataclass(frozen=True)
class Memory:
    """A whole look: of each character that was on the stage, the light and the framing."""

    characters: Mapping[str, CharacterMemory]
    light: Weights
    framing: Weights


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
    """Head and gaze on their way to where a memory has them, begun after so many panics; a hand that moves one ends its
    way."""

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
    replaced = {other: change for other, change in memories.replaced.items() if other != key}
    replaced[key] = Replaced(name, memories.kept.get(name))
    kept = {**memories.kept, name: memory}
    return Memories(
        {other: each for other, each in kept.items() if each is not None},
        dict([*replaced.items()][-MOST_REPLACED:]),
    )


def check_memory_name(name: object) -> str:
    """Returns the name of a memory without spaces around it; ValueError for none, or one that is too long."""
    text = name.strip() if isinstance(name, str) else ""
    if not 0 < len(text) <= LONGEST_MEMORY_NAME:
        raise ValueError(f"the name of a memory is {name!r:.100}; give 1 to {LONGEST_MEMORY_NAME} letters")
    return text


def turn_at(part: str, way: Movement) -> Head | Gaze:
    """Where a part is on its way. part: head or gaze; way: its numbers."""
    angles = values(way, TURN_LIMITS[part])
    return Head(**angles) if part == "head" else Gaze(**angles)


def standing_mix(mix: Weights) -> dict[str, float]:
    """A mix that shows, as one to come to a stand at: nothing weighs less than none of it. mix: as on air."""
    return normalise({name: weight for name, weight in mix.items() if weight >= LEAST_STANDING})


def called_mix(on: Axis, mix: Weights, seconds: float, easing: str) -> Axis:
    """The axis with a call to a whole mix. on: the axis; mix: what it comes to; seconds, easing: the way."""
    heaviest = max(mix, key=lambda name: (mix[name], name))
    return called(on, heaviest, seconds, easing, mix if len(mix) > 1 else None)


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
    """Rejects a way of head and gaze that none can be."""
    if turning is not None:
        for part, way in turning.ways.items():
            check_movement(
                way, TURN_LIMITS[check_known(part, TURN_LIMITS, "part that turns")], f"the way of the {part}:"
            )


def _check_memory(name: str, memory: Memory) -> None:
    check_within(len(memory.characters), 0, MOST_CHARACTERS, f"the number of characters of the memory {name}")
    mixes = [memory.light, memory.framing]
    for character, of in memory.characters.items():
        check_character_name(character)
        for region in of.regions:
            check_play_region(region)
        mixes += [of.faces, of.expressions, *of.regions.values()]
    for mix in mixes:
        if not mix:
            raise ValueError(f"a mix of the memory {name} is empty; expected weights that sum to one")
        for other, weight in mix.items():
            check_within(weight, LOWEST, HIGHEST, f"the weight of {other} in the memory {name}")
