"""A voice: a vowel opens the mouth, a pause does not, whatever the pieces and the level."""

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import FRAME_SECONDS, SAMPLE_RATE
from omote.inputs.microphone.viseme_network import Dense, VisemeNetwork, load_network
from omote.inputs.microphone.voice_visemes import DELAY_SECONDS, LONGEST_SENTENCE, VoiceVisemes
from omote.perform.speech.visemes import PP, VISEMES
from tests.inputs.microphone.test_speaker_profile import sentence
from tests.inputs.microphone.voices import AA, UU, Sound, pause, vowel

OPEN = {"aa", "E", "O"}


def made(sound: Sound) -> list[str]:
    voice = VoiceVisemes(load_network())
    return [frame.strongest if frame.speaks > 0.5 else "sil" for frame in voice.push(sound)]


@pytest.mark.parametrize("gain", [1.0, 0.05])
def test_a_vowel_is_open_and_a_pause_is_silent(gain: float) -> None:
    heard = made(np.float32(gain) * np.concatenate([pause(1.0), vowel(0.2, AA), pause(1.0)]))
    spoken = heard[106:118]
    assert sum(each in OPEN for each in spoken) > 0.5 * len(spoken)
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


def sure_of(viseme: str, share: float) -> VisemeNetwork:
    """A network that says the same of every frame."""
    shares = np.full(len(VISEMES), (1.0 - share) / (len(VISEMES) - 1))
    shares[VISEMES.index(viseme)] = share
    network = load_network()
    bias = np.log(shares).astype(np.float32)
    return VisemeNetwork(network.first, network.gated, Dense(np.zeros_like(network.last.weight), bias))


def closes(network: VisemeNetwork, noise: float) -> float:
    """The weight of bilabials at the end of a sentence in noise (dB below full scale)."""
    sound = np.concatenate([np.zeros(SAMPLE_RATE, np.float32), sentence()])
    hiss = np.random.default_rng(3).normal(0.0, 10.0 ** (noise / 20.0), len(sound)).astype(np.float32)
    return VoiceVisemes(network).push(sound + hiss)[-1].weights[PP]


def test_a_bilabial_counts_more_in_speech_and_most_in_noise() -> None:
    quiet, noisy = (closes(sure_of("aa", 0.7), noise) for noise in (-80.0, -25.0))
    assert 1.5 * 0.3 / 14 < quiet < noisy


def test_after_silence_a_bilabial_counts_as_the_network_says() -> None:
    """Lips are shut there as it is, and what holds them shut parts them late."""
    frames = VoiceVisemes(sure_of("sil", 0.99)).push(pause(1.0))
    weights = np.array([frame.weights for frame in frames])
    assert weights[-1, PP] == pytest.approx(weights[-1, PP + 1], rel=0.05)


def test_the_gate_opens_before_the_decision() -> None:
    """By the frames that a decision waits for: lips that part late are seen."""
    frames = VoiceVisemes(load_network()).push(np.concatenate([pause(1.0), vowel(0.4)]))
    opened = next(place for place, frame in enumerate(frames) if frame.gate > 0.9)
    assert opened * FRAME_SECONDS - 1.0 < DELAY_SECONDS - 0.01
