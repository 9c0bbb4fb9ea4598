"""What VRM's expressions are made of: the presets from the cast's own, the custom ones of Perfect Sync from ARKit's."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from omote.arrays import Points
from omote.model.cast import Cast
from omote.model.space.head_size import HEAD_METRES, head_height
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.speech.visemes import MOUTH_UNITS, VISEMES, mouth_of

Weights = Mapping[str, float]

EMOTIONS = {"happy": "joy", "angry": "angry", "sad": "sad", "relaxed": "smile", "surprised": "surprise"}
VOWELS = {"aa": "aa", "ih": "I", "ou": "U", "ee": "E", "oh": "O"}
UNITS = {
    "blink": ("eyeBlinkLeft", "eyeBlinkRight"),
    "blinkLeft": ("eyeBlinkLeft",),
    "blinkRight": ("eyeBlinkRight",),
    "lookUp": ("eyeLookUpLeft", "eyeLookUpRight"),
    "lookDown": ("eyeLookDownLeft", "eyeLookDownRight"),
    "lookLeft": ("eyeLookOutLeft", "eyeLookInRight"),
    "lookRight": ("eyeLookInLeft", "eyeLookOutRight"),
    "neutral": (),
}
PRESETS = (*EMOTIONS, *VOWELS, *UNITS)
"""All that VRM 1.0 has."""
SHUT = 0.3
AJAR = 0.5
"""How far lids close, of a blink, and how far lips part, of an `aa`, until a blink or speech on top of it shows."""
_LIDS = ((0.031, 0.0047, 0.141), (0.031, -0.0044, 0.140)), ((-0.031, 0.0047, 0.141), (-0.031, -0.0044, 0.140))
_LIPS = (((0.0, -0.059, 0.160), (0.0, -0.077, 0.156)),)
"""What is above and below each opening, metres on a generic head that is HEAD_METRES tall."""
_LEAST_METRES = 1e-4
"""What opens less cannot be told."""


@dataclass(frozen=True)
class Overrides:
    """What an expression lessens by as much as it is worn: VRM's `overrideBlink`, `overrideLookAt`, `overrideMouth`."""

    blink: bool = False
    look: bool = False
    mouth: bool = False


def preset_weights(cast: Cast, chosen: Collection[str] = (), /) -> dict[str, dict[str, float]]:
    """The weights of expressions that add up to each preset; one that is chosen and named like it takes its place.

    What the cast lacks is left out.
    """
    presets: dict[str, dict[str, float]] = {preset: {name: 1.0} for preset, name in EMOTIONS.items()}
    for preset, viseme in VOWELS.items():
        mouth = mouth_of(np.array([float(spoken == viseme) for spoken in VISEMES]))
        presets[preset] = {unit: round(float(part), 3) for unit, part in zip(MOUTH_UNITS, mouth, strict=True)}
    presets |= {preset: dict.fromkeys(units, 1.0) for preset, units in UNITS.items()}
    presets |= {name: {name: 1.0} for name in chosen if name in presets}
    return {
        preset: {name: part for name, part in weights.items() if part and name in cast.expressions}
        for preset, weights in presets.items()
    }


def custom_expressions(cast: Cast, chosen: Iterable[str], /) -> dict[str, str]:
    """Custom expressions by what they are called: all units of ARKit as Perfect Sync has them (EyeBlinkLeft), and those
    that are chosen and no preset.

    cast: with its titles; chosen: names of expressions.
    """
    units = [name for name, title in cast.titles.items() if title.kind == "arkit"]
    called = {name[0].upper() + name[1:]: name for name in units}
    return called | {name: name for name in chosen if name not in (*units, *PRESETS)}


def required_expressions(cast: Cast, chosen: Collection[str], /) -> list[str]:
    """The expressions that an avatar needs as targets: what its presets are made of, and its custom ones.

    cast: with its titles; chosen: names of expressions.
    """
    presets = [name for weights in preset_weights(cast, chosen).values() for name in weights]
    return list(dict.fromkeys([*custom_expressions(cast, chosen).values(), *presets]))


def find_overrides(
    space: ParameterSpace, rest: Points, poses: Mapping[str, Points], presets: Mapping[str, Weights]
) -> dict[str, Overrides]:
    """What each emotion of a face overrides, by how far it closes the lids and parts the lips; and a blink the gaze.

    rest (V, 3), poses: the skin at rest and wearing each expression, metres. Lids that are nearly shut would be shut
    twice by a blink; eyes that look down have lowered lids, which a blink would lower again.

    space: of the face; presets: weights of expressions, by preset.
    """
    worn = {
        preset: rest + sum(part * (poses[name] - rest) for name, part in weights.items())
        for preset, weights in presets.items()
    }
    shut = {preset: -_opens(space, rest, points, _LIDS) for preset, points in worn.items()}
    ajar = {preset: _opens(space, rest, points, _LIPS) for preset, points in worn.items()}
    overrides = {
        preset: Overrides(
            blink=shut[preset] >= max(SHUT * shut["blink"], _LEAST_METRES),
            mouth=ajar[preset] >= max(AJAR * ajar["aa"], _LEAST_METRES),
        )
        for preset in EMOTIONS
    }
    return overrides | {"blink": Overrides(look=True)}


def _opens(
    space: ParameterSpace, rest: Points, worn: Points, pairs: Iterable[tuple[tuple[float, ...], tuple[float, ...]]]
) -> float:
    """How much farther what is above an opening is from what is below, metres, the mean of several."""
    places = np.array([list(pair) for pair in pairs]) * (head_height(space) / HEAD_METRES)
    rows = cKDTree(space.points).query(places)[1]
    moved = (worn - rest)[rows, 1]
    return float((moved[:, 0] - moved[:, 1]).mean())
