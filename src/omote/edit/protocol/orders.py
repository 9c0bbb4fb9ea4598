"""What the workshop is asked to compute for editors: orders and what is made of them, as plain data."""

from __future__ import annotations

import msgspec

from omote.edit.protocol.messages import NetDocument
from omote.model.recipes.recipe import FaceRecipe, Recipe, Vector

Contents = dict[str, bytes]
"""Bytes (`files.contents`) of own things by key, all that an order's recipe names."""


class Bake(msgspec.Struct, frozen=True, tag=True):
    """An own expression or face of a recipe; answered with `Baked`; weave: with the document of the recipe's net."""

    recipe: Recipe | FaceRecipe
    contents: Contents
    with_net: bool = False


class Solve(msgspec.Struct, frozen=True, tag=True):
    """Vectors of a recipe such that its control points `points` lie at `targets` (metres) on a face; answered with
    `Baked` (recipe: with the vectors found; miss).

    `face`: a source; `vectors`: where the solve starts.
    """

    recipe: Recipe
    contents: Contents
    face: str
    points: tuple[int, ...]
    targets: tuple[Vector, ...]
    vectors: tuple[Vector, ...]


class Renet(msgspec.Struct, frozen=True, tag=True):
    """The same expression under another net; answered with `Baked`."""

    recipe: Recipe
    contents: Contents
    net: tuple[int, ...]


class Flat(msgspec.Struct, frozen=True, tag=True):
    """The same expression as one ground, with the points at rest on it; answered with `Baked`."""

    recipe: Recipe
    contents: Contents


class Baked(msgspec.Struct, frozen=True):
    """The recipe as it is now, the key of its content, every content made on the way by key, the net if it is another
    than before, and how far the worst point missed its target, metres."""

    recipe: Recipe | FaceRecipe
    key: str
    contents: Contents
    net: NetDocument | None = None
    miss: float = 0.0


EditOrder = Bake | Solve | Renet | Flat
