"""Limb fields: bulges, breath and puffed sleeves, made once on unrolled limbs and worn by all bodies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from omote.arrays import Floats, Values
from omote.geometry.cylinder import wrap
from omote.geometry.mesh import freeze, validate_numbers
from omote.model.body.limb_recipe import Bump, LimbChannel, LimbRecipe, limb_channels
from omote.model.body.limbs import LIMB_PLACES, LimbSpace
from omote.model.space.expression import refuse_name

HINGE_BONES = {"elbow": "lowerarm01", "knee": "lowerleg01"}
"""The bone that begins at the hinge, without its side."""


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
    return [
        LimbField(channel.name, channel.label, _driver(recipe, channel), _sample(recipe.bumps, space, channel.sides))
        for channel in limb_channels(recipe)
    ]


def _driver(recipe: LimbRecipe, channel: LimbChannel) -> str:
    """What drives a channel: of a hinge the one on its side, and both sides at once have none."""
    bone = HINGE_BONES.get(recipe.driver)
    if bone is None:
        return recipe.driver
    return f"{bone}.{channel.sides[0]}" if recipe.pair else ""


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
