"""Tokens: made from a key and an id, found again, revoked, ended."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.access.people_list import (
    LONGEST_HOURS,
    MOST_PEOPLE,
    TOKEN_LENGTH,
    People,
    Person,
    add_person,
    check_hours,
    cookie_name,
    find_person,
    is_own,
    remove_person,
    token_of,
)
from omote.show.validation import Refusal

ADA = Person("adaadaad", "Ada", "admin", 0.0)
BEN = Person("benbenbe", "Ben", "operate", 0.0, until=100.0)
PEOPLE = People("5e" * 32, (ADA, BEN))


def test_a_token_finds_its_person_and_nobody_elses() -> None:
    for person in PEOPLE.people:
        token = token_of(PEOPLE, person)
        assert len(token) == TOKEN_LENGTH
        assert find_person(PEOPLE, token, 1.0) is person
        assert find_person(People("5f" * 32, PEOPLE.people), token, 1.0) is None


@given(st.text(max_size=60) | st.from_regex(r"\A[A-Za-z0-9_-]{30}\Z"))
def test_no_other_text_is_a_token(text: str) -> None:
    assert find_person(PEOPLE, text, 1.0) is None
    assert not is_own(PEOPLE, text)


@given(place=st.integers(0, TOKEN_LENGTH - 1), letter=st.sampled_from("AZaz09-_é\0"))
def test_a_token_with_one_letter_changed_is_none(place: int, letter: str) -> None:
    right = token_of(PEOPLE, ADA)
    wrong = right[:place] + letter + right[place + 1 :]
    assert (find_person(PEOPLE, wrong, 1.0) is ADA) == (wrong == right)


def test_a_token_ends_at_its_time_and_when_it_is_revoked() -> None:
    token = token_of(PEOPLE, BEN)
    assert find_person(PEOPLE, token, 99.9) is BEN
    assert find_person(PEOPLE, token, 100.0) is None
    rest, gone = remove_person(PEOPLE, "ben")
    assert gone is BEN
    assert find_person(rest, token, 1.0) is None
    assert is_own(rest, token)  # it was made here: no guess


def test_nobody_gets_two_tokens_and_nobody_is_revoked_who_is_not_there() -> None:
    added = add_person(PEOPLE, Person("cyccyccy", "Cy", "view", 0.0))
    assert [each.name for each in added.people] == ["Ada", "Ben", "Cy"]
    with pytest.raises(Refusal, match="'ADA' already"):
        add_person(PEOPLE, Person("xxxxxxxx", "ADA", "view", 0.0))
    with pytest.raises(Refusal, match="there are tokens for Ada, Ben"):
        remove_person(PEOPLE, "Cy")


@pytest.mark.parametrize("name", ["", "  ", "a\x1b[2J", "x" * 25])
def test_what_is_no_name_is_rejected(name: str) -> None:
    with pytest.raises(Refusal, match="is no name"):
        add_person(PEOPLE, Person("xxxxxxxx", name, "view", 0.0))


def test_a_list_has_an_end() -> None:
    full = People(PEOPLE.key, tuple(Person(f"{n:08}", f"p{n}", "admin", 0.0) for n in range(MOST_PEOPLE)))
    with pytest.raises(Refusal, match="the most there can be"):
        add_person(full, ADA)


def test_the_last_who_may_change_the_list_stays() -> None:
    with pytest.raises(Refusal, match="the last who may change"):
        remove_person(PEOPLE, ADA.id)
    brief = add_person(PEOPLE, Person("evaevaev", "Eva", "admin", 0.0, until=50.0))
    with pytest.raises(Refusal, match="the last who may change"):
        remove_person(brief, ADA.id)


@pytest.mark.parametrize("hours", [0.0, -1.0, float("nan"), float("inf"), LONGEST_HOURS + 1])
def test_a_time_that_cannot_be_is_rejected(hours: float) -> None:
    assert check_hours(None) is None
    assert check_hours(LONGEST_HOURS) == LONGEST_HOURS
    with pytest.raises(Refusal, match="hours cannot be"):
        check_hours(hours)


def test_no_token_stands_in_the_list() -> None:
    written = msgspec.json.encode(PEOPLE).decode()
    assert not any(token_of(PEOPLE, person)[8:] in written for person in PEOPLE.people)


def test_each_list_has_a_cookie_of_its_own() -> None:
    assert cookie_name(PEOPLE) != cookie_name(People("5f" * 32))
    assert PEOPLE.key[:8] not in cookie_name(PEOPLE)
