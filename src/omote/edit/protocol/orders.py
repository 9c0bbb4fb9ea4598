"""Orders of editors to the workshop and their results, as plain data: bake, solve, change the net, flatten."""

from __future__ import annotations

import msgspec

from omote.edit.protocol.messages import NetDocument
from omote.model.recipes.recipe import AnyRecipe, Recipe, Vector

Contents = dict[str, bytes]
"""Bytes (`showfile.contents`) of authored faces and expressions by key: all that an order's recipe names."""


class Bake(msgspec.Struct, frozen=True, tag=True):
    """Bakes a recipe into an expression or face; answered with `Baked`; with_net: with the document of its net."""

    recipe: AnyRecipe
    contents: Contents
    with_net: bool = False


class Solve(msgspec.Struct, frozen=True, tag=True):
    """Solves for the vectors with which a recipe's control points `points` lie at `targets` (metres) on a face;
    answered with `Baked` (recipe: with the vectors found; miss).

    `face`: a source; `vectors`: where the solve starts.
    """

    recipe: Recipe
    contents: Contents
    face: str
    points: tuple[int, ...]
    targets: tuple[Vector, ...]
    vectors: tuple[Vector, ...]


class Renet(msgspec.Struct, frozen=True, tag=True):
    """Refits the same expression to another control net; answered with `Baked`."""

    recipe: Recipe
    contents: Contents
    net: tuple[int, ...]


class Flat(msgspec.Struct, frozen=True, tag=True):
    """Flattens an expression into one ground field, with the points at rest on it and muted layers as they were;
    answered with `Baked`."""

    recipe: Recipe
    contents: Contents


class Baked(msgspec.Struct, frozen=True):
    """The recipe as it is now, the key of its content, every content made on the way by key, the net if it is another
    than before, and how far the worst point missed its target, metres."""

    recipe: AnyRecipe
    key: str
    contents: Contents
    net: NetDocument | None = None
    miss: float = 0.0


EditOrder = Bake | Solve | Renet | Flat
