"""The parts of characters and of the scene that can be leased, and which of them each message plays."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import get_args

from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL, describe_character
from omote.perform.scene.goals import SCENE_PARTS as PLAYED_PARTS
from omote.perform.scene.goals import Part
from omote.perform.scene.scene import Scene
from omote.show.declaration import ClientMessage
from omote.show.objects.leases import LeasePart

SCENE_PARTS = (*PLAYED_PARTS, "cues")
"""The parts of the scene."""
CHARACTER_PARTS = tuple(part for part in get_args(LeasePart) if part not in (*SCENE_PARTS, ALL))
"""The parts of a character."""
WORD_FOR_ALL = "all"
"""How all parts are named where `*` would be a pattern."""
REGION_PARTS = ("brows", "eyes", "mouth")
"""The parts of an expression that are called alone; the rest of the face belongs to the expression."""


def find_part(name: str, *, of_scene: bool) -> str:
    """The part of a name as people write it, of the scene (of_scene) or of a character; ValueError for one that there
    is not."""
    if not of_scene and name in SCENE_PARTS:
        raise ValueError(
            f"the {name} is a part of the scene, not of a character: leave the character out of the address"
        )
    if of_scene and name in CHARACTER_PARTS:
        raise ValueError(
            f"there is no part of the scene to hold {name!r}, for it is a character's: name that in the address"
        )
    parts = (*(SCENE_PARTS if of_scene else CHARACTER_PARTS), WORD_FOR_ALL)
    part = check_known(name, parts, "part of the scene to hold" if of_scene else "part of a character to hold")
    return ALL if part == WORD_FOR_ALL else part


def key_of(character: str, part: str) -> str:
    """The name of a part of a character, `*` for the scene, in the table of leases: `one/face`, `*/light`."""
    return f"{character}/{part}"


def keys_of(characters: Iterable[str], part: str, *, whole_scene: bool = False) -> tuple[str, ...]:
    """The parts that a character and a part mean; characters: those of the scene that are meant, whole_scene: all are.

    ValueError where a part of the scene is asked of one character.
    """
    scene = tuple(key_of(ALL, name) for name in SCENE_PARTS)
    if part in SCENE_PARTS:
        if not whole_scene:
            raise ValueError(f"the {part} belongs to the scene: lease it with the character {ALL}")
        return (key_of(ALL, part),)
    parts = CHARACTER_PARTS if part == ALL else (part,)
    keys = tuple(key_of(character, name) for character in characters for name in parts)
    return (*keys, *scene) if part == ALL and whole_scene else keys


def keys_played(message: ClientMessage, characters: Iterable[str], scene: Scene) -> tuple[str, ...]:
    """The parts of some characters of a scene that a message plays; none where it passes whoever holds what."""
    whom = tuple(characters)
    region = getattr(message, "region", None)
    parts = message.parts_played(scene)
    if parts and region in REGION_PARTS:
        parts = (region,)
    return tuple(key for part in parts for key in keys_of(whom, part, whole_scene=part in SCENE_PARTS))


def keys_of_part(part: Part) -> tuple[str, ...]:
    """What the table of leases calls a part of a scene; nothing where whoever plays it passes."""
    character, _, name = part.rpartition("/")
    held = {"presence": "place", "rest": "expression"}.get(name, name)
    return (key_of(character, held),) if held in (*PLAYED_PARTS, *CHARACTER_PARTS) else ()


def regions_of(key: str) -> tuple[str, ...]:
    """The regions that an expression moves too; none of another part."""
    character, _, part = key.rpartition("/")
    return tuple(key_of(character, region) for region in REGION_PARTS) if part == "expression" else ()


def expression_of(key: str) -> str:
    """The expression that a region is one of; "" of another part."""
    character, _, part = key.rpartition("/")
    return key_of(character, "expression") if part in REGION_PARTS else ""


def describe_key(key: str, labels: Mapping[str, str]) -> str:
    """A part (key: `one/face`) in words: `the face of one`, `the face of two (Rex)`, `the light`. labels: of the
    characters."""
    character, _, part = key.rpartition("/")
    if character == ALL:
        return f"the {part}"
    return f"the {part} of {describe_character(character, labels.get(character, character))}"
