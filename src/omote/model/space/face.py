"""Faces: identities, shapes with the topology of the generic face (the paper's global deformation data, section
2.1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Floats
from omote.geometry import mesh
from omote.model.space.expression import refuse_name
from omote.model.space.gain import Gain, validate_gains


@dataclass(frozen=True, eq=False)
class Face:
    """One shape with the topology of the generic face (an identity).

    Parameters
    ----------
    name : str
        1 to 80 printable characters.
    positions : array_like, (V, 3)
        Skin and inner skin, metres; kept as float32, read-only.
    parts : mapping of array_like (n, 3), by the name of a part
        Where the face knows better than the bindings where its eyeballs, teeth, tongue and lashes are.
    gains : iterable of Gain
        In which strength it answers expressions, region by region; kept as a tuple without those that change nothing.

    Raises
    ------
    ValueError
        On other shapes, values that are not finite and names that nobody could call. That a face fits a space is
        checked where it is used. Where two gains are of one region and expression.
    TypeError
        Where parts is no mapping, or a gain is none.

    Examples
    --------
    >>> wide = omote.Face("wide", cast.faces["kaori"].positions * [1.1, 1.0, 1.0])
    >>> wide.positions.dtype, wide.positions.flags.writeable
    (dtype('float32'), False)

    References
    ----------
    K. Arai (1993), section 2.1: global deformation data.
    """

    name: str
    positions: NDArray[np.floating]
    parts: Mapping[str, NDArray[np.floating]] = field(default_factory=lambda: MappingProxyType({}))
    gains: tuple[Gain, ...] = ()

    def __post_init__(self) -> None:
        refuse_name(self.name, "a face")
        if not isinstance(self.parts, Mapping):
            raise TypeError(
                f"parts of face {self.name!r} are a {type(self.parts).__name__}; expected a mapping by part name"
            )
        object.__setattr__(self, "positions", _freeze(self.positions, f"positions of face {self.name!r}"))
        parts = {part: _freeze(points, f"part {part!r} of face {self.name!r}") for part, points in self.parts.items()}
        object.__setattr__(self, "parts", MappingProxyType(parts))
        object.__setattr__(self, "gains", validate_gains(self.gains, f"face {self.name!r}"))


def _freeze(points: ArrayLike, name: str) -> Floats:
    return mesh.freeze(np.ascontiguousarray(mesh.validate_points(points, name=name), dtype=np.float32))
