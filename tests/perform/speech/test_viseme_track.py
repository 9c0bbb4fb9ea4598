"""Visemes with times: closures, no jump, coarticulation, rejections."""

from __future__ import annotations

import numpy as np
import pytest

from omote.perform.speech.viseme_track import EMPTY_TRACK, LEAD_SECONDS, VisemeTrack, mouth_at
from omote.perform.speech.visemes import MOUTH_UNITS, RECIPES, VISEMES

JAW, CLOSE, PUCKER, ROLL = (
    MOUTH_UNITS.index(unit) for unit in ("jawOpen", "mouthClose", "mouthPucker", "mouthRollLower")
)
VOWELS = ("aa", "E", "I", "O", "U")


def _track(*marks: tuple[str, float]) -> VisemeTrack:
    starts = np.cumsum([0.0, *(length for _, length in marks)]).round(6).tolist()
    return VisemeTrack(tuple(starts[:-1]), tuple(VISEMES.index(name) for name, _ in marks), starts[-1])


def _random_track(seed: int) -> VisemeTrack:
    random = np.random.default_rng(seed)
    return _track(*((str(random.choice(VISEMES)), float(random.uniform(0.02, 0.25))) for _ in range(60)))


@pytest.mark.parametrize("length", [0.03, 0.05, 0.08, 0.2])
@pytest.mark.parametrize("vowel", VOWELS)
def test_bilabials_close_however_short_they_are(vowel: str, length: float) -> None:
    """In the middle of a p between two vowels nothing parts the lips."""
    mouth = mouth_at(_track((vowel, 0.1), ("PP", length), (vowel, 0.1)), 0.1 + length / 2)
    assert mouth[CLOSE] == pytest.approx(mouth[JAW], rel=0.02)


@pytest.mark.parametrize("length", [0.03, 0.05, 0.08, 0.2])
@pytest.mark.parametrize("vowel", VOWELS)
def test_labiodentals_bite_however_short_they_are(vowel: str, length: float) -> None:
    """In the middle of an f between two vowels the lower lip is at the teeth."""
    mouth = mouth_at(_track((vowel, 0.1), ("FF", length), (vowel, 0.1)), 0.1 + length / 2)
    assert mouth[ROLL] > 0.9 * RECIPES["FF"]["mouthRollLower"]
    assert mouth[JAW] < 2.0 * RECIPES["FF"]["jawOpen"]


def test_every_closure_of_a_random_speech_closes() -> None:
    """Whatever stands beside a p: at least nine in ten, here all of them."""
    for seed in range(20):
        track = _random_track(seed)
        for place, viseme in enumerate(track.visemes[:-1]):
            if VISEMES[viseme] == "PP" and "FF" not in (VISEMES[each] for each in track.visemes[place - 1 : place + 2]):
                mouth = mouth_at(track, (track.starts[place] + track.starts[place + 1]) / 2)
                assert mouth[CLOSE] > 0.9 * mouth[JAW]


def test_nothing_pops() -> None:
    """No unit moves by more than a part of its range in a 240th of a second, and none changes its speed at once."""
    for seed in range(5):
        track = _random_track(seed)
        ways = np.array([mouth_at(track, time) for time in np.arange(-0.3, track.seconds + 0.3, 1 / 240)])
        assert np.abs(np.diff(ways, axis=0)).max() < 0.25
        assert np.abs(np.diff(ways, axis=0, n=2)).max() < 0.15


def test_a_mouth_begins_and_ends_at_rest() -> None:
    """A lead before the first viseme nothing moves yet, and after the last all comes to rest."""
    track = _track(("O", 0.2))
    assert not mouth_at(track, -LEAD_SECONDS).any()
    assert not mouth_at(track, track.seconds + LEAD_SECONDS).any()
    assert mouth_at(track, 0.1)[JAW] > 0.3
    assert not mouth_at(EMPTY_TRACK, 0.0).any()


def test_lips_are_rounded_before_a_rounded_vowel() -> None:
    """A t before u already has lips of u, before an i it has not."""
    rounded, spread = (mouth_at(_track(("DD", 0.08), (vowel, 0.15)), 0.06)[PUCKER] for vowel in ("U", "I"))
    assert rounded > 0.25
    assert spread < 0.05


def test_the_mouth_is_not_behind_its_sound() -> None:
    """The jaw is half open for a vowel when that begins, not a frame later."""
    track = _track(("sil", 0.5), ("aa", 0.2), ("sil", 0.5))
    most = max(mouth_at(track, time)[JAW] for time in np.arange(0.4, 0.9, 0.01))
    assert mouth_at(track, 0.5)[JAW] > most / 2


@pytest.mark.parametrize(
    ("starts", "visemes", "seconds", "match"),
    [
        ((0.0,), (), 1.0, "send one for each"),
        ((0.2, 0.1), (1, 2), 1.0, "before the last one"),
        ((-0.1,), (1,), 1.0, "time of viseme 1"),
        ((float("nan"),), (1,), 1.0, "time of viseme 1"),
        ((601.0,), (1,), 602.0, "time of viseme 1"),
        ((0.0,), (15,), 1.0, "there is no viseme 15"),
        ((0.0,), (-1,), 1.0, "there is no viseme -1"),
        ((0.5,), (1,), 0.4, "length of a speech"),
        ((0.5,), (1,), 601.0, "length of a speech"),
        ((0.0,) * 8001, (0,) * 8001, 1.0, "at most 8000"),
    ],
)
def test_rejects_what_cannot_be_spoken(
    starts: tuple[float, ...], visemes: tuple[int, ...], seconds: float, match: str
) -> None:
    """Every number is checked."""
    with pytest.raises(ValueError, match=match):
        VisemeTrack(starts, visemes, seconds)
