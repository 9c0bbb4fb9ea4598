"""Letters of any script as Latin ones, and which visemes those stand for: a mouth for every language."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence

from anyascii import anyascii

ROMAN_RULES: tuple[tuple[str, str], ...] = (
    ("shch|sh|ch|zh|jj?", "CH"), ("th", "TH"), ("kh|gh|kk|gg|[kgq]", "kk"), ("ts|tz|c", "DD SS"), ("ks", "kk SS"),
    ("ss|zz|[szx]", "SS"), ("ph|pp|bb|mm|[bpm]", "PP"), ("ff|[fv]", "FF"), ("ng(?![aeiouwy])", "nn kk"),
    ("nn|ll|[nl]", "nn"), ("rr|r", "RR"), ("tt|dd|[td]", "DD"), ("h", ""),
    ("ai|ay", "aa I"), ("au|ao", "aa U"), ("ou", "O U"), ("eo", "O"), ("ae", "E"), ("eu", "U"), ("aa|a", "aa"),
    ("ee|e", "E"), ("ii|i|y", "I"), ("oo|o", "O"), ("uu|u|w", "U"),
)  # fmt: skip
"""As most romanizations mean their letters: each vowel as in Italian, nothing silent but h."""
UNWRITTEN_VOWELS = frozenset(
    "ARABIC HEBREW SYRIAC DEVANAGARI BENGALI GURMUKHI GUJARATI ORIYA TAMIL TELUGU KANNADA MALAYALAM SINHALA THAI LAO "
    "KHMER MYANMAR TIBETAN".split()
)
"""Scripts, by the first word of their letters' names, in which a vowel is said that nobody writes."""
_VOWELS = frozenset("aeiouwy")


def is_latin(letter: str) -> bool:
    """Whether a letter is one of the Latin script, with whatever accent."""
    return letter.isascii() or "LATIN" in unicodedata.name(letter, "")


def is_mark(character: str) -> bool:
    """Whether a character changes the letter before it: an accent, a vowel sign."""
    return unicodedata.category(character).startswith("M")


def romanize(letters: Sequence[str]) -> list[str]:
    """What each letter is in Latin, in lower case.

    Chinese characters have one reading each, that of Mandarin, also in a Japanese text; kana are read as they sound.
    Where a script leaves vowels out, an `a` is said between two consonants, and for a letter that has no sound.

    Parameters
    ----------
    letters : sequence of str
        Letters and marks of one word, one each.

    Returns
    -------
    list of str
        One text for each, "" for what is not heard.
    """
    latin = [_letters_of(letter) for letter in letters]
    for place, (letter, name) in enumerate((letter, unicodedata.name(letter, "")) for letter in letters):
        before = latin[place - 1] if place else ""
        if name.startswith(("HIRAGANA", "KATAKANA")):
            latin[max(place - 1, 0)], latin[place] = _join_kana(name, before, latin[place])
        elif name.partition(" ")[0] in UNWRITTEN_VOWELS:
            latin[place] = latin[place] or ("" if is_mark(letter) else "a")
            if before and not is_mark(letter) and not _VOWELS & {*before, *latin[place]}:
                latin[place - 1] = f"{before}a"
    return latin


def _letters_of(letter: str) -> str:
    return "".join(latin for latin in anyascii(letter).lower() if latin.isalpha())


def _join_kana(name: str, before: str, now: str) -> tuple[str, str]:
    """A kana and what stands before it: a small one takes the vowel's place, a small tsu stops the mouth."""
    if "PROLONGED" in name:
        return before, before[-1:]
    if name.endswith("SMALL TU"):
        return before, ""
    if "SMALL Y" in name and before.endswith("i"):
        return before[:-1], now[1:] if before.endswith(("shi", "chi", "ji")) else now
    if "SMALL" in name and before[-1:] in ("i", "u", "e", "o"):
        return before[:-1], now
    return before, now
