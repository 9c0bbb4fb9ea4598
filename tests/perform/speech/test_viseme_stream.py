"""A stream of visemes: no jump, quick closures, rejections."""

from __future__ import annotations

import numpy as np
import pytest

from omote.perform.speech.viseme_stream import VisemeStream, follow_visemes
from omote.perform.speech.visemes import MOUTH_UNITS, RECIPES, VISEMES, mouth_of

JAW = MOUTH_UNITS.index("jawOpen")
CLOSE = MOUTH_UNITS.index("mouthClose")


def _alone(viseme: str) -> np.ndarray:
    return np.array([float(each == viseme) for each in VISEMES])


def _followed(stream: VisemeStream, viseme: str, seconds: float, level: float = 1.0) -> VisemeStream:
    for _ in range(round(seconds * 100)):
        stream = follow_visemes(stream, _alone(viseme), level, 0.01)
    return stream


def test_a_viseme_that_lasts_is_reached() -> None:
    """After a third of a second the mouth is that of the viseme."""
    assert np.allclose(_followed(VisemeStream(), "O", 0.35).mouth, mouth_of(_alone("O")), atol=0.01)


def test_lips_close_within_a_short_p() -> None:
    """Seventy milliseconds of p between two open vowels close the lips."""
    stream = _followed(_followed(VisemeStream(), "aa", 0.3), "PP", 0.07)
    mouth = stream.mouth
    assert mouth[CLOSE] > 0.97 * mouth[JAW]


def test_silence_brings_the_mouth_to_rest() -> None:
    """A level of 0 is silence, whatever the classifier believes."""
    spoken = _followed(VisemeStream(), "aa", 0.3)
    assert np.abs(_followed(spoken, "aa", 0.5, level=0.0).mouth).max() < 0.01


def test_nothing_pops_where_the_classifier_jumps() -> None:
    """From one viseme to another in one frame, the mouth is never more than a part of the way on at 60 frames a
    second, and its speed changes in steps, not at once."""
    random = np.random.default_rng(3)
    stream = VisemeStream()
    ways = []
    for _ in range(400):
        weights = random.dirichlet(np.full(len(VISEMES), 0.05))
        for _ in range(20):
            stream = follow_visemes(stream, weights, 1.0, 1.0 / 240.0)
            ways.append(stream.mouth)
    assert np.abs(np.diff(ways, axis=0)).max() < 0.2
    assert np.abs(np.diff(ways, axis=0, n=2)).max() < 0.15


def test_one_long_step_is_many_short_ones() -> None:
    """A gap is cut into steps."""
    one = follow_visemes(VisemeStream(), _alone("aa"), 1.0, 0.5)
    assert np.allclose(one.mouth, _followed(VisemeStream(), "aa", 0.5).mouth, atol=0.01)
    assert one.mouth[JAW] == pytest.approx(RECIPES["aa"]["jawOpen"], abs=0.01)


@pytest.mark.parametrize(
    ("weights", "level", "dt", "match"),
    [
        (np.zeros(14), 1.0, 0.01, "give 15 weights"),
        (np.full(15, np.nan), 1.0, 0.01, "weight of the viseme sil"),
        (np.full(15, 1.5), 1.0, 0.01, "weight of the viseme sil"),
        (np.full(15, -0.1), 1.0, 0.01, "weight of the viseme sil"),
        (np.zeros(15), 1.1, 0.01, "level of a voice"),
        (np.zeros(15), float("nan"), 0.01, "level of a voice"),
        (np.zeros(15), 1.0, -0.01, "time step"),
    ],
)
def test_rejects_what_is_no_voice(weights: np.ndarray, level: float, dt: float, match: str) -> None:
    """Every number is checked, and the message names it."""
    with pytest.raises(ValueError, match=match):
        follow_visemes(VisemeStream(), weights, level, dt)
