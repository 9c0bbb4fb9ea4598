"""Writes what Python and the web share into `web/src`: `python tools/messages.py [--check]`.

`messages.ts`, `editing_messages.ts`, `microphone_messages.ts` and `camera_messages.ts` have the messages of the links,
`constants.ts` the names, ranges and lengths.
"""

from __future__ import annotations

import dataclasses
import inspect
import json
import sys
import types
import typing
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import msgspec
import numpy as np

from omote.edit.protocol import messages as editing
from omote.inputs.microphone import microphone_messages as microphone
from omote.inputs.microphone.sound_features import SAMPLE_RATE
from omote.inputs.performers import camera_messages as camera
from omote.interchange.formats.file_kinds import FILE_CONTENTS
from omote.interchange.part_textures import ARCH, ARCH_DEPTH, TOOTH_REACH
from omote.interchange.skin_texture import HAIRLINE
from omote.interchange.skin_texture import LAYERS as SKIN_LAYERS
from omote.interchange.tooth_profiles import jaw_table
from omote.model.body.correctives import (
    FINGER_BENDS,
    FINGERS,
    HINGE_BENDS,
    HINGES,
    HIP_BENDS,
    HIPS,
    SHAPES,
    SHOULDER_SHARES,
    SHOULDER_WAYS,
    SHOULDERS,
)
from omote.model.body.limb_recipe import BREATH
from omote.model.body.limbs import LIMBS
from omote.model.body.pose_regions import POSE_REGIONS
from omote.model.body.twist import SPREAD
from omote.model.fitting.landmarks import SEVEN
from omote.model.folding import LIDS, RANGE
from omote.model.hair import STRETCH
from omote.model.known_names import PLAY_REGIONS
from omote.model.sculpting.sculpt import WARP_UNIT
from omote.model.space.complexion import OF_REGION, REGIONS, SPOTS
from omote.model.space.eye_socket import FAR, NEAR
from omote.model.space.gain import LEAST_GAIN, MOST_GAIN, NEUTRAL_GAINS
from omote.model.space.lid_lip_lines import RUNGS
from omote.perform.clips.clip_parts import CLIP_PARTS
from omote.perform.complexion import RANGES, SKIN_FADERS, SKIN_LIMIT
from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_action import CueAction
from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.figures.limb_mix import TENSED
from omote.perform.figures.pose_mix import BREATH_IN, CHEST, IDLE_POSES, WEIGHT
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, DRIVEN, LAYER_PARTS, LAYERS, ROUTE_PARTS
from omote.perform.layers.source_frame import SPEECH
from omote.perform.lights import BACKGROUNDS, FIRST_LIGHT, LIGHTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST
from omote.perform.mappings.mapping import (
    LONGEST_FOLLOWER,
    LONGEST_MACRO,
    MOST_TARGETS,
    HalfBelow,
    MacroCondition,
    MacroMapping,
    MacroTarget,
)
from omote.perform.mappings.monotone_curve import MOST_KNOTS, NEAREST_KNOTS
from omote.perform.pads.blend_space import FEWEST_LOOKS, LEAST_APART, MOST_LOOKS, MOST_PADS, PadLook
from omote.perform.scene.character_names import ALL, FIRST_CHARACTER, MOST_CHARACTERS
from omote.perform.scene.framings import JOINT, SHOT_SIZES, SIZED
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.show import messages
from omote.show.access.access_documents import ACCESS_STRUCTS, REVOKED_CODE
from omote.show.access.access_role import ACCESS_ROLES
from omote.show.declaration import Message
from omote.show.messages import CLIENT_MESSAGES, LINK_PATH, PROTOCOL_VERSION, SERVER_MESSAGES, STATE_RATE, STRUCTS
from omote.show.objects.hand.setups import LONGEST_SETUP_NAME
from omote.show.objects.stages import Level
from tools.baking.skin.brows import LINE, REACH

FOLDER = Path(__file__).parent.parent / "web" / "src" / "link"
HEAD = "// Written by tools/messages.py from {}. Do not edit: run `python tools/messages.py`.\n"
WIDTH = 120
"""Characters of a line, as the web's formatter has it."""
VALUES = (Move, CueAction, Cue, PadLook, HalfBelow, MacroTarget, MacroCondition, MacroMapping)
"""Values of the engine that travel as they are."""
PLAIN = {float: "number", int: "number", str: "string", bool: "boolean", bytes: "Uint8Array", type(None): "null"}


def type_script(annotation: object) -> str:
    """The TypeScript type of a Python annotation; TypeError for one the wire does not know."""
    if isinstance(annotation, type) and annotation in PLAIN:
        return PLAIN[annotation]
    if isinstance(annotation, type) and (issubclass(annotation, msgspec.Struct) or annotation in VALUES):
        return annotation.__name__
    return _generic(typing.get_origin(annotation), typing.get_args(annotation), annotation)


def value_type(value: type[Any]) -> str:
    """One exported type of a value of the engine, with the first line of its docstring as its comment."""
    hints = typing.get_type_hints(value)
    fields = "".join(f"  {each.name}: {type_script(hints[each.name])};\n" for each in dataclasses.fields(value))
    comment = (value.__doc__ or "").splitlines()[0]
    return f"/** {comment} */\n\nexport type {value.__name__} = {{\n{fields}}};\n"


def interface(struct: type[msgspec.Struct], sent: bool = False) -> str:
    """One exported type, in one line where it fits, with the docstring as its comment.

    `sent`: a page sends it, so that a field with a default may be left out: the show fills it in as it reads. So it may
    where the show leaves out what is as at first.
    """
    config = struct.__struct_config__
    hints = typing.get_type_hints(struct)
    left_out = sent or config.omit_defaults
    fields = [f"{config.tag_field}: {_quote(config.tag)}"] if config.tag is not None else []
    fields += [
        f"{field.name}{'' if field.required or not left_out else '?'}: {type_script(hints[field.name])}"
        for field in msgspec.structs.fields(struct)
    ]
    lines = inspect.cleandoc(struct.__doc__ or "").replace("\n\n", "\n").splitlines()
    comment = f"/** {lines[0]} */" if len(lines) == 1 else "/**\n" + "".join(f" * {line}\n" for line in lines) + " */"
    line = f"export type {struct.__name__} = {{ {'; '.join(fields)} }};\n"
    if len(line) > WIDTH:
        line = f"export type {struct.__name__} = {{\n" + "".join(f"  {one};\n" for one in fields) + "};\n"
    return f"{comment}\n{line}"


def show_module() -> str:
    """The messages of the show's link in TypeScript, the same text for the same messages."""
    constants = [
        f"export const PROTOCOL_VERSION = {PROTOCOL_VERSION};",
        f"export const LINK_PATH = {_quote(LINK_PATH)};",
        f"/** States per second. */\nexport const STATE_RATE = {STATE_RATE:g};",
    ]
    unions = [_union("FromClient", CLIENT_MESSAGES), _union("FromServer", SERVER_MESSAGES)]
    module = _module(messages, constants, [*STRUCTS, *ACCESS_STRUCTS], unions, CLIENT_MESSAGES)
    return "\n".join([module, *map(value_type, VALUES)])


def editing_module() -> str:
    """The messages of the editors' link in TypeScript, recipes and what is kept of them included."""
    constants = [
        f"export const EDITING_VERSION = {editing.EDITING_VERSION};",
        f"export const EDITING_PATH = {_quote(editing.EDITING_PATH)};",
        f"/** Bytes; no message of an editor is longer. */\nexport const EDITING_LIMIT = {editing.EDITING_LIMIT};",
    ]
    unions = [_union("FromEditor", editing.EDITOR_MESSAGES), _union("ToEditor", editing.ANSWERS)]
    return _module(editing, constants, structs_of(editing), unions, editing.EDITOR_MESSAGES)


def camera_module() -> str:
    """The messages of the camera page's link in TypeScript."""
    constants = [
        f"export const CAMERA_VERSION = {camera.CAMERA_VERSION};",
        f"export const CAMERA_PATH = {_quote(camera.CAMERA_PATH)};",
    ]
    unions = [_union("FromCamera", camera.CAMERA_MESSAGES), _union("ToCamera", camera.CAMERA_ANSWERS)]
    return _module(camera, constants, structs_of(camera), unions, camera.CAMERA_MESSAGES)


def microphone_module() -> str:
    """The messages of the microphone page's link in TypeScript."""
    constants = [
        f"export const MICROPHONE_PATH = {_quote(microphone.MICROPHONE_PATH)};",
        f"/** Samples per second. */\nexport const SAMPLE_RATE = {SAMPLE_RATE};",
    ]
    unions = [
        _union("FromMicrophone", microphone.MICROPHONE_MESSAGES),
        _union("ToMicrophone", microphone.PAGE_MESSAGES),
    ]
    return _module(microphone, constants, structs_of(microphone), unions, microphone.MICROPHONE_MESSAGES)


def _lights() -> dict[str, dict[str, object]]:
    """The values of the lights by name, without their labels, which come with the cast."""
    values = {name: dataclasses.asdict(light) for name, light in LIGHTS.items()}
    return {name: {key: value for key, value in light.items() if key != "label"} for name, light in values.items()}


CONSTANTS: Mapping[str, tuple[str, object]] = {
    "MOST_PADS": ("Pads of a show.", MOST_PADS),
    "FEWEST_LOOKS": ("Looks of a pad at least.", FEWEST_LOOKS),
    "MOST_LOOKS": ("Looks of a pad at most.", MOST_LOOKS),
    "LEAST_APART": ("Between the places of two looks of a pad, which go from -1 to 1.", LEAST_APART),
    "LONGEST_MACRO": ("Letters of the name of a macro.", LONGEST_MACRO),
    "MOST_TARGETS": ("Targets of a macro.", MOST_TARGETS),
    "MOST_KNOTS": ("Knots of the curve of a target.", MOST_KNOTS),
    "NEAREST_KNOTS": ("Between two knots of a curve, of the way of its macro.", NEAREST_KNOTS),
    "LONGEST_FOLLOWER": ("Seconds of the rise and of the fall of a target.", LONGEST_FOLLOWER),
    "LONGEST_SETUP_NAME": ("Letters of the name of a set-up.", LONGEST_SETUP_NAME),
    "FIRST_CHARACTER": ("The name of the first character of a new show.", FIRST_CHARACTER),
    "ALL": ("In the place of a character: all of them; a framing: of all that are on the stage.", ALL),
    "FRAMING_JOINT": ("Between the names of the characters of a framing.", JOINT),
    "FRAMING_SIZED": ("Before the size of the shot of a framing.", SIZED),
    "MOST_CHARACTERS": ("Characters that a scene holds at most.", MOST_CHARACTERS),
    "ACCESS_ROLES": ("What people may do: each role all that those before it may.", ACCESS_ROLES),
    "REVOKED_CODE": ("How a link is closed whose token is not valid any more.", REVOKED_CODE),
    "LIGHTS": ("The lights that a show can call, in the order of the console (`perform/lights.py`).", _lights()),
    "FIRST_LIGHT": ("The light that a show begins with.", FIRST_LIGHT),
    "BACKGROUNDS": ("The backgrounds that have a name.", dict(BACKGROUNDS)),
    "PLAY_REGIONS": ("The regions of a face in which an expression can be called alone.", PLAY_REGIONS),
    "LAYERS": ("The layers of a character, lowest first.", LAYERS),
    "LAYER_PARTS": ("What an influence of a layer is of.", LAYER_PARTS),
    "ROUTE_PARTS": ("What a source can play.", ROUTE_PARTS),
    "CLIP_PARTS": ("What a clip can give.", CLIP_PARTS),
    "SPRINGS": ("The springs of a character.", SPRING_NAMES),
    "SKIN_FADERS": ("The faders of a character's skin.", SKIN_FADERS),
    "SKIN_LIMIT": ("How far a fader of the skin goes.", SKIN_LIMIT),
    "COMPLEXION": ("The numbers of a complexion, with the region whose mix brings each.", dict(REGIONS)),
    "BLOOD_SPOTS": (
        "Where blood shows on the generic head: middle, radii (metres), share.",
        {part: [list(spot) for spot in spots] for part, spots in SPOTS.items()},
    ),
    "COMPLEXION_OF_REGION": (
        "What of a complexion a layer brings in one region of the head alone.",
        {region: list(parts) for region, parts in OF_REGION.items()},
    ),
    "LID_UNITS": ("Units whose pressing of the skin counts as rest.", LIDS),
    "FOLDING_MOST": ("What 255 of the folding of a vertex stands for.", RANGE[1]),
    "COMPLEXION_RANGES": (
        "What each part of a complexion is held in where several expressions bring it.",
        dict(zip(REGIONS, RANGES, strict=True)),
    ),
    "DRIVEN_LAYERS": ("The layers that sources drive.", DRIVEN),
    "SPEECH": ("The source of what a character says, which ends by itself.", SPEECH),
    "LIPS_INFLUENCE": (
        "The influence of lips at first, by part; all others have 1 on all.",
        tuple(DEFAULT_SETTINGS["lips"].influence.values()),
    ),
    "FILE_CONTENTS": (
        "What files can hold, by their suffix; the first is what they are taken for.",
        {suffix: list(held) for suffix, held in FILE_CONTENTS.items()},
    ),
    "EASING_NAMES": ("The easings of a call.", tuple(EASINGS)),
    "DEFAULT_EASING": ("The easing of a call that names none.", DEFAULT_EASING),
    "LEVELS": ("The levels of quality, from the cheapest to the best.", typing.get_args(Level)),
    "POSE_REGIONS": ("The parts of a figure that can do a pose of their own.", POSE_REGIONS),
    "SHAPES": ("Correctives of each joint that has some.", SHAPES),
    "HINGES": ("Where limbs that bend begin, where they bend and where they end, as bones.", HINGES),
    "LIMBS": (
        "The limbs: where the axis of each begins and ends, as bones, and the sense in which angles grow about it.",
        [[limb.begin, limb.end, limb.outward] for limb in LIMBS],
    ),
    "TENSED": ("Degrees of a hinge from which on it drives a limb field, and at which it drives all of it.", TENSED),
    "BREATH": ("What drives a limb field: the breath in the chest.", BREATH),
    "HINGE_BENDS": ("Degrees from the straight limb at which these have correctives.", HINGE_BENDS),
    "FINGERS": ("Of each joint of a finger with correctives the bone before it and its own.", FINGERS),
    "FINGER_BENDS": ("Degrees to the palm at which fingers have correctives.", FINGER_BENDS),
    "HIPS": ("Where thighs begin and end.", HIPS),
    "HIP_BENDS": ("Degrees to the front at which hips have correctives.", HIP_BENDS),
    "SHOULDERS": ("Where upper arms begin and end.", SHOULDERS),
    "SHOULDER_WAYS": (
        "Where a left arm points as modelled, and where shoulders have correctives.",
        np.round(SHOULDER_WAYS, 9).tolist(),
    ),
    "SHOULDER_SHARES": (
        "By how much the angle to each of these calls each corrective.",
        np.round(SHOULDER_SHARES, 9).tolist(),
    ),
    "TWIST_SPREAD": ("Of the twist of an upper arm, what its second bone makes alone.", SPREAD),
    "IDLE_POSES": ("The poses that figures come to by themselves: no list of what people call has them.", IDLE_POSES),
    "BREATH_IN": ("The pose of a figure with a breath in its chest.", BREATH_IN),
    "CHEST": ("The pose of a figure whose chest has followed its head.", CHEST),
    "WEIGHT": ("The poses of a figure whose weight is on its left foot, and on its right.", WEIGHT),
    "FACES_OWN": ("In a mix of bodies: those of the faces on air, by their weights.", FACES_OWN),
    "SHOT_SIZES": ("How much of figures a shot shows, from heads alone to all.", SHOT_SIZES),
    "CHANNEL_RANGE": ("The lowest and the highest weight of a channel.", (CHANNEL_LOWEST, CHANNEL_HIGHEST)),
    "NEUTRAL_GAINS": ("A face's gains where it sets none, by region, in the order of the panels.", dict(NEUTRAL_GAINS)),
    "GAIN_RANGE": ("The lowest and the highest gain.", (LEAST_GAIN, MOST_GAIN)),
    "LANDMARKS": ("The points of a scan that people are asked for; left is the character's own.", SEVEN),
    "RUNGS": ("Pairs of points between the edges of lids and lips that corrective shapes keep apart.", RUNGS),
    "SOCKET_NEAR": ("In radii of an eyeball: skin below keeps its height over it exactly.", NEAR),
    "SOCKET_FAR": ("In radii of an eyeball: skin above moves freely.", FAR),
    "WARP_UNIT": ("Metres in which the warp of the handles counts lengths.", WARP_UNIT),
    "SKIN_LAYERS": ("The layers of the skin's picture, from the top.", SKIN_LAYERS),
    "STRETCH": ("How far a face may turn or stretch one piece of a strand of hair, of its own length.", STRETCH),
    "HAIRLINE": ("Radians from straight ahead, and the metres over the eyes where hair begins.", HAIRLINE.tolist()),
    "BROW_LINE": (
        "The middle line of the left brow on the generic head, from nose to temple: x, y, half height, metres.",
        LINE.tolist(),
    ),
    "BROW_REACH": ("Metres from the mirror plane to the first and to the last hair of a brow.", REACH),
    "ARCH": ("Metres from the front teeth back to the middle of the dental arch.", ARCH),
    "TOOTH_REACH": ("Radians along the arch within which vertices belong to one tooth's height.", TOOTH_REACH),
    "JAWS": ("The measures of teeth by jaw and by whose they are, millimetres.", jaw_table()),
    "ARCH_DEPTH": ("Metres behind the front teeth that the teeth's texture spans.", ARCH_DEPTH),
}
"""What exists in both languages and on no message: name, its comment, its value in Python."""


def constants_module() -> str:
    """The shared constants in TypeScript, each as the literal that it is."""
    lines = [
        f"/** {comment} */\nexport const {name} = {_literal(value)};" for name, (comment, value) in CONSTANTS.items()
    ]
    return HEAD.format("the Python tables that it imports") + "\n" + "\n".join(lines) + "\n"


MODULES = {
    "messages.ts": show_module,
    "editing_messages.ts": editing_module,
    "../microphone/microphone_messages.ts": microphone_module,
    "../camera/session/camera_messages.ts": camera_module,
    "constants.ts": constants_module,
}


def structs_of(module: ModuleType) -> list[type[msgspec.Struct]]:
    """Every struct that a module of messages defines or names, in its order."""
    return [value for value in vars(module).values() if _is_message(value)]


def main(arguments: list[str]) -> int:
    """Writes the mirrors; with `--check` only says whether one is stale (exit status 1)."""
    texts = {FOLDER / name: text() for name, text in MODULES.items()}
    if "--check" in arguments:
        return 0 if all(path.exists() and path.read_text() == text for path, text in texts.items()) else 1
    FOLDER.mkdir(parents=True, exist_ok=True)
    for path, text in texts.items():
        path.write_text(text)
    return 0


def _literal(value: object) -> str:
    return json.dumps(value) + (" as const" if isinstance(value, tuple | list | dict) else "")


def _module(
    source: ModuleType,
    constants: list[str],
    structs: list[type[msgspec.Struct]],
    unions: list[str],
    sent: tuple[type[msgspec.Struct], ...],
) -> str:
    head = HEAD.format(f"src/{source.__name__.replace('.', '/')}.py")
    interfaces = [interface(struct, sent=struct in sent) for struct in structs]
    return "\n".join([head, "\n".join(constants) + "\n", *interfaces, *unions])


def _generic(origin: object, arguments: tuple[object, ...], annotation: object) -> str:
    if origin is typing.Literal:
        return " | ".join(map(_quote, arguments))
    if origin in (typing.Union, types.UnionType):
        return " | ".join(map(type_script, arguments))
    if origin is list or (origin is tuple and arguments[1:] == (...,)):
        inner = type_script(arguments[0])
        return f"({inner})[]" if "|" in inner else f"{inner}[]"
    if origin is tuple:
        return f"[{', '.join(map(type_script, arguments))}]"
    if origin in (dict, Mapping) and arguments[0] is str:
        return f"Record<string, {type_script(arguments[1])}>"
    if origin is dict and typing.get_origin(arguments[0]) is typing.Literal:
        return f"Partial<Record<{type_script(arguments[0])}, {type_script(arguments[1])}>>"
    raise TypeError(
        f"no TypeScript for {annotation!r}: use float, int, str, bool, bytes, None, list, tuple, dict or a struct"
    )


def _is_message(value: object) -> bool:
    if not isinstance(value, type) or not issubclass(value, msgspec.Struct):
        return False
    return not (issubclass(value, Message) and value.__subclasses__())


def _union(name: str, members: tuple[type[msgspec.Struct], ...]) -> str:
    names = [member.__name__ for member in members]
    line = f"export type {name} = {' | '.join(names)};\n"
    return (
        line
        if len(line) <= WIDTH
        else f"export type {name} =\n" + "\n".join(f"  | {member}" for member in names) + ";\n"
    )


def _quote(value: object) -> str:
    return f'"{value}"'


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
