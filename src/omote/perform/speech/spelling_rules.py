"""Which visemes letters stand for: rules, the first that fits wins, and words that no rule gets right."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_SILENT_E = "(?=[bcdfgklmnpqrstvwz]e[sd]?$)"
ENGLISH_RULES: tuple[tuple[str, str], ...] = (
    # a
    ("augh|aw|au", "O"), ("air|are$", "E RR"), ("ai|ay", "E I"), ("all", "O nn"), ("al(?=k)", "O"), ("arr?", "aa RR"),
    ("a(?=tion)", "E I"), ("a" + _SILENT_E, "E I"), ("a", "aa"),
    # b, c, d
    ("bt$", "DD"), ("bb?", "PP"),
    ("ch", "CH"), ("ck", "kk"), ("ci(?=[ao])", "CH"), ("cc(?=[ei])", "kk SS"), ("c(?=[eiy])", "SS"), ("cc?", "kk"),
    ("dge?", "CH"), ("dd?", "DD"),
    # e
    ("eigh", "E I"), ("earn?", "RR"), ("eau", "O"), ("eer|ere$", "I RR"), ("ee|ea", "I"), ("ew|eu", "U"), ("ey", "I"),
    ("(?<=[td])ed$", "E DD"), ("(?<=..)ed$", "DD"), ("(?<=[aeiouy][bcdfgklmnpqrtvw])es$", "SS"),
    ("err?", "RR"), ("e" + _SILENT_E, "I"), ("(?<=..)e$", ""), ("^..?e$", "I"), ("e", "E"),
    # f, g, h
    ("ff?", "FF"), ("gh(?=t)|(?<=.)gh$", ""), ("^gn|gn$", "nn"), ("g(?=e[sd]?$)|g(?=y$)", "CH"), ("gg?", "kk"),
    ("h", ""),
    # i
    ("igh", "aa I"), ("i(?=nd$|ld$)", "aa I"), ("ie(?=[sd]?$)", "aa I"), ("ie", "I"), ("irr?", "RR"),
    ("i" + _SILENT_E, "aa I"), ("i", "I"),
    # j to n
    ("j", "CH"), ("^kn", "nn"), ("k+", "kk"), ("l(?=k$|ks$)", ""), ("ll?e?$", "nn"), ("ll?", "nn"), ("mb$", "PP"),
    ("mm?", "PP"), ("ngl?", "nn kk"), ("nn?", "nn"),
    # o
    ("ough(?=t)", "O"), ("ough$", "O U"), ("ould$", "U DD"), ("oo", "U"), ("ow$", "O U"), ("ou|ow", "aa U"),
    ("oa", "O U"), ("oi|oy", "O I"), ("orr?e?", "O RR"), ("o" + _SILENT_E, "O U"), ("(?<=.)o$", "O U"), ("o", "O"),
    # p to t
    ("ph", "FF"), ("^ps", "SS"), ("pp?", "PP"), ("qu?", "kk U"), ("rh|rr?", "RR"), ("sh", "CH"),
    ("(?<=.)s?sion", "CH nn"),
    ("sch", "SS kk"), ("sc(?=[eiy])", "SS"), ("ss?", "SS"), ("(?<=.)ti(?=on|al|en)", "CH"), ("tch", "CH"),
    ("th", "TH"),
    ("(?<=.)ture$", "CH RR"), ("tt?", "DD"),
    # u to z
    ("ui|ue$", "U"), ("urr?e?", "RR"), ("u" + _SILENT_E, "U"), ("(?<=[jlr])u", "U"), ("u", "aa"), ("v", "FF"),
    ("^wr", "RR"), ("wh|w", "U"), ("^x", "SS"), ("x", "kk SS"), ("^y", "I"), ("y", "I"),
    ("zz?", "SS"),
)  # fmt: skip
"""A pattern at a place in a word (a regular expression, in lower case), and what it stands for."""

ENGLISH_WORDS: Mapping[str, str] = MappingProxyType(
    {
        "a": "aa", "the": "TH aa", "of": "O FF", "to": "DD U", "do": "DD U", "who": "U", "two": "DD U", "you": "I U",
        "your": "I O RR", "one": "U aa nn", "once": "U aa nn SS", "was": "U aa SS", "what": "U aa DD", "are": "aa RR",
        "were": "U RR", "have": "aa FF", "has": "aa SS", "give": "kk I FF", "live": "nn I FF", "love": "nn aa FF",
        "come": "kk aa PP", "some": "SS aa PP", "done": "DD aa nn", "does": "DD aa SS", "said": "SS E DD",
        "says": "SS E SS", "my": "PP aa I", "by": "PP aa I", "why": "U aa I", "i": "aa I", "i'm": "aa I PP",
        "eye": "aa I", "be": "PP I", "he": "I", "she": "CH I", "we": "U I", "me": "PP I", "they": "TH E I",
        "their": "TH E RR", "there": "TH E RR", "where": "U E RR", "here": "I RR", "people": "PP I PP nn",
        "could": "kk U DD", "would": "U U DD", "should": "CH U DD", "good": "kk U DD", "put": "PP U DD",
        "through": "TH RR U", "though": "TH O U", "enough": "E nn aa FF", "laugh": "nn aa FF", "know": "nn O U",
        "so": "SS O U", "no": "nn O U", "go": "kk O U", "hello": "E nn O U", "show": "CH O U",
        "friend": "FF RR E nn DD",
        "get": "kk E DD", "very": "FF E RR I", "any": "E nn I", "many": "PP E nn I", "great": "kk RR E I DD",
        "four": "FF O RR", "eight": "E I DD", "heart": "aa RR DD", "world": "U RR nn DD", "word": "U RR DD",
        "work": "U RR kk", "mother": "PP aa TH RR", "brother": "PP RR aa TH RR", "other": "aa TH RR",
        "fly": "FF nn aa I", "try": "DD RR aa I", "sky": "SS kk aa I", "cry": "kk RR aa I", "eyes": "aa I SS",
        "zero": "SS I RR O U", "seven": "SS E FF nn", "nineteen": "nn aa I nn DD I nn", "ninety": "nn aa I nn DD I",
        "hundred": "aa nn DD RR E DD", "thousand": "TH aa U SS nn DD", "hundreds": "aa nn DD RR E DD SS",
        "twenty": "DD U E nn DD I", "sixty": "SS I kk SS DD I", "degrees": "DD I kk RR I SS",
        "mr": "PP I SS DD RR", "dr": "DD O kk DD RR",
    }
)  # fmt: skip
"""Frequent words that the rules get wrong."""

GERMAN_RULES: tuple[tuple[str, str], ...] = (
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

GERMAN_WORDS: Mapping[str, str] = MappingProxyType(
    {
        "der": "DD E aa", "er": "E aa", "wer": "FF E aa", "den": "DD E nn", "dem": "DD E PP", "ein": "aa I nn",
        "mehr": "PP E aa", "sehr": "SS E aa", "hier": "I aa", "mir": "PP I aa", "wir": "FF I aa", "ihr": "I aa",
        "vier": "FF I aa", "chef": "CH E FF", "computer": "kk O PP I U DD aa", "vase": "FF aa SS E",
        "vielleicht": "FF I nn aa I I DD", "team": "DD I PP", "okay": "O kk E I", "herr": "E aa",
        "dr": "DD O kk DD O aa",
    }
)  # fmt: skip
"""Frequent words that the rules get wrong."""
