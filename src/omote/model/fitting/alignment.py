"""Brings a scan onto the template: trimmed iterative closest points, point to plane, pose and modes together
(Chen and Medioni 1992; Chetverikov, Svirko, Stepanov and Krsek 2002)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from omote.arrays import Rows, Values
from omote.model.fitting.head_template import HeadTemplate
from omote.model.space.similarity import Similarity

# How much a match counts along the surface beside across it: without it heads slide.
ALONG = 0.05
# One standard deviation of a mode costs as much as so many metres at every point.
PRIOR = 0.0004
# The most that one step turns, radians, and grows, logarithm; and the most that all steps grow together.
TURN = 0.3
GROW = 0.15
GROWN = 0.55


@dataclass(frozen=True, eq=False)
class Alignment:
    """The similarity that brings the scan to the template, metres, and the weights (m,) of the template's modes."""

    pose: Similarity
    weights: Values


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of a scan (n, 3) in its own unit, the tree of them, and how far they are apart there."""

    points: Values
    tree: cKDTree
    spacing: float


def align(
    template: HeadTemplate, samples: Samples, start: Alignment, rows: Rows, counted: Values, *,
    reaches: Sequence[float], modes: int,
) -> Alignment:  # fmt: skip
    """The alignment after a round for each reach, metres: rows (k,) of the template with how much each counts (k,).

    template: the head; samples: the scan's; start: from where; rows (k,), counted (k,): points of the template that are
    matched and how much each counts; reaches: how far matches may be in each round, metres; modes: how many of the
    template's are used.
    """
    weights = np.zeros(modes)
    weights[: len(start.weights)] = start.weights[:modes]
    alignment = Alignment(start.pose, weights)
    for reach in reaches:
        alignment = _step(template, samples, alignment, rows, counted, reach)
        if abs(np.log(alignment.pose.scale / start.pose.scale)) > GROWN:
            break
    return alignment


def find_matches(samples: Samples, pose: Similarity, points: Values, /, *, reach: float = np.inf) -> Values:
    """The samples nearest to points (k, 3) of the template, brought there: (k, 3) metres; inf where out of reach.

    samples: the scan's; pose: from the scan to the template; points (k, 3): of the template, metres; reach: metres.
    """
    away, rows = samples.tree.query(pose.back(points), distance_upper_bound=reach / pose.scale, workers=1)
    matches: Values = pose(samples.points[np.minimum(rows, len(samples.points) - 1)])
    matches[np.isinf(away)] = np.inf
    return matches


def _step(
    template: HeadTemplate, samples: Samples, last: Alignment, rows: Rows, counted: Values, reach: float
) -> Alignment:
    goals = template.shape(rows, last.weights)
    normals = template.normals[rows]
    came = find_matches(samples, last.pose, goals, reach=reach)
    middle = goals.mean(axis=0)
    near = np.isfinite(came[:, 0])
    if not near.any():
        return last
    came = came[near]
    normals = normals[near]
    off = came - goals[near]
    arm = came - middle
    count = len(last.weights)
    share = counted[near] * np.maximum(1.0 - (off**2).sum(axis=1) / reach**2, 0.0) ** 2
    shifts = _shifts(arm)
    moves = np.einsum("mkc,kc->km", template.moves[:count, rows[near]], normals)
    slopes = np.hstack([np.einsum("kcj,kc->kj", shifts, normals), -moves])
    matrix, pull = normal_equations(slopes, (off * normals).sum(axis=1), share)
    more = normal_equations(shifts.reshape(-1, 7), off.ravel(), ALONG * np.repeat(share, 3))
    matrix[:7, :7] += more[0]
    pull[:7] += more[1]
    prior = PRIOR**2 * share.sum()
    matrix += np.diag(np.append(np.full(7, 1e-12), np.full(count, prior)))
    pull[7:] += prior * last.weights
    step: Values = -np.linalg.solve(matrix, pull).astype(np.float64)
    return Alignment(_moved(last.pose, step[:7], middle), last.weights + step[7:])


def _shifts(arm: Values) -> Values:
    """How far places (k, 3) about a middle go (k, 3, 7) with each part of a step: turn, shift, growth."""
    x, y, z = arm.T
    shifts = np.zeros((len(arm), 3, 7))
    shifts[:, 0, 1], shifts[:, 0, 2] = z, -y
    shifts[:, 1, 0], shifts[:, 1, 2] = -z, x
    shifts[:, 2, 0], shifts[:, 2, 1] = y, -x
    shifts[:, :, 3:6] = np.eye(3)
    shifts[:, :, 6] = arm
    return shifts


def normal_equations(slopes: Values, heights: Values, share: Values, /) -> tuple[Values, Values]:
    """The matrix (n, n) and the side (n,) of least squares: slopes (k, n), heights (k,), share (k,) of each."""
    weighted = slopes * share[:, None]
    return slopes.T @ weighted, weighted.T @ heights


def _moved(pose: Similarity, step: Values, middle: Values) -> Similarity:
    """The pose after a turn (3,) about a middle (3,), a shift (3,) and growth, none larger than a step may be."""
    turn = Rotation.from_rotvec(step[:3] * min(1.0, TURN / max(float(np.linalg.norm(step[:3])), 1e-12))).as_matrix()
    growth = float(np.exp(step[6] * min(1.0, GROW / max(abs(step[6]), 1e-12))))
    shift = middle + growth * turn @ (pose.shift - middle) + step[3:6]
    return Similarity(pose.scale * growth, turn @ pose.rotation, shift)
