"""Expressions: blendshapes defined on S, independent of identity (the paper's local deformation data, section 2.2)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Values
from omote.geometry import mesh
from omote.model.space.complexion import PALE, Complexion, check_complexion

STILL_EYES = (0.0, 0.0, 0.0, 0.0)
"""The turns of eyes by an expression that leaves them alone."""
LONGEST_NAME = 80
"""Characters; what a message of a console may hold (`show/messages.py`)."""


@dataclass(frozen=True, eq=False)
class Expression:
    """An expression: a blendshape as a field (dtheta, dh, R) on S, independent of identity.

    Beside the field it has what the sheet cannot say: inner skin, parts, eyes.

    Parameters
    ----------
    dtheta, dh, ratio : array_like, (V,)
        Radians, metres and the ratio of radii R; 0, 0, 1 where nothing moves and off the sheet.
    residual : array_like, (inner, 3)
        What the inner skin does over what the bindings predict, metres on the generic face.
    parts : mapping of array_like (n, 3), by the name of a part
        The same of the parts.
    eyes : array_like, (2, 2)
        Yaw and pitch of the left and of the right eyeball, radians.
    radius, transfer : str
        The rules under which it was taken.
    pupil : float
        What it adds to the pupils, 1 as wide as they go, -1 as narrow.
    name : str
        Of a built-in expression, by which a face's gain may single it out; others have none.
    ears : array_like, (2, 3)
        How far the left and the right ear turn back, up and out, radians; only faces with a gain for ears answer it.
    head : array_like, (3,)
        Yaw, pitch and roll of the head, radians; only faces with a gain for the head answer it.
    signed : bool
        Whether it is played below 0 as far as above it, as by a spring: ears then go as far the one way as the other.
    complexion : sequence of seven floats
        What it does to blood, tears and sweat, as of `Complexion`, -2 to 2 each.

    Raises
    ------
    ValueError
        On other shapes, values that are not finite and ratios that are not positive.
    TypeError
        Where parts is no mapping.

    Examples
    --------
    >>> smile = cast.expressions["smile"]
    >>> smile.dtheta.shape, bool((smile.ratio > 0).all())
    ((4278,), True)

    References
    ----------
    K. Arai (1993), section 2.2: local deformation data; docs/method.md, "Expressions".
    """

    dtheta: Values
    dh: Values
    ratio: Values
    residual: Values
    parts: Mapping[str, Values] = field(default_factory=lambda: MappingProxyType({}))
    eyes: Values = field(default_factory=lambda: np.zeros((2, 2)))
    radius: str = "origin"
    transfer: str = "smooth"
    pupil: float = 0.0
    name: str = ""
    ears: Values = field(default_factory=lambda: np.zeros((2, 3)))
    head: Values = field(default_factory=lambda: np.zeros(3))
    signed: bool = False
    complexion: Complexion = PALE

    def __post_init__(self) -> None:
        count = np.shape(self.dtheta)
        for name, shape in (
            ("dtheta", count),
            ("dh", count),
            ("ratio", count),
            ("residual", (*np.shape(self.residual)[:1], 3)),
            ("eyes", (2, 2)),
            ("ears", (2, 3)),
            ("head", (3,)),
        ):
            object.__setattr__(self, name, _validate(getattr(self, name), name, shape))
        object.__setattr__(self, "pupil", float(_validate([self.pupil], "pupil", (1,))[0]))
        object.__setattr__(self, "complexion", check_complexion(self.complexion))
        if len(count) != 1:
            raise ValueError(f"dtheta has shape {count}; expected (V,), one angle per vertex")
        low = int(self.ratio.argmin()) if len(self.ratio) else 0
        if len(self.ratio) and self.ratio[low] <= 0:
            raise ValueError(f"ratio[{low}] is {self.ratio[low]}; expected a positive ratio of radii")
        if not isinstance(self.parts, Mapping):
            raise TypeError(
                f"parts of an expression are a {type(self.parts).__name__}; expected a mapping by part name"
            )
        parts = {
            name: _validate(value, f"part {name!r}", (*np.shape(value)[:1], 3)) for name, value in self.parts.items()
        }
        object.__setattr__(self, "parts", MappingProxyType(parts))

    @cached_property
    def eye_turns(self) -> tuple[float, float, float, float]:
        """Yaw and pitch of the left and of the right eyeball, radians, as plain numbers: they are added sixty times a
        second."""
        left_yaw, left_pitch, right_yaw, right_pitch = self.eyes.ravel().tolist()
        turns = left_yaw, left_pitch, right_yaw, right_pitch
        return turns if any(turns) else STILL_EYES


def refuse_name(name: object, what: str, /) -> None:
    """Raises ValueError on a name that nobody could call on the wire, where names are keys, or read on a console.

    what: what messages call it.
    """
    if not isinstance(name, str) or not 1 <= len(name) <= LONGEST_NAME or not name.isprintable():
        shown = repr(name)
        raise ValueError(
            f"{what} is named {shown[:LONGEST_NAME]}; expected a text of 1 to {LONGEST_NAME} printable characters"
        )


@dataclass(frozen=True)
class Title:
    """How an expression is presented: label, kind ("neutral", "performed", "arkit", "makehuman", "omote", "spring",
    "own") and region."""

    label: str
    kind: str = "own"
    region: str = "whole"


def _validate(value: ArrayLike, name: str, shape: tuple[int, ...]) -> Values:
    result = mesh.validate_numbers(value, name=f"{name} of an expression")
    if result.shape != shape:
        raise ValueError(f"{name} of an expression has shape {result.shape}; expected {shape}")
    bad = mesh.rows_out_of_reach(result)
    if len(bad):
        raise ValueError(
            f"{name}[{bad[0]}] of an expression is {result[bad[0]]}; "
            f"expected finite numbers, at most {mesh.FARTHEST:g} from zero"
        )
    return mesh.freeze(result)
