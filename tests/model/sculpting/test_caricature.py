"""Caricature: linear up to one, beyond it only the smooth form grows, and nothing folds."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.sculpting.caricature import (
    caricature,
    extrapolate,
    find_folds,
    find_way_back,
    repair_folds,
    stand_around_axis,
)
from omote.model.space.face import Face
from omote.model.transfer.mouth_bag import find_mouth_bag
from tests.synthetic import FACES, cast, space

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
    before = face.positions.astype(np.float64)
    after = made.positions.astype(np.float64)
    assert not find_folds(before, after, CAST.space.skin_triangles).any()


@pytest.mark.parametrize("name", [name for name in CAST.faces if name != "generic"])
@pytest.mark.parametrize("amount", [2.0, 2.5, 3.0])
def test_everybody_can_be_drawn_up_to_three_times_with_lining_and_tongue_inside(name: str, amount: float) -> None:
    """At 3.0 the lining of the dog's mouth came 56 mm out of its crown, and the cat's tongue lay against its throat."""
    made = caricature(CAST.space, CAST.faces[name], amount)  # `fit` refuses what does not stand around the axis
    bag = find_mouth_bag(CAST.space)
    assert bag is not None
    positions = made.positions.astype(np.float64)
    skin = positions[CAST.space.location_triangles]
    for tested, inside in ((positions[bag.vertices], -0.0005), (made.parts["tongue"].astype(np.float64), 0.0015)):
        away, _ = nearest_triangles(skin, tested)
        assert np.where(winding_numbers(skin, tested) < 0.5, -away, away).min() > inside


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


BELL = 0.02


@pytest.mark.parametrize("name", FACES)
def test_no_growth_gives_the_face(name: str) -> None:
    face = cast().faces[name].positions.astype(np.float64)
    assert np.allclose(extrapolate(space().points, face, space().triangles, 0.0, BELL), face, atol=1e-8)


@pytest.mark.parametrize("amount", [0.5, 1.0, 2.0])
def test_a_larger_head_grows_by_the_power_of_its_size(amount: float) -> None:
    stretch = 1.2
    result = extrapolate(space().points, space().points * stretch, space().triangles, amount, BELL)
    wanted = space().points * stretch ** (1.0 + amount)
    assert np.allclose(result - result.mean(axis=0), wanted - wanted.mean(axis=0), atol=1e-7)


def test_a_head_shrunk_to_a_third_shrinks_further_and_never_turns_over() -> None:
    small = space().points * [1.0, 0.34, 1.0]
    result = extrapolate(space().points, small, space().triangles, 2.0, BELL)
    assert np.ptp(result[:, 1]) < np.ptp(small[:, 1])
    assert not find_folds(small, result, space().triangles).any()


def test_what_is_turned_over_is_pulled_back_and_the_rest_stays() -> None:
    points = CAST.space.points
    triangles = CAST.space.skin_triangles
    folded = np.array(points)
    vertex = int(np.linalg.norm(points - [0.045, -0.04, 0.125], axis=1).argmin())
    folded[vertex] += 1.5 * (points[triangles[(triangles == vertex).any(axis=1)].max()] - points[vertex])
    assert find_folds(points, folded, triangles).any()
    back = repair_folds(points, folded, triangles)
    assert not find_folds(points, back, triangles).any()
    assert (back == points).all(axis=1).sum() > len(points) - 20
    assert np.array_equal(repair_folds(points, points, triangles), points)


@pytest.mark.parametrize("amount", [2.0, 3.0])
def test_a_cats_ears_do_not_meet_over_its_head(amount: float) -> None:
    """They turned as far once more as they are turned already."""
    rest = CAST.faces["cat"].positions
    ears = (rest[:, 1] > 0.085) & (np.abs(rest[:, 0]) > 0.05)
    made = caricature(CAST.space, CAST.faces["cat"], amount).positions
    assert ears.sum() > 20
    assert (made[ears, 0] * np.sign(rest[ears, 0])).min() > 0.01


@pytest.mark.parametrize(("low", "high"), [(0.0021, 1.0), (0.0121, 0.0312), (0.0581, 1.0)])
def test_the_first_place_around_the_axis_is_found_though_farther_back_there_may_be_none(
    monkeypatch: pytest.MonkeyPatch, low: float, high: float
) -> None:
    """Only 0 and 60 mm were asked: a cat drawn three times itself was refused, which stands at 5 to 30 mm."""
    monkeypatch.setattr(
        "omote.model.sculpting.caricature._is_around_axis", lambda _space, _skin, back: low <= back <= high
    )
    assert find_way_back(space(), space().points) == pytest.approx(low, abs=1e-4)
    monkeypatch.setattr("omote.model.sculpting.caricature._is_around_axis", lambda *_: False)
    assert find_way_back(space(), space().points) is None
