"""The network: its shape, its inputs, and the weights that are shipped."""

from pathlib import Path

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import BANDS, FeatureStream
from omote.inputs.microphone.speaker_profile import SpeakerState
from omote.inputs.microphone.viseme_network import (
    AHEAD,
    FRAME_INPUTS,
    HISTORY,
    INPUTS,
    WEIGHTS_FILE,
    VisemeNetwork,
    frame_inputs,
    load_network,
    stack_frames,
)
from omote.perform.speech.visemes import VISEMES
from tests.inputs.microphone.voices import vowel

MOST_BYTES = 500_000


def test_the_shipped_network_is_small_and_gives_shares() -> None:
    network = load_network()
    assert WEIGHTS_FILE.stat().st_size < MOST_BYTES
    shares = network.run(np.random.default_rng(2).normal(size=(20, INPUTS)).astype(np.float32))
    assert shares.shape == (20, len(VISEMES))
    assert np.allclose(shares.sum(axis=1), 1.0, atol=1e-5)
    assert shares.min() >= 0.0


def test_layers_that_do_not_fit_are_rejected(tmp_path: Path) -> None:
    zeros = [np.zeros(shape, np.float32) for shape in ((INPUTS, 3), (4, len(VISEMES)))]
    with pytest.raises(ValueError, match="they lead from"):
        VisemeNetwork(tuple(zeros), (np.zeros(3, np.float32), np.zeros(len(VISEMES), np.float32)))
    np.savez(tmp_path / "other.npz", weight_0=zeros[0], bias_0=np.zeros(3))
    with pytest.raises(ValueError, match="they lead from"):
        load_network(tmp_path / "other.npz")


def test_a_decision_sees_the_frames_around_it() -> None:
    frames = np.arange(40 * FRAME_INPUTS, dtype=np.float32).reshape(40, FRAME_INPUTS)
    stacked = stack_frames(frames, np.zeros((40, BANDS), np.float32))
    assert stacked.shape == (40 - HISTORY + 1, INPUTS)
    now = HISTORY - 1 - AHEAD
    assert stacked[0, :FRAME_INPUTS].tolist() == frames[0].tolist()
    last = slice(INPUTS - BANDS - FRAME_INPUTS, INPUTS - BANDS)
    assert stacked[0, last].tolist() == frames[now + AHEAD].tolist()
    assert stack_frames(frames[:5], np.zeros((5, BANDS), np.float32)).shape == (0, INPUTS)


def test_inputs_are_relative_to_the_speaker() -> None:
    """A louder microphone gives the same, once the speaker is known."""
    given = []
    for gain in (1.0, 0.2):
        heard, speaker = FeatureStream().push(gain * vowel(1.0)), SpeakerState()
        speaker.level += 20.0 * np.log10(gain)
        speaker.bands = speaker.bands + np.float32(20.0 * np.log10(gain))
        given.append(frame_inputs(heard, speaker)[0][30, :15])  # above lies silence
    assert given[0] == pytest.approx(given[1], abs=0.05)
