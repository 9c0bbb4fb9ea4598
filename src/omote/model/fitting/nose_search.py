"""Guesses where a face may be: every place of a scan that looks like a nose amid a face, in every size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from omote.arrays import Values
from omote.model.fitting.depth_maps import CELL, TURNS, DepthMaps, Likeness, compare_maps, make_maps
from omote.model.fitting.head_template import HeadTemplate
from omote.model.fitting.scan_surface import thin_out
from omote.model.space.similarity import Similarity

HEAD = 0.25
"""Metres: about a head's height with its neck."""
# From a head that is larger than what was scanned of it to one in a whole body, in extents of the scan.
SIZES = tuple(1.45 / 1.18**step for step in range(16))
# The sizes of another person's head beside somebody's: of a child's to a giant's.
BESIDE = tuple(1.2**step for step in range(-2, 2))
# What is farther than so many extents from nearly all of a scan is left out.
FAR = 0.5
# Places are tried so far apart, metres; so many of each size are kept.
APART = 0.007
KEPT = 40
# Two guesses are one where noses, metres, sizes (logarithm) and turns (trace) are as near as this.
SAME_NOSE = 0.012
SAME_SIZE = 0.1
SAME_TURN = 2.7


@dataclass(frozen=True, eq=False)
class Guess:
    """A place for a face: how unlike a face it looks, metres; the nose's tip in the scan (3,); the pose."""

    unlike: float
    tip: Values
    pose: Similarity


def guess_faces(template: HeadTemplate, points: Values, most: int, /) -> list[Guess]:
    """At most so many guesses for samples (n, 3) of a scan, the likeliest first.

    template: the head; points (n, 3): in the scan's unit; most: how many guesses.
    """
    near, extent = leave_out_crumbs(points)
    if not extent > 0.0:
        return []
    return _choose([guess for size in SIZES for guess in _guess_at(template, near, HEAD / (extent * size))], most)


def guess_faces_beside(template: HeadTemplate, points: Values, scale: float, most: int, /) -> list[Guess]:
    """At most so many guesses for samples (n, 3), either way up, of about a size, whose scale brings them to metres.

    template: the head; points (n, 3): in the scan's unit; scale: metres of one; most: how many guesses.
    """
    if not len(points):
        return []
    return _choose([guess for size in BESIDE for guess in _guess_at(template, points, size * scale, both=True)], most)


def leave_out_crumbs(points: Values, /) -> tuple[Values, float]:
    """The samples (n, 3) of a scan without crumbs far away, which would make lattices endless; its extent."""
    low, high = np.percentile(points, (0.5, 99.5), axis=0)
    extent = float(np.linalg.norm(high - low)) / 1.3
    return points[((points >= low - FAR * extent) & (points <= high + FAR * extent)).all(axis=1)], extent


def _choose(guesses: Sequence[Guess], most: int) -> list[Guess]:
    """At most so many guesses, no two alike, the likeliest first."""
    kept = list[Guess]()
    for guess in sorted(guesses, key=lambda guess: guess.unlike):
        if not any(are_alike(guess.pose, other.pose, guess.tip, other.tip) for other in kept):
            kept.append(guess)
        if len(kept) == most:
            break
    return kept


def are_alike(one: Similarity, other: Similarity, tip: Values, other_tip: Values, /) -> bool:
    """Whether two poses with the nose's tip at two places of a scan (3,) are nearly the same.

    one, other: the poses; tip (3,), other_tip (3,): in the scan's unit.
    """
    return bool(
        np.linalg.norm(tip - other_tip) * one.scale < SAME_NOSE
        and abs(np.log(one.scale / other.scale)) < SAME_SIZE
        and np.trace(one.rotation @ other.rotation.T) > SAME_TURN
    )


def _guess_at(template: HeadTemplate, points: Values, scale: float, *, both: bool = False) -> list[Guess]:
    """The likeliest guesses of one size; both: also as many the other way up."""
    surface = thin_out(points * scale, CELL)
    _, rows = cKDTree(surface).query(thin_out(surface, APART), workers=1)
    maps = make_maps(surface, surface[np.unique(rows)])
    likeness = compare_maps(maps.depths, template.nose.depths[0])
    guesses = _likeliest(template, maps, likeness, scale)
    if both:
        other = compare_maps(maps.depths, template.nose.depths[0], barred=likeness.turn)
        guesses += _likeliest(template, maps, other, scale)
    return guesses


def _likeliest(template: HeadTemplate, maps: DepthMaps, likeness: Likeness, scale: float) -> list[Guess]:
    order = np.argsort(likeness.distance, kind="stable")[:KEPT]
    return [
        Guess(float(likeness.distance[row]), maps.points[row] / scale, _pose(template, maps, likeness, int(row), scale))
        for row in order if np.isfinite(likeness.distance[row])
    ]  # fmt: skip


def _pose(template: HeadTemplate, maps: DepthMaps, likeness: Likeness, row: int, scale: float) -> Similarity:
    """The pose that lays a map over the template's, turned and leant as it fits."""
    first, second, axis = maps.frames[row]
    angle = likeness.turn[row] * 2.0 * np.pi / TURNS
    lean = likeness.lean[row]
    axis = axis - lean[0] * first - lean[1] * second
    axis /= np.linalg.norm(axis)
    across = np.cos(angle) * first + np.sin(angle) * second
    across -= axis * (across @ axis)
    across /= np.linalg.norm(across)
    frame = np.stack([across, np.cross(axis, across), axis])
    rotation = template.nose.frames[0].T @ frame
    return Similarity(scale, rotation, template.nose.points[0] - rotation @ maps.points[row])
