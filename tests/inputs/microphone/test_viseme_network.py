"""The network: its shape, its inputs, and the weights that are shipped."""

from pathlib import Path

import numpy as np
import pytest

from omote.inputs.microphone.sound_features import FeatureStream
from omote.inputs.microphone.speaker_profile import SpeakerState
from omote.inputs.microphone.viseme_network import (
    FRAME_INPUTS,
    INPUTS,
    STACK,
    WEIGHTS_FILE,
    Dense,
    VisemeNetwork,
    frame_inputs,
    load_network,
    stack_frames,
)
from omote.perform.speech.visemes import VISEMES
from tests.inputs.microphone.voices import vowel

MOST_BYTES = 1_000_000


def test_the_shipped_network_is_small_and_gives_shares() -> None:
    network = load_network()
    assert WEIGHTS_FILE.stat().st_size < MOST_BYTES
    shares, _ = network.run(np.random.default_rng(2).normal(size=(20, INPUTS)).astype(np.float32), network.begin())
    assert shares.shape == (20, len(VISEMES))
    assert np.allclose(shares.sum(axis=1), 1.0, atol=1e-5)
    assert shares.min() >= 0.0


def test_what_was_before_is_remembered_from_run_to_run() -> None:
    network = load_network()
    inputs = np.random.default_rng(4).normal(size=(12, INPUTS)).astype(np.float32)
    whole, _ = network.run(inputs, network.begin())
    first, state = network.run(inputs[:5], network.begin())
    second, _ = network.run(inputs[5:], state)
    assert np.concatenate([first, second]) == pytest.approx(whole, abs=1e-5)
    forgot, _ = network.run(inputs[5:], network.begin())
    assert np.abs(forgot - second).max() > 1e-3


def test_layers_that_do_not_fit_are_rejected() -> None:
    network = load_network()
    narrow = Dense(network.last.weight[:-1], network.last.bias)
    with pytest.raises(ValueError, match="they lead from"):
        VisemeNetwork(network.first, network.gated, narrow)
    with pytest.raises(ValueError, match="they lead from"):
        VisemeNetwork(network.first, network.gated[::-1], network.last)


def test_a_file_of_another_network_is_rejected(tmp_path: Path) -> None:
    np.savez(tmp_path / "other.npz", weight_0=np.zeros((2, 3)), bias_0=np.zeros(3))
    with pytest.raises(ValueError, match="holds no network of visemes: 'first_weight' is missing"):
        load_network(tmp_path / "other.npz")


def test_a_decision_sees_the_newest_frames() -> None:
    frames = np.arange(20 * FRAME_INPUTS, dtype=np.float32).reshape(20, FRAME_INPUTS)
    stacked = stack_frames(frames)
    assert stacked.shape == (20 - STACK + 1, INPUTS)
    assert stacked[0].tolist() == frames[:STACK].ravel().tolist()
    assert stack_frames(frames[: STACK - 1]).shape == (0, INPUTS)


def test_inputs_are_relative_to_the_speaker() -> None:
    """A louder microphone gives the same, once the speaker is known."""
    given = []
    for gain in (1.0, 0.2):
        heard = FeatureStream().push(gain * vowel(1.0))
        speaker = SpeakerState()
        speaker.level += 20.0 * np.log10(gain)
        speaker.bands = speaker.bands + np.float32(20.0 * np.log10(gain))
        given.append(frame_inputs(heard, speaker)[30, :15])  # above lies silence
    assert given[0] == pytest.approx(given[1], abs=0.05)
