"""The network that reads visemes from frames of sound: three layers, trained by `tools/lips`."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from omote.inputs.microphone.sound_features import BANDS, FloatArray, SoundFeatures
from omote.inputs.microphone.speaker_profile import SpeakerState
from omote.perform.speech.visemes import VISEMES

OFFSETS = (-18, -15, -12, -10, -8, -6, -5, -4, -3, -2, -1, 0, 1, 2)
"""The frames that one decision looks at; those after it are what a decision waits for."""
AHEAD = OFFSETS[-1]
HISTORY = -OFFSETS[0] + AHEAD + 1
"""Frames that are kept for a decision."""
FRAME_INPUTS = BANDS + 3
INPUTS = len(OFFSETS) * FRAME_INPUTS + BANDS
WEIGHTS_FILE = Path(__file__).with_name("viseme_network.npz")


@dataclass(frozen=True, eq=False)
class VisemeNetwork:
    """Weights and biases of the layers, of which all but the last are rectified."""

    weights: tuple[FloatArray, ...]
    biases: tuple[FloatArray, ...]

    def __post_init__(self) -> None:
        """Rejects layers that do not fit each other; ValueError with their shapes."""
        sizes = [INPUTS, *(len(bias) for bias in self.biases)]
        shapes = [weight.shape for weight in self.weights]
        if shapes != list(pairwise(sizes)) or sizes[-1] != len(VISEMES):
            raise ValueError(f"the layers are {shapes}; they lead from {INPUTS} inputs to {len(VISEMES)} visemes")

    def run(self, inputs: FloatArray) -> FloatArray:
        """The probabilities of the visemes, (frames, 15), for inputs (frames, INPUTS)."""
        values = inputs
        for weight, bias in zip(self.weights[:-1], self.biases[:-1], strict=True):
            values = np.maximum(values @ weight + bias, 0.0)
        scores = values @ self.weights[-1] + self.biases[-1]
        powers = np.exp(scores - np.max(scores, axis=1, keepdims=True))
        shares: FloatArray = powers / np.sum(powers, axis=1, keepdims=True)
        return shares


def frame_inputs(sound: SoundFeatures, speaker: SpeakerState) -> tuple[FloatArray, FloatArray]:
    """What the network is given of each frame, (frames, FRAME_INPUTS), and of the noise then, (frames, BANDS).

    All of it is relative to the speaker, who is followed frame by frame: neither gain nor a microphone's tone counts.
    """
    frames, floors = np.empty((len(sound), FRAME_INPUTS), np.float32), np.empty((len(sound), BANDS), np.float32)
    for index, (bands, level, voicing) in enumerate(zip(sound.bands, sound.level.tolist(), sound.voicing, strict=True)):
        floor = speaker.follow(bands, level)
        frames[index, :BANDS] = bands - speaker.bands
        frames[index, BANDS:] = level - speaker.level, level - speaker.floor_level, 10.0 * voicing
        floors[index] = floor - speaker.bands
    return np.clip(frames * 0.1, -5.0, 4.0), np.clip(floors * 0.1, -5.0, 2.0)


def stack_frames(frames: FloatArray, floors: FloatArray) -> FloatArray:
    """The inputs of a decision for each frame but the first HISTORY - 1; `floors` of the newest."""
    count = max(0, len(frames) - HISTORY + 1)
    first = HISTORY - 1 - AHEAD
    parts = [frames[first + offset : first + offset + count] for offset in OFFSETS]
    return np.concatenate([*parts, floors[HISTORY - 1 : HISTORY - 1 + count]], axis=1)


def load_network(path: Path = WEIGHTS_FILE) -> VisemeNetwork:
    """The trained network; ValueError where the file holds another one."""
    with np.load(path, allow_pickle=False) as stored:
        layers = len(stored.files) // 2
        weights = tuple(stored[f"weight_{layer}"].astype(np.float32) for layer in range(layers))
        return VisemeNetwork(weights, tuple(stored[f"bias_{layer}"].astype(np.float32) for layer in range(layers)))
