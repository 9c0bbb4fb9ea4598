"""From letters to visemes, by rules: good enough for a mouth, where nobody has said what is heard."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple, get_args

from omote.perform.limits import check_known
from omote.perform.speech.number_words import SIGNS, Language, number_words
from omote.perform.speech.romanization import ROMAN_RULES, is_latin, is_mark, romanize
from omote.perform.speech.spelling_rules import ENGLISH_RULES, ENGLISH_WORDS, GERMAN_RULES, GERMAN_WORDS
from omote.perform.speech.visemes import VISEMES, Viseme, check_viseme

LANGUAGES: tuple[Language, ...] = get_args(Language)
LONGEST_WORD = 60
"""Letters; a longer one is read in parts."""


Rules = tuple[tuple[re.Pattern[str], tuple[Viseme, ...]], ...]


def _compiled(rules: Sequence[tuple[str, str]]) -> Rules:
    return tuple((re.compile(pattern), tuple(map(check_viseme, shapes.split()))) for pattern, shapes in rules)


_RULES: Mapping[Language, Rules] = {"en": _compiled(ENGLISH_RULES), "de": _compiled(GERMAN_RULES)}
_ROMANIZED = _compiled(ROMAN_RULES)
_WORDS: Mapping[Language, Mapping[str, str]] = {"en": ENGLISH_WORDS, "de": GERMAN_WORDS}
_OWN_LETTERS: Mapping[Language, str] = {"en": "", "de": "äöüß"}
"""Letters beside a to z that a language's rules know; others lose their accents."""
_JOINERS = "\u200c\u200d"
"""What some scripts shape their letters with, without a width."""
_APOSTROPHES = "'’"  # noqa: RUF001  (that of typesetters)


class SpelledSound(NamedTuple):
    """A viseme of a word, and the letters of the word that it stands for: from `first` to before `last`."""

    viseme: Viseme
    first: int
    last: int


def check_language(name: object) -> Language:
    """The language of this name; ValueError for one that there are no rules for."""
    return check_known(name, LANGUAGES, "language")


def words_in(text: str) -> list[tuple[int, str]]:
    """The words of a text, each with its place: letters of any script, numbers, signs that are read (%); what stands
    between them is silent. One of more than 60 letters comes in parts."""
    words = list[tuple[int, str]]()
    begin = 0
    while begin < len(text):
        end = begin
        while end < len(text) and end - begin < LONGEST_WORD and _goes_on(text, begin, end):
            end += 1
        if end > begin:
            words.append((begin, text[begin:end]))
        begin = max(end, begin + 1)
    return words


def _goes_on(text: str, begin: int, at: int) -> bool:
    """Whether the word that begins there has this character."""
    here = text[at]
    after = text[at + 1 : at + 2]
    if at == begin:
        return here.isalnum() or here in SIGNS
    if text[begin] in SIGNS:
        return False
    if here.isalnum() or is_mark(here) or here in _JOINERS:
        return True
    between = text[at - 1].isalnum() and after.isalnum()
    return between and (here in _APOSTROPHES or (here in ".," and text[at - 1].isdigit() and after.isdigit()))


@lru_cache(maxsize=4096)
def sounds_of(word: str, language: Language) -> tuple[SpelledSound, ...]:
    """The visemes of a word, in their order.

    Parameters
    ----------
    word : str
        Letters of any script in any case, digits, an apostrophe, or a sign such as %; numbers are read as words, other
        scripts than Latin by `romanize`.
    language : {"en", "de"}
        By whose rules Latin letters and numbers are read.

    Returns
    -------
    tuple of SpelledSound
        Each with its letters; a word of letters is never silent. Empty where there is neither letter nor number.
    """
    plain = word.lower().replace("’", "'")  # noqa: RUF001  (as above)
    spoken = _WORDS[language].get(plain) or _known_sign(word, language)
    if spoken is not None:
        return tuple(_spread(_shapes_of(spoken, language), 0, len(word)))
    sounds: list[SpelledSound] = []
    for first, last in _runs(word):
        run = word[first:last]
        if _kind(run[0]) == "number":
            words = number_words("".join(map(_digits_of, run)), language)
            shapes = [sound.viseme for part in words for sound in sounds_of(part, language)]
            sounds += _spread(shapes, first, last)
        else:
            sounds += _spell(run, first, language)
    return tuple(sounds or _hum(word))


def _known_sign(word: str, language: Language) -> str | None:
    return SIGNS[word][language] if word in SIGNS else None


def _shapes_of(spoken: str, language: Language) -> list[Viseme]:
    """Of visemes by name, or of a word that a sign is read as."""
    names = spoken.split()
    if all(name in VISEMES for name in names):
        return [check_viseme(name) for name in names]
    return [sound.viseme for sound in sounds_of(spoken, language)]


def _runs(word: str) -> Iterator[tuple[int, int]]:
    """Parts of a word that are read by one rule: from, to."""
    first = 0
    for place in range(1, len(word) + 1):
        if place < len(word) and _belongs(word[place], word[first]):
            continue
        if _kind(word[first]):
            yield first, place
        first = place


def _belongs(character: str, first: str) -> bool:
    kind = _kind(first)
    if is_mark(character) or character in _JOINERS or (kind == "number" and character in ".,"):
        return bool(kind)
    return _kind(character) == kind


def _kind(character: str) -> str:
    if character.isalpha() or is_mark(character):
        return "latin" if is_latin(character) else "other"
    return "number" if character.isnumeric() else ""


def _digits_of(character: str) -> str:
    """A figure of any script in ours, ½ as 0.5; a point or comma itself."""
    value = unicodedata.numeric(character, None)
    return character if value is None else f"{value:.2f}".rstrip("0").rstrip(".")


def _spell(run: str, offset: int, language: Language) -> list[SpelledSound]:
    """By the rules of the language for Latin letters, of romanizations for others."""
    latin = is_latin(run[0])
    pieces = [_fold(letter, language) for letter in _compose(run)] if latin else romanize(run)
    text = "".join(pieces)
    places = [offset + place for place, piece in enumerate(pieces) for _ in piece]
    sounds: list[SpelledSound] = []
    for shapes, at, end in _by_rules(text, _RULES[language] if latin else _ROMANIZED):
        sounds += _spread(shapes, places[at], places[end - 1] + 1)
    return sounds


def _compose(run: str) -> list[str]:
    """Each letter with the accents behind it, and nothing in their places."""
    letters: list[str] = []
    base = 0
    for place, character in enumerate(run):
        whole = unicodedata.normalize("NFC", run[base] + character) if is_mark(character) and place else ""
        if len(whole) == 1:
            letters[base] = whole
        base = base if is_mark(character) else place
        letters.append("" if is_mark(character) else character)
    return letters


def _fold(letter: str, language: Language) -> str:
    small = letter.lower()
    if small in _OWN_LETTERS[language] or small.isascii():
        return small
    return "".join(romanize([letter]))


def _by_rules(letters: str, rules: Rules) -> Iterator[tuple[tuple[Viseme, ...], int, int]]:
    """What each rule that fits stands for, from where to where."""
    at = 0
    while at < len(letters):
        for pattern, shapes in rules:
            match = pattern.match(letters, at)
            if match is not None and match.end() > at:
                yield shapes, at, match.end()
                at = match.end()
                break
        else:
            at += 1


def _hum(word: str) -> list[SpelledSound]:
    """A word of letters that no rule knows: an open mouth for each."""
    return [SpelledSound("aa", place, place + 1) for place, letter in enumerate(word) if letter.isalpha()]


def _spread(shapes: tuple[Viseme, ...] | list[Viseme], first: int, last: int) -> list[SpelledSound]:
    """Some visemes over letters, in equal parts; a letter may stand for several."""
    count = max(len(shapes), 1)
    return [
        SpelledSound(shape, first + (last - first) * place // count, first + (last - first) * (place + 1) // count)
        for place, shape in enumerate(shapes)
    ]
