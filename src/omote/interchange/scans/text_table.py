"""Reads numbers from large untrusted texts without a loop over their lines."""

from __future__ import annotations

import numpy as np

from omote.arrays import Rows, Values

_NEWLINE = 10
_SPACE = 32
_TO_SMALL = np.uint8(ord("a") - ord("A"))


def parse_numbers(text: bytes, what: str, /) -> Values:
    """All numbers of a text, separated by white space, their decimals by points or commas; ValueError, naming the first
    word that is none.

    text: of numbers alone; what: it is, in a message.
    """
    plain = text.replace(b",", b".")
    try:
        return np.fromstring(plain, np.float64, sep=" ")  # type: ignore[call-overload, no-any-return, unused-ignore]
    except ValueError:
        raise ValueError(f"{what} has {_find_stranger(text)!r}, which is no number; export it anew") from None


def cut_comments(text: bytes, begin_with: bytes, /) -> bytes:
    """The text without what stands behind a # in lines that begin with one of some signs.

    text: lines that end with newlines; begin_with: the signs.
    """
    kept = list[bytes]()
    begin = 0
    mark = text.find(b"#")
    while mark >= 0:
        end = text.find(b"\n", mark)
        first = text[text.rfind(b"\n", 0, mark) + 1 : mark].lstrip()[:1]
        if first and first in begin_with:
            kept.append(text[begin:mark])
            begin = end if end >= 0 else len(text)
        mark = text.find(b"#", end) if end >= 0 else -1
    return b"".join([*kept, text[begin:]])


def _find_stranger(text: bytes) -> str:
    """The first word that is no number; a text without one fails elsewhere."""
    for begin in range(0, len(text), 2**20):
        for word in text[begin : begin + 2**20 + 80].split():
            try:
                float(word.replace(b",", b"."))
            except ValueError:
                return word[:40].decode("ascii", "replace")
    return "a character of no text"


class TextTable:
    """The lines of a text that are not blank, and the words in them.

    words (lines,): how many each has; initials (lines, 3): the first three bytes of each, capitals as small letters.
    """

    def __init__(self, text: bytes) -> None:
        plain = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n") + b"\n"
        self._padded = np.frombuffer(plain + b"   ", np.uint8)
        self.text = self._padded[:-3]
        ends = np.flatnonzero(self.text == _NEWLINE) + 1
        solid = self.text > _SPACE
        begins = np.flatnonzero(solid & ~np.concatenate([[False], solid[:-1]]))  # of words
        count = np.bincount(np.searchsorted(ends, begins, side="right"), minlength=len(ends))
        kept = np.flatnonzero(count)
        self.words: Rows = count[kept]
        self.begins: Rows = begins[np.cumsum(self.words) - self.words]  # of the first word of each line
        self.ends: Rows = ends[kept]
        initials = self._padded[self.begins[:, None] + np.arange(3)]
        self.initials = np.where((initials >= ord("A")) & (initials <= ord("Z")), initials + _TO_SMALL, initials)

    def __len__(self) -> int:
        return len(self.words)

    def lines_of(self, keyword: bytes) -> Rows:
        """The lines whose first word this is; two letters at most."""
        wanted = np.frombuffer(keyword, np.uint8)
        same = (self.initials[:, : len(wanted)] == wanted).all(axis=1)
        return np.flatnonzero(same & (self.initials[:, len(wanted)] <= _SPACE))

    def join(self, lines: Rows, skip: int = 0) -> bytes:
        """The text of some lines, each without its first `skip` bytes."""
        marks = np.zeros(len(self.text) + 1, np.int8)
        np.add.at(marks, np.minimum(self.begins[lines] + skip, self.ends[lines]), np.int8(1))
        np.add.at(marks, self.ends[lines], np.int8(-1))
        chosen: bytes = self.text[np.cumsum(marks[:-1], dtype=np.int8).astype(bool)].tobytes()
        return chosen

    def numbers(self, lines: Rows, what: str, skip: int = 0, most: int = 0) -> Values:
        """The numbers of some lines behind a keyword of `skip` letters: of each as many as the shortest has, up to
        `most` where another has more (nan where one has fewer); ValueError for words that are none. what: a line, in
        words."""
        words = self.words[lines] - (skip > 0)
        numbers = parse_numbers(self.join(lines, skip), what)
        if len(numbers) != words.sum():
            raise ValueError(f"{what} has words that run together; export it anew")
        if (words == words[0]).all():
            return numbers.reshape(len(lines), -1)
        most = max(int(words.min()), min(int(words.max()), most))
        begins = np.cumsum(words) - words
        rows: Values = numbers[np.minimum(begins[:, None] + np.arange(most), len(numbers) - 1)]
        rows[np.arange(most) >= words[:, None]] = np.nan
        return rows

    def rest(self, number: int) -> str:
        """What a line has behind its first word."""
        words = bytes(self.text[self.begins[number] : self.ends[number]]).decode("utf-8", "replace").split(None, 1)
        return words[1].strip() if len(words) > 1 else ""

    def line(self, number: int, most: int = 80) -> str:
        """A line as people read it, by its number, or the first `most` letters of it.

        number: from 0; most: letters.
        """
        return bytes(self.text[self.begins[number] : self.ends[number]][:most]).decode("utf-8", "replace").strip()
