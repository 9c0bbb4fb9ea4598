"""Ids that were executed, by seat and client."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.executed_calls import MOST_CLIENTS, MOST_SEATS, WINDOW, ExecutedCalls, split_id

numbers = st.lists(st.integers(1, 3 * WINDOW), max_size=40)


@given(numbers, st.integers(1, 3 * WINDOW))
def test_what_is_executed_is_what_was_noted_or_lies_below_the_window(noted: list[int], number: int) -> None:
    calls = ExecutedCalls()
    for each in noted:
        calls.note("seat", f"page-{each}")
    old = bool(noted) and number <= max(noted) - WINDOW
    assert calls.has("seat", f"page-{number}") == (number in noted or old)
    assert not calls.has("another seat", f"page-{number}")
    assert not calls.has("seat", f"other-{number}")


@given(numbers)
def test_what_a_restarted_session_remembers_is_the_same(noted: list[int]) -> None:
    calls = ExecutedCalls()
    for each in noted:
        calls.note("seat", f"page-{each}")
    again = ExecutedCalls(calls.snapshot())
    assert again.snapshot() == calls.snapshot()
    assert all(again.has("seat", f"page-{each}") for each in noted)


def test_the_memory_is_bounded_and_forgets_who_was_silent_longest() -> None:
    calls = ExecutedCalls()
    for seat in range(MOST_SEATS + 1):
        calls.note(f"seat {seat}", "a")
    for client in "abcdefgh" * MOST_CLIENTS:
        calls.note("seat 1", client)
    for number in range(5 * WINDOW):
        calls.note("seat 1", f"page-{number}")
    kept = calls.snapshot()
    assert len(kept) == MOST_SEATS
    assert "seat 0" not in kept
    assert len(kept["seat 1"]["page-"]) <= 2 * WINDOW + 1


@pytest.mark.parametrize(
    ("call", "parts"), [("a-7", ("a-", 7)), ("12", ("", 12)), ("abc", ("abc", 0)), ("a\n3", ("a\n", 3))]
)
def test_an_id_is_a_client_and_a_number(call: str, parts: tuple[str, int]) -> None:
    assert split_id(call) == parts
