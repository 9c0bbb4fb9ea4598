"""Garments: which rows they cover, and what a skirt hides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

import omote
from omote.builtin import load_figures
from omote.geometry import mesh
from omote.model.body.figures import Figures
from omote.model.body.garment import FIELDS, SUIT, Garment
from omote.model.cast import Look
from omote.perform.figures.figure import RestingFigure, pose_figure, resting_figure, skin_figure
from omote.perform.figures.pose_mix import mix_poses

CAST = omote.load_cast()
FIGURES = load_figures()
SPACE = FIGURES.space
SKIRT = SPACE.first_of_skirt
SKIRTED = [name for name, garment in CAST.garments.items() if (garment.cover[SKIRT:] > 0.0).any()]
OUTSIDE = 0.002
"""Metres outside of a skirt from which on a row counts as come through."""
UNDER = -0.62
"""Metres: what of the generic body is below, a skirt covers; above it a skirt lies under the rest of its garment."""


def resting(name: str) -> RestingFigure:
    face = CAST.faces.get(name, CAST.faces["generic"]).positions.astype(np.float64)
    return resting_figure(FIGURES, {name: 1.0}, face)


def share_outside(garment: Garment, rest: RestingFigure, pose: str) -> float:
    """Of the body's rows, moved out as far as cloth lies on them, those that are outside of the skirt above them, by
    the nearest of its rows."""
    mixed = mix_poses(FIGURES.poses, {pose: 1.0}, {}, {})
    rows = skin_figure(SPACE, rest, pose_figure(SPACE, rest, mixed)).astype(np.float64)
    normals = mesh.normals(rows, np.concatenate([CAST.space.triangles, SPACE.triangles, SPACE.skirt]))
    heights = np.r_[CAST.faces["generic"].positions, FIGURES.bodies["generic"].positions][:, 1]
    shown = SKIRT + np.flatnonzero(garment.cover[SKIRT:] > -0.02)
    hem = heights[SKIRT:][garment.cover[SKIRT:] > 0.0].min() + 0.01
    under = np.flatnonzero((heights[:SKIRT] < UNDER) & (heights[:SKIRT] > hem) & (garment.hidden[:SKIRT] > -0.4))
    cloth = rows[under] + normals[under] * garment.thick[under][:, None]
    near = shown[cKDTree(rows[shown]).query(cloth)[1]]
    return float((((cloth - rows[near]) * normals[near]).sum(axis=1) > OUTSIDE).mean())


def test_the_first_is_the_suit_which_every_look_wears_that_chose_nothing() -> None:
    assert next(iter(CAST.garments)) == SUIT == Look().garment
    assert len(SKIRTED) >= 3
    assert len(CAST.garments) >= 4


@pytest.mark.parametrize("name", CAST.garments)
def test_cloth_covers_the_neck_where_it_meets_the_head_and_leaves_hands_bare(name: str) -> None:
    garment = CAST.garments[name]
    assert (garment.cover[SPACE.head_rows + SPACE.joined] > 0.0).all()
    assert (garment.thick >= 0.0).all()
    fingers = [bone.startswith("finger") for bone in SPACE.skeleton.names]
    tips = (np.where(np.array(fingers)[SPACE.bones], SPACE.weights, 0.0)).sum(axis=1) > 0.9
    assert tips.sum() > 500
    assert (garment.cover[tips] < 0.0).all()
    assert (garment.thick[tips] < 1e-4).all()
    assert (garment.hidden[: SPACE.head_rows] <= 0.0).all()
    assert (garment.hidden > 0.0).any() == (name in SKIRTED)  # nothing is hidden but by a skirt


@pytest.mark.parametrize("name", SKIRTED)
def test_a_skirt_holds_the_legs_of_every_body_that_stands_and_of_one_that_steps(name: str) -> None:
    garment = CAST.garments[name]
    for body in FIGURES.bodies:
        rest = resting(body)
        assert share_outside(garment, rest, "stand") < 0.02, body
    assert share_outside(garment, resting("kaori"), "step") < 0.03


def test_fields_of_another_length_are_rejected() -> None:
    suit = CAST.garments[SUIT]
    with pytest.raises(ValueError, match="one number a row"):
        replace(suit, thick=suit.thick[:-1])
    short = replace(suit, **{field: getattr(suit, field)[:-1] for field in FIELDS})
    with pytest.raises(ValueError, match="garment 'suit' covers"):
        Figures(SPACE, FIGURES.bodies, FIGURES.poses, {SUIT: short})


def test_a_look_with_a_garment_that_nobody_made_is_rejected() -> None:
    with pytest.raises(ValueError, match="toga"):
        CAST.with_faces(looks={"kaori": replace(CAST.looks["kaori"], garment="toga")})
