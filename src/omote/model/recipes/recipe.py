"""Recipes: how an own expression, face or pose was made, as plain data for storage, undo and exchange."""

from __future__ import annotations

import msgspec

from omote.model.body.pose_recipe import PoseRecipe
from omote.model.space.complexion import PALE, ComplexionNumbers

Vector = tuple[float, float, float]

KEY = "#"
"""Begins the source of what is known by its content's key; a source without it is a name of the built-in cast."""


class Layer(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A weighted expression (a blendshape) under the control points.

    source: a name of the built-in cast, or `#` and a content key; label: what people read; region: one of
    `sculpting.regions.REGIONS`, or None for the whole face; mirrored: left and right exchanged; muted: kept, but not
    added (`compose_expression`).
    """

    source: str
    label: str
    weight: float = 1.0
    region: str | None = None
    mirrored: bool = False
    muted: bool = False


class Pull(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A muscle's contraction, 0 at rest, 1 as far as it goes."""

    muscle: str
    contraction: float


class Recipe(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="expression"):
    """An expression as an artist made it; `compose_expression` adds up its fields.

    net: rows of the generic face's sheet under the control points; vectors: dtheta (radians), dh (metres), R (1 on the
    surface) of each; ground: `#` and the key of a field that the net cannot say, or None; eyes: left yaw, pitch, right
    yaw, pitch, radians, pupil and complexion (`space.complexion`): what is added to those of ground and layers.
    """

    net: tuple[int, ...]
    vectors: tuple[Vector, ...]
    ground: str | None = None
    layers: tuple[Layer, ...] = ()
    pulls: tuple[Pull, ...] = ()
    eyes: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    pupil: float = 0.0
    complexion: ComplexionNumbers = PALE


class GainRow(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A gain that a recipe sets: its region (`space.gain.GAIN_REGIONS`), value, and the expression that alone it is
    for, by name, or None."""

    region: str
    value: float
    expression: str | None = None


class FaceRecipe(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="face"):
    """A face made from faces (`compose_face`): a mix, regions from others, caricature, then handles.

    base: faces by weight, summing to one (sources as in `Layer`); regions: for a region the source it comes from;
    amount: of caricature, 1 for none; points: rows of the sheet under the handles; moves: metres, from where base,
    regions and amount put them; gains: in place of those that base and regions bring; look: colours, traits and hair
    style by the names that `cast.Look` has for them, in place of those that base and regions bring.
    """

    base: dict[str, float]
    regions: dict[str, str] = {}
    amount: float = 1.0
    points: tuple[int, ...] = ()
    moves: tuple[Vector, ...] = ()
    gains: tuple[GainRow, ...] = ()
    look: dict[str, str | float] = {}


AnyRecipe = Recipe | FaceRecipe | PoseRecipe


def sources(recipe: AnyRecipe, /) -> frozenset[str]:
    """Every source that a recipe names; a pose is made from nothing else."""
    if isinstance(recipe, PoseRecipe):
        return frozenset()
    if isinstance(recipe, FaceRecipe):
        return frozenset(recipe.base) | frozenset(recipe.regions.values())
    ground = () if recipe.ground is None else (recipe.ground,)
    return frozenset((*ground, *(layer.source for layer in recipe.layers)))
