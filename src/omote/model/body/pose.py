"""Poses: what the bones of any body do, against the stand that all of them share."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Values
from omote.geometry.mesh import freeze, validate_numbers
from omote.model.space.expression import refuse_name

STAND = "stand"
"""The pose at rest: every turn is nothing."""
FEET = 2
"""Left and right."""
LARGEST_TURN = 3.5
"""Radians: a joint turns less than a whole turn, and a sum of rotation vectors stays a rotation that people know."""
FARTHEST = 3.0
"""Leg lengths that hips or feet may be away from the stand."""


@dataclass(frozen=True, eq=False)
class Pose:
    """One pose, which belongs to no body (local deformation data of a figure).

    Parameters
    ----------
    name : str
        1 to 80 printable characters.
    turns : array_like, (J, 3)
        The rotation vector of each bone against its parent from the stand, radians, along the head's axes (x to the
        character's left, y up, z forward). Of thighs and shins they say where knees point: feet say where legs end.
    travel : array_like, (3,)
        Of the hips from the stand, leg lengths.
    feet : array_like, (2, 3)
        Of the left and the right ankle from the stand, leg lengths.
    feet_turns : array_like, (2, 3)
        The rotation vector of each foot from the stand, radians; it is of the house and not of the shin, so that a
        foot that stands stays flat.
    label : str
        What people read; the name where it is empty.

    Raises
    ------
    ValueError
        On other shapes, values that are not finite or out of range, and names that nobody could call.

    References
    ----------
    F. S. Grassia, Practical parameterization of rotations using the exponential map, 1998.
    """

    name: str
    turns: Values
    travel: Values = field(default_factory=lambda: np.zeros(3))
    feet: Values = field(default_factory=lambda: np.zeros((FEET, 3)))
    feet_turns: Values = field(default_factory=lambda: np.zeros((FEET, 3)))
    label: str = ""

    def __post_init__(self) -> None:
        refuse_name(self.name, "a pose")
        turns = np.asarray(self.turns, np.float64)
        if turns.ndim != 2 or turns.shape[1] != 3:
            raise ValueError(f"the turns of pose {self.name!r} are {turns.shape}; expected three for each bone")
        _check(self, "turns", turns.shape, LARGEST_TURN, "radians")
        _check(self, "travel", (3,), FARTHEST, "leg lengths")
        _check(self, "feet", (FEET, 3), FARTHEST, "leg lengths")
        _check(self, "feet_turns", (FEET, 3), LARGEST_TURN, "radians")
        object.__setattr__(self, "label", self.label or self.name.replace("_", " ").capitalize())


def _check(pose: Pose, name: str, shape: tuple[int, ...], most: float, unit: str) -> None:
    given: ArrayLike = getattr(pose, name)
    values = validate_numbers(given, name=f"{name} of pose {pose.name!r}").astype(np.float64)
    if values.shape != shape:
        raise ValueError(f"{name} of pose {pose.name!r} are {values.shape}; expected {shape}")
    if not np.abs(values).max(initial=0.0) <= most:  # also what is no number
        raise ValueError(
            f"{name} of pose {pose.name!r} reach {np.abs(values).max():.3g} {unit}; expected {most:g} at most"
        )
    object.__setattr__(pose, name, freeze(np.array(values)))
