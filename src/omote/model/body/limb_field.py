"""Limb fields: bulges, breath and puffed sleeves, made once on unrolled limbs and worn by all bodies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, Literal

import msgspec
import numpy as np

from omote.arrays import Floats, Values
from omote.geometry.cylinder import wrap
from omote.geometry.mesh import freeze, validate_numbers
from omote.model.body.limbs import LIMB_PLACES, LimbSpace
from omote.model.space.expression import refuse_name

LimbName = Literal["trunk", "upperarm", "lowerarm", "upperleg", "lowerleg"]
Driver = Literal["", "elbow", "knee", "breath"]
BREATH = "breath"
"""What drives a field: the breath that is in the chest."""
HINGE_BONES = {"elbow": "lowerarm01", "knee": "lowerleg01"}
"""The bone that begins at the hinge, without its side."""
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


@dataclass(frozen=True, eq=False)
class LimbField:
    """A field on the limbs of all figures.

    Parameters
    ----------
    name : str
        Of the channel that plays it, 1 to 80 printable characters.
    label : str
        What people read.
    driver : str
        What plays it as long as nobody plays more: "breath", the bone that begins at a hinge ("lowerarm01.L": its
        bend), or "" for nothing.
    values : array_like, (n, 3)
        By row of a `LimbSpace`, at full weight: out, a ratio of the row's radius; round, radians; along, a ratio of
        the limb's length.

    Raises
    ------
    ValueError
        On another shape and values that are not finite.

    References
    ----------
    K. Arai (1993), section 2.2: local deformation data; docs/method.md, "Limbs".
    """

    name: str
    label: str
    driver: str
    values: Floats

    def __post_init__(self) -> None:
        refuse_name(self.name, "a limb field")
        values = np.array(validate_numbers(self.values, name=f"the values of limb field {self.name!r}"), np.float32)
        if values.ndim != 2 or values.shape[1] != 3:
            raise ValueError(f"limb field {self.name!r} has values of {values.shape}; expected three for each row")
        object.__setattr__(self, "values", freeze(values))


def make_fields(recipe: LimbRecipe, space: LimbSpace) -> list[LimbField]:
    """The fields of a recipe on limbs: one, or those of the left and the right side.

    recipe: how it was written; space: of the rows.
    """
    if not recipe.pair:
        driver = "" if recipe.driver != BREATH else BREATH
        return [LimbField(recipe.name, recipe.label, driver, _sample(recipe.bumps, space, ("L", "R")))]
    bones = HINGE_BONES.get(recipe.driver)
    return [
        LimbField(
            recipe.name + name,
            f"{recipe.label}, {name.lower()}",
            recipe.driver if bones is None else f"{bones}.{side}",
            _sample(recipe.bumps, space, (side,)),
        )
        for name, side in SIDES_OF_NAMES.items()
    ]


def _sample(bumps: Iterable[Bump], space: LimbSpace, sides: tuple[str, ...]) -> Floats:
    """The sum of bumps (n, 3) on the limbs of these sides."""
    values = np.zeros((len(space.rows), 3))
    for bump in bumps:
        names = [bump.limb] if bump.limb == "trunk" else [f"{bump.limb}.{side}" for side in sides]
        own = np.isin(space.limbs, [LIMB_PLACES[name] for name in names])
        bell = _bell(bump, space.ways[own], space.angles[own], 1.0)
        turned = bell
        if bump.both:
            other = _bell(bump, space.ways[own], space.angles[own], -1.0)
            bell, turned = bell + other, bell - other
        amounts = np.stack([bump.out * bell, np.radians(bump.round) * turned, bump.along * bell], axis=1)
        values[own] += space.shares[own, None] * amounts
    return values.astype(np.float32)


def _bell(bump: Bump, ways: Values, angles: Values, side: float) -> Values:
    """The bump's shape, 0 to 1, at places of its limb; side: 1 where it was written, -1 on the other side."""
    off = ((ways - bump.way) / bump.long) ** 2
    if bump.wide:
        off = off + (wrap(angles - side * np.radians(bump.angle)) / np.radians(bump.wide)) ** 2
    return np.asarray(np.maximum(1.0 - off, 0.0) ** 2)
