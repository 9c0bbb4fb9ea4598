"""Snapshots of a scene: the whole state beside its cast, and their validation when they come from a file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from omote.perform.axis import Axis
from omote.perform.lights import FIRST_LIGHT, LIGHTS
from omote.perform.limits import FOREVER, check_known, check_within
from omote.perform.motion.sight import Point
from omote.perform.pads.kept_pads import NO_PADS, Pads, check_pads
from omote.perform.scene.character_names import ALL, MOST_CHARACTERS, check_character_name
from omote.perform.scene.framings import framing_or_none
from omote.perform.scene.gaze_targets import MOST_POINTS, check_point
from omote.perform.scene.goals import BLACK_LIMITS, PRESENCE_LIMITS
from omote.perform.scene.memories import CHANNELS, NO_MEMORIES, Memories, Turning, check_memories, check_turning
from omote.perform.scene.movement import Movement, check_movement, proceed
from omote.perform.scene.scene_frame import PLACE_LIMITS, Place
from omote.perform.snapshot import (
    ROUNDING,
    NamesHeld,
    Playable,
    Snapshot,
    axis_names,
    check_axis,
    check_snapshot,
    names_held,
)

LONGEST_LABEL = 80
MOST_REMOVALS = 16
"""Removed characters that can be brought back."""


@dataclass(frozen=True)
class Standing:
    """How a character stands in a scene: its label, place and presence; `leaves`: it was removed and is on its way."""

    label: str
    place: Movement = field(default_factory=lambda: Movement(vars(Place())))
    presence: Movement = field(default_factory=lambda: Movement({"presence": 1.0}))
    leaves: bool = False


def standing_after(standing: Standing, dt: float) -> Standing:
    """How a character stands `dt` seconds later; the same object where it does not move. standing: how it stands."""
    place = proceed(standing.place, dt)
    presence = proceed(standing.presence, dt)
    still = place is standing.place and presence is standing.presence
    return standing if still else replace(standing, place=place, presence=presence)


@dataclass(frozen=True)
class CharacterSnapshot:
    """The state of one character. `turning`: head, gaze and channels on their way to where they were called."""

    performer: Snapshot
    standing: Standing
    turning: Turning | None = None


@dataclass(frozen=True)
class Removal:
    """A character that was removed, and what brings it back.

    `before`: those that stood before it in the order; `presence`: where it was or was going, 0..1; `framing`: the shot
    that held it and the one that went on without it; `kept`: how it was when it was gone, None while it is on its way.
    """

    character: str
    before: tuple[str, ...]
    presence: float
    framing: tuple[str, str] | None = None
    kept: CharacterSnapshot | None = None


@dataclass(frozen=True)
class SceneSnapshot:
    """The state of a scene: plain values, so msgspec writes and reads it exactly. `time`: of all performers too.

    `removals`: by their keys, oldest first. `gaze_points`, `cameras`: points that eyes may look at, by name, and where
    stages' cameras are, metres. `black`: how far the picture is faded to black; `memories`: the looks that were kept;
    `pads`: the blend spaces. Older snapshots have none of these.
    """

    characters: Mapping[str, CharacterSnapshot] = field(default_factory=dict)
    light: Axis = field(default_factory=lambda: Axis(FIRST_LIGHT))
    framing: Axis = field(default_factory=lambda: Axis(ALL))
    time: float = 0.0
    removals: Mapping[str, Removal] = field(default_factory=dict)
    gaze_points: Mapping[str, Point] = field(default_factory=dict)
    cameras: Mapping[str, Point] = field(default_factory=dict)
    black: Movement = field(default_factory=lambda: Movement({"black": 0.0}))
    memories: Memories = NO_MEMORIES
    pads: Pads = NO_PADS


def check_scene(snapshot: SceneSnapshot, cast: Playable) -> SceneSnapshot:
    """Validates a snapshot and returns it; rejects one that the cast cannot play, or that no scene wrote."""
    if not isinstance(snapshot, SceneSnapshot):
        raise TypeError(f"the snapshot is a {type(snapshot).__name__}; expected what Scene.snapshot() gives")
    check_within(len(snapshot.characters), 0, MOST_CHARACTERS, "the number of characters")
    check_within(snapshot.time, 0.0, FOREVER, "the snapshot's time (seconds)")
    for name, character in snapshot.characters.items():
        check_character_name(name)
        check_standing(character.standing, name)
        check_turning(character.turning)
        for channel in channels_coming(character):
            check_known(channel, cast.expressions, "channel")
        performer = check_snapshot(character.performer, cast)
        if not math.isclose(performer.time, snapshot.time, rel_tol=ROUNDING, abs_tol=ROUNDING):
            raise ValueError(f"{name} is at {performer.time} seconds, its scene at {snapshot.time}; they must agree")
    check_axis(snapshot.light, LIGHTS, "light")
    check_axis(snapshot.framing, known_framings(snapshot.framing, snapshot.characters), "framing")
    check_movement(snapshot.black, BLACK_LIMITS, "the fade of the picture:")
    check_removals(snapshot)
    check_memories(snapshot.memories)
    check_pads(snapshot.pads)
    check_within(len(snapshot.gaze_points), 0, MOST_POINTS, "the number of gaze points")
    for name, point in (*snapshot.gaze_points.items(), *snapshot.cameras.items()):
        check_point(*point, f"the point {name!r:.80}")
    return snapshot


def check_removals(snapshot: SceneSnapshot) -> None:
    """Rejects removals that no scene has written; whether a cast can play who comes back is asked when it does."""
    check_within(len(snapshot.removals), 0, MOST_REMOVALS, "the number of removed characters")
    for key, removal in snapshot.removals.items():
        name = check_character_name(removal.character)
        check_within(removal.presence, *PRESENCE_LIMITS["presence"], f"the presence of {name}, removed as {key},")
        if removal.kept is not None:
            check_standing(removal.kept.standing, name)
        elif name not in snapshot.characters:
            raise ValueError(f"nothing is kept of {name}, removed as {key}; expected how it was when it was gone")


def known_framings(framing: Axis, characters: Mapping[str, object]) -> dict[str, None]:
    """The framings of an axis that some of these characters make. framing: the axis."""
    return {name: None for name in axis_names(framing) if name == framing_or_none(name, characters)}


def check_standing(standing: Standing, name: str) -> None:
    """Rejects what no character can stand at. standing: what was read; name: of the character."""
    check_label(standing.label)
    check_movement(standing.place, PLACE_LIMITS, f"the place of {name}:")
    check_movement(standing.presence, PRESENCE_LIMITS, f"the presence of {name}:")


IN_ADDRESSES = "/*?[]{}"
"""What parts and patterns of OSC addresses are made of."""


def check_label(label: object, others: Mapping[str, str] | None = None) -> str:
    """Returns the label of a character without spaces around it; ValueError for none, for one that is too long, for one
    that another has, in any case, and for one that no address can call. others: the labels of the other characters, by
    name; None for one that was kept: it was given when all letters were allowed."""
    text = label.strip() if isinstance(label, str) else ""
    if not 0 < len(text) <= LONGEST_LABEL:
        raise ValueError(f"the label of a character is {label!r:.100}; give 1 to {LONGEST_LABEL} letters")
    if others is not None and (wrong := [letter for letter in text if letter in IN_ADDRESSES]):
        raise ValueError(
            f"a character cannot be labelled {text[:80]!r}, for {wrong[0]} has a meaning in addresses, which call "
            "characters by their labels too; leave it out"
        )
    for name, other in (others or {}).items():
        if other.casefold() == text.casefold():
            raise ValueError(f"the character {name} is called {other!r} already; give another label")
    return text


def without_time(snapshot: SceneSnapshot) -> SceneSnapshot:
    """The same at the time 0: equal while nothing but the clock moves."""
    characters = {
        name: replace(character, performer=replace(character.performer, time=0.0))
        for name, character in snapshot.characters.items()
    }
    return replace(snapshot, characters=characters, time=0.0)


def names_held_by(snapshot: SceneSnapshot) -> NamesHeld:
    """The names that a scene cannot be played without."""
    held = [names_held(character.performer) for character in snapshot.characters.values()]
    coming = frozenset[str]().union(*map(channels_coming, snapshot.characters.values()))
    return NamesHeld(expressions=coming).with_others(*held)


def channels_coming(character: CharacterSnapshot) -> frozenset[str]:
    """The channels that are on their way to weights of their own."""
    ways = {} if character.turning is None else character.turning.ways
    return frozenset(ways[CHANNELS].goal) if CHANNELS in ways else frozenset()
