"""Filling what is not known of a picture: what is known stays, what is alike all over is carried on as it is."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.appearance.taken_albedo import double, halve, pull_push

RANDOM = np.random.default_rng(7)


@pytest.mark.parametrize("side", [1, 2, 16, 128])
def test_what_is_known_stays(side: int) -> None:
    values = RANDOM.normal(size=(side, side, 3)).astype(np.float32)
    known = (RANDOM.random((side, side)) < 0.3).astype(np.float32)
    filled = pull_push(values, known)
    np.testing.assert_array_equal(filled[known == 1.0], values[known == 1.0])
    assert np.isfinite(filled).all()


def test_one_known_value_fills_all_of_it() -> None:
    values = np.zeros((64, 64, 1), np.float32)
    known = np.zeros((64, 64), np.float32)
    values[17, 40] = 3.0
    known[17, 40] = 1.0
    np.testing.assert_allclose(pull_push(values, known), 3.0, rtol=1e-5)


def test_what_is_filled_lies_between_what_is_known() -> None:
    values = RANDOM.uniform(-1.0, 2.0, (64, 64, 2)).astype(np.float32)
    known = np.zeros((64, 64), np.float32)
    known[20:30, 5:50] = 1.0
    filled = pull_push(values, known)
    given = values[known == 1.0]
    assert (filled >= given.min(axis=0) - 1e-5).all()
    assert (filled <= given.max(axis=0) + 1e-5).all()


def test_nothing_known_fills_nothing() -> None:
    np.testing.assert_array_equal(pull_push(np.ones((8, 8, 1), np.float32), np.zeros((8, 8), np.float32)), 0.0)


def test_halving_undoes_doubling_of_what_is_even() -> None:
    even = np.full((4, 4, 1), 2.5, np.float32)
    np.testing.assert_array_equal(halve(double(even)), even)
    slope = np.broadcast_to(np.arange(8, dtype=np.float32)[:, None, None], (8, 8, 1))
    np.testing.assert_allclose(np.diff(double(slope)[1:-1], axis=0), 0.5)  # linear between the middles
