"""Which visemes German letters stand for: rules, the first that fits wins, and words that no rule gets right."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

RULES: tuple[tuple[str, str], ...] = (
    # vowels; an h behind one is silent
    ("äuh?|euh?", "O I"), ("aih?|eih?|ayh?|eyh?", "aa I"), ("auh?", "aa U"), ("ieh?|ih", "I"), ("aah?|ah", "aa"),
    ("eeh?|eh", "E"), ("ooh?|oh", "O"), ("uh", "U"), ("äh?", "E"), ("öh?", "O"), ("üh?", "U"), ("a", "aa"),
    ("(?<=..)er(?=$|s$|n$|[bcdfgklmnpqstvwz])", "aa"), ("(?<=..)e(?=[nl]$)", ""), ("e", "E"), ("i", "I"), ("o", "O"),
    ("u", "U"), ("y", "U"),
    # consonants
    ("tsch|sch", "CH"), ("chs", "kk SS"), ("(?<=[aou])ch", "kk"), ("ch", "I"), ("ck", "kk"),
    ("c(?=[eiäöy])", "DD SS"),
    ("c", "kk"), ("^st|(?<=ge)st(?=[aeiouäöür])", "CH DD"), ("^sp|(?<=ge)sp(?=[aeiouäöür])", "CH PP"),
    ("ss?|ß", "SS"),
    ("tion", "DD SS I O nn"), ("tz|zz|z|ts", "DD SS"), ("tth?|dt|th|t|dd?", "DD"), ("pf", "PP FF"), ("ph", "FF"),
    ("pp?|bb?", "PP"), ("mm?", "PP"), ("ff?|v|w", "FF"), ("qu", "kk FF"), ("x", "kk SS"), ("ng", "nn kk"),
    ("nn?", "nn"),
    ("ll?", "nn"), ("(?<=[aeiouäöü])rr?(?![aeiouäöü])", "aa"), ("rr?h?", "kk"), ("gg?|kk?", "kk"), ("j", "I"),
    ("h", ""),
)  # fmt: skip
"""A pattern at a place in a word (a regular expression, in lower case), and what it stands for."""

WORDS: Mapping[str, str] = MappingProxyType(
    {
        "der": "DD E aa", "er": "E aa", "wer": "FF E aa", "den": "DD E nn", "dem": "DD E PP", "ein": "aa I nn",
        "mehr": "PP E aa", "sehr": "SS E aa", "hier": "I aa", "mir": "PP I aa", "wir": "FF I aa", "ihr": "I aa",
        "vier": "FF I aa", "chef": "CH E FF", "computer": "kk O PP I U DD aa", "vase": "FF aa SS E",
        "vielleicht": "FF I nn aa I I DD", "team": "DD I PP", "okay": "O kk E I", "herr": "E aa",
        "dr": "DD O kk DD O aa",
    }
)  # fmt: skip
"""Frequent words that the rules get wrong."""
