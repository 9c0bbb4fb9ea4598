"""Limb fields as people write them: bumps on unrolled limbs, named, drawn in pairs, driven."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

LimbName = Literal["trunk", "upperarm", "lowerarm", "upperleg", "lowerleg"]
Driver = Literal["", "elbow", "knee", "breath"]
BREATH = "breath"
"""What drives a field: the breath that is in the chest."""
LIMB_KIND = "limb"
"""The kind of the expressions whose names play limb fields."""
SIDES_OF_NAMES = {"Left": "L", "Right": "R"}
MOST = 0.6
"""How far a bump goes out, of the limb's radius, and along, of its length."""

Share = Annotated[float, msgspec.Meta(ge=-0.5, le=1.5)]
Degrees = Annotated[float, msgspec.Meta(ge=-180.0, le=180.0)]
Size = Annotated[float, msgspec.Meta(gt=0.0, le=180.0)]
Much = Annotated[float, msgspec.Meta(ge=-MOST, le=MOST)]


class Bump(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A bump on a limb: `(1 - d^2)^2` around its middle, where d is how far off it is, in its own half lengths.

    way, angle: of its middle, shares of the limb and degrees (0 ahead, + outward, on the trunk to the left); long,
    wide: half of how far it reaches along (a share of the limb) and around (degrees; 0: all around); out: how far it
    goes out, a ratio of the radius; round: degrees that it turns about the axis; along: how far it moves to the limb's
    end, a ratio of its length; both: on the trunk, on the other side too.
    """

    limb: LimbName
    way: Share
    angle: Degrees = 0.0
    long: Size = 0.2
    wide: Annotated[float, msgspec.Meta(ge=0.0, le=180.0)] = 0.0
    out: Much = 0.0
    round: Annotated[float, msgspec.Meta(ge=-30.0, le=30.0)] = 0.0
    along: Much = 0.0
    both: bool = False


class LimbRecipe(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A limb field as people write it: its name and label, of a pair without the side (`pair`: bicepsLeft and
    bicepsRight, a channel each); what drives it; its bumps."""

    name: str
    label: str
    bumps: tuple[Bump, ...]
    pair: bool = False
    driver: Driver = ""


class LimbChannel(msgspec.Struct, frozen=True):
    """A channel of a recipe: its name, what people read, and the sides of the figure that it moves."""

    name: str
    label: str
    sides: tuple[str, ...]


def limb_channels(recipe: LimbRecipe) -> list[LimbChannel]:
    """The channels of a recipe: one, or one for each side. recipe: how it was written."""
    if not recipe.pair:
        return [LimbChannel(recipe.name, recipe.label, tuple(SIDES_OF_NAMES.values()))]
    return [
        LimbChannel(recipe.name + name, f"{recipe.label}, {name.lower()}", (side,))
        for name, side in SIDES_OF_NAMES.items()
    ]


def read_limb_recipes(text: bytes) -> list[LimbRecipe]:
    """The limb fields of a TOML text, a table `field` for each; ValueError where it holds something else."""
    return msgspec.toml.decode(text, type=dict[Literal["field"], list[LimbRecipe]])["field"]
