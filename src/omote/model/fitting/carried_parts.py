"""What shapes of a scan do to eyeballs, teeth and tongue: each goes as the scan's own there does, as one rigid body."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.model.fitting.fitted_eyes import fit_sphere
from omote.model.space.eye_socket import radius_of
from omote.model.space.face_fit import FittedFace
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import fit_turn

# An eyeball of the scan: its points lie between so many radii from the middle of ours, all but a few, and it reaches so
# far in each axis.
SHELL = (0.5, 1.3)
WITHIN = 0.9
AROUND = 0.7
# Teeth and tongue of the scan lie so near to ours, metres.
NEAR = 0.005
FEWEST = 12
# A body that moves is rigid where no more than this share of its squared displacements is left.
RIGID = 0.1
# What moves less, metres, rests.
STILL = 5e-5


@dataclass(frozen=True, eq=False)
class ScanParts:
    """Rows of a scan's points by the name of the part of ours that they are, and the middle of those that turn."""

    rows: Mapping[str, Rows]
    middles: Mapping[str, Values]


def find_parts(
    space: ParameterSpace, fitted: FittedFace, points: Values, triangles: NDArray[np.integer], skin: Rows, /
) -> ScanParts:
    """What of a scan (n, 3), (t, 3), in the face's frame, is an eyeball, teeth or tongue; skin: rows that are not.

    space, fitted: the face's space and the face; points (n, 3), triangles (t, 3): the scan, metres; skin (k,): rows.
    """
    joined = mesh.weld(points)
    labels = mesh.components(joined[triangles], len(points))[joined]
    other = np.setdiff1d(np.flatnonzero(~np.isin(labels, labels[skin])), skin)
    rows = dict[str, Rows]()
    middles = dict[str, Values]()
    for name in space.eyes:
        if len(ball := _find_ball(points, labels, other, fitted.parts[name].astype(np.float64))):
            rows[name] = ball
            middles[name] = fit_sphere(points[ball])[0]
    mouth = [name for name, part in space.parts.items() if not part.eye and not part.follows_skin]
    places = np.concatenate([fitted.parts[name] for name in mouth])
    owner = np.repeat(np.arange(len(mouth)), [len(fitted.parts[name]) for name in mouth])
    away, nearest = cKDTree(places).query(points[other], workers=1)
    for number, name in enumerate(mouth):
        near_rows = other[(away < NEAR) & (owner[nearest] == number)]
        if len(near_rows) >= FEWEST:
            rows[name] = near_rows
    return ScanParts(rows, middles)


def _find_ball(points: Values, labels: NDArray[np.integer], other: Rows, ball: Values) -> Rows:
    """The rows of the largest component that is a ball around the middle of an eyeball (n, 3)."""
    middle = ball.mean(axis=0)
    radius = radius_of(ball)
    high = np.linalg.norm(points - middle, axis=1) / radius
    inside = (high > SHELL[0]) & (high < SHELL[1])
    best = np.zeros(0, np.intp)
    for label in np.unique(labels[other[inside[other]]]):
        rows = np.flatnonzero(labels == label)
        round_ = inside[rows].mean() > WITHIN and np.ptp(points[rows], axis=0).min() > AROUND * radius
        if round_ and len(rows) > max(len(best), FEWEST):
            best = rows
    return best


def carry_parts(scan_parts: ScanParts, fitted: FittedFace, points: Values, moves: Values, /) -> dict[str, Values]:
    """The displacements (m, 3) of our parts, by name, by one shape (n, 3) of the scan: none of what is not rigid.

    scan_parts: which rows of the scan are which part; fitted: the face; points (n, 3), moves (n, 3): the scan at rest
    and its shape, metres.
    """
    result = {}
    for name, rows in scan_parts.rows.items():
        rest = points[rows]
        goal = points[rows] + moves[rows]
        moving = np.abs(moves[rows]).max() > STILL
        turn, shift = _fit_turn(rest, goal, scan_parts.middles.get(name)) if moving else (np.eye(3), np.zeros(3))
        left = ((rest @ turn.T + shift - goal) ** 2).sum()
        if left > RIGID * (moves[rows] ** 2).sum() and moving:
            continue
        ours = fitted.parts[name].astype(np.float64)
        if name in scan_parts.middles:  # about our own middle: it may differ a little
            shift = (np.eye(3) - turn) @ ours.mean(axis=0)
        result[name] = ours @ turn.T + shift - ours
    return result


def _fit_turn(rest: Values, goal: Values, middle: Values | None) -> tuple[Values, Values]:
    """The turn and shift that bring points nearest to others; about a middle where there is one."""
    here, there = (rest.mean(axis=0), goal.mean(axis=0)) if middle is None else (middle, middle)
    turn = fit_turn(rest - here, goal - there)
    return turn, there - turn @ here
