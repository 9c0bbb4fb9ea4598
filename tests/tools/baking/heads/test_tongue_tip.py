"""The tongue's tip is round, and nothing else has changed."""

import numpy as np

from tools.baking.heads.basemesh import BaseMesh, Floats
from tools.baking.heads.head import Head
from tools.baking.heads.tongue_tip import round_tongue_tip


def test_the_tongues_outline_is_round_at_its_tip(base: BaseMesh, head: Head) -> None:
    rounded = round_tongue_tip(base).points
    tongue = head.parts["tongue"].vertices
    others = np.setdiff1d(np.arange(len(base.points)), tongue)
    assert (rounded[others] == base.points[others]).all()
    assert (rounded[:, 1] == base.points[:, 1]).all()
    assert rounded[:, 2].max() == base.points[:, 2].max()
    assert _edge(base.points[tongue]) > 0.35
    assert _edge(rounded[tongue]) < 0.25


def _edge(tongue: Floats) -> float:
    """How wide the tongue is a twenty-fifth of its half width behind its tip, of its width."""
    half = np.abs(tongue[:, 0]).max()
    front = tongue[tongue[:, 2] > tongue[:, 2].max() - 0.04 * half]
    return float(np.abs(front[:, 0]).max() / half)


def test_no_part_of_the_tongue_passes_another(base: BaseMesh, head: Head) -> None:
    triangles = head.parts["tongue"].vertices[head.parts["tongue"].triangles]

    def plan(points: Floats) -> Floats:
        """Twice the area of each triangle as seen from above, with its sign."""
        a, b, c = (points[triangles[:, corner]][:, [0, 2]] for corner in range(3))
        u, v = b - a, c - a
        return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]

    before, after = plan(base.points), plan(round_tongue_tip(base).points)
    flat = np.abs(before) > 0.1 * np.abs(before).mean()
    assert (np.sign(before[flat]) == np.sign(after[flat])).all()
