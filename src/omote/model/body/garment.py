"""Garments: what cloth covers of a figure and how far it stands off, made once and worn by all bodies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Floats
from omote.geometry.mesh import freeze, validate_numbers
from omote.model.space.expression import refuse_name

SUIT = "suit"
"""What everybody wears who chose nothing else."""
FIELDS = ("cover", "thick", "trim", "hidden")
"""What of a garment is one number a row."""


@dataclass(frozen=True, eq=False)
class Garment:
    """A garment as fields over the rows of all figures, head, body and skirt; metres on the generic figure.

    Cloth is the skin itself, moved outward: what lies under it is not drawn a second time and cannot come through. All
    fields are linear, so garments mix as faces do: edges slide from where one garment has them to where the other does.

    Parameters
    ----------
    name : str
        1 to 80 printable characters.
    label : str
        What people read.
    cover : array_like, (V + B,)
        How far inside its edge a row lies; what lies outside (below 0) is bare, and a skirt ends there.
    thick : array_like, (V + B,)
        How far it stands off the skin.
    trim : array_like, (V + B,)
        How far inside a part of the second colour a row lies.
    hidden : array_like, (V + B,)
        How far inside the part of the body that a skirt hides: this is not drawn at all.

    Raises
    ------
    ValueError
        On fields of other shapes and values that are not finite.

    References
    ----------
    K. Arai (1993), section 2.2: local deformation data are made once and carried to every model.
    """

    name: str
    label: str
    cover: Floats
    thick: Floats
    trim: Floats
    hidden: Floats

    def __post_init__(self) -> None:
        refuse_name(self.name, "a garment")
        for what in FIELDS:
            object.__setattr__(self, what, _check(self.name, what, getattr(self, what)))
        shapes = {getattr(self, what).shape for what in FIELDS}
        if len(shapes) > 1 or self.cover.ndim != 1:
            raise ValueError(f"the fields of garment {self.name!r} are {sorted(shapes)}; expected one number a row")


def _check(name: str, what: str, values: ArrayLike) -> Floats:
    return freeze(np.array(validate_numbers(values, name=f"{what} of garment {name!r}"), np.float32))
