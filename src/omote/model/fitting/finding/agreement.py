"""Agreement: how well a scan and the template lie on each other, both ways, what is missing left out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.fitting.finding.alignment import Alignment, Samples, find_matches
from omote.model.fitting.finding.finding_template import HeadTemplate

Values = NDArray[np.float64]

# Farther than this, metres, a place of the face is simply not there: it counts no more.
FARTHEST = 0.01
# Nothing of the scan is here where the nearest lies aside by so many metres, or spacings.
ASIDE, SPACINGS = 0.002, 4.0
# Of the scan, what lies so near to the face, metres, is asked whether it lies on it.
AROUND = 0.012


@dataclass(frozen=True)
class Agreement:
    """residual: the mean distance of the face that is there from the scan; back: the median distance of the scan
    around the face from the face; covered: how much of the face is there; metres."""

    residual: float
    back: float
    covered: float


def measure_agreement(template: HeadTemplate, samples: Samples, found: Alignment, /, *, back: bool = True) -> Agreement:
    """How well an aligned scan and the template's face lie on each other; without back, only how the face does."""
    goals, normals = template.shape(template.face, found.weights), template.normals[template.face]
    off = find_matches(samples, found.pose, goals) - goals
    across = np.abs((off * normals).sum(axis=1))
    aside = np.sqrt(np.maximum((off**2).sum(axis=1) - across**2, 0.0))
    spacing = samples.spacing * found.pose.scale
    missing = (aside > max(ASIDE, SPACINGS * spacing)) & (aside > 2.0 * across)
    away = np.minimum(np.hypot(across, np.maximum(aside - spacing, 0.0)), FARTHEST)
    # All missing is no agreement.
    residual = float(away[~missing].mean()) if not missing.all() else FARTHEST
    behind = _measure_back(samples, found, goals, normals) if back else 0.0
    return Agreement(residual, behind, float(1.0 - missing.mean()))


def _measure_back(samples: Samples, found: Alignment, goals: Values, normals: Values) -> float:
    """The median distance of the samples around the face from it, along its normals."""
    middle = goals.mean(axis=0)
    reach = float(np.linalg.norm(goals - middle, axis=1).max()) + AROUND
    back = ((middle - found.pose.shift) @ found.pose.rotation) / found.pose.scale
    rows = samples.tree.query_ball_point(back, reach / found.pose.scale, workers=1)
    came = found.pose(samples.points[rows][:: max(len(rows) // 8000, 1)])
    if not len(came):
        return FARTHEST
    away, at = cKDTree(goals).query(came, distance_upper_bound=AROUND, workers=1)
    near = np.isfinite(away)
    heights = ((came[near] - goals[at[near]]) * normals[at[near]]).sum(axis=1)
    return float(np.median(np.abs(heights))) if near.any() else FARTHEST
