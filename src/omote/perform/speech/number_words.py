"""Numbers and signs as the words that they are read as, in English and German."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal, NamedTuple

Language = Literal["en", "de"]
"""Those that there are rules of spelling for."""
MOST_DIGITS = 9
"""A number of more digits is read digit by digit, as one that begins with 0 is: a telephone number."""
YEARS = range(1100, 2000)
"""Read by hundreds where they stand alone: nineteen eighty-four."""

_SMALL: Mapping[Language, tuple[str, ...]] = {
    "en": tuple(
        "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
        "seventeen eighteen nineteen".split()
    ),
    "de": tuple(
        "null eins zwei drei vier fünf sechs sieben acht neun zehn elf zwölf dreizehn vierzehn fünfzehn sechzehn "
        "siebzehn achtzehn neunzehn".split()
    ),
}
_TENS: Mapping[Language, tuple[str, ...]] = {
    "en": tuple("twenty thirty forty fifty sixty seventy eighty ninety".split()),
    "de": tuple("zwanzig dreißig vierzig fünfzig sechzig siebzig achtzig neunzig".split()),
}


class _Marks(NamedTuple):
    """How a language writes and reads numbers: what parts thousands and what fractions, and the words of them."""

    group: str
    point: str
    spoken: Mapping[str, str]
    hundred: str
    thousand: str
    million: str


_MARKS: Mapping[Language, _Marks] = {
    "en": _Marks(",", ".", {".": "point", ",": "comma"}, "hundred", "thousand", "million"),
    "de": _Marks(".", ",", {".": "Punkt", ",": "Komma"}, "hundert", "tausend", "Millionen"),
}
_SINGULAR: Mapping[tuple[str, ...], tuple[str, ...]] = {("ein", "Millionen"): ("eine", "Million")}
SIGNS: Mapping[str, Mapping[Language, str]] = MappingProxyType(
    {
        "%": {"en": "percent", "de": "Prozent"}, "&": {"en": "and", "de": "und"}, "+": {"en": "plus", "de": "plus"},
        "=": {"en": "equals", "de": "gleich"}, "@": {"en": "at", "de": "at"}, "°": {"en": "degrees", "de": "Grad"},
        "€": {"en": "euro", "de": "Euro"}, "$": {"en": "dollar", "de": "Dollar"}, "£": {"en": "pound", "de": "Pfund"},
    }
)  # fmt: skip
"""Signs that are read as words."""


def number_words(number: str, language: Language) -> list[str]:
    """The words that a number is read as.

    Parameters
    ----------
    number : str
        Digits 0 to 9, with points or commas between them as people write them: `42`, `3.5`, `1,000`.
    language : {"en", "de"}
        How it is read; in German a comma parts the fraction and a point the thousands.

    Returns
    -------
    list of str
        In their order; words of German numbers one by one (zwei, und, vierzig). Empty where there is no digit.
    """
    marks = _MARKS[language]
    if re.fullmatch(rf"\d{{1,3}}(?:{re.escape(marks.group)}\d{{3}})+", number):
        number = number.replace(marks.group, "")
    whole, *rest = re.split(r"([.,])", number)
    words = _whole(whole, language)
    for part in rest:
        words += [marks.spoken[part]] if part in marks.spoken else _digits(part, language)
    return words


def _whole(digits: str, language: Language) -> list[str]:
    if len(digits) > MOST_DIGITS or (len(digits) > 1 and digits[0] == "0"):
        return _digits(digits, language)
    if not digits:
        return []
    number = int(digits)
    if number in YEARS:
        hundreds, rest = divmod(number, 100)
        middle = [] if language == "en" and rest else [_MARKS[language].hundred]
        return [*_below_thousand(hundreds, language), *middle, *_rest(rest, language)]
    return _counted(number, language) or [_SMALL[language][0]]


def _counted(number: int, language: Language) -> list[str]:
    """A number to 999,999,999; nothing for 0."""
    marks = _MARKS[language]
    counted: list[str] = []
    for size, name in ((1_000_000, marks.million), (1000, marks.thousand)):
        many, number = divmod(number, size)
        words = (*_before(_below_thousand(many, language)), name) if many else ()
        counted += _SINGULAR.get(words, words)
    return counted + _rest(number, language)


def _rest(number: int, language: Language) -> list[str]:
    return _below_thousand(number, language) if number else []


def _below_thousand(number: int, language: Language) -> list[str]:
    hundreds, rest = divmod(number, 100)
    words = [*_before([_SMALL[language][hundreds]]), _MARKS[language].hundred] if hundreds else []
    if rest >= 20:
        tens = _TENS[language][rest // 10 - 2]
        ones = rest % 10
        last = [_SMALL[language][ones]] if ones else []
        if language == "de":
            return words + ([*_before(last), "und", tens] if last else [tens])
        return [*words, tens, *last]
    return [*words, _SMALL[language][rest]] if rest or not hundreds else words


def _before(words: list[str]) -> list[str]:
    """One as German says it before another word: ein hundert."""
    return [*words[:-1], "ein"] if words[-1:] == ["eins"] else words


def _digits(digits: str, language: Language) -> list[str]:
    return [_SMALL[language][int(digit)] for digit in digits]
