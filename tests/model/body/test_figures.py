"""Figures: what does not fit the space is rejected, and every face has a body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.builtin import load_figures
from omote.model.body.body import Body
from omote.model.body.pose import STAND, Pose

FIGURES = load_figures()


def test_every_face_of_the_cast_has_a_body_and_a_stranger_the_first() -> None:
    assert FIGURES.bodies.keys() == omote.load_cast().faces.keys()
    assert FIGURES.body_of("heavy") is FIGURES.bodies["heavy"]
    assert FIGURES.body_of("somebody") is FIGURES.bodies["generic"]


def test_what_does_not_fit_is_rejected() -> None:
    with pytest.raises(ValueError, match="turns nothing"):
        replace(FIGURES, poses={STAND: FIGURES.poses["bow"]})
    with pytest.raises(ValueError, match="bones"):
        replace(FIGURES, poses={**FIGURES.poses, "short": Pose("short", np.zeros((3, 3)))})
    with pytest.raises(ValueError, match="no body"):
        replace(FIGURES, bodies={})
    body = FIGURES.bodies["generic"]
    short = Body("short", body.positions[:5], body.edge, body.joints, body.ends)
    with pytest.raises(ValueError, match="short"):
        replace(FIGURES, bodies={"short": short})
