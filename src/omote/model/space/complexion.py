"""The complexion that an expression brings: how much blood shows where, tears and sweat.

An expression carries it with its field; what is on air follows in seconds (docs/method.md, "Blood, tears and sweat").
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from omote.model.known_names import PlayRegion

MOST = 2.0
"""What a number of an expression's complexion is at most, either way."""


class Complexion(NamedTuple):
    """Blood in the skin of the cheeks, of nose and chin, of the forehead, around the eyes and in the whole face, 1 a
    strong flush, below 0 pallor; tears, 0 none to 1 as they run; sweat, 0 none to 1 as its beads run."""

    cheeks: float = 0.0
    nose: float = 0.0
    forehead: float = 0.0
    eyes: float = 0.0
    whole: float = 0.0
    tears: float = 0.0
    sweat: float = 0.0


PALE: Complexion = Complexion()
"""Of an expression that leaves blood, tears and sweat alone."""
PARTS = Complexion._fields
ComplexionNumbers = tuple[float, float, float, float, float, float, float]
"""A complexion as documents and messages have it."""
WATER = ("tears", "sweat")
"""The parts that lie on the skin, 0 to 1; all others are blood."""
REGIONS: Mapping[str, PlayRegion | None] = MappingProxyType(
    {
        "cheeks": "mouth",
        "nose": "rest",
        "forehead": "brows",
        "eyes": "eyes",
        "whole": None,
        "tears": "eyes",
        "sweat": None,
    }
)
"""By part, the region whose mix of expressions brings it where regions differ; None: that of the whole face."""


OF_REGION: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "brows": ("forehead",),
        "eyes": ("eyes", "tears"),
        "nose": ("nose",),
        "cheeks": ("cheeks",),
        "skull": ("whole", "sweat"),
    }
)
"""The parts that a layer of a recipe brings in one region of the head alone; all of them without a region."""
SPOTS: Mapping[str, tuple[tuple[float, float, float, float, float], ...]] = MappingProxyType(
    {
        "cheeks": ((0.042, -0.037, 0.029, 0.026, 0.5), (0.058, -0.026, 0.042, 0.028, 0.45)),
        "nose": ((0.0, -0.036, 0.014, 0.013, 1.0), (0.0, -0.098, 0.017, 0.012, 0.6)),
        "forehead": ((0.0, 0.044, 0.046, 0.027, 1.0), (0.0, 0.016, 0.015, 0.014, 0.5)),
        "eyes": ((0.034, -0.003, 0.022, 0.016, 1.0),),
    }
)
"""Where blood shows, on the generic head: middle across (mirrored) and up, radius across and along (metres; a third is
left there), and how much of it."""


def check_complexion(values: object) -> Complexion:
    """A complexion of plain numbers; ValueError on other counts and numbers out of range, TypeError on what is none.

    values: one number for each of `PARTS`.
    """
    if not isinstance(values, Sequence) or isinstance(values, str):
        raise TypeError(f"the complexion of an expression is a {type(values).__name__}; expected {len(PARTS)} numbers")
    if len(values) != len(PARTS):
        raise ValueError(
            f"the complexion of an expression has {len(values)} numbers; expected {len(PARTS)}: {', '.join(PARTS)}"
        )
    for part, value in zip(PARTS, values, strict=True):
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise TypeError(f"{part} of a complexion is {value!r}; expected a number")
        if not abs(value) <= MOST:
            raise ValueError(f"{part} of a complexion is {value!r}; expected a number from {-MOST:g} to {MOST:g}")
    return Complexion(*map(float, values)) if any(values) else PALE
