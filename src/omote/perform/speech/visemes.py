"""The fifteen visemes, as Oculus and MPEG-4 name them: which units of ARKit shape the mouth, and how they mix
(docs/method.md, "Speech")."""

from __future__ import annotations

from collections.abc import Container, Mapping
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np

from omote.arrays import Values
from omote.perform.layers.source_frame import SourceFrame
from omote.perform.limits import check_known

Viseme = Literal["sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U"]
VISEMES: tuple[Viseme, ...] = get_args(Viseme)
"""In the order of OVRLipSync and OpenXR; the weights of a mouth are in this order."""
SIL, PP, FF = (VISEMES.index(name) for name in ("sil", "PP", "FF"))

_PAIRS = ("mouthPress", "mouthStretch", "mouthSmile", "mouthUpperUp", "mouthLowerDown")
_SINGLE = ("jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthRollLower", "mouthRollUpper", "tongueOut")
MOUTH_UNITS: tuple[str, ...] = (*_SINGLE, *(f"{pair}{side}" for pair in _PAIRS for side in ("Left", "Right")))
"""The units of ARKit that visemes move; the values of a mouth are in this order."""
_JAW = MOUTH_UNITS.index("jawOpen")
_CLOSE = MOUTH_UNITS.index("mouthClose")

_SHAPES: Mapping[Viseme, Mapping[str, float]] = {
    "sil": {},
    "PP": {"jawOpen": 0.08},
    "FF": {"jawOpen": 0.05},
    "TH": {"jawOpen": 0.15, "tongueOut": 0.3, "mouthLowerDown": 0.1},
    "DD": {"jawOpen": 0.12, "mouthStretch": 0.12, "mouthUpperUp": 0.08, "mouthLowerDown": 0.12},
    "kk": {"jawOpen": 0.18, "mouthStretch": 0.1, "mouthLowerDown": 0.08},
    "CH": {"jawOpen": 0.08, "mouthFunnel": 0.5, "mouthPucker": 0.15, "mouthLowerDown": 0.15},
    "SS": {"jawOpen": 0.04, "mouthStretch": 0.25, "mouthUpperUp": 0.15, "mouthLowerDown": 0.25},
    "nn": {"jawOpen": 0.14, "mouthStretch": 0.08, "mouthLowerDown": 0.1},
    "RR": {"jawOpen": 0.12, "mouthPucker": 0.35, "mouthFunnel": 0.15},
    "aa": {"jawOpen": 0.65, "mouthLowerDown": 0.1},
    "E": {"jawOpen": 0.35, "mouthStretch": 0.3, "mouthLowerDown": 0.15},
    "I": {"jawOpen": 0.18, "mouthSmile": 0.3, "mouthStretch": 0.25, "mouthLowerDown": 0.15},
    "O": {"jawOpen": 0.42, "mouthFunnel": 0.4, "mouthPucker": 0.25},
    "U": {"jawOpen": 0.15, "mouthPucker": 0.7},
}
"""What the jaw, the lips and the tongue do where nothing else is spoken beside it; a pair is both sides."""
_SEAL = {"mouthPress": 0.35, "mouthRollUpper": 0.12, "mouthRollLower": 0.15}
_BITE = {"mouthRollLower": 0.55, "mouthUpperUp": 0.2}
"""What lips do that are closed, and a lower lip that is at the upper teeth."""
_BITE_JAW = 0.05
_DOMINANCE: Mapping[Viseme, tuple[float, float]] = {
    "sil": (1.0, 1.0), "PP": (2.0, 0.2), "FF": (3.0, 0.3), "TH": (1.5, 0.3), "DD": (1.0, 0.2), "kk": (0.7, 0.15),
    "CH": (1.5, 1.5), "SS": (2.5, 0.7), "nn": (0.8, 0.15), "RR": (0.8, 1.0), "aa": (1.0, 0.5), "E": (1.0, 0.8),
    "I": (1.0, 1.0), "O": (1.0, 1.5), "U": (1.0, 2.0),
}  # fmt: skip
"""How much a viseme insists on its jaw and on its lips beside others: the rounding of a vowel goes through a t."""
_NONE = 1e-3
"""The weight of silence where nothing has a weight."""
CLOSING = 0.05
CLOSED = 0.48
"""The shares of PP or FF at which lips begin to close and are closed."""


def _row(shape: Mapping[str, float]) -> Values:
    return np.array([shape.get(unit, shape.get(unit.removesuffix("Left").removesuffix("Right"), 0.0))
                     for unit in MOUTH_UNITS])  # fmt: skip


_TARGETS = np.stack([_row(_SHAPES[viseme]) for viseme in VISEMES])
_INSISTS = np.array([_DOMINANCE[viseme] for viseme in VISEMES])
_COLUMN = np.array([0 if unit == "jawOpen" else 1 for unit in MOUTH_UNITS])
_SEALED = _row(_SEAL)
_BITTEN = _row(_BITE)
_OPENING = np.array(
    [unit.startswith(("mouthFunnel", "mouthUpperUp", "mouthLowerDown", "tongueOut")) for unit in MOUTH_UNITS]
)
"""What parts lips; rounding and spreading go on through a closure."""


def check_viseme(name: object) -> Viseme:
    """The viseme of this name; ValueError that lists all of them where there is none."""
    return check_known(name, VISEMES, "viseme")


def mouth_of(weights: Values) -> Values:
    """The mouth where several visemes are spoken at once, each as much as its weight.

    Each unit is the mean of its values in the visemes, weighed by how much each insists on it (the dominance of Cohen
    and Massaro). Lips close wherever PP has half of the weight, whatever the jaw does, and the lower lip meets the
    teeth where FF has: a mean alone would leave them open.

    Parameters
    ----------
    weights : array (15,)
        In the order of `VISEMES`, 0 or more each; only their shares count.

    Returns
    -------
    array (len(MOUTH_UNITS),)
        Weights of `MOUTH_UNITS`, 0 to 1; continuous in the weights, without a kink that shows.

    References
    ----------
    Cohen, M. M., and Massaro, D. W. (1993): Modeling coarticulation in synthetic visual speech.
    """
    shares = weights.copy()
    shares[SIL] += _NONE
    total = _sum(shares)
    seal = _closure(float(shares[PP]) / total)
    bite = _closure(float(shares[FF]) / total)
    mouth = _mean(shares)
    jaw = float(mouth[_JAW]) * (1.0 - bite) + _BITE_JAW * bite
    mouth[_OPENING] *= (1.0 - seal) * (1.0 - bite)
    mouth += seal * _SEALED
    mouth += (1.0 - seal) * bite * _BITTEN
    mouth[_JAW], mouth[_CLOSE] = jaw, seal * jaw
    return mouth


def speech_frame(mouth: Values, names: Container[str], *, source: str, share: float = 1.0) -> SourceFrame:
    """The frame that plays a mouth on the layer *lips*; units that are not among the channels' names are left out.

    source: who drives the layer.

    It is smooth already, so the layer shows it as it is (`direct`); the layer's influence of 0.7 on the mouth leaves a
    smile what it needs. share: how much of the layer is taken, 0 to 1.
    """
    has = [place for place, unit in enumerate(MOUTH_UNITS) if unit in names]
    units = tuple(MOUTH_UNITS[place] for place in has)
    return SourceFrame(units, mouth[has], source=source, direct=True, share=share)


def _sum(values: Values) -> float:
    """One after the other: the same bits on every machine."""
    total = 0.0
    for value in values.tolist():
        total += value
    return total


def _mean(weights: Values) -> Values:
    """The mean of the visemes' shapes by their weights and dominances, in one order of adding on every machine."""
    insists = weights[:, None] * _INSISTS
    total = np.zeros(2)
    shape = np.zeros(len(MOUTH_UNITS))
    for place in np.flatnonzero(weights):
        total += insists[place]
        shape += insists[place][_COLUMN] * _TARGETS[place]
    mean: Values = shape / total[_COLUMN]
    return mean


def _closure(share: float) -> float:
    """How far lips are closed at a share of the weight, without a kink."""
    u = min(max((share - CLOSING) / (CLOSED - CLOSING), 0.0), 1.0)
    return u * u * (3.0 - 2.0 * u)


def _recipe(viseme: Viseme) -> Mapping[str, float]:
    alone = mouth_of(np.array([float(viseme == other) for other in VISEMES]))
    return MappingProxyType({unit: value for unit, value in zip(MOUTH_UNITS, alone.tolist(), strict=True) if value})


RECIPES: Mapping[Viseme, Mapping[str, float]] = MappingProxyType({viseme: _recipe(viseme) for viseme in VISEMES})
"""Each viseme alone, as weights of units."""


Shapes = tuple[Viseme, ...]

AZURE: tuple[Shapes, ...] = (
    ("sil",), ("aa",), ("aa",), ("O",), ("E",), ("RR",), ("I",), ("U",), ("O",), ("aa", "U"), ("O", "I"), ("aa", "I"),
    ("kk",), ("RR",), ("nn",), ("SS",), ("CH",), ("TH",), ("FF",), ("DD",), ("kk",), ("PP",),
)  # fmt: skip
"""The 22 viseme ids of Microsoft's text to speech, by id."""
RHUBARB: Mapping[str, Shapes] = MappingProxyType(
    {"A": ("PP",), "B": ("SS",), "C": ("E",), "D": ("aa",), "E": ("O",), "F": ("U",), "G": ("FF",), "H": ("nn",),
     "X": ("sil",)}
)  # fmt: skip
"""The mouth shapes of Rhubarb Lip Sync."""
_OTHERS: Mapping[str, Viseme] = MappingProxyType({"ih": "I", "oh": "O", "ou": "U", "ee": "E"})
"""Spellings of Oculus and OpenXR."""


def shapes_of_azure(name: str) -> Shapes:
    """The visemes of an id of Microsoft's text to speech, as text; ValueError for one that there is not."""
    if not (name.isdecimal() and name.isascii() and len(name) <= 2 and int(name) < len(AZURE)):
        raise ValueError(f"there is no viseme id {name[:80]!r}; give 0 to {len(AZURE) - 1}, as Azure sends it")
    return AZURE[int(name)]


def shapes_of_rhubarb(name: str) -> Shapes:
    """The visemes of a shape of Rhubarb; ValueError for one that there is not."""
    if name not in RHUBARB:
        raise ValueError(f"there is no mouth shape {name[:80]!r}; give one of {', '.join(RHUBARB)}, as Rhubarb writes")
    return RHUBARB[name]


def shapes_of_viseme(name: str) -> Shapes:
    """The viseme of a name of Oculus, OpenXR or Ready Player Me (`aa`, `viseme_aa`, `ih`), in any case; ValueError for
    one that there is not."""
    plain = name.removeprefix("viseme_")
    if plain in _OTHERS:
        return (_OTHERS[plain],)
    by_case = {viseme.lower(): viseme for viseme in VISEMES}
    return (by_case.get(plain.lower()) or check_viseme(plain),)
