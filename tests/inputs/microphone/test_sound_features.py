"""Features: whatever the pieces, relative to full scale, voiced or not."""

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import BANDS, HOP, QUIETEST, SAMPLE_RATE, FeatureStream, read_pcm
from tests.inputs.microphone.voices import AA, II, pause, pcm, vowel


def test_pieces_do_not_matter() -> None:
    sound = np.concatenate([pause(0.1), vowel(0.3)])
    whole = FeatureStream().push(sound)
    stream = FeatureStream()
    parts = [stream.push(piece) for piece in np.array_split(sound, [7, 300, 301, 1000, 2500])]
    for name in ("bands", "level", "voicing"):
        joined = np.concatenate([getattr(part, name) for part in parts])
        assert np.allclose(joined, getattr(whole, name), atol=1e-3)
    assert len(whole) == len(sound) // HOP


def test_a_gain_shifts_all_bands() -> None:
    loud, quiet = (FeatureStream().push(gain * vowel(0.2)) for gain in (1.0, 0.1))
    low = slice(5, -3), slice(0, 15)  # above lies silence
    assert np.allclose(loud.bands[low] - quiet.bands[low], 20.0, atol=0.01)
    assert np.allclose(loud.level[5:-3] - quiet.level[5:-3], 20.0, atol=0.01)


def test_silence_is_quiet_and_a_sine_of_full_scale_is_loud() -> None:
    assert FeatureStream().push(np.zeros(800, np.float32)).level[-1] == pytest.approx(QUIETEST)
    time = np.arange(SAMPLE_RATE) / SAMPLE_RATE
    sine = FeatureStream().push(np.sin(2 * np.pi * 1000 * time).astype(np.float32))
    assert sine.level[50] == pytest.approx(10 * np.log10(0.5), abs=0.1)
    assert sine.bands.shape[1] == BANDS


def test_voicing_tells_a_voice_from_noise() -> None:
    noise = np.random.default_rng(1).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
    assert FeatureStream().push(vowel(0.5)).voicing[20:-5].min() > 0.8
    assert np.median(FeatureStream().push(noise).voicing) < 0.5


def test_vowels_differ_where_their_formants_do() -> None:
    dark, bright = (FeatureStream().push(vowel(0.3, formants)).bands[20] for formants in (AA, II))
    assert dark[9] > bright[9] + 6.0  # about 1.1 kHz
    assert bright[14] > dark[14] + 6.0  # about 2.2 kHz


def test_samples_are_read_as_they_were_written() -> None:
    assert read_pcm(pcm(np.array([0.0, 0.5, -1.0], np.float32))).tolist() == pytest.approx([0.0, 0.5, -1.0], abs=1e-4)
