"""Heads about other axes, in other units, and what is no head: what several tests of finding share."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import omote
from omote.model.fitting.scan import Scan

Values = NDArray[np.float64]

CAST = omote.load_cast()


def head_points(name: str = "kaori") -> Values:
    """The skin (V, 3) of somebody of the cast, metres."""
    return CAST.faces[name].positions.astype(np.float64)


def head_scan(points: Values, *, seed: int = 0, cut: bool = True) -> Scan:
    """A scan of the cast's skin with points (V, 3), in another order: rows tell nothing."""
    order = np.random.default_rng(seed).permutation(len(points))
    triangles = np.argsort(order)[CAST.space.triangles]
    return Scan(points[order], triangles if cut else None)


def join_scans(*scans: Scan) -> Scan:
    """One scan of several."""
    starts = np.cumsum([0, *(len(scan.positions) for scan in scans)])
    triangles = [
        scan.triangles + start for scan, start in zip(scans, starts, strict=False) if scan.triangles is not None
    ]
    return Scan(np.concatenate([scan.positions for scan in scans]), np.concatenate(triangles))


def turn_by(seed: int) -> Values:
    """A rotation drawn at random."""
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return np.array(turn * np.sign(np.linalg.det(turn)))


def degrees_between(one: Values, other: Values) -> float:
    """The angle of the rotation between two rotations."""
    cosine = (np.trace(one @ other.T) - 1.0) / 2.0
    return float(np.degrees(np.arccos(np.minimum(cosine, 1.0))))


def ball(radii: tuple[float, float, float], count: int = 60) -> Scan:
    """An ellipsoid."""
    theta, phi = np.meshgrid(np.linspace(0.01, 3.13, count), np.linspace(0, 2 * np.pi, count), indexing="ij")
    points = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], axis=-1) * radii
    at = np.arange(count * count).reshape(count, count)
    a, b, c, d = (part.ravel() for part in (at[:-1, :-1], at[:-1, 1:], at[1:, :-1], at[1:, 1:]))
    return Scan(points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)]))
