"""Names that other programs have for mouth shapes: each as one of our visemes, or as two of them in a row."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omote.perform.speech.visemes import VISEMES, Viseme, check_viseme

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
