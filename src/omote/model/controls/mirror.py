"""Mirrors expressions: the left-right correspondence of the head's vertices, and expressions exchanged by it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from omote.arrays import Indices, Values
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

_ACROSS = np.array([-1.0, 1.0, 1.0])
_EXACT = 1e-6
"""Metres that a vertex may be off its mirror image."""


@dataclass(frozen=True, eq=False)
class Mirror:
    """Where each vertex's mirror image is: skin (V,); inner (inner,) places among the inner skin; parts: the name of
    the part across and its rows (n,)."""

    skin: Indices
    inner: Indices
    parts: Mapping[str, tuple[str, Indices]]


@weakly_cached
def mirror_of(space: ParameterSpace, /) -> Mirror:
    """The mirror of a space, found once. Raises ValueError where the generic head is not symmetric about x = 0."""
    skin = _match_across(space.points, space.points, "the generic head")
    inner = np.full(space.vertex_count, -1, np.int32)
    inner[space.inner.vertices] = np.arange(len(space.inner.vertices), dtype=np.int32)
    return Mirror(skin, inner[skin[space.inner.vertices]], _parts(space))


def mirror_rows(space: ParameterSpace, /) -> Indices:
    """For each vertex of the generic head the row of its mirror image, its own on the midline: (V,); ValueError as
    `mirror_of`."""
    return mirror_of(space).skin


def mirror_expression(space: ParameterSpace, expression: Expression, /) -> Expression:
    """Exchanges left and right of an expression: its field, its residuals, its eyes, ears and head.

    space: the space of the generic head.
    """
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


def _parts(space: ParameterSpace) -> dict[str, tuple[str, Indices]]:
    images = {}
    for name, part in space.parts.items():
        middle = part.points.mean(axis=0) * _ACROSS
        others = [other for other, candidate in space.parts.items() if len(candidate.points) == len(part.points)]
        nearest = min(others, key=lambda other: float(np.linalg.norm(space.parts[other].points.mean(axis=0) - middle)))
        images[name] = (nearest, _match_across(part.points, space.parts[nearest].points, f"part {name!r}"))
    return images


def _match_across(points: Values, others: Values, what: str) -> Indices:
    """For each of points (n, 3) the row of others (m, 3) that is its mirror image."""
    distance, rows = cKDTree(others).query(points * _ACROSS)
    if distance.max() > _EXACT:
        raise ValueError(
            f"{what} is not symmetric about x = 0: vertex {int(distance.argmax())} is {distance.max():.2g} m off its "
            f"mirror image; expected at most {_EXACT:g} m: left and right cannot be exchanged on this head"
        )
    return np.asarray(rows, np.int32)
