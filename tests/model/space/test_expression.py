"""Expressions: frozen fields, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.model.space.expression import Expression


def rest(count: int = 4) -> dict[str, Any]:
    return {"dtheta": np.zeros(count), "dh": np.zeros(count), "ratio": np.ones(count), "residual": np.zeros((2, 3))}


def test_an_expression_keeps_copies_nobody_can_write() -> None:
    given = rest()
    expression = Expression(**given)
    given["dh"][0] = 1.0
    assert expression.dh[0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        expression.dh[0] = 1.0


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"dh": np.zeros(3)}, r"dh of an expression has shape \(3,\); expected \(4,\)"),
        ({"ratio": np.array([1, 1, 0, 1.0])}, r"ratio\[2\] is 0.0; expected a positive ratio"),
        ({"dtheta": np.array([0, np.nan, 0, 0])}, r"dtheta\[1\].*nan"),
        ({"residual": np.zeros((2, 2))}, r"residual of an expression has shape \(2, 2\)"),
        ({"eyes": np.zeros(2)}, r"eyes of an expression has shape \(2,\)"),
        ({"parts": {"tongue": np.full((1, 3), np.inf)}}, r"part 'tongue'\[0\]"),
        ({"parts": None}, "parts of an expression are a NoneType; expected a mapping"),
        ({"parts": {"tongue": 3}}, r"part 'tongue' of an expression has shape \(\)"),
        ({"dtheta": None}, "dtheta of an expression has no numbers but NoneType"),
        ({"dh": np.zeros(4, complex)}, "dh of an expression has no numbers but complex128"),
        ({"dh": np.full(4, 1e308)}, r"dh\[0\] of an expression is 1e\+308"),
        ({"pupil": np.nan}, r"pupil\[0\] of an expression is nan"),
        ({"pupil": "wide"}, "pupil of an expression"),
        ({"residual": None}, "residual of an expression has no numbers but NoneType"),
    ],
)
def test_expressions_are_refused(change: dict[str, Any], sentence: str) -> None:
    with pytest.raises((ValueError, TypeError), match=sentence):
        Expression(**{**rest(), **change})


def test_a_field_of_two_dimensions_is_refused() -> None:
    with pytest.raises(ValueError, match=r"dtheta has shape \(2, 2\); expected \(V,\)"):
        Expression(np.zeros((2, 2)), np.zeros((2, 2)), np.ones((2, 2)), np.zeros((0, 3)))
