"""The inner skin's residual gives the goal, and the one that is known where the bag's fit allows several."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import omote
from omote.model.extraction.inner_skin_residual import solve_inner_residual
from omote.model.transfer.compound import compound

CAST = omote.load_cast()


def test_of_several_residuals_the_known_one_is_taken() -> None:
    """Kaori's mouth bag is pushed behind her lips by a funnel: her compound alone does not say what was pushed."""
    face = CAST.faces["kaori"]
    funnel = CAST.expressions["mouthFunnel"]
    inner = CAST.space.inner.vertices
    bare = replace(funnel, residual=np.zeros_like(funnel.residual), parts={})
    goal = compound(CAST.space, face, funnel).astype(np.float64)[inner]
    alone = solve_inner_residual(CAST.space, face, bare, goal, None)
    near = solve_inner_residual(CAST.space, face, bare, goal, replace(funnel, residual=0.999 * funnel.residual))
    for residual in (alone, near):
        assert np.abs(compound(CAST.space, face, replace(bare, residual=residual))[inner] - goal).max() < 1e-5
    assert np.abs(near - funnel.residual).max() < 0.01 * np.abs(alone - funnel.residual).max()
    assert np.abs(solve_inner_residual(CAST.space, face, bare, goal, funnel) - funnel.residual).max() < 1e-6


def test_a_known_one_that_does_not_give_the_goal_is_left() -> None:
    face = CAST.faces["kaori"]
    funnel = CAST.expressions["mouthFunnel"]
    inner = CAST.space.inner.vertices
    bare = replace(funnel, residual=np.zeros_like(funnel.residual), parts={})
    goal = compound(CAST.space, face, funnel).astype(np.float64)[inner]
    far = replace(funnel, residual=np.full_like(funnel.residual, 0.5))
    residual = solve_inner_residual(CAST.space, face, bare, goal, far)
    assert np.abs(compound(CAST.space, face, replace(bare, residual=residual))[inner] - goal).max() < 1e-5
