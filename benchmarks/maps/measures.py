"""Folds, closure and creases of a compound, against the source's own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.space.lid_lip_lines import Line

Values = NDArray[np.float64]
Indices = NDArray[np.int32]
Mask = NDArray[np.bool_]


# ---- folds


def find_folds(rest: Values, now: Values, sheet: Indices) -> Mask:
    """The triangles (T,) whose normal points against that at rest; positions (V, 3) at rest and now."""
    result: Mask = (normals(rest, sheet) * normals(now, sheet)).sum(axis=1) < 0
    return result


def normals(positions: Values, triangles: Indices) -> Values:
    """The triangles' normals (T, 3), twice their areas long."""
    a, b, c = positions[triangles].transpose(1, 0, 2)
    result: Values = np.cross(b - a, c - a)
    return result


# ---- closure


def closure_errors(line: Line, source: tuple[Values, Values], target: tuple[Values, Values]) -> tuple[float, float]:
    """How differently a line opens on a face and on the source, in the mean and along the line (docs/method.md,
    "Contact of lids and lips").

    source, target: positions (V, 3) at rest and now. With g_i the rungs and e_i = g_i / |g_i| at rest:
    lids, mean: |O(target) - O(source)|, O = sum e_i.g_i(now) / sum |g_i(rest)|; along: the mean over the rungs of
    |r_i(target) - r_i(source)|, r_i = e_i.g_i(now) / |g_i(rest)|, weighted by the face's |g_i(rest)|.
    Lips, which touch at rest: the same of the change of the opening upward, over the mouth's width W:
    mean: |D(target) - D(source)|, D = mean_i up.(g_i(now) - g_i(rest)) / W; along: mean_i |d_i(target) - d_i(source)|.
    """
    if line.kind == "lips":
        here = _rise(line, *target)
        there = _rise(line, *source)
        return abs(float(here.mean() - there.mean())), float(np.abs(here - there).mean())
    (here, long_here) = _part(line, *target)
    (there, long_there) = _part(line, *source)
    mean = (here * long_here).sum() / long_here.sum() - (there * long_there).sum() / long_there.sum()
    return abs(float(mean)), float((long_here * np.abs(here - there)).sum() / long_here.sum())


def _rise(line: Line, rest: Values, now: Values) -> Values:
    result: Values = (line.rungs(now) - line.rungs(rest))[:, 1] / np.ptp(rest[line.loop, 0])
    return result


def _part(line: Line, rest: Values, now: Values) -> tuple[Values, Values]:
    """Openings relative to rest and the lengths at rest, rung by rung."""
    still = line.rungs(rest)
    length = np.linalg.norm(still, axis=1)
    return (still * line.rungs(now)).sum(axis=1) / length**2, length


# ---- creases


@dataclass(frozen=True, eq=False)
class Creases:
    """The edges of a sheet between two triangles: ends (E, 2), the triangles on either side (E, 2)."""

    sheet: Indices
    ends: Indices
    sides: Indices

    @staticmethod
    def of(sheet: Indices) -> Creases:
        """The inner edges of a sheet (T, 3)."""
        ends = np.stack([sheet, np.roll(sheet, -1, axis=1)], axis=2).reshape(-1, 2)
        owner = np.repeat(np.arange(len(sheet), dtype=np.int32), 3)
        order = np.lexsort(np.sort(ends, axis=1).T)
        ordered = np.sort(ends, axis=1)[order]
        first = np.flatnonzero((ordered[1:] == ordered[:-1]).all(axis=1))
        return Creases(sheet, ends[order[first]], np.stack([owner[order[first]], owner[order[first + 1]]], axis=1))

    def angles(self, positions: Values) -> Values:
        """The angle (E,) by which the surface bends at each edge, radians; positions (V, 3)."""
        normal = normals(positions, self.sheet)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
        one = normal[self.sides[:, 0]]
        other = normal[self.sides[:, 1]]
        along = positions[self.ends[:, 1]] - positions[self.ends[:, 0]]
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-30)
        result: Values = np.arctan2((along * np.cross(one, other)).sum(axis=1), (one * other).sum(axis=1))
        return result

    def bent(self, rest: Values, now: Values) -> Values:
        """How much more an edge is bent now than at rest (E,), radians in [0, pi]."""
        turn = self.angles(now) - self.angles(rest)
        result: Values = np.abs((turn + np.pi) % (2 * np.pi) - np.pi)
        return result

    def lengths(self, positions: Values) -> Values:
        """The edges' lengths (E,), metres."""
        result: Values = np.linalg.norm(positions[self.ends[:, 1]] - positions[self.ends[:, 0]], axis=1)
        return result
