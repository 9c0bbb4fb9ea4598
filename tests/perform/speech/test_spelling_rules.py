"""The tables of letters: every pattern can be read, and stands for visemes."""

import re

from omote.perform.speech.spelling_rules import ENGLISH_RULES, ENGLISH_WORDS, GERMAN_RULES, GERMAN_WORDS
from omote.perform.speech.visemes import VISEMES


def test_every_rule_and_every_word_is_of_visemes() -> None:
    for pattern, shapes in (*ENGLISH_RULES, *GERMAN_RULES, *ENGLISH_WORDS.items(), *GERMAN_WORDS.items()):
        re.compile(pattern)
        assert set(shapes.split()) <= set(VISEMES), pattern
    assert all(word == word.lower() for word in (*ENGLISH_WORDS, *GERMAN_WORDS))
