"""Numbers as words: what people read, in both languages; every number has its own words."""

import pytest

from omote.perform.speech.number_words import SIGNS, Language, number_words
from omote.perform.speech.spelling import LANGUAGES


@pytest.mark.parametrize(
    ("number", "language", "words"),
    [
        ("0", "en", "zero"), ("42", "en", "forty two"), ("110", "en", "one hundred ten"),
        ("3.5", "en", "three point five"),
        ("2026", "en", "two thousand twenty six"), ("1984", "en", "nineteen eighty four"),
        ("007", "en", "zero zero seven"),
        ("1900", "en", "nineteen hundred"), ("1,000,000", "en", "one million"),
        ("12.30", "en", "twelve point three zero"),
        ("0", "de", "null"), ("42", "de", "zwei und vierzig"), ("101", "de", "ein hundert eins"),
        ("3,5", "de", "drei Komma fünf"), ("3.5", "de", "drei Punkt fünf"), ("1.000", "de", "ein tausend"),
        ("1.000.000", "de", "eine Million"), ("2.000.001", "de", "zwei Millionen eins"),
        ("1984", "de", "neunzehn hundert vier und achtzig"), ("21", "de", "ein und zwanzig"),
    ],
)  # fmt: skip
def test_numbers_are_read_as_people_read_them(number: str, language: Language, words: str) -> None:
    assert " ".join(number_words(number, language)) == words


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_two_numbers_are_read_alike(language: Language) -> None:
    read = [tuple(number_words(str(number), language)) for number in [*range(2200), *range(10_000, 10**9, 9_999_991)]]
    assert len(set(read)) == len(read)
    assert all(read)


def test_more_digits_than_a_number_has_are_read_one_by_one() -> None:
    assert number_words("1234567890", "en")[:3] == ["one", "two", "three"]


def test_signs_have_a_word_in_each_language() -> None:
    assert all(set(words) == set(LANGUAGES) for words in SIGNS.values())
