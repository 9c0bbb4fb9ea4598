"""From letters to visemes, by rules: good enough for a mouth, where nobody has said what is heard."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import Literal, NamedTuple, get_args

from omote.perform.limits import check_known
from omote.perform.speech import english_spelling, german_spelling
from omote.perform.speech.visemes import Viseme, check_viseme

Language = Literal["en", "de"]
LANGUAGES: tuple[Language, ...] = get_args(Language)
LONGEST_WORD = 60
"""Letters; a longer one is read as far."""


def _compiled(rules: Sequence[tuple[str, str]]) -> tuple[tuple[re.Pattern[str], tuple[Viseme, ...]], ...]:
    return tuple((re.compile(pattern), tuple(map(check_viseme, shapes.split()))) for pattern, shapes in rules)


_RULES: Mapping[Language, tuple[tuple[re.Pattern[str], tuple[Viseme, ...]], ...]] = MappingProxyType(
    {
        "en": _compiled(english_spelling.RULES),
        "de": _compiled(german_spelling.RULES),
    }
)
_WORDS: Mapping[Language, Mapping[str, str]] = {"en": english_spelling.WORDS, "de": german_spelling.WORDS}
_DIGITS: Mapping[Language, tuple[str, ...]] = {
    "en": ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"),
    "de": ("null", "eins", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun"),
}
_PLAIN = str.maketrans("àáâãåèéêëìíîïòóôõùúûçñ", "aaaaaeeeeiiiioooouuucn")
_WORD = re.compile(r"[^\W_]+(?:['’][^\W_]+)*")  # noqa: RUF001  (the apostrophe of typesetters)


class SpelledSound(NamedTuple):
    """A viseme of a word, and the letters of the word that it stands for: from `first` to before `last`."""

    viseme: Viseme
    first: int
    last: int


def check_language(name: object) -> Language:
    """The language of this name; ValueError for one that there are no rules for."""
    found = check_known(name, LANGUAGES, "language")
    return next(language for language in LANGUAGES if language == found)


def words_in(text: str) -> list[tuple[int, str]]:
    """The words of a text, each with its place; what stands between them is silent."""
    return [(found.start(), found.group()) for found in _WORD.finditer(text)]


@lru_cache(maxsize=4096)
def sounds_of(word: str, language: Language) -> tuple[SpelledSound, ...]:
    """The visemes of a word, in their order.

    Parameters
    ----------
    word : str
        Letters in any case, digits, an apostrophe; what no rule knows is silent.
    language : {"en", "de"}
        By whose rules.

    Returns
    -------
    tuple of SpelledSound
        Each with its letters; empty where nothing of it is heard.
    """
    plain = word.lower().translate(_PLAIN).replace("’", "'")[:LONGEST_WORD]  # noqa: RUF001  (as above)
    known = _WORDS[language].get(plain)
    if known is not None:
        shapes = [check_viseme(each) for each in known.split()]
        return tuple(_spread(shapes, 0, len(plain)))
    found: list[SpelledSound] = []
    for run in re.finditer(r"[^\W\d_]+|\d", plain):
        found += _of_digit(run, language) if run.group().isdigit() else _by_rules(run.group(), run.start(), language)
    return tuple(found)


def _of_digit(run: re.Match[str], language: Language) -> list[SpelledSound]:
    """Digit by digit; other figures than ours are silent."""
    if not run.group().isascii():
        return []
    shapes = [each.viseme for each in sounds_of(_DIGITS[language][int(run.group())], language)]
    return _spread(shapes, run.start(), run.end())


def _by_rules(letters: str, offset: int, language: Language) -> list[SpelledSound]:
    found: list[SpelledSound] = []
    at = 0
    while at < len(letters):
        for pattern, shapes in _RULES[language]:
            match = pattern.match(letters, at)
            if match is not None and match.end() > at:
                found += _spread(shapes, offset + at, offset + match.end())
                at = match.end()
                break
        else:
            at += 1
    return found


def _spread(shapes: tuple[Viseme, ...] | list[Viseme], first: int, last: int) -> list[SpelledSound]:
    """Some visemes over letters, in equal parts; a letter may stand for several."""
    count = max(len(shapes), 1)
    return [
        SpelledSound(shape, first + (last - first) * place // count, first + (last - first) * (place + 1) // count)
        for place, shape in enumerate(shapes)
    ]
