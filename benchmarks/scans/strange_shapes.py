"""Surfaces that are no head: boxes, balls, noise, a teapot, a hand, a body without its head, a chair."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Values = NDArray[np.float64]
Mesh = tuple[Values, NDArray[np.int64]]
Maker = Callable[[np.random.Generator], Mesh]


def join(pieces: Sequence[Mesh]) -> Mesh:
    """Several meshes as one."""
    starts = np.cumsum([0, *(len(points) for points, _ in pieces)])
    return (
        np.concatenate([points for points, _ in pieces]),
        np.concatenate([triangles + start for (_, triangles), start in zip(pieces, starts, strict=False)]),
    )


def ball(middle: ArrayLike, radii: ArrayLike, count: int = 48) -> Mesh:
    """An ellipsoid."""
    theta, phi = np.meshgrid(np.linspace(0, np.pi, count), np.linspace(0, 2 * np.pi, 2 * count), indexing="ij")
    points = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], axis=-1)
    return points.reshape(-1, 3) * np.asarray(radii) + np.asarray(middle), _lattice(count, 2 * count)


def rod(start: ArrayLike, end: ArrayLike, radius: float, count: int = 24) -> Mesh:
    """A capsule from one point to another."""
    one = np.array(start, float)
    other = np.array(end, float)
    points, triangles = ball((0, 0, 0), (radius, radius, radius), count)
    along = (other - one) / np.linalg.norm(other - one)
    side = np.cross(along, np.eye(3)[np.abs(along).argmin()])
    side /= np.linalg.norm(side)
    frame = np.stack([side, along, np.cross(side, along)])
    return np.where(points[:, 1:2] > 0, other, one) + points @ frame, triangles


def box(middle: ArrayLike, sides: ArrayLike, count: int = 24) -> Mesh:
    """A box, each side a lattice."""
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, count), np.linspace(-0.5, 0.5, count), indexing="ij")
    pieces = []
    for axis in range(3):
        for sign in (-0.5, 0.5):
            points = np.stack([np.full(u.size, sign), u.ravel(), v.ravel()], axis=1)
            pieces.append(
                (np.roll(points, axis, axis=1) * np.asarray(sides) + np.asarray(middle), _lattice(count, count))
            )
    return join(pieces)


def _lattice(rows: int, columns: int) -> NDArray[np.int64]:
    at = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel()
    return np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)])


def _lumps(draw: np.random.Generator) -> Mesh:
    """A ball as large as a head with random hills and pits, as deep as a face's."""
    points, triangles = ball((0, 0, 0), (0.08, 0.12, 0.1), 90)
    away = np.zeros(len(points))
    for _ in range(60):
        middle = points[draw.integers(len(points))]
        width = draw.uniform(0.01, 0.03)
        away += draw.normal(0, 0.3) * width * np.exp(-((points - middle) ** 2).sum(1) / (2 * width**2))
    return points * (1 + away / 0.1)[:, None], triangles


def _noise(draw: np.random.Generator) -> Mesh:
    return draw.normal(size=(30_000, 3)) * draw.uniform(0.05, 0.2, 3), np.zeros((0, 3), np.int64)


def _teapot(draw: np.random.Generator) -> Mesh:
    grip = [ball((-0.13 - 0.05 * np.sin(a), 0.06 * np.cos(a), 0), (0.012, 0.016, 0.012), 12)
            for a in np.linspace(0, np.pi, 12)]  # fmt: skip
    spout = [rod((0.09, -0.03, 0), (0.16, 0.03, 0), 0.02), rod((0.16, 0.03, 0), (0.2, 0.07, 0), 0.014)]
    lid = [ball((0, 0.09, 0), (0.06, 0.015, 0.06)), ball((0, 0.115, 0), (0.015, 0.015, 0.015), 16)]
    return join([ball((0, 0, 0), (0.12, draw.uniform(0.07, 0.1), 0.12)), *grip, *spout, *lid])


def _hand(draw: np.random.Generator) -> Mesh:
    bend = draw.uniform(-0.03, 0.03, 5)
    fingers = [rod((x, 0.05, 0), (1.5 * x, long, bend[i]), 0.009)
               for i, (x, long) in enumerate(((-0.03, 0.11), (-0.01, 0.13), (0.01, 0.125), (0.03, 0.1)))]  # fmt: skip
    return join([ball((0, 0, 0), (0.042, 0.055, 0.016)), *fingers, rod((0.03, -0.02, 0), (0.08, 0.03, bend[4]), 0.011),
                 rod((0, -0.04, 0), (0, -0.2, 0), 0.028)])  # fmt: skip


def _chair(draw: np.random.Generator) -> Mesh:
    high = draw.uniform(0.35, 0.5)
    legs = [box((x, -high / 2, z), (0.04, high, 0.04), 8) for x in (-0.2, 0.2) for z in (-0.2, 0.2)]
    return join([box((0, 0, 0), (0.45, 0.04, 0.45)), box((0, 0.3, -0.2), (0.45, 0.5, 0.03)), *legs])


def _ring(draw: np.random.Generator) -> Mesh:
    return join([ball((np.cos(a), np.sin(a), 0), (0.2, 0.2, draw.uniform(0.1, 0.3)), 12)
                 for a in np.linspace(0, 2 * np.pi, 25)])  # fmt: skip


SHAPES: Mapping[str, Maker] = {
    "cube": lambda draw: box((0, 0, 0), draw.uniform(0.5, 1.5, 3)),
    "ball": lambda draw: ball((0, 0, 0), draw.uniform(0.5, 1.0, 3)),
    "lumps": _lumps, "noise": _noise, "teapot": _teapot, "hand": _hand, "chair": _chair, "ring": _ring,
}  # fmt: skip
"""Makers of each shape, by name."""
