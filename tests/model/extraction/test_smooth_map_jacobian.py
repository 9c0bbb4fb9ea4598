"""The Jacobian of the continuous stages is what finite differences say, and its inverse undoes it."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.extraction.smooth_map_jacobian import linearise_smooth_map
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, apply_smooth_map
from omote.model.transfer.smooth_map import prepare_smooth_map

CAST = omote.load_cast()


@pytest.mark.parametrize(("name", "unit"), [("dog", "jawOpen"), ("baby", "eyeBlinkLeft"), ("kaori", "mouthFunnel")])
def test_a_step_of_the_inverse_makes_the_change_that_it_was_asked_for(name: str, unit: str) -> None:
    """A smooth change of a hundredth of a millimetre, to within two per cent: lines lie in one another's reach."""
    face = CAST.faces[name]
    space = CAST.space
    rows = prepare_smooth_map(space, face).detail.used
    source = displace_generic(space, compile_expression(space, CAST.expressions[unit])) * space.on_sheet[:, None]
    source = source[space.welded]
    places = space.points[rows]
    change = 1e-5 * np.stack([np.sin(40 * places[:, 1]), np.cos(30 * places[:, 0]), np.sin(20 * places[:, 2])], axis=1)
    step = np.zeros_like(source)
    step[rows] = linearise_smooth_map(space, face, source).solve(change)
    before, after = (apply_smooth_map(space, face, each, CONTINUOUS_STAGES)[rows] for each in (source, source + step))
    assert np.abs(after - before - change).max() < 0.02 * np.abs(change).max()


def test_on_the_generic_face_a_step_is_the_change_itself() -> None:
    face = CAST.faces["generic"]
    space = CAST.space
    rows = prepare_smooth_map(space, face).detail.used
    change = np.random.default_rng(3).normal(size=(len(rows), 3))
    step = linearise_smooth_map(space, face, np.zeros_like(space.points)).solve(change)
    assert step == pytest.approx(change, abs=1e-6)
