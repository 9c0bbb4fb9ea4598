"""Validation: only numbers in their range pass."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show import validation
from omote.show.objects.link import Notice, Refused
from omote.show.validation import Quantity, Refusal, name_escapes, validate_number

QUANTITIES = [value for value in vars(validation).values() if isinstance(value, Quantity)]
NO_NUMBERS: list[object] = [True, False, None, "0.5", b"0.5", [], {}, 1j, np.bool_(True)]
OUT_OF_REACH = [math.nan, math.inf, -math.inf, 1e308, -1e308, 10**400, -(10**400)]


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: str(q.what))
@given(value=st.floats(allow_nan=True, allow_infinity=True) | st.integers())
def test_a_number_comes_through_exactly_when_it_is_in_range(quantity: Quantity, value: float) -> None:
    if math.isfinite(value) and quantity.low <= value <= quantity.high:
        assert validate_number(value, quantity) == value
    else:
        with pytest.raises(Refusal):
            validate_number(value, quantity)


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: str(q.what))
@pytest.mark.parametrize("value", [*NO_NUMBERS, *OUT_OF_REACH], ids=lambda v: f"{type(v).__name__} {v!r:.12}")
def test_everything_else_is_refused_with_what_was_expected(quantity: Quantity, value: object) -> None:
    with pytest.raises(Refusal) as refused:
        validate_number(value, quantity)
    sentence = str(refused.value)
    assert sentence.startswith(quantity.what)
    assert sentence.endswith(".")
    assert f"{quantity.high:.4g}" in sentence or f"{quantity.high:g}" in sentence
    assert len(sentence) < 300


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: str(q.what))
def test_both_ends_belong_to_the_range(quantity: Quantity) -> None:
    assert validate_number(quantity.low, quantity) == quantity.low
    assert validate_number(quantity.high, quantity) == quantity.high


def test_what_nobody_sees_in_a_quoted_name_is_named_in_words_for_people() -> None:
    said = f"there is no face {'dog' + chr(0x202E) + chr(0x200B)!r}."
    named = "there is no face 'dog<right-to-left override><zero width space>'."
    assert [name_escapes(said), Refused(said).reason, Notice("1", 0.0, said).text] == [named] * 3
    assert name_escapes(f"{chr(0x1F)!r}") == "'<U+001F>'"


@given(st.text(st.characters(exclude_categories=["C", "Z"])))
def test_a_name_that_is_seen_stays_as_it_is_quoted(name: str) -> None:
    quoted = repr(name)
    assert name_escapes(quoted) == quoted
    assert name_escapes(name_escapes(repr(name + chr(0x202E)))) == name_escapes(repr(name + chr(0x202E)))
