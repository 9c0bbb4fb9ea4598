"""Caricature: linear up to one, beyond it only the smooth form grows, and nothing folds."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.sculpting.caricature import caricature, stand_around_axis
from omote.model.sculpting.extrapolation import find_folds
from omote.model.space.face import Face
from tests.synthetic import cast, space

CAST = omote.load_cast()


def test_a_caricature_is_the_generic_face_at_nothing_and_the_face_at_one() -> None:
    face = cast().faces["long"]
    assert np.allclose(caricature(space(), face, 0.0).positions, space().points, atol=1e-7)
    assert np.allclose(caricature(space(), face, 1.0).positions, face.positions, atol=1e-7)
    half = (face.positions + space().points) / 2
    assert np.allclose(caricature(space(), face, 0.5).positions, half, atol=1e-7)


def test_beyond_one_it_starts_without_a_jump_and_goes_on_and_on() -> None:
    face = CAST.faces["old"]
    one, little, more, most = (
        caricature(CAST.space, face, amount).positions.astype(np.float64) for amount in (1.0, 1.0001, 1.25, 1.5)
    )
    assert np.abs(little - one).max() < 1e-4
    onward = ((most - more) * (more - one)).sum(axis=1)
    large = np.linalg.norm(more - one, axis=1) > 0.001
    assert (onward[large] > 0).mean() > 0.99


@pytest.mark.parametrize(
    ("name", "amount"),
    [(name, 1.5) for name in CAST.faces if name != "generic"] + [(name, 2.0) for name in ("kaori", "old", "baby")],
)
def test_no_caricature_folds(name: str, amount: float) -> None:
    face = CAST.faces[name]
    made = caricature(CAST.space, face, amount)
    before, after = face.positions.astype(np.float64), made.positions.astype(np.float64)
    assert not find_folds(before, after, CAST.space.skin_triangles).any()


@pytest.mark.parametrize("name", [name for name in CAST.faces if name != "generic"])
@pytest.mark.parametrize("amount", [2.0, 2.5, 3.0])
def test_everybody_can_be_drawn_up_to_three_times(name: str, amount: float) -> None:
    caricature(CAST.space, CAST.faces[name], amount)  # `fit` refuses what does not stand around the axis


def test_a_small_head_moves_back_until_it_stands_around_the_axis_and_no_farther() -> None:
    small = CAST.space.points * 0.55 + [0.0, 0.0, 0.075]  # as near to the stage as the generic one
    moved = stand_around_axis(CAST.space, small, "it")
    back = (small - moved)[:, 2]
    assert np.ptp(back) < 1e-12 < back[0]
    assert np.allclose(moved[:, :2], small[:, :2])
    assert np.array_equal(stand_around_axis(CAST.space, moved, "it"), moved)
    ahead = np.add(moved, [0.0, 0.0, 0.001])
    assert not np.array_equal(stand_around_axis(CAST.space, ahead, "it"), ahead)


def test_what_no_place_puts_around_the_axis_is_refused_in_words() -> None:
    with pytest.raises(ValueError, match=r"old drawn 3 times itself is too flat .* expected a smaller amount"):
        stand_around_axis(CAST.space, CAST.space.points * [1.0, 1.0, 0.02], "old drawn 3 times")


def test_a_caricature_adds_form_and_no_detail() -> None:
    smooth = CAST.space.points * [1.1, 1.0, 1.0]
    bump = np.array(smooth)
    vertex = int(np.abs(CAST.space.points - [0.0, 0.06, 0.145]).sum(axis=1).argmin())
    bump[vertex] += [0.0, 0.0, 0.003]
    grown = [caricature(CAST.space, Face("a", points), 2.0).positions for points in (smooth, bump)]
    assert 0.003 <= grown[1][vertex, 2] - grown[0][vertex, 2] < 0.0036
    wider = grown[0][:, 0] / np.where(CAST.space.points[:, 0] == 0, 1.0, CAST.space.points[:, 0])
    assert 1.15 < wider[int(np.abs(CAST.space.points - [0.06, -0.02, 0.1]).sum(axis=1).argmin())] < 1.22


def test_a_caricature_has_a_name_of_its_own() -> None:
    assert caricature(space(), cast().faces["long"], 1.5).name == "long_150"


@pytest.mark.parametrize("amount", [float("nan"), float("inf"), 50, -1, 3.001])
def test_an_amount_out_of_range_is_refused_with_the_range(amount: float) -> None:
    with pytest.raises(ValueError, match=r"a caricature's amount is .*from 0 .the generic face. to 3"):
        caricature(space(), cast().faces["long"], amount)
