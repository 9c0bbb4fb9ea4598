"""What VRM's expressions are made of: the presets from the cast's own, the custom ones of Perfect Sync from ARKit's."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.cast import Cast
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.speech.visemes import MOUTH_UNITS, VISEMES, mouth_of

Points = NDArray[np.float64]
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
SHUT, AJAR = 0.3, 0.5
"""How far lids close, of a blink, and how far lips part, of an `aa`, until a blink or speech on top of it shows."""
_LIDS = ((0.031, 0.0047, 0.141), (0.031, -0.0044, 0.140)), ((-0.031, 0.0047, 0.141), (-0.031, -0.0044, 0.140))
_LIPS = (((0.0, -0.059, 0.160), (0.0, -0.077, 0.156)),)
"""What is above and below each opening, metres on the generic head."""
_LEAST = 1e-4
"""Metres: what opens less cannot be told."""


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
    found: dict[str, dict[str, float]] = {preset: {name: 1.0} for preset, name in EMOTIONS.items()}
    for preset, viseme in VOWELS.items():
        mouth = mouth_of(np.array([float(each == viseme) for each in VISEMES]))
        found[preset] = {unit: round(float(part), 3) for unit, part in zip(MOUTH_UNITS, mouth, strict=True)}
    found |= {preset: dict.fromkeys(units, 1.0) for preset, units in UNITS.items()}
    found |= {name: {name: 1.0} for name in chosen if name in found}
    return {
        preset: {name: part for name, part in weights.items() if part and name in cast.expressions}
        for preset, weights in found.items()
    }


def custom_expressions(cast: Cast, chosen: Iterable[str], /) -> dict[str, str]:
    """Custom expressions by what they are called: all units of ARKit as Perfect Sync has them (EyeBlinkLeft), and those
    that are chosen and no preset."""
    units = [name for name, title in cast.titles.items() if title.kind == "arkit"]
    called = {name[0].upper() + name[1:]: name for name in units}
    return called | {name: name for name in chosen if name not in (*units, *PRESETS)}


def required_expressions(cast: Cast, chosen: Collection[str], /) -> list[str]:
    """The expressions that an avatar needs as targets: what its presets are made of, and its custom ones."""
    presets = [name for weights in preset_weights(cast, chosen).values() for name in weights]
    return list(dict.fromkeys([*custom_expressions(cast, chosen).values(), *presets]))


def find_overrides(
    space: ParameterSpace, rest: Points, poses: Mapping[str, Points], presets: Mapping[str, Weights]
) -> dict[str, Overrides]:
    """What each emotion of a face overrides, by how far it closes the lids and parts the lips; and a blink the gaze.

    rest (V, 3), poses: the skin at rest and wearing each expression, metres. Lids that are nearly shut would be shut
    twice by a blink; eyes that look down have lowered lids, which a blink would lower again.
    """
    worn = {
        preset: rest + sum(part * (poses[name] - rest) for name, part in weights.items())
        for preset, weights in presets.items()
    }
    shut = {preset: -_opens(space, rest, points, _LIDS) for preset, points in worn.items()}
    ajar = {preset: _opens(space, rest, points, _LIPS) for preset, points in worn.items()}
    found = {
        preset: Overrides(
            blink=shut[preset] >= max(SHUT * shut["blink"], _LEAST),
            mouth=ajar[preset] >= max(AJAR * ajar["aa"], _LEAST),
        )
        for preset in EMOTIONS
    }
    return found | {"blink": Overrides(look=True)}


def _opens(
    space: ParameterSpace, rest: Points, worn: Points, pairs: Iterable[tuple[tuple[float, ...], tuple[float, ...]]]
) -> float:
    """How much farther what is above an opening is from what is below, metres, the mean of several."""
    rows = cKDTree(space.points).query(np.array([list(pair) for pair in pairs]))[1]
    moved = (worn - rest)[rows, 1]
    return float((moved[:, 0] - moved[:, 1]).mean())
