"""The mouth of a voice: it moves without a jump, shuts for a bilabial, and lets its layer go in silence."""

import numpy as np
import pytest

from omote.inputs.microphone.spoken_mouth import FALL_SECONDS, HOLD_SECONDS, SpokenMouth
from omote.inputs.microphone.viseme_frame import VisemeFrame
from omote.perform.speech.visemes import MOUTH_UNITS, VISEMES, mouth_of

JAW = MOUTH_UNITS.index("jawOpen")
CLOSE = MOUTH_UNITS.index("mouthClose")


def frame(**given: float) -> VisemeFrame:
    return VisemeFrame(0.0, tuple(given.get(viseme, 0.0) for viseme in VISEMES), -20.0, 1.0)


def test_a_vowel_opens_at_once_and_takes_the_layer() -> None:
    mouth = SpokenMouth()
    mouth.follow([frame(aa=1.0)] * 8)
    assert mouth.share > 0.9
    assert mouth.mouth[JAW] > 0.4


def test_a_bilabial_between_vowels_shuts_the_lips() -> None:
    mouth = SpokenMouth()
    mouth.follow([frame(aa=1.0)] * 20)
    mouth.follow([frame(aa=0.3, PP=0.7)] * 6)
    assert mouth.mouth[CLOSE] == pytest.approx(mouth.mouth[JAW])
    assert mouth.share > 0.9


def test_nothing_pops() -> None:
    """Whatever the decisions, no unit goes in 10 ms what a cut would make it go."""
    random = np.random.default_rng(3)
    mouth = SpokenMouth()
    ways = [mouth.mouth]
    cuts = [mouth.mouth]
    for _ in range(300):
        chosen = frame(**{VISEMES[int(random.integers(len(VISEMES)))]: 1.0})
        for _ in range(int(random.integers(1, 12))):
            mouth.follow([chosen])
            ways.append(mouth.mouth)
            cuts.append(mouth_of(np.array(chosen.weights)))
    assert np.abs(np.diff(ways, axis=0)).max() < 0.65 * np.abs(np.diff(cuts, axis=0)).max()


def test_silence_lets_the_layer_go_but_a_closure_does_not() -> None:
    mouth = SpokenMouth()
    mouth.follow([frame(aa=1.0)] * 30)
    mouth.follow([frame(sil=1.0)] * round(0.12 / 0.01))
    assert mouth.share > 0.95
    mouth.follow([frame(sil=1.0)] * round((HOLD_SECONDS + 3 * FALL_SECONDS) / 0.01))
    assert mouth.share == 0.0
    assert mouth.mouth.max() < 0.01


def test_a_voice_that_is_gone_rests() -> None:
    mouth = SpokenMouth()
    mouth.follow([frame(aa=1.0)] * 30)
    for _ in range(120):
        mouth.rest(1 / 60)
    assert mouth.share == 0.0
    assert mouth.mouth[JAW] < 0.01
