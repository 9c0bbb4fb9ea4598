"""From what a program knows of a speech (words, letters or mouth shapes with their times, or text alone) to a track."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Literal, NamedTuple, get_args

from omote.perform.limits import check_known, check_within
from omote.perform.speech.number_words import Language
from omote.perform.speech.spelling import check_language, sounds_of, words_in
from omote.perform.speech.viseme_track import LONGEST_SPEECH, VisemeTrack
from omote.perform.speech.visemes import (
    SIL,
    VISEMES,
    Shapes,
    Viseme,
    shapes_of_azure,
    shapes_of_rhubarb,
    shapes_of_viseme,
)

TimingKind = Literal["text", "words", "characters", "visemes", "azure", "rhubarb"]
TIMING_KINDS: tuple[TimingKind, ...] = get_args(TimingKind)
LONGEST_TEXT = 2000
VISEME_SECONDS: Mapping[Viseme, float] = {
    "sil": 0.15, "PP": 0.075, "FF": 0.085, "TH": 0.075, "DD": 0.06, "kk": 0.07, "CH": 0.1, "SS": 0.095, "nn": 0.065,
    "RR": 0.065, "aa": 0.1, "E": 0.085, "I": 0.08, "O": 0.1, "U": 0.09,
}  # fmt: skip
"""Seconds of a viseme in running speech, about 12 a second."""
_PAUSES: Mapping[str, float] = {
    ",": 0.2, ";": 0.3, ":": 0.3, ".": 0.45, "!": 0.45, "?": 0.45, "…": 0.5, "\n": 0.4,
    "、": 0.2, "،": 0.2, "\uff0c": 0.2, "؛": 0.3, "\uff1b": 0.3, "\uff1a": 0.3, "。": 0.45, "\uff0e": 0.45,
    "\uff01": 0.45, "\uff1f": 0.45, "؟": 0.45, "।": 0.45, "—": 0.3, "\u2013": 0.2,
}  # fmt: skip
"""Seconds of silence behind a word, by the points that follow it; \\uff.. are those of Chinese."""
LONGEST_DRAWL = 2.0
"""A word lasts until the next begins, but no longer than this share of what it takes by rule; then it is silent."""
LAST_SECONDS = 0.1
"""How long the last mouth shape lasts where nobody says when it ends."""


class Mark(NamedTuple):
    """Something heard: a viseme's place, its begin and its end, seconds."""

    viseme: int
    start: float
    end: float


def make_track(
    kind: str, text: str, marks: Sequence[str], times: Sequence[float], *, language: str, seconds: float | None
) -> VisemeTrack:
    """The visemes of a speech with their times.

    Parameters
    ----------
    kind : {"text", "words", "characters", "visemes", "azure", "rhubarb"}
        What the marks are.
    text : str
        What is said; read where the kind is "text".
    marks : sequence of str
        Words, characters (ElevenLabs), or names of mouth shapes: of Oculus, ids of Azure, letters of Rhubarb.
    times : sequence of float
        When each mark begins, seconds from the beginning of the sound; one more: when the last ends.
    language : {"en", "de"}
        By whose rules words are read.
    seconds : float, optional
        The length of the speech, where it is known: text alone is stretched to it.

    Returns
    -------
    VisemeTrack
        Silence where nothing is said.

    Raises
    ------
    ValueError
        On a kind, a language or a mouth shape that there is not, on times that go back or beyond 600 s, on other than
        one time for each mark, on text of more than 2000 characters.
    TypeError
        On what is no number.
    """
    timing = check_known(kind, TIMING_KINDS, "kind of timing")
    spoken = check_language(language)
    length = _check_length(seconds)
    if len(text) > LONGEST_TEXT:
        raise ValueError(f"the text has {len(text)} characters; say at most {LONGEST_TEXT} at once, and the rest after")
    if timing == "text":
        _refuse_marks(marks, times)
        return _track(_of_text(text, spoken, length), length)
    starts, end = _check_times(marks, times, length)
    if timing == "words":
        return _track(_of_words(marks, starts, end, spoken), length)
    if timing == "characters":
        return _track(_of_characters(marks, starts, end, spoken), length)
    return _track(_of_shapes(marks, starts, end, _READERS[timing]), length)


_READERS: Mapping[str, Callable[[str], Shapes]] = {
    "visemes": shapes_of_viseme,
    "azure": shapes_of_azure,
    "rhubarb": shapes_of_rhubarb,
}


def word_seconds(word: str, language: Language) -> float:
    """How long a word takes in running speech, seconds. language: by whose rules it is spelled."""
    return sum(VISEME_SECONDS[sound.viseme] for sound in sounds_of(word, language))


def _check_length(seconds: float | None) -> float | None:
    return None if seconds is None else check_within(seconds, 0.0, LONGEST_SPEECH, "the length of a speech (seconds)")


def _refuse_marks(marks: Sequence[str], times: Sequence[float]) -> None:
    if marks or times:
        raise ValueError("marks came with text alone; say what they are: words, characters, visemes, azure or rhubarb")


def _check_times(marks: Sequence[str], times: Sequence[float], seconds: float | None) -> tuple[list[float], float]:
    """The times of the marks, and the end of the last."""
    if len(times) not in (len(marks), len(marks) + 1) or not marks:
        raise ValueError(
            f"{len(times)} times came for {len(marks)} marks; send one for each, and one more for the end of the last"
        )
    checked = [check_within(at, 0.0, LONGEST_SPEECH, f"time {place + 1} (seconds)") for place, at in enumerate(times)]
    for place, (before, after) in enumerate(pairwise(checked)):
        if after < before:
            raise ValueError(f"time {place + 2} is {after:g} s, before the last one's {before:g} s")
    if len(checked) > len(marks):
        return checked[:-1], checked[-1]
    end = LONGEST_SPEECH if seconds is None else max(seconds, checked[-1])
    return checked, end


def _of_text(text: str, language: Language, seconds: float | None) -> list[Mark]:
    """By rule, with pauses at punctuation; stretched to a length that is known."""
    words = words_in(text)
    at = 0.0
    visemes = list[Mark]()
    for place, (begin, word) in enumerate(words):
        end = at + word_seconds(word, language)
        visemes += _of_word(word, language, at, end)
        after = text[begin + len(word) : words[place + 1][0]] if place + 1 < len(words) else ""
        at = end + max((_PAUSES.get(letter, 0.0) for letter in after), default=0.0)
    stretch = 1.0 if seconds is None or at == 0.0 else seconds / at
    latest = LONGEST_SPEECH if seconds is None else seconds
    return [Mark(mark.viseme, min(mark.start * stretch, latest), min(mark.end * stretch, latest)) for mark in visemes]


def _of_words(marks: Sequence[str], starts: Sequence[float], end: float, language: Language) -> list[Mark]:
    visemes: list[Mark] = []
    for mark, start, until in zip(marks, starts, [*starts[1:], end], strict=True):
        words = [word for _, word in words_in(mark)]
        needs = [word_seconds(word, language) for word in words]
        total = sum(needs)
        if total == 0.0:
            continue
        lasts = min(until - start, LONGEST_DRAWL * total if until < LONGEST_SPEECH else total)
        at = start
        for word, need in zip(words, needs, strict=True):
            visemes += _of_word(word, language, at, at + lasts * need / total)
            at += lasts * need / total
    return visemes


def _of_word(word: str, language: Language, start: float, end: float) -> list[Mark]:
    sounds = sounds_of(word, language)
    total = sum(VISEME_SECONDS[sound.viseme] for sound in sounds)
    visemes = list[Mark]()
    at = start
    for sound in sounds:
        later = at + (end - start) * VISEME_SECONDS[sound.viseme] / total
        visemes.append(Mark(VISEMES.index(sound.viseme), at, later))
        at = later
    return visemes


def _of_characters(marks: Sequence[str], starts: Sequence[float], end: float, language: Language) -> list[Mark]:
    """Each viseme at the time of its letters."""
    times = [*starts, end]
    text = ""
    for mark in marks:
        if len(mark) != 1:
            raise ValueError(f"{mark[:80]!r} came among characters; send each character by itself, spaces too")
        text += mark
    visemes: list[Mark] = []
    for begin, word in words_in(text):
        ends = min(times[begin + len(word)], times[begin + len(word) - 1] + LONGEST_DRAWL * LAST_SECONDS)
        edges = [*times[begin : begin + len(word)], ends]
        visemes += _of_letters(word, edges, language)
    return visemes


def _of_letters(word: str, edges: Sequence[float], language: Language) -> list[Mark]:
    """Visemes by the times of their letters; those that share a letter share its time."""
    sounds = sounds_of(word, language)
    visemes = list[Mark]()
    place = 0
    while place < len(sounds):
        first = sounds[place].first
        same = [sound for sound in sounds[place:] if sound.first == first]
        last = max(sound.last for sound in same)
        start = edges[min(first, len(word))]
        end = edges[min(max(last, first + 1), len(word))]
        for count, sound in enumerate(same):
            share = (end - start) / len(same)
            visemes.append(Mark(VISEMES.index(sound.viseme), start + count * share, start + (count + 1) * share))
        place += len(same)
    return visemes


def _of_shapes(marks: Sequence[str], starts: Sequence[float], end: float, read: Callable[[str], Shapes]) -> list[Mark]:
    visemes: list[Mark] = []
    for mark, start, until in zip(marks, starts, [*starts[1:], end], strict=True):
        shapes = read(mark)
        ends = min(until, start + LAST_SECONDS) if until >= LONGEST_SPEECH else until
        share = (ends - start) / len(shapes)
        visemes += [
            Mark(VISEMES.index(shape), start + place * share, start + (place + 1) * share)
            for place, shape in enumerate(shapes)
        ]
    return visemes


def _track(marks: Sequence[Mark], seconds: float | None) -> VisemeTrack:
    """Marks one after the other, silence where there is none for longer than a breath."""
    starts = list[float]()
    visemes = list[int]()
    end = 0.0
    for mark in marks:
        if mark.end <= mark.start:
            continue
        if mark.start > end + 0.02 and mark.start > 0.0:
            starts.append(end)
            visemes.append(SIL)
        starts.append(max(mark.start, end) if mark.start > end + 0.02 else end)
        visemes.append(mark.viseme)
        end = max(end, mark.end)
    if seconds is not None and seconds > end and starts:
        starts.append(end)
        visemes.append(SIL)
    return VisemeTrack(tuple(starts), tuple(visemes), end if seconds is None else max(seconds, end))
