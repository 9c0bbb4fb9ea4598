"""Two people and the same expressions of both; how far what a map finds is from the truth, by kind of skin."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_mouth_bag

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]
Parts = Mapping[str, Values]
Carrier = Callable[["Pair"], Mapping[str, Values]]
"""Carries every unit of a pair's source to its face: displacements (V, 3) by the unit's name."""

ALL = "all skin"
SHEET = "sheet"
INNER = "inner skin"
BAG = "bag"


@dataclass(frozen=True, eq=False)
class Pair:
    """Expressions of one person that are known of another.

    space: which both fit; source, face: the two at rest; given, true: what each does, (V, 3) metres by unit; parts:
    what the source's parts do.
    """

    name: str
    space: ParameterSpace
    source: Face
    face: Face
    given: Mapping[str, Values]
    true: Mapping[str, Values]
    parts: Mapping[str, Parts]


def kinds_of_skin(space: ParameterSpace) -> dict[str, Mask]:
    """Which vertices (V,) are sheet, mouth bag, and inner skin otherwise."""
    bag = find_mouth_bag(space)
    in_bag = np.zeros(space.vertex_count, np.bool_) if bag is None else np.isin(space.welded, bag.vertices)
    in_bag &= ~space.on_sheet
    everywhere = np.ones(space.vertex_count, np.bool_)
    return {ALL: everywhere, SHEET: space.on_sheet, INNER: ~space.on_sheet & ~in_bag, BAG: in_bag}


def measure_errors(pair: Pair, found: Mapping[str, Values]) -> dict[str, Values]:
    """|found - true| / |true| of every unit (units,), by kind of skin: over its vertices, and over the whole truth but
    for the sheet, which is measured against its own."""
    errors: dict[str, list[float]] = {}
    for kind, mask in kinds_of_skin(pair.space).items():
        for unit, true in pair.true.items():
            against = true[mask] if kind == SHEET else true
            lacks = np.linalg.norm((found[unit] - true)[mask])
            errors.setdefault(kind, []).append(float(lacks / max(float(np.linalg.norm(against)), 1e-9)))
    return {kind: np.array(each) for kind, each in errors.items()}
