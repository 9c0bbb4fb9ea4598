"""Nets on vertices: what they reproduce, what they hold apart, what they refuse."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.controls.upper_lower import sides
from omote.model.space.parameter_space import ParameterSpace


def space() -> ParameterSpace:
    return omote.load_cast().space


@cache
def net() -> NetField:
    return build_net_field(space(), default_net(space()))


def with_rings(field: NDArray[np.float64]) -> NDArray[np.float64]:
    """The sheet's values (V, k) of a net whose points and rings carry field (n, k)."""
    result: NDArray[np.float64] = (net().net.basis @ field)[space().on_sheet]
    return result


@given(st.integers(0, 10**6))
def test_a_points_vector_is_the_field_under_it(seed: int) -> None:
    made = net()
    vectors = np.random.default_rng(seed).normal([0, 0, 1], 0.05, (len(made.rows), 3))
    assert np.allclose(made.field(vectors)[list(made.rows)], vectors - [0, 0, 1], atol=1e-12)


@given(st.floats(-0.1, 0.1), st.floats(-0.1, 0.1))
def test_constant_and_linear_in_h_are_exact_where_the_rings_carry_them(constant: float, slope: float) -> None:
    h = net().net.h
    found = with_rings((constant + slope * h)[:, None])[:, 0]
    assert np.abs(found - constant - slope * space().h[space().on_sheet]).max() < 1e-12


def test_linear_in_theta_is_exact_away_from_the_seam() -> None:
    theta = space().theta[space().on_sheet]
    front = np.abs(theta) < 1.2
    assert np.abs(with_rings(net().net.theta[:, None])[:, 0] - theta)[front].max() < 1e-12


def test_lifting_all_points_of_a_lower_lip_or_lid_moves_nothing_of_the_upper_one() -> None:
    made = net()
    for line, side in zip(space().lines, sides(space()), strict=True):
        for sign in (1, -1):
            vectors = np.tile([0.0, 0.0, 1.0], (len(made.rows), 1))
            chosen = (side[list(made.rows)] == -sign) & np.isin(made.rows, line.loop)
            vectors[chosen, 1] = 0.01
            field = made.field(vectors)
            assert field[side == -sign, 1].max() == pytest.approx(0.01, rel=0.1)
            assert not field[side == sign].any()


def test_the_field_is_bilinear_and_zero_off_the_sheet() -> None:
    made = net()
    random = np.random.default_rng(1)
    a, b = random.normal([0, 0, 1], 0.01, (2, len(made.rows), 3))
    assert np.allclose(made.field((a + b) / 2), (made.field(a) + made.field(b)) / 2)
    assert not made.field(a)[~space().on_sheet].any()


@pytest.mark.parametrize(
    ("rows", "sentence"),
    [
        ((1, 2), "a net of 2 control points"),
        ((*range(401),), "a net of 401 control points"),
        ((0, 1, -1), "stands on vertex -1; expected a row of the skin"),
        ((0, 1, 10**6), "stands on vertex 1000000"),
        ((0, 1, 1), "two control points stand on vertex 1"),
        ((True, 1, 2), "stands on vertex True"),
    ],
)
def test_rows_that_make_no_net_are_refused(rows: tuple[int, ...], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        build_net_field(space(), rows)


def test_inner_skin_carries_no_point() -> None:
    inner = int(space().inner.vertices[0])
    with pytest.raises(ValueError, match="which is inner skin"):
        build_net_field(space(), (*default_net(space()), inner))


def test_vectors_of_other_shapes_or_not_finite_are_refused() -> None:
    with pytest.raises(ValueError, match=r"expected \(104, 3\), one for each point"):
        net().field(np.ones((3, 3)))
    vectors = np.tile([0.0, 0.0, 1.0], (len(net().rows), 1))
    vectors[7, 1] = np.nan
    with pytest.raises(ValueError, match="vector 7 is"):
        net().field(vectors)
