"""Faces of nobody are heads without faults, and faults are found where there are some."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting.random_identities import TRIED, draw_identity, find_faults

CAST = omote.load_cast()
MODES = load_identity_modes()
GUIDE = MODES.skin


def test_somebody_who_is_drawn_has_no_faults_and_looks_ahead_from_where_all_do() -> None:
    face = draw_identity(CAST.space, MODES, "kim", np.random.default_rng(3))
    assert find_faults(CAST.space, GUIDE, face, {name: CAST.expressions[name] for name in TRIED}) == ()
    here, there = (
        np.mean([points[eye].mean(axis=0) for eye in CAST.space.eyes], axis=0)
        for points in (face.parts, {name: part.points for name, part in CAST.space.parts.items()})
    )
    np.testing.assert_allclose(here, there, atol=1e-6)


def test_each_fault_is_named() -> None:
    kaori = CAST.faces["kaori"]
    row = CAST.space.sheet_triangles[0][0]
    folded = kaori.positions.copy()
    folded[row] += [0.0, 0.0, 0.05]
    teeth = {
        name: points + np.array([0.0, 0.0, 0.02 * name.startswith("teeth")]) for name, points in kaori.parts.items()
    }
    still = {"eyeBlinkLeft": CAST.expressions["neutral"]}
    assert find_faults(CAST.space, GUIDE, kaori, {}) == ()
    assert "its skin is folded at rest" in find_faults(CAST.space, GUIDE, replace(kaori, positions=folded), {})
    assert find_faults(CAST.space, GUIDE, replace(kaori, parts=teeth), {}) == ("its teeth are outside of its skin",)
    assert find_faults(CAST.space, GUIDE, kaori, still) == ("eyeBlinkLeft does not shut its eye",)
