"""The phones of Piper in time: its signs, a letter of IPA each, joined into phones; stops laid on their silence."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np

from omote.inputs.voices.phones import MARKS, STOPS, Segment, shapes_in_place, shapes_of_ipa
from omote.perform.speech.speech_timing import VISEME_SECONDS

_POINTS = re.compile(r"[\s_^$.,;:!?…。、¿¡\"()«»“”-]*")
"""Signs that are no phone: where a text begins and ends, its points, spaces."""
_STRESS = "ˈˌ'"
_AFFRICATES = ("tʃ", "dʒ", "ts", "dz", "tɕ", "dʑ", "ʈʂ", "ɖʐ")
_LONGEST_SPACE = 0.15
"""Seconds; a space between words that lasts longer is a pause."""
_QUIET = 10.0 ** (-36 / 20)
"""A share of the loudest sample, below which lips or tongue are shut: the sound of a model is never all silent."""
_NEAR = 0.12
"""Seconds from a stop's sign in which its silence is looked for."""
_SHORTEST_CLOSURE = 0.02
_STEP = 0.005


class Sign(NamedTuple):
    """A sign of a model's alphabet, and how long it sounds, seconds."""

    name: str
    seconds: float


def join_signs(signs: Sequence[Sign]) -> list[Segment]:
    """The phones that signs make, one after the other from second 0.

    A mark of stress belongs to the phone behind it, all other marks to the phone before; points and spaces together are
    a pause, a space alone none, unless it lasts.
    """
    names = list[str]()
    lengths = list[float]()
    for name, seconds in signs:
        if names and _belongs_together(names[-1], name):
            names[-1] += name
            lengths[-1] += seconds
        else:
            names.append(name)
            lengths.append(seconds)
    times = [0.0, *accumulate(lengths)]
    return [
        Segment(start, end, name, _shapes_of(name, end - start))
        for name, (start, end) in zip(names, pairwise(times), strict=True)
        if end > start
    ]


def share_seconds(names: Sequence[str], sound: np.ndarray, rate: int) -> list[Sign]:
    """Signs with lengths by rule, for a model that tells none: those of running speech, stretched to what is heard.

    names: the signs; sound: samples, -1 to 1; rate: of them, Hz.
    """
    loud = np.flatnonzero(np.abs(sound) > _QUIET * max(float(np.abs(sound).max(initial=0.0)), 1e-9)) / rate
    first, last = (float(loud[0]), float(loud[-1])) if len(loud) else (0.0, len(sound) / rate)
    spoken = [index for index, name in enumerate(names) if not _POINTS.fullmatch(name)]
    if not spoken:
        return [Sign("", len(sound) / rate)]
    inner = list(names[spoken[0] : spoken[-1] + 1])
    usual = [_usual_seconds(name) for name in inner]
    stretch = (last - first) / max(sum(usual), 1e-9)
    signs = [Sign(name, stretch * seconds) for name, seconds in zip(inner, usual, strict=True)]
    return [Sign("^", first), *signs, Sign("$", len(sound) / rate - last)]


def lay_stops_on_silence(segments: Sequence[Segment], sound: np.ndarray, rate: int) -> list[Segment]:
    """The same, each stop from where its sound ends to its burst: a model says to a tenth of a second where a phone is,
    and a silence in the sound says it exactly.

    segments: phones in time, without gaps; sound: samples, -1 to 1; rate: of them, Hz.
    """
    count = round(_STEP * rate)
    pieces = sound[: len(sound) // count * count].reshape(-1, count)
    level = np.sqrt(np.mean(pieces**2, axis=1)) if len(pieces) else np.zeros(0)
    edges = np.flatnonzero(np.diff(np.r_[False, level < _QUIET * np.abs(sound).max(initial=0.0), False])) * _STEP
    silences = [(start, end) for start, end in edges.reshape(-1, 2).tolist() if end - start >= _SHORTEST_CLOSURE]
    laid = list(segments)
    shapes = shapes_in_place(segments)
    for index in range(1, len(laid) - 1):
        before, stop, after = laid[index - 1 : index + 2]
        if not stop.shapes or stop.shapes[0] not in STOPS or ("sil",) in (shapes[index - 1], shapes[index + 1]):
            continue
        found = _silence_near(silences, stop.start, before.start, after.end)
        if found is not None:
            start = max(found[0], before.start + _STEP)
            end = found[1]
            laid[index - 1] = replace(before, end=start)
            laid[index] = replace(stop, start=start, end=end)
            laid[index + 1] = replace(after, start=end)
    return laid


def _silence_near(
    silences: Sequence[tuple[float, float]], at: float, first: float, last: float
) -> tuple[float, float] | None:
    """The silence whose end is nearest to a time, between two others."""
    near = [(start, end) for start, end in silences if first + 2 * _STEP < end < last and abs(end - at) < _NEAR]
    return min(near, key=lambda silence: abs(silence[1] - at), default=None)


def _belongs_together(before: str, name: str) -> bool:
    if _POINTS.fullmatch(name) or _POINTS.fullmatch(before):
        return bool(_POINTS.fullmatch(name) and _POINTS.fullmatch(before))
    if name in _STRESS:
        return False
    bare = before.strip(_STRESS)
    return not bare or not MARKS.sub("", name) or bare + name in _AFFRICATES


def _shapes_of(name: str, seconds: float) -> tuple[str, ...] | None:
    if not _POINTS.fullmatch(name):
        return shapes_of_ipa(name)
    return () if not name.strip() and seconds < _LONGEST_SPACE else ("sil",)


def _usual_seconds(name: str) -> float:
    """How long a sign lasts in running speech; a mark as good as nothing, and a space a little."""
    if _POINTS.fullmatch(name):
        return 0.3 if name.strip() else 0.02
    shapes = shapes_of_ipa(name)
    return VISEME_SECONDS[shapes[0]] if shapes else 0.03  # type: ignore[index]
