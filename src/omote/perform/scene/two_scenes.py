"""Two scenes of one show: how a second one follows the cast of the first, and what one has that the other has not."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from omote.model.known_names import PLAY_REGIONS
from omote.perform.axis import Axis
from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import NO_TARGET, MotionSettings
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, LayerName, LayerSetting
from omote.perform.limits import check_known
from omote.perform.mappings.macros import follow_change
from omote.perform.performer import Performer
from omote.perform.scene.character_names import ALL
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    PASSING,
    SCENE_PARTS,
    WITH_FACE,
    Goal,
    Part,
    rank_of,
    regions_of,
    whole_of,
)
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_snapshot import CharacterSnapshot, SceneSnapshot, known_framings
from omote.perform.snapshot import axis_names

SETTINGS = ("channels", "switches")
"""What a character has beside the parts that have goals: weights under hands, and what is on or off of it: its layers,
and whether it moves while its tracker is lost."""
TAKEN_PARTS = (*(part for part in CHARACTER_PARTS if part not in PASSING), *SETTINGS)
"""All of a character that one scene takes from another."""


def shared_of(snapshot: SceneSnapshot) -> tuple[object, ...]:
    """What two scenes of one show have in common, to be compared: who is there, what people call them and who leaves;
    mappings; points, memories and the stages that have a camera."""
    standings = tuple(
        (name, each.standing.label, each.standing.leaves, each.performer.mappings)
        for name, each in snapshot.characters.items()
    )
    return standings, snapshot.gaze_points, snapshot.memories, tuple(snapshot.cameras)


def follow(own: SceneSnapshot, first: SceneSnapshot) -> SceneSnapshot:
    """A scene with the cast of another: who has come there comes as it is there, who has gone goes; all else stays.

    own: the scene; first: the one that it follows.
    """
    characters = {name: _following(own.characters.get(name), first, name, own.time) for name in first.characters}
    stay = {name: each for name, each in characters.items() if not each.standing.leaves}
    holds_who_stays = known_framings(own.framing, stay).keys() == axis_names(own.framing)
    return replace(
        own,
        characters=characters,
        framing=own.framing if holds_who_stays else first.framing,
        removals={},
        gaze_points=first.gaze_points,
        cameras=first.cameras,
        memories=first.memories,
    )


def _following(own: CharacterSnapshot | None, first: SceneSnapshot, name: str, time: float) -> CharacterSnapshot:
    there = first.characters[name]
    if own is None:
        return replace(there, performer=replace(there.performer, time=time))
    standing = replace(own.standing, label=there.standing.label)
    if own.standing.leaves != there.standing.leaves:
        standing = there.standing
    motion = own.performer.motion
    target = _motion_of(own).target
    if motion is not None and target.kind == "gaze_point" and target.name not in first.gaze_points:
        motion = replace(motion, settings=replace(motion.settings, target=NO_TARGET))
    mappings = there.performer.mappings
    macros = follow_change(own.performer.macros, own.performer.mappings.kept, mappings.kept)
    performer = replace(own.performer, motion=motion, mappings=mappings, macros=macros)
    return replace(own, standing=standing, performer=performer)


def differing_parts(wanted: Scene, shown: Scene, parts: Iterable[str] = ()) -> list[Part]:
    """The parts of one scene that go, or are set, otherwise than in another, in the order in which they are called.

    Parameters
    ----------
    wanted, shown : Scene
        Two scenes of one show. Who leaves one of them has no parts.
    parts : sequence of str
        Those that are meant, `one/face`, or `one` for all of a character; none named: all.

    Returns
    -------
    list of str
        A whole expression before its regions, which it would take along: where it differs, those that go their own way
        are among them.

    Raises
    ------
    ValueError
        On a part or a character that there is not.
    """
    ours = wanted.snapshot()
    theirs = shown.snapshot()
    there = [name for name in theirs.characters if _stays(ours, name) and _stays(theirs, name)]
    every = [*(f"{name}/{part}" for name in there for part in TAKEN_PARTS), *(f"{ALL}/{part}" for part in SCENE_PARTS)]
    meant = _meant(list(parts), there, every)
    differ = {part for part in meant if _wanted(wanted, ours, part) != _wanted(shown, theirs, part)}
    along = {each for part in differ for each in regions_of(part) if each in meant}
    differ = {part for part in differ | along if part not in along or wanted.goal_of(part) != WITH_FACE}
    return sorted(differ, key=rank_of)


def take_parts(
    wanted: Scene, shown: Scene, parts: Iterable[Part], *, seconds: float, easing: str = DEFAULT_EASING
) -> None:
    """Calls parts of one scene in another; what the eyes look at and how much of layers shows is set at once, and
    followed as always.

    wanted: the scene that has them; shown: where they are called; parts: as of `differing_parts`; seconds: 0 cuts;
    easing: the curve of the way.
    """
    ours = wanted.snapshot()
    theirs = shown.snapshot()
    for part in parts:
        character, _, name = part.rpartition("/")
        if name not in SETTINGS:
            shown.call_goal(part, _goal(wanted, ours, part), seconds=seconds, easing=easing)
        elif name == "channels":
            weights = wanted.channels_of(character)
            shown.call_channels(character, weights, seconds=seconds, easing=easing)
        else:
            _take_switches(shown[character], ours.characters[character], theirs.characters[character])


def _take_switches(shown: Performer, wanted: CharacterSnapshot, before: CharacterSnapshot) -> None:
    shown.set_motion(idle=_motion_of(wanted).idle)
    settings = _layers_of(before)
    for layer, setting in _layers_of(wanted).items():
        if setting.on != settings[layer].on:
            shown.set_layer(layer, on=setting.on)


def _wanted(scene: Scene, snapshot: SceneSnapshot, part: Part) -> object:
    """Where a part goes, or how it is set. scene, snapshot: the same."""
    character, _, name = part.rpartition("/")
    if name not in SETTINGS:
        goal = _goal(scene, snapshot, part)
        whole = whole_of(part)
        return goal if whole is None or goal else _goal(scene, snapshot, whole)  # a region that goes with the face
    if name == "channels":
        return scene.channels_of(character)
    own = snapshot.characters[character]
    return _motion_of(own).idle, {layer: setting.on for layer, setting in _layers_of(own).items()}


def _goal(scene: Scene, snapshot: SceneSnapshot, part: Part) -> Goal:
    """Where a part goes; where a hand has it at its T-bar, what that shows. scene, snapshot: the same."""
    character, _, name = part.rpartition("/")
    if name in ("face", "expression", *PLAY_REGIONS):
        performer = snapshot.characters[character].performer
        axes: dict[str, Axis] = {
            "face": performer.face,
            "expression": performer.expression,
            **{str(region): on for region, on in performer.regions.items()},
        }
        axis = axes.get(name)
        call = None if axis is None else axis.call
        if call is not None and (call.held or call.seconds is None):
            return scene.shown_goal(part)
    return scene.goal_of(part)


def _motion_of(character: CharacterSnapshot) -> MotionSettings:
    motion = character.performer.motion
    return MotionSettings() if motion is None else motion.settings


def _layers_of(character: CharacterSnapshot) -> Mapping[LayerName, LayerSetting]:
    layers = character.performer.layers
    return DEFAULT_SETTINGS if layers is None else layers.settings


def _stays(snapshot: SceneSnapshot, name: str) -> bool:
    return name in snapshot.characters and not snapshot.characters[name].standing.leaves


def _meant(parts: Sequence[str], characters: Sequence[str], every: Sequence[Part]) -> list[Part]:
    if not parts:
        return [*every]
    for part in parts:
        if part not in characters:
            check_known(part, every, "part")
    return [part for part in every if part in parts or part.rpartition("/")[0] in parts]
