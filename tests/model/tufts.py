"""A hair style that no file is needed for: a tuft on the crown of the synthetic head."""

from __future__ import annotations

import numpy as np

from omote.model.hair import HairStyle
from tests import synthetic
from tools.baking.hair.strands import find_anchors


def tuft() -> HairStyle:
    """Five strands of three places that stand off the crown."""
    skin, _ = synthetic.head()
    roots = np.array([0.0, 0.12, 0.0]) + np.random.default_rng(4).normal(0.0, 0.02, (5, 1, 3))
    points = roots + np.linspace(0.0, 0.03, 3)[None, :, None] * [0.0, 1.0, 0.0]
    rows, weights = find_anchors(points, skin, skin[:, 1] > 0.0)
    return HairStyle(
        name="tuft",
        points=points.astype(np.float32),
        rows=rows,
        weights=weights.astype(np.float32),
        anchors=rows[:, 0, 0],
        facing=np.tile(np.array([0.0, 1.0, 0.0], np.float32), (5, 3, 1)),
        light=np.linspace(0.0, 1.0, 15, dtype=np.float32).reshape(5, 3),
        fullness=np.ones(5, np.float32),
        width=0.004,
    )
