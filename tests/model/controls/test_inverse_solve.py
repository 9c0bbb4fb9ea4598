"""On release a dragged point lies where it was put on its face, and means the same on others."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.inverse_solve import MOST, solve_vectors
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.extraction.extract import extract
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import Layer, Recipe
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
PROMISED = 5e-5
REST = (0.0, 0.0, 1.0)


def space() -> ParameterSpace:
    return CAST.space


@cache
def net() -> NetField:
    return build_net_field(space(), default_net(space()))


def at_rest() -> np.ndarray:
    return np.tile(REST, (len(net().rows), 1))


@given(
    st.sampled_from(["kaori", "baby", "dog", "noh"]), st.sampled_from(["neutral", "smile", "surprise"]),
    st.integers(0, 103), st.integers(1, 4), st.integers(0, 10**6),
)  # fmt: skip
@settings(max_examples=40)
def test_dragged_points_lie_where_they_were_put(name: str, worn: str, point: int, count: int, seed: int) -> None:
    made = net()
    face = CAST.faces[name]
    random = np.random.default_rng(seed)
    layers = Recipe(made.rows, (REST,) * len(made.rows), layers=(Layer(worn, ""),))
    under = compose_expression(space(), layers, CAST.expressions, made)
    rows = np.array(made.rows)
    near = np.linalg.norm(space().points[rows] - space().points[rows[point]], axis=1)
    points = [int(one) for one in np.argsort(near, kind="stable")[:count]]
    way = random.normal(size=3)
    way *= random.uniform(0.001, 0.012) / np.linalg.norm(way)
    targets = compound(space(), face, under)[rows[points]].astype(np.float64) + way
    found = solve_vectors(space(), face, under, made, at_rest(), points, targets)
    vectors = tuple((float(a), float(b), float(c)) for a, b, c in found.vectors)
    whole = compose_expression(space(), Recipe(made.rows, vectors, layers=layers.layers), CAST.expressions, made)
    there = compound(space(), face, whole)[rows[points]]
    assert np.linalg.norm(there - targets, axis=1).max() == pytest.approx(found.miss, abs=1e-6)
    assert found.miss < PROMISED


def test_points_that_are_not_dragged_stay_and_a_point_at_its_target_costs_one_compound() -> None:
    made = net()
    face = CAST.faces["kaori"]
    start = at_rest()
    start[50] += [0.01, 0.002, 0.01]
    row = made.rows[20]
    rest = face.positions[row].astype(np.float64)
    found = solve_vectors(
        space(), face, CAST.expressions["neutral"], made, start, [20], [rest + np.array([0.0, 0.003, 0.001])]
    )
    others = np.arange(len(made.rows)) != 20
    assert np.array_equal(found.vectors[others], start[others])
    still = solve_vectors(space(), face, CAST.expressions["neutral"], made, at_rest(), [20], [rest])
    assert still.compounds == 1
    assert np.allclose(still.vectors, at_rest(), atol=1e-12)


def test_what_cannot_be_reached_is_missed_by_what_it_says() -> None:
    """A lid cannot go through the eyeball to the back of the head, whatever is tried."""
    made = net()
    face = CAST.faces["baby"]
    target = face.positions[made.rows[2]].astype(np.float64) - [0.0, 0.0, 0.08]
    found = solve_vectors(space(), face, CAST.expressions["neutral"], made, at_rest(), [2], [target])
    assert np.isfinite(found.vectors).all()
    assert found.miss > PROMISED or found.compounds < 5 * MOST


@pytest.mark.parametrize("name", ["kaori", "child", "noh"])
def test_a_drag_on_one_face_extracted_from_another_is_the_same_on_s(name: str) -> None:
    """Within a hundredth of a millimetre where nothing folds and no eyeball pushes: there the map is inverted."""
    made = net()
    worn_by = CAST.faces[name]
    point = made.rows.index(next(row for row in made.rows if space().points[row, 1] > 0.02))
    goal = CAST.faces["generic"].positions[made.rows[point]] + np.array([0.0, 0.004, 0.002])
    under = CAST.expressions["neutral"]
    found = solve_vectors(space(), CAST.faces["generic"], under, made, at_rest(), [point], [goal])
    vectors = tuple((float(a), float(b), float(c)) for a, b, c in found.vectors)
    expression = compose_expression(space(), Recipe(made.rows, vectors), {}, made)
    moved = compound(space(), worn_by, expression).astype(np.float64) - worn_by.positions
    back = extract(space(), worn_by, moved)
    rows = list(made.rows)
    assert np.abs(back.dh - expression.dh)[rows].max() < 1e-5
    assert np.abs(back.dtheta - expression.dtheta)[rows].max() * 0.1 < 1e-5
    assert np.abs(back.ratio - expression.ratio)[rows].max() * 0.1 < 1e-5


def test_points_and_targets_that_are_none_are_refused() -> None:
    made = net()
    face = CAST.faces["kaori"]
    under = CAST.expressions["neutral"]
    for points, targets, sentence in (
        ([104], [[0, 0, 0]], "control point 104 does not exist; expected 0 to 103"),
        ([1, 1], [[0, 0, 0]] * 2, "expected each of them once"),
        ([1], [[0, 0]], "expected finite metres"),
        ([1], [[0, np.nan, 0]], "expected finite metres"),
    ):
        with pytest.raises(ValueError, match=sentence):
            solve_vectors(space(), face, under, made, at_rest(), points, targets)


def test_what_is_far_out_of_reach_is_given_up_before_anybody_waits_for_it() -> None:
    """Nobody gives way for a point a metre off, and where all are dragged there is nobody who could."""
    made = net()
    face = CAST.faces["dog"]
    under = CAST.expressions["neutral"]
    far = solve_vectors(space(), face, under, made, at_rest(), [5], [[0.0, 1.0, 0.0]])
    assert far.compounds <= MOST
    every = range(len(made.rows))
    here = face.positions[list(made.rows)].astype(np.float64)
    all_dragged = solve_vectors(space(), face, under, made, at_rest(), every, here + np.array([0.01, 0, 0]))
    assert all_dragged.compounds <= MOST
