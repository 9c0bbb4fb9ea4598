"""Faces of fitted skins."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast, load_identity_modes
from omote.model.fitting.fit_face import close_face

SPACE = load_cast().space
MODES = load_identity_modes()


def test_a_skin_of_the_modes_becomes_a_face_that_hardly_differs() -> None:
    weights = np.random.default_rng(3).normal(size=len(MODES.moves))
    skin = MODES.shape_skin(weights)
    parts = MODES.shape_parts(weights)
    face = close_face(SPACE, "kim", skin, skin, parts)
    assert face.name == "kim"
    moved = np.linalg.norm(face.positions - skin, axis=1)[SPACE.on_sheet]
    assert np.median(moved) < 1e-6
    for name, points in parts.items():
        assert face.parts[name] == pytest.approx(points, abs=1e-6)


def test_a_skin_that_is_no_head_of_the_space_is_refused() -> None:
    skin = np.full_like(MODES.skin, np.nan)
    with pytest.raises(ValueError):  # noqa: PT011 - whichever step notices first says it
        close_face(SPACE, "kim", MODES.skin, skin, dict(MODES.parts))
