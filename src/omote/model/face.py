"""Faces: global deformation data (paper, section 2.1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.model.parts import similarity


@dataclass(frozen=True, eq=False)
class Face:
    """One shape with the topology of the generic face.

    positions (V, 3) metres, skin and inner skin, kept as float32; parts: positions (n, 3) by part name, where the face
    knows better than the bindings. Raises ValueError on other shapes and on values that are not finite; that it fits a
    space is checked where it is used.
    """

    name: str
    positions: NDArray[np.floating]
    parts: Mapping[str, NDArray[np.floating]] = field(default_factory=lambda: MappingProxyType({}))

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name:
            raise ValueError(f"a face is named {self.name!r}; expected a text that is not empty")
        object.__setattr__(self, "positions", _frozen(self.positions, f"positions of face {self.name!r}"))
        parts = {part: _frozen(points, f"part {part!r} of face {self.name!r}") for part, points in self.parts.items()}
        object.__setattr__(self, "parts", MappingProxyType(parts))


def _frozen(points: ArrayLike, name: str) -> NDArray[np.float32]:
    result = np.ascontiguousarray(mesh.checked_points(points, name=name), dtype=np.float32)
    result.setflags(write=False)
    return result


def aligned(
    points: NDArray[np.float64], generic: NDArray[np.float64], /, *, rows: NDArray[np.int32]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rotation (3, 3) and shift (3,) that bring a face nearest to the generic one, size kept (method.md, section 3).

    points, generic (V, 3); rows: the vertices that decide (the sheet's). Apply as `points @ rotation.T + shift`.
    """
    _, rotation, _ = similarity(points[rows], generic[rows])
    return rotation, generic[rows].mean(axis=0) - rotation @ points[rows].mean(axis=0)
