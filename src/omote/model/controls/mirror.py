"""Mirrors expressions: the left-right correspondence of the head's vertices, and expressions exchanged by it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Rows = NDArray[np.int32]

_ACROSS = np.array([-1.0, 1.0, 1.0])
_EXACT = 1e-6
"""Metres that a vertex may be off its mirror image."""


@dataclass(frozen=True, eq=False)
class Mirror:
    """Where each vertex's mirror image is: skin (V,); inner (inner,) places among the inner skin; parts: the name of
    the part across and its rows (n,)."""

    skin: Rows
    inner: Rows
    parts: Mapping[str, tuple[str, Rows]]


_mirrors: WeakKeyDictionary[ParameterSpace, Mirror] = WeakKeyDictionary()


def mirror_of(space: ParameterSpace, /) -> Mirror:
    """The mirror of a space, found once. Raises ValueError where the generic head is not symmetric about x = 0."""
    if space not in _mirrors:
        skin = _match_across(space.points, space.points, "the generic head")
        inner = np.full(space.vertex_count, -1, np.int32)
        inner[space.inner.vertices] = np.arange(len(space.inner.vertices), dtype=np.int32)
        _mirrors[space] = Mirror(skin, inner[skin[space.inner.vertices]], _parts(space))
    return _mirrors[space]


def mirror_rows(space: ParameterSpace, /) -> Rows:
    """For each vertex of the generic head the row of its mirror image, its own on the midline: (V,); ValueError as
    `mirror_of`."""
    return mirror_of(space).skin


def mirror_expression(space: ParameterSpace, expression: Expression, /) -> Expression:
    """Exchanges left and right of an expression: its field, its residuals, its eyes, ears and head."""
    mirror = mirror_of(space)
    parts = {other: expression.parts[name][rows] * _ACROSS for other, (name, rows) in mirror.parts.items()
             if name in expression.parts}  # fmt: skip
    return replace(
        expression,
        dtheta=-expression.dtheta[mirror.skin],
        dh=expression.dh[mirror.skin],
        ratio=expression.ratio[mirror.skin],
        residual=expression.residual[mirror.inner] * _ACROSS,
        parts=parts,
        eyes=expression.eyes[::-1] * [-1.0, 1.0],
        ears=expression.ears[::-1],
        head=expression.head * [-1.0, 1.0, -1.0],
        name="",
    )


def _parts(space: ParameterSpace) -> dict[str, tuple[str, Rows]]:
    found = {}
    for name, part in space.parts.items():
        middle = part.points.mean(axis=0) * _ACROSS
        others = [other for other, candidate in space.parts.items() if len(candidate.points) == len(part.points)]
        nearest = min(others, key=lambda other: float(np.linalg.norm(space.parts[other].points.mean(axis=0) - middle)))
        found[name] = (nearest, _match_across(part.points, space.parts[nearest].points, f"part {name!r}"))
    return found


def _match_across(points: Values, others: Values, what: str) -> Rows:
    """For each of points (n, 3) the row of others (m, 3) that is its mirror image."""
    distance, rows = cKDTree(others).query(points * _ACROSS)
    if distance.max() > _EXACT:
        raise ValueError(
            f"{what} is not symmetric about x = 0: vertex {int(distance.argmax())} is {distance.max():.2g} m off its "
            f"mirror image; expected at most {_EXACT:g} m: left and right cannot be exchanged on this head"
        )
    return np.asarray(rows, np.int32)
