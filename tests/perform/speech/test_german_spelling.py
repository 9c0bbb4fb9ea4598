"""The table of German letters: every pattern can be read, and stands for visemes."""

import re

from omote.perform.speech.german_spelling import RULES, WORDS
from omote.perform.speech.visemes import VISEMES


def test_every_rule_and_every_word_is_of_visemes() -> None:
    for pattern, shapes in RULES:
        re.compile(pattern)
        assert set(shapes.split()) <= set(VISEMES)
    assert all(word == word.lower() for word in WORDS)
