"""Muscles on S: towards the bone, fading, lids over the ball, lips apart."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.controls.face_muscles import muscles
from omote.model.controls.muscle import Muscle, lip_share, metric_of, pull_field, slide_radius
from omote.model.controls.upper_lower import sides
from omote.model.space.parameter_space import ParameterSpace
from tests import synthetic

LINEAR = Muscle("m", "M", "linear", (), (0.03, 0.02), (0.03, -0.02), 0.008, 0.7, 0.02)


def egg() -> ParameterSpace:
    return synthetic.space()


def on_s(muscle: Muscle) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Places of the egg's sheet seen from the bone, and where they go, on S in metres (m, 2)."""
    space = egg()
    metric = metric_of(egg())
    field = pull_field(space, muscle)
    sheet = space.on_sheet
    place = np.stack([space.theta * metric - muscle.bone[0], space.h - muscle.bone[1]], axis=1)
    return place[sheet], np.stack([field[:, 0] * metric, field[:, 1]], axis=1)[sheet]


def test_a_linear_muscle_pulls_straight_to_its_bone_and_never_past_it() -> None:
    place, move = on_s(LINEAR)
    moved = np.abs(move).any(axis=1)
    place = place[moved]
    move = move[moved]
    assert np.allclose(place[:, 0] * move[:, 1], place[:, 1] * move[:, 0], atol=1e-12)
    assert ((place * move).sum(axis=1) < 0).all()
    assert np.hypot(*move.T).max() <= LINEAR.pull + 1e-12
    assert (np.hypot(*move.T) <= np.hypot(*place.T)).all()


def test_nothing_moves_beyond_angle_and_reach_nor_off_the_sheet() -> None:
    place, move = on_s(LINEAR)
    distance = np.hypot(*place.T)
    angle = np.arccos(np.clip(-place[:, 1] / np.maximum(distance, 1e-9), -1, 1))
    assert not move[(distance > 0.06) | (angle > LINEAR.spread)].any()
    assert not pull_field(egg(), LINEAR)[~egg().on_sheet].any()


def test_a_sheet_muscle_pulls_in_parallel() -> None:
    _, move = on_s(replace(LINEAR, kind="sheet", spread=0.03))
    assert not move[:, 0].any()
    assert move[:, 1].max() == pytest.approx(LINEAR.pull, rel=0.2)


def test_a_sphincter_draws_towards_its_middle_from_all_sides() -> None:
    ring = replace(LINEAR, kind="sphincter", bone=(0.0, -0.03), skin=(0.02, 0.01), reach=2.0, swell=0.05)
    place, move = on_s(ring)
    assert ((place * move).sum(axis=1) <= 1e-15).all()
    assert (np.sign(move) == -np.sign(place)).all(axis=1).sum() >= 4
    assert pull_field(egg(), ring)[:, 2].max() > 0.02


def test_skin_slides_along_an_egg() -> None:
    """Sideways on a body of revolution the radius stays; nothing moves, nothing changes."""
    still = np.zeros(egg().vertex_count)
    assert not slide_radius(egg(), still, still).any()
    back = np.abs(egg().theta) > 2.0
    assert np.abs(slide_radius(egg(), np.where(back, 0.02, 0.0), still)).max() < 0.01


def test_a_lip_muscle_leaves_the_other_lip() -> None:
    space = omote.load_cast().space
    side = sides(space)[[line.kind for line in space.lines].index("lips")]
    assert not lip_share(space, "upper")[side < 0].any()
    assert not lip_share(space, "lower")[side > 0].any()
    assert lip_share(space, "upper")[side > 0].max() == 1.0
    field = pull_field(space, muscles(space)["levator_left"])
    assert not field[side < 0].any()
    assert field[space.lines[-1].loop, 1].max() > 0.004


def test_squeezed_lids_meet() -> None:
    cast = omote.load_cast()
    space = cast.space
    for name in ("left", "right"):
        field = pull_field(space, muscles(space)[f"orbicularis_oculi_{name}"])
        line = next(line for line in space.lines if line.name == f"lid_{name}")
        h = space.h + field[:, 1]
        gap = line.rungs(np.stack([h, h, h], axis=1))[:, 0]
        before = line.rungs(np.stack([space.h] * 3, axis=1))[:, 0]
        assert np.abs(gap).max() < 0.15 * before.max()


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"pull": np.nan}, "expected finite ones"),
        ({"spread": 0.0}, "expected positive ones"),
        ({"reach": -1.0}, "expected positive ones"),
        ({"skin": (0.03, 0.02)}, "begins where it ends"),
        ({"kind": "sphincter", "skin": (0.0, 0.1)}, "expected two positive lengths"),
    ],
)
def test_numbers_that_make_no_muscle_are_refused(wrong: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        replace(LINEAR, **wrong)
