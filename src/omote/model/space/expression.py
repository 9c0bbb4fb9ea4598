"""Expressions: local deformation data, fields on S that belong to no face (paper, section 2.2)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Expression:
    """A field (dtheta, dh, R) on S with what the sheet cannot say: inner skin, parts, eyes.

    dtheta (V,) radians, dh (V,) metres, ratio (V,) of radii (zero, zero, one where nothing moves and off the sheet);
    residual (inner, 3) and parts (n, 3) by name: metres on the generic face over what the bindings predict;
    eyes (2, 2): yaw and pitch of the left and the right eyeball, radians; radius, transfer: the rules under
    which it was taken; pupil: what it adds to the pupils, 1 as wide as they go, -1 as narrow.
    Raises ValueError on other shapes, values that are not finite and ratios that are not positive.
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

    def __post_init__(self) -> None:
        count = np.shape(self.dtheta)
        for name, shape in (
            ("dtheta", count),
            ("dh", count),
            ("ratio", count),
            ("residual", (*np.shape(self.residual)[:1], 3)),
            ("eyes", (2, 2)),
        ):
            object.__setattr__(self, name, _validate(getattr(self, name), name, shape))
        object.__setattr__(self, "pupil", float(_validate([self.pupil], "pupil", (1,))[0]))
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
    result.setflags(write=False)
    return result
