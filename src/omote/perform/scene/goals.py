"""Goals: where a part of a character or of the scene goes, as plain numbers by name; cues and memories consist of them.

A part is `kaori/face`, or `*/light` of the scene. A goal of it is a mix (`{"joy": 1.0}`) or numbers that it stands at
(`{"yaw": 0.2, "pitch": 0.0, "roll": 0.0}`); of `look` what eyes look at (`look_goals.py`), of `clip` which and how it
plays (`clip_goals.py`). Where a pad plays a mix, a goal is the place of its point (`pad_goals.py`); of `macros`
it is where some of them are.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from omote.model.body.pose import STAND
from omote.model.body.pose_regions import POSE_REGIONS
from omote.model.known_names import PLAY_REGIONS
from omote.perform.complexion import SKIN_FADERS, SKIN_LIMIT
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.frame import DETAIL_LIMIT, DETAILS
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, LAYER_PARTS, LAYERS, check_layer
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS, check_known, check_within
from omote.perform.mappings.mapping import MACRO_LIMITS, check_macro_name
from omote.perform.mix import HIGHEST, LOWEST
from omote.perform.scene.character_names import ALL
from omote.perform.scene.clip_goals import clip_of_goal, goal_of_clip
from omote.perform.scene.look_goals import AHEAD, goal_of_target, target_of_goal
from omote.perform.scene.movement import Ranges
from omote.perform.scene.pad_goals import goal_of_point, is_pad_goal, point_of_goal
from omote.perform.scene.scene_frame import PLACE_LIMITS
from omote.perform.snapshot import ROUNDING
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.perform.springs.springs import AMOUNT_LIMIT

Part = str
Goal = Mapping[str, float]
NOTHING_MOVED: Goal = {}
"""The goal of macros of which a hand has moved none."""
WITH_FACE: Goal = {}
"""The goal of a region of the expression that goes with the whole face, and of a clip where none plays."""

TURN_LIMITS: Mapping[str, Ranges] = {
    "head": {name: (-limit, limit) for name, limit in HEAD_LIMITS.items()},
    "gaze": {name: (-limit, limit) for name, limit in GAZE_LIMITS.items()},
}
"""Radians."""
PRESENCE_LIMITS: Ranges = {"presence": (0.0, 1.0)}
BLACK_LIMITS: Ranges = {"black": (0.0, 1.0)}
LAYER_LIMITS: Ranges = dict.fromkeys(LAYER_PARTS, (0.0, 1.0))
LAYER = "layer:"
"""What the part of a layer begins with: `layer:tracker` is how much of it shows, by region."""
MOTION_LIMITS: Ranges = {"liveliness": (0.0, 1.0), **dict.fromkeys(DETAILS, (0.0, DETAIL_LIMIT))}
SPRING_LIMITS: Ranges = dict.fromkeys(SPRING_NAMES, (0.0, AMOUNT_LIMIT))
SKIN_LIMITS: Ranges = dict.fromkeys(SKIN_FADERS, (0.0, SKIN_LIMIT))
CHARACTER_NUMBERS: Mapping[str, Ranges] = {
    **TURN_LIMITS,
    "place": PLACE_LIMITS,
    "presence": PRESENCE_LIMITS,
    "motion": MOTION_LIMITS,
    "springs": SPRING_LIMITS,
    "skin": SKIN_LIMITS,
    **{f"{LAYER}{layer}": LAYER_LIMITS for layer in LAYERS},
}
"""The parts of a character that are numbers, with the range of each; all else of it but `look` are mixes."""
MACROS = "macros"
"""The part whose goal is where macros are, by name; those that it does not name stay."""
POSE = "pose"
POSE_PART = "pose:"
"""What the part of a region of the figure begins with: `pose:arm_left` is the pose of the left arm."""
POSE_PARTS = tuple(f"{POSE_PART}{region}" for region in POSE_REGIONS)
BODY = "body"
CHARACTER_PARTS = (
    "face", "expression", *PLAY_REGIONS, POSE, *POSE_PARTS, BODY, *CHARACTER_NUMBERS, "look", "clip", MACROS,
)  # fmt: skip
STANDING_MIXES: Mapping[str, Goal] = {POSE: {STAND: 1.0}, BODY: {FACES_OWN: 1.0}}
"""Where the mixes of a figure are in a new show."""
PASSING = ("clip",)
"""Parts that come to an end by themselves: nothing of them is left standing, so cues do not track them."""
SCENE_PARTS = ("light", "framing", "black")


def split_part(part: Part) -> tuple[str, str]:
    """The character of a part, `*` for the scene, and its name there; ValueError for a part that there is not."""
    character, _, name = part.rpartition("/")
    parts = SCENE_PARTS if character == ALL else CHARACTER_PARTS
    if not character or name not in parts:
        expected = f"CHARACTER/{'|'.join(CHARACTER_PARTS)} or {ALL}/{'|'.join(SCENE_PARTS)}"
        raise ValueError(f"there is no part {part[:80]!r}; expected {expected}")
    return character, name


def regions_of(part: Part) -> tuple[Part, ...]:
    """The regions that go with a whole expression or a whole pose; none of another part."""
    character, _, name = part.rpartition("/")
    regions = {"expression": PLAY_REGIONS, POSE: POSE_PARTS}.get(name, ())
    return tuple(f"{character}/{region}" for region in regions)


def whole_of(part: Part) -> Part | None:
    """The whole expression, or the whole pose, that a region is one of; None of another part."""
    character, _, name = part.rpartition("/")
    if name in POSE_PARTS:
        return f"{character}/{POSE}"
    return f"{character}/expression" if name in PLAY_REGIONS else None


def is_of_macros(part: Part) -> bool:
    """Whether the goal of a part is where macros are."""
    return part.rpartition("/")[2] == MACROS


def passes(part: Part) -> bool:
    """Whether what is called of a part is over by itself."""
    return part.rpartition("/")[2] in PASSING


def ranges_of(part: Part) -> Ranges | None:
    """The numbers of a part, with the range of each; None of a part that is a mix."""
    character, name = split_part(part)
    if character == ALL:
        return BLACK_LIMITS if name == "black" else None
    return CHARACTER_NUMBERS.get(name)


def is_setting(name: str) -> bool:
    """Whether a part of a character (by its name there) is set at once, and followed in its own time."""
    return name in ("motion", "look", "springs", "skin") or name.startswith(LAYER)


def takes_one_number(part: Part) -> bool:
    """Whether one number says all of a part: it has no other, or all of them are of one kind, as of a layer or of
    springs."""
    ranges = ranges_of(part)
    return ranges is not None and (len(ranges) == 1 or ranges is LAYER_LIMITS or ranges is SPRING_LIMITS)


def first_goal(part: Part) -> Goal | None:
    """Where a part stands in a new show, of those that nobody means to set there; None for all others."""
    name = split_part(part)[1]
    if whole_of(part) or passes(part):
        return WITH_FACE
    if name == MACROS:
        return NOTHING_MOVED
    if name in STANDING_MIXES:
        return STANDING_MIXES[name]
    if name == "look":
        return AHEAD
    if name in ("springs", "skin"):
        return dict.fromkeys(CHARACTER_NUMBERS[name], 1.0)
    if name.startswith(LAYER):
        influence = DEFAULT_SETTINGS[check_layer(name.removeprefix(LAYER))].influence
        return {str(region): value for region, value in influence.items()}
    return None


def check_goal(part: Part, goal: Goal) -> Goal:
    """Returns a goal that a part can have, whoever is in the scene and the cast; ValueError, TypeError for another.

    part: `kaori/face`; goal: its mix, or all its numbers.
    """
    ranges = ranges_of(part)
    if part.endswith("/look"):
        return goal_of_target(target_of_goal(dict(goal)))
    if is_of_macros(part):
        return {check_macro_name(name): check_within(goal[name], *MACRO_LIMITS, f"{name} of {part}") for name in goal}
    if ranges is not None:
        return _check_numbers(part, goal, ranges)
    if not goal and (whole_of(part) or passes(part)):
        return WITH_FACE
    if passes(part):
        return goal_of_clip(clip_of_goal(goal))
    if is_pad_goal(part, goal):
        return goal_of_point(*point_of_goal(goal))
    mix = {name: check_within(weight, LOWEST, HIGHEST, f"{name} of {part}") for name, weight in goal.items()}
    if not abs(math.fsum(mix.values()) - 1.0) <= ROUNDING:
        raise ValueError(f"the weights of {part} sum to {math.fsum(mix.values()):g}; they must sum to 1")
    return mix


def _check_numbers(part: Part, goal: Goal, ranges: Ranges) -> Goal:
    if goal.keys() != ranges.keys():
        missing = [f"{name} = 0" for name in ranges if name not in goal] if goal.keys() < ranges.keys() else []
        said = f"; add {', '.join(missing)} for what stays at 0" if missing else ""
        raise ValueError(f"the goal of {part} has {', '.join(goal) or 'nothing'}; expected {', '.join(ranges)}{said}")
    return {name: check_within(goal[name], *ranges[name], _number_of(part, name)) for name in ranges}


def _number_of(part: Part, name: str) -> str:
    """A number of a part in words, with its unit where people would take another for it."""
    of = part.rpartition("/")[2]
    is_angle = of in TURN_LIMITS or (of == "place" and name == "turn")
    return f"{name} of {part} (radians; 1 is 57.3 degrees)" if is_angle else f"{name} of {part}"


def check_names(goal: Goal, names: Iterable[str], what: str) -> None:
    """Raises ValueError for a name of a mix (goal) that there is not. names: those that there are; what: what messages
    call one."""
    for name in goal:
        check_known(name, names, what)


def rank_of(part: Part) -> tuple[bool, Part]:
    """The rank of a part among those called at one time: a whole expression comes before its regions, which it would
    take along."""
    return regions_of(part) == (), part
