"""Sentences of random words, so that every run speaks what nobody has heard."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

DICTIONARIES = Path("/usr/share/dict")
"""Of the packages wamerican, wfrench, wngerman and others."""
SYLLABLES = (
    "pa ba ma pi bi mi po bo mo pu bu mu pe be me fa va fi vi fo vu ta da na ti di ni to do nu te de ne sa za si zo su "
    "ka ga ko gu ke gi la ra li ri lo ro lu ru le re sha chi jo wa we ya yo ha ho che"
).split()
LONGEST_WORD = 10


@cache
def read_words(dictionary: str) -> tuple[str, ...]:
    """The words of a dictionary without apostrophes and abbreviations; made of syllables where there is none."""
    path = DICTIONARIES / dictionary
    if not path.is_file():
        return ()
    words = path.read_text(encoding="utf-8", errors="ignore").split()
    return tuple(word for word in words if word.isalpha() and 2 <= len(word) <= LONGEST_WORD and not word.isupper())


def make_sentence(dictionary: str, rng: np.random.Generator, *, words: int = 0) -> str:
    """A sentence of `words` words, 3 to 8 where it is 0; a tenth of them, or all without a dictionary, is invented.

    dictionary: the file's name; rng: of the words.
    """
    known = read_words(dictionary)
    count = words or int(rng.integers(3, 9))
    return " ".join(
        _invent(rng) if not known or rng.random() < 0.1 else known[int(rng.integers(len(known)))] for _ in range(count)
    )


def _invent(rng: np.random.Generator) -> str:
    return "".join(rng.choice(SYLLABLES, int(rng.integers(1, 4))))
