"""The JSON of `VRMC_vrm`: who and what for (meta), bones, expressions, gaze and first person.

VRM Consortium, VRMC_vrm-1.0: https://github.com/vrm-c/vrm-specification/tree/master/specification/VRMC_vrm-1.0
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from omote.interchange.avatar.preset_expressions import UNITS, Overrides, Weights
from omote.interchange.avatar.vrm_licence import LICENCE_URL, Terms
from omote.interchange.formats.glb_writer import Json, Shape
from omote.interchange.formats.rig import Position
from omote.model.cast import Cast

EXTENSION = "VRMC_vrm"
VERSION = "1.0"


def describe_meta(name: str, authors: Sequence[str], terms: Terms, notice: str, /) -> Json:
    """The model's name, its authors, and what others may do with it.

    name, authors: as written; terms: by VRM's names; notice: on copyright.
    """
    credits = {"name": name, "authors": list(authors), "copyrightInformation": notice, "licenseUrl": LICENCE_URL}
    return {**credits, **terms}


def describe_expressions(
    shapes: Sequence[Shape],
    presets: Mapping[str, Weights],
    customs: Mapping[str, str],
    overrides: Mapping[str, Overrides],
    shown: Callable[[Weights], Mapping[int, float]],
) -> Json:
    """All presets and custom expressions; shapes stand at nodes from 1 on; customs: targets by what they are called.

    shapes: in the order of their nodes; presets: weights by name; overrides: by preset; shown: by weights, how much
    shows of materials that nothing shows of at rest, by their places.
    """
    return {
        "preset": {
            preset: _expression(shapes, weights, overrides.get(preset, Overrides()), shown(weights))
            for preset, weights in presets.items()
        },
        "custom": {
            custom: _expression(shapes, {name: 1.0}, Overrides(), shown({name: 1.0}))
            for custom, name in customs.items()
        },
    }


def _expression(shapes: Sequence[Shape], weights: Weights, overrides: Overrides, shown: Mapping[int, float]) -> Json:
    binds = [
        {"node": node, "index": list(shape.targets).index(name), "weight": part}
        for node, shape in enumerate(shapes, start=1)
        for name, part in weights.items()
        if name in shape.targets
    ]
    words = {False: "none", True: "blend"}
    targets: Json = {"morphTargetBinds": binds} if binds else {}
    if shown:
        targets["materialColorBinds"] = [
            {"material": place, "type": "color", "targetValue": [1.0, 1.0, 1.0, part]} for place, part in shown.items()
        ]
    return targets | {
        "isBinary": False,
        "overrideBlink": words[overrides.blink],
        "overrideLookAt": words[overrides.look],
        "overrideMouth": words[overrides.mouth],
    }


def describe_gaze(cast: Cast, eyes: Position, /) -> Json:
    """The gaze by expressions, so that lids go along; a direction is met by as much of `lookLeft` as turns there.

    eyes: from the head's joint to between the eyes, metres; empty where the cast has no units that turn the eyes.
    """
    across, down, up = (_turn(cast, *names) for names in (("lookLeft", "lookRight"), ("lookDown",), ("lookUp",)))
    if not across or not down or not up:
        return {}
    sides = {"rangeMapHorizontalInner": across, "rangeMapHorizontalOuter": across}
    maps = {**sides, "rangeMapVerticalDown": down, "rangeMapVerticalUp": up}
    reach = {name: {"inputMaxValue": degrees, "outputScale": 1.0} for name, degrees in maps.items()}
    return {"type": "expression", "offsetFromHeadBone": list(eyes), **reach}


def _turn(cast: Cast, *presets: str) -> float:
    """By how many degrees presets turn an eye, in the mean."""
    units = [cast.expressions[name] for preset in presets for name in UNITS[preset] if name in cast.expressions]
    turns = [abs(unit.eyes).max() for unit in units]
    return round(math.degrees(sum(turns) / len(turns)), 3) if turns else 0.0


def describe_bones(nodes: Mapping[str, int], /) -> Json:
    """Which node is which bone."""
    return {"humanBones": {name: {"node": node} for name, node in nodes.items()}}


def describe_first_person(heads: Mapping[int, bool], /) -> Json:
    """What is of the head, the eyes in it do not see. heads: by the nodes of meshes, whether they are of it."""
    annotations = [{"node": node, "type": "thirdPersonOnly" if head else "both"} for node, head in heads.items()]
    return {"meshAnnotations": annotations}
