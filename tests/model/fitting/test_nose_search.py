"""Guesses: one of them is near the truth, whatever the axes and the unit; none on what does not jut out."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_identity_modes
from omote.model.fitting.head_template import make_template
from omote.model.fitting.nose_search import are_alike, guess_faces, guess_faces_beside, leave_out_crumbs
from omote.model.fitting.scan_surface import sample_surface
from omote.model.space.similarity import Similarity
from tests.model.fitting.placed_heads import CAST, ball, degrees_between, head_points, head_scan, turn_by

TEMPLATE = make_template(CAST.space, load_identity_modes())


@pytest.mark.parametrize(("seed", "size"), [(1, 1.0), (2, 1000.0), (3, 0.02)])
def test_one_of_the_first_guesses_is_near_the_truth(seed: int, size: float) -> None:
    turn = turn_by(seed)
    points = sample_surface(head_scan(size * head_points() @ turn.T))
    guesses = guess_faces(TEMPLATE, points, 10)
    near = [each for each in guesses if degrees_between(each.pose.rotation @ turn, np.eye(3)) < 20.0]
    assert near
    assert any(abs(np.log(each.pose.scale * size)) < 0.25 for each in near)
    assert {type(each.pose.scale) for each in guesses} == {float}


def test_guesses_are_unlike_each_other_and_come_in_order() -> None:
    guesses = guess_faces(TEMPLATE, sample_surface(head_scan(head_points("man"))), 30)
    assert [each.unlike for each in guesses] == sorted(each.unlike for each in guesses)
    for number, one in enumerate(guesses):
        assert not any(are_alike(one.pose, other.pose, one.tip, other.tip) for other in guesses[:number])


def test_a_ball_has_no_nose() -> None:
    assert guess_faces(TEMPLATE, sample_surface(ball((1.0, 1.0, 1.0))), 10) == []


def test_a_crumb_far_away_changes_nothing() -> None:
    points = sample_surface(head_scan(head_points()))
    far = np.concatenate([points, [(1e6, -1e6, 1e6)]])
    first = guess_faces(TEMPLATE, points, 1)[0]
    same = guess_faces(TEMPLATE, far, 1)[0]
    assert np.linalg.norm(first.tip - same.tip) < 0.01


def test_points_at_one_place_give_no_guess() -> None:
    assert guess_faces(TEMPLATE, np.ones((200, 3)), 5) == []


def test_poses_differ_by_place_size_or_turn() -> None:
    pose = Similarity(1.0, np.eye(3), np.zeros(3))
    tip = np.zeros(3)
    assert are_alike(pose, pose, tip, tip)
    assert not are_alike(pose, pose, tip, tip + 0.02)
    assert not are_alike(pose, Similarity(1.3, np.eye(3), np.zeros(3)), tip, tip)
    assert not are_alike(pose, Similarity(1.0, np.diag([-1.0, -1.0, 1.0]), np.zeros(3)), tip, tip)


def test_of_a_known_size_either_way_up_is_guessed() -> None:
    points = sample_surface(head_scan(1000.0 * head_points()))
    guesses = guess_faces_beside(TEMPLATE, points, 0.001, 40)
    turned = [degrees_between(each.pose.rotation, np.eye(3)) for each in guesses]
    assert min(turned) < 20.0
    assert max(turned) > 140.0
    assert all(0.6e-3 < each.pose.scale < 1.3e-3 for each in guesses)
    assert {type(each.pose.scale) for each in guesses} == {float}
    assert guess_faces_beside(TEMPLATE, np.zeros((0, 3)), 0.001, 40) == []


def test_crumbs_are_left_out_and_the_extent_is_the_rest_s() -> None:
    points = sample_surface(head_scan(head_points()))
    kept, extent = leave_out_crumbs(np.concatenate([points, [(1e6, -1e6, 1e6)]]))
    assert np.array_equal(kept, points)
    assert np.isclose(extent, leave_out_crumbs(points)[1], rtol=0.01)
