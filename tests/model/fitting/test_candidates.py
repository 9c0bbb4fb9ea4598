"""Candidates: the true place first, by far; no two alike; refined from near it to the same; another head beside it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from omote.builtin import load_identity_modes
from omote.model.fitting.alignment import Alignment
from omote.model.fitting.find_head import Candidate, find_candidates, find_others, refine, score
from omote.model.fitting.head_template import make_template
from omote.model.fitting.nose_search import are_alike
from omote.model.space.similarity import Similarity
from tests.model.fitting.placed_heads import CAST, degrees_between, head_points, head_scan, join_scans, turn_by

TEMPLATE = make_template(CAST.space, load_identity_modes())
SCAN = head_scan(head_points("man") @ turn_by(7).T)


@cache
def _found() -> list[Candidate]:
    return find_candidates(TEMPLATE, SCAN)


def test_the_first_candidate_is_the_head() -> None:
    best = _found()[0]
    assert degrees_between(best.alignment.pose.rotation @ turn_by(7), np.eye(3)) < 5.0
    tip = head_points("man")[TEMPLATE.marks[4]] @ turn_by(7).T
    assert np.linalg.norm(best.tip - tip) < 0.01


def test_candidates_come_in_order_and_no_two_are_alike() -> None:
    found = _found()
    assert [score(each) for each in found] == sorted(score(each) for each in found)
    for number, one in enumerate(found):
        assert not any(
            are_alike(one.alignment.pose, other.alignment.pose, one.tip, other.tip) for other in found[:number]
        )


def test_from_near_the_head_the_same_place_is_refined() -> None:
    best = _found()[0]
    near = Similarity(best.alignment.pose.scale, best.alignment.pose.rotation, best.alignment.pose.shift + 0.003)
    again = refine(TEMPLATE, SCAN, Alignment(near, np.zeros(0)))
    assert (
        np.linalg.norm(again.alignment.pose(SCAN.positions) - best.alignment.pose(SCAN.positions), axis=1).max() < 0.004
    )


def test_places_go_to_the_template_and_back() -> None:
    found = _found()[0].alignment
    assert np.allclose(found.pose.back(found.pose(SCAN.positions)), SCAN.positions)


@pytest.mark.parametrize(("other", "seed", "unit"), [("baby", 1, 1.0), ("old", 2, 1000.0), ("round", 3, 39.37)])
def test_another_head_is_found_in_what_the_first_leaves(other: str, seed: int, unit: float) -> None:
    """However it is turned, and whatever its size beside the first's."""
    turn = turn_by(seed)
    head = head_points(other)
    points = (head - head.mean(axis=0)) @ turn.T + head_points("man").mean(axis=0) + np.array([0.36, 0.1, 0.0])
    scan = join_scans(head_scan(unit * head_points("man")), head_scan(unit * points, seed=seed))
    start = Alignment(Similarity(1.0 / unit, np.eye(3), np.zeros(3)), np.zeros(0))
    found = find_others(TEMPLATE, scan, refine(TEMPLATE, scan, start, rounds=3))[0]
    assert found.agreement.residual < 0.0016
    assert degrees_between(found.alignment.pose.rotation @ turn, np.eye(3)) < 8.0
    assert np.linalg.norm(found.tip / unit - points[TEMPLATE.marks[4]]) < 0.01


def test_beside_a_head_that_is_alone_there_is_none() -> None:
    assert not [each for each in find_others(TEMPLATE, SCAN, _found()[0]) if each.agreement.residual < 0.0019]
