"""A voice: a vowel opens the mouth, a pause does not, whatever the pieces and the level."""

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import FRAME_SECONDS
from omote.inputs.microphone.viseme_network import load_network
from omote.inputs.microphone.voice_visemes import DELAY_SECONDS, LONGEST_SENTENCE, VoiceVisemes
from omote.perform.speech.visemes import VISEMES
from tests.inputs.microphone.test_speaker_profile import sentence
from tests.inputs.microphone.voices import AA, UU, Sound, pause, vowel

OPEN = {"aa", "E", "O"}


def made(sound: Sound) -> list[str]:
    voice = VoiceVisemes(load_network())
    return [frame.strongest if frame.speaks > 0.5 else "sil" for frame in voice.push(sound)]


@pytest.mark.parametrize("gain", [1.0, 0.05])
def test_a_vowel_is_open_and_a_pause_is_silent(gain: float) -> None:
    heard = made(gain * np.concatenate([pause(1.0), vowel(0.2, AA), pause(1.0)]))
    spoken = heard[106:118]
    assert sum(each in OPEN for each in spoken) > 0.8 * len(spoken)
    assert set(heard[20:98]) == {"sil"}
    assert set(heard[135:]) == {"sil"}


def test_vowels_are_told_apart() -> None:
    """A round one is round, after an open one."""
    heard = made(np.concatenate([sentence(), pause(0.3), vowel(0.2, UU), pause(0.2)]))
    spoken = heard[-36:-24]
    assert sum(each in {"U", "O"} for each in spoken) > 0.6 * len(spoken)


def test_pieces_do_not_matter() -> None:
    sound = np.concatenate([pause(0.3), vowel(0.4), pause(0.1)])
    voice = VoiceVisemes(load_network())
    pieces = [frame for piece in np.array_split(sound, 37) for frame in voice.push(piece)]
    whole = VoiceVisemes(load_network()).push(sound)
    assert len(pieces) == len(whole)
    difference = [np.abs(np.subtract(a.weights, b.weights)).max() for a, b in zip(pieces, whole, strict=True)]
    assert max(difference) < 1e-3
    assert [frame.time for frame in whole] == pytest.approx(np.arange(1, len(whole) + 1) * FRAME_SECONDS)


def test_the_decision_is_late_by_what_it_says() -> None:
    heard = made(np.concatenate([pause(1.0), vowel(0.5)]))
    begun = heard.index(next(each for each in heard if each != "sil"))
    assert begun * FRAME_SECONDS - 1.0 == pytest.approx(DELAY_SECONDS, abs=0.025)


def test_one_sentence_measures_the_speaker() -> None:
    voice = VoiceVisemes(load_network())
    voice.start_sentence()
    assert voice.calibrating
    voice.push(0.3 * sentence())
    profile = voice.finish_sentence()
    assert (voice.profile, voice.calibrating) == (profile, False)
    assert voice.loudness == profile.level
    assert VoiceVisemes(load_network(), profile).loudness == profile.level


def test_a_sentence_of_nobody_changes_nothing() -> None:
    voice = VoiceVisemes(load_network())
    voice.start_sentence()
    voice.push(pause(2.0))
    with pytest.raises(ValueError, match="no sentence was heard"):
        voice.finish_sentence()
    assert (voice.profile, voice.calibrating) == (None, False)


def test_a_sentence_that_never_ends_is_cut() -> None:
    voice = VoiceVisemes(load_network())
    voice.start_sentence()
    for _ in range(25):
        voice.push(pause(1.0))
    assert voice._sentence is not None
    assert sum(map(len, voice._sentence)) * FRAME_SECONDS < LONGEST_SENTENCE + 2.0


def test_nothing_heard_is_nothing() -> None:
    assert VoiceVisemes(load_network()).push(np.zeros(0, np.float32)) == []
    assert len(VISEMES) == 15
