"""Rounds the tongue's tip: the published one ends in a straight edge, two fifths as wide as the tongue."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from omote.geometry.ramp import clamp_unit, smooth_ramp
from tools.baking.heads.basemesh import BaseMesh, Floats
from tools.baking.heads.head import PART_GROUPS, join

# How far behind the tip its outline comes to be as wide as the published one, in half widths of the tongue, and the
# share of that width at the tip itself.
ROUND = 0.6
TIP = 0.55
# In half widths: how far back places beside the tip go at most, where they begin to go no farther, and how far behind
# the tip none does.
BACK = 0.06
ASIDE = 0.4
REACH = 0.7


def round_tongue_tip(base: BaseMesh) -> BaseMesh:
    """The base mesh with the edge of its tongue's tip in a curve."""
    rows = np.unique(join(base, PART_GROUPS["tongue"]).corners)
    points = base.points.copy()
    points[rows] = rounded(points[rows])
    return replace(base, points=points)


def rounded(tongue: Floats) -> Floats:
    """Points of a tongue (n, 3), in any unit, with its tip round: narrower, by an ellipse, and a little farther back
    aside of the middle, which does not move. Mostly narrower, for a tongue that hangs out goes into the lip if it goes
    back."""
    half = float(np.abs(tongue[:, 0]).max())
    behind = (tongue[:, 2].max() - tongue[:, 2]) / half
    wide = np.sqrt(1.0 - (1.0 - clamp_unit(behind / ROUND)) ** 2)
    aside = clamp_unit(np.abs(tongue[:, 0]) / (ASIDE * half))
    found = tongue.copy()
    found[:, 0] *= TIP + (1.0 - TIP) * wide
    found[:, 2] -= BACK * half * aside**2 * (1.0 - smooth_ramp(0.0, REACH, behind))
    return found
