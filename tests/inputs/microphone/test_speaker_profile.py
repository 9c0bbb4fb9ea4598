"""A speaker: measured by a sentence, followed, kept as JSON."""

import json

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import FeatureStream, SoundFeatures
from omote.inputs.microphone.speaker_profile import SpeakerProfile, SpeakerState, measure_speaker
from tests.inputs.microphone.voices import AA, II, UU, Sound, pause, vowel


def sentence() -> Sound:
    """Vowels with pauses, as a sentence is to a microphone."""
    parts = [each for formants in (AA, II, UU) * 3 for each in (vowel(0.15, formants), pause(0.08))]
    return np.concatenate([pause(0.5), *parts])


def measured(sound: Sound) -> SpeakerProfile:
    return measure_speaker(FeatureStream().push(sound))


def test_a_sentence_measures_a_speaker_whatever_the_gain() -> None:
    loud = measured(sentence())
    quiet = measured(0.1 * sentence())
    assert loud.level - quiet.level == pytest.approx(20.0, abs=0.5)
    assert np.subtract(loud.bands, quiet.bands)[:15] == pytest.approx(np.full(15, 20.0), abs=3.0)


@pytest.mark.parametrize("sound", [pause(3.0), vowel(0.3), np.zeros(0, np.float32)], ids=["noise", "short", "nothing"])
def test_what_is_no_sentence_measures_nobody(sound: Sound) -> None:
    with pytest.raises(ValueError, match="no sentence was heard"):
        measured(sound)


def test_a_profile_is_kept_as_json() -> None:
    profile = measured(sentence())
    assert SpeakerProfile.from_json(profile.to_json()) == profile


@pytest.mark.parametrize("data", [b"", b"[]", b"{}", b'{"bands": [1], "level": 0}', b'{"bands": "x", "level": 0}'])
def test_what_is_no_profile_is_rejected(data: bytes) -> None:
    with pytest.raises(ValueError, match="speaker"):
        SpeakerProfile.from_json(data)


def test_numbers_out_of_range_are_rejected() -> None:
    document = json.loads(measured(sentence()).to_json())
    for value in (float("nan"), 500.0):
        with pytest.raises(ValueError, match="a speaker's band is"):
            SpeakerProfile(tuple(document["bands"]), value)


def followed(state: SpeakerState, sound: Sound) -> SpeakerState:
    heard: SoundFeatures = FeatureStream().push(sound)
    for bands, level in zip(heard.bands, heard.level.tolist(), strict=True):
        state.follow(bands, level)
    return state


def test_an_unknown_speaker_becomes_known() -> None:
    wanted = measured(sentence())
    before = SpeakerState()
    far = float(np.abs(before.bands - wanted.bands).mean())
    known = followed(SpeakerState(), np.concatenate([sentence()] * 3))
    assert float(np.abs(known.bands - wanted.bands).mean()) < 0.4 * far


def test_noise_is_the_floor_and_not_the_speaker() -> None:
    state = followed(SpeakerState(), pause(3.0))
    assert state.level == SpeakerState().level
    assert state.floor_level == pytest.approx(-66.0, abs=3.0)


def test_who_holds_one_vowel_stays_known() -> None:
    """The mean of a voice is not the vowel that is held."""
    profile = measured(sentence())
    held = followed(SpeakerState(profile), np.concatenate([pause(0.5), vowel(4.0, II)]))
    assert float(np.abs(held.bands - profile.bands).mean()) < 1.5
