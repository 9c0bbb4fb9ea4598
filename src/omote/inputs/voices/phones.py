"""Which viseme a phone looks like, by its letters of IPA as espeak-ng writes them; and phones in time as visemes."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from omote.perform.speech.visemes import VISEMES

Shapes = tuple[str, ...]
"""Visemes of a phone, one after the other; two of a diphthong, none where it takes the shape of its neighbours."""

_CONSONANTS = {
    "PP": "p b m ɓ ɸ β",
    "FF": "f v ʋ ɱ",
    "TH": "θ ð",
    "DD": "t d ʈ ɖ ɗ ɾ ɟ c ʔd",
    "kk": "k g ɡ ŋ x ɣ q χ ɠ ʁ ʀ ɰ ɢ ħ ʕ",
    "CH": "tʃ dʒ ʃ ʒ tɕ dʑ ɕ ʑ ʂ ʐ tʂ dʐ ç ʝ",
    "SS": "s z ts dz",
    "nn": "n l ɲ ʎ ɳ ɫ ɭ ɬ",
    "RR": "r ɹ ɻ ɚ ɝ ɽ",
    "U": "w ɥ",
    "I": "j",
}
_VOWELS = {
    "aa": "a ɑ ɐ ʌ æ ɒ̃ ɑ̃",
    "E": "e ɛ ə ɜ ɘ ɛ̃ ẽ ɤ œ̃",
    "I": "i ɪ ɨ ɯ ĩ ᵻ",
    "O": "o ɔ ɒ õ ɔ̃ œ ø ɵ",
    "U": "u ʊ y ʏ ʉ ũ",
}
_IPA = {phone: shape for table in (_CONSONANTS, _VOWELS) for shape, phones in table.items() for phone in phones.split()}
MARKS = re.compile("[ːˑˈˌʰʲʷˤ̩̯̪̝̞̃ˠ'ˀ̥̬̟̠̤̰~.|\u200d͡0-9-]")
"""Signs of IPA that change a phone and not its mouth."""
_PHONES = sorted(_IPA, key=len, reverse=True)
STOPS = ("PP", "DD", "kk", "CH")
"""Shapes in which lips or tongue are shut for a moment."""
_LONGEST_CLOSURE = 0.13
_SILENT = 10.0 ** (-55 / 20)
_STEP = 0.005
GLIDE = 0.55
"""Where in a diphthong the second vowel begins."""


@dataclass(frozen=True)
class Segment:
    """A phone from `start` to `end` (seconds). shapes: its visemes, () of a neighbour's shape, None unknown."""

    start: float
    end: float
    name: str
    shapes: Shapes | None


def shapes_of_ipa(phone: str) -> Shapes | None:
    """The visemes of a phone in IPA; ("sil",) of a pause, () of one without a shape of its own (h, a glottal stop),
    None of one that is unknown."""
    if not phone.strip("_: "):
        return ("sil",)
    rest = MARKS.sub("", phone)
    found: list[str] = []
    while rest:
        match = next((each for each in _PHONES if rest.startswith(each)), None)
        if match is None:
            plain = unicodedata.normalize("NFD", rest[0])[0]
            if plain != rest[0]:
                rest = plain + rest[1:]
                continue
            if rest[0] not in "hɦʔ":
                return None
            rest = rest[1:]
            continue
        found.append(_IPA[match])
        rest = rest[len(match) :]
    return tuple(found[:2])


def claim_closures(segments: Sequence[Segment], sound: np.ndarray, rate: int) -> list[Segment]:
    """Gives each stop the silence before its burst: espeak-ng marks a stop at the burst, and what is silent before it
    is the closure, in which lips or tongue are shut already.

    segments: phones and their times; sound: samples; rate: Hz.
    """
    claimed = list(segments)
    for index in range(1, len(claimed)):
        before = claimed[index - 1]
        stop = claimed[index]
        if not stop.shapes or stop.shapes[0] not in STOPS or before.shapes == ("sil",):
            continue
        start = _silence_start(sound, rate, before)
        if start < before.end - _STEP:
            claimed[index - 1], claimed[index] = replace(before, end=start), replace(stop, start=start)
    return claimed


def _silence_start(sound: np.ndarray, rate: int, segment: Segment) -> float:
    """Where the silence at the end of a segment begins, seconds; its end where there is none."""
    start = segment.end
    while start - _STEP > max(segment.start, segment.end - _LONGEST_CLOSURE):
        piece = sound[round((start - _STEP) * rate) : round(start * rate)]
        if np.sqrt(np.mean(piece**2)) > _SILENT:
            break
        start -= _STEP
    return start


def shapes_in_place(segments: Sequence[Segment]) -> list[Shapes | None]:
    """The visemes of each segment; one without a shape of its own (h) has that of the next."""
    shapes: list[Shapes | None] = []
    after: Shapes | None = None
    for segment in reversed(segments):
        shapes.append(after[:1] if segment.shapes == () and after and after != ("sil",) else segment.shapes)
        after = segment.shapes
    return shapes[::-1]


def visemes_of(segments: Sequence[Segment], seconds: float) -> tuple[list[str], list[float]]:
    """Visemes with the times at which each begins, and one time more, the end of the last, for `say`.

    segments: phones in time, without gaps; seconds: the length of their sound. What looks alike is one; a phone of
    another shape than is known looks like silence.
    """
    marks = list[str]()
    times = list[float]()
    for segment, shapes in zip(segments, shapes_in_place(segments), strict=True):
        shown = shapes or ("sil",)
        halves = (segment.start, segment.start + GLIDE * (segment.end - segment.start))
        for viseme, start in zip(shown, halves, strict=False):
            if not marks or marks[-1] != viseme:
                marks.append(viseme)
                times.append(start)
    return marks, [*times, max(seconds, times[-1])] if times else []


assert {shape for shapes in (*_CONSONANTS, *_VOWELS) for shape in shapes.split()} <= set(VISEMES)
