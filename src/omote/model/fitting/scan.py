"""Scans: surfaces of heads that were made elsewhere, as they came, in any unit and about any axes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Values
from omote.geometry import mesh

FEWEST_POINTS = 100
"""Fewer say nothing of a face."""


@dataclass(frozen=True, eq=False)
class Scan:
    """A surface as it was scanned or modelled elsewhere.

    Parameters
    ----------
    positions : array_like, (n, 3)
        Points, in any unit and about any axes; kept as float64.
    triangles : array_like of int, (t, 3), optional
        Rows of positions, counterclockwise from outside; None for a cloud of points.
    colours : array_like of uint8, (n, 3), optional
        sRGB of each point.
    texture : array_like of uint8, (height, width, 3), optional
        sRGB; row 0 is the top of the picture.
    texcoords : array_like, (t, 3, 2), optional
        Of each triangle's corners: u to the right, v down from the texture's top, 0 to 1; with a texture only.
    shapes : mapping of array_like (n, 3), by name
        Displacements of named blendshapes (morph targets), in the unit of positions.

    Raises
    ------
    ValueError
        On other shapes, values that are not finite, fewer than 100 points, triangles of rows that there are not.

    Examples
    --------
    >>> kaori = cast.faces["kaori"]
    >>> omote.Scan(1000.0 * kaori.positions, cast.space.triangles).positions.shape
    (4278, 3)

    References
    ----------
    K. Arai (1993), section 5.1.
    """

    positions: Values
    triangles: NDArray[np.integer] | None = None
    colours: NDArray[np.uint8] | None = None
    texture: NDArray[np.uint8] | None = None
    texcoords: Values | None = None
    shapes: Mapping[str, Values] = field(default_factory=lambda: MappingProxyType({}))

    def __post_init__(self) -> None:
        points = _freeze(mesh.validate_points(self.positions, name="positions of a scan"), np.float64)
        if len(points) < FEWEST_POINTS:
            raise ValueError(f"a scan has {len(points)} points; expected at least {FEWEST_POINTS}")
        count = len(points)
        triangles = None if self.triangles is None else _validate_triangles(self.triangles, count)
        faces = 0 if triangles is None else len(triangles)
        if (self.texture is None) != (self.texcoords is None):
            raise ValueError("a scan has a texture or texture coordinates alone; expected both or neither")
        object.__setattr__(self, "positions", points)
        object.__setattr__(self, "triangles", triangles)
        object.__setattr__(self, "colours", _validate_colours(self.colours, (count, 3)))
        object.__setattr__(self, "texture", _validate_colours(self.texture, (None, None, 3)))
        object.__setattr__(self, "texcoords", _validate_texcoords(self.texcoords, faces))
        object.__setattr__(self, "shapes", _validate_shapes(self.shapes, count))


def _validate_triangles(triangles: ArrayLike, count: int) -> NDArray[np.integer]:
    rows = np.asarray(triangles)
    if rows.ndim != 2 or rows.shape[1:] != (3,) or not np.issubdtype(rows.dtype, np.integer):
        raise ValueError(f"triangles of a scan have shape {rows.shape} of {rows.dtype}; expected (t, 3) of integers")
    if rows.size and not 0 <= rows.min() <= rows.max() < count:
        raise ValueError(f"triangles of a scan name rows {rows.min()} to {rows.max()}; expected 0 to {count - 1}")
    return _freeze(rows, np.int32)


def _validate_colours(colours: ArrayLike | None, shape: tuple[int | None, ...]) -> NDArray[np.uint8] | None:
    if colours is None:
        return None
    values = np.asarray(colours)
    fits = values.ndim == len(shape) and all(
        is_ in (want, None) or want is None for is_, want in zip(values.shape, shape, strict=True)
    )
    if not fits or values.dtype != np.uint8 or not values.size:
        wanted = tuple("any" if size is None else size for size in shape)
        raise ValueError(f"colours of a scan have shape {values.shape} of {values.dtype}; expected {wanted} of uint8")
    return _freeze(values, np.uint8)


def _validate_texcoords(texcoords: ArrayLike | None, faces: int) -> Values | None:
    if texcoords is None:
        return None
    values = np.asarray(texcoords, np.float64)
    if values.shape != (faces, 3, 2) or not np.isfinite(values).all():
        raise ValueError(
            f"texture coordinates of a scan have shape {values.shape}; expected ({faces}, 3, 2) of finite numbers"
        )
    return _freeze(values, np.float64)


def _validate_shapes(shapes: Mapping[str, ArrayLike], count: int) -> Mapping[str, Values]:
    kept = {}
    for name, moves in shapes.items():
        values = mesh.validate_points(np.asarray(moves), name=f"shape {name!r} of a scan")
        if len(values) != count:
            raise ValueError(f"shape {name!r} of a scan has {len(values)} points; expected {count}, one for each")
        kept[name] = _freeze(values, np.float64)
    return MappingProxyType(kept)


def _freeze(values: ArrayLike, kind: Any) -> NDArray[Any]:
    result = np.ascontiguousarray(values, dtype=kind)
    return mesh.freeze(result.copy() if result is values else result)
