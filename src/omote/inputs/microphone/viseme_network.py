"""The network that reads visemes from frames of sound, trained by `tools/lips`: a dense layer, two layers of gated
recurrent units, and the shares of the visemes."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from omote.arrays import Floats
from omote.inputs.microphone.sound_features import BANDS, SoundFeatures
from omote.inputs.microphone.speaker_profile import SpeakerState
from omote.perform.speech.visemes import VISEMES

AHEAD = 2
"""Frames after its own that a decision waits for."""
STACK = 4
"""Newest frames that the first layer sees at once."""
FRAME_INPUTS = 2 * BANDS + 3
INPUTS = STACK * FRAME_INPUTS
WEIGHTS_FILE = Path(__file__).with_name("viseme_network.npz")

_HALF = np.float32(0.5)

Remembered = tuple[Floats, ...]
"""What the recurrent layers remember, one array of units each."""


@dataclass(frozen=True, eq=False)
class Dense:
    """A layer: weight (inputs, units), bias (units,)."""

    weight: Floats
    bias: Floats


@dataclass(frozen=True, eq=False)
class Gated:
    """A layer of gated recurrent units (Cho et al. 2014), the reset after the product as in cuDNN.

    weight (inputs, 3 units), bias: of reset, update and new value; back (units, 3 units), back_bias: of its own values.
    """

    weight: Floats
    bias: Floats
    back: Floats
    back_bias: Floats

    @property
    def units(self) -> int:
        """How many numbers it remembers."""
        return len(self.back)

    def step(self, weighted: Floats, before: Floats) -> Floats:
        """Its values after one frame. weighted: of the frame, `inputs @ weight + bias`; before: its values after the
        frame before, (units,)."""
        units = self.units
        own = before @ self.back + self.back_bias
        gates: Floats = _HALF + _HALF * np.tanh(_HALF * (weighted[: 2 * units] + own[: 2 * units]))
        new = np.tanh(weighted[2 * units :] + gates[:units] * own[2 * units :])
        values: Floats = new + gates[units:] * (before - new)
        return values


@dataclass(frozen=True, eq=False)
class VisemeNetwork:
    """The layers, from INPUTS to the visemes; the first is rectified."""

    first: Dense
    gated: tuple[Gated, ...]
    last: Dense

    def __post_init__(self) -> None:
        """Rejects layers that do not fit each other; ValueError with their shapes."""
        sizes = [INPUTS, len(self.first.bias), *(layer.units for layer in self.gated), len(VISEMES)]
        layers: list[Dense | Gated] = [self.first, *self.gated, self.last]
        shapes = [(*layer.weight.shape, *layer.bias.shape) for layer in layers]
        wides = [sizes[1], *(3 * layer.units for layer in self.gated), len(VISEMES)]
        backs = [(*layer.back.shape, *layer.back_bias.shape) for layer in self.gated]
        expected = [(before, wide, wide) for (before, _), wide in zip(pairwise(sizes), wides, strict=True)]
        if shapes != expected or backs != [(n.units, 3 * n.units, 3 * n.units) for n in self.gated]:
            raise ValueError(
                f"the layers are {shapes}, {backs}; they lead from {INPUTS} inputs to {len(VISEMES)} visemes"
            )

    def begin(self) -> Remembered:
        """What is remembered before any sound."""
        return tuple(np.zeros(layer.units, np.float32) for layer in self.gated)

    def run(self, inputs: Floats, state: Remembered) -> tuple[Floats, Remembered]:
        """The probabilities of the visemes, (frames, 15), for inputs (frames, INPUTS), and what is remembered then.

        state: what was remembered before.
        """
        values = np.maximum(inputs @ self.first.weight + self.first.bias, 0.0)
        kept = []
        for layer, before in zip(self.gated, state, strict=True):
            weighted_rows = values @ layer.weight + layer.bias
            values = np.empty((len(inputs), layer.units), np.float32)
            for index, weighted in enumerate(weighted_rows):
                before = values[index] = layer.step(weighted, before)
            kept.append(before)
        scores = values @ self.last.weight + self.last.bias
        powers = np.exp(scores - np.max(scores, axis=1, keepdims=True))
        return powers / np.sum(powers, axis=1, keepdims=True), tuple(kept)


def frame_inputs(sound: SoundFeatures, speaker: SpeakerState) -> Floats:
    """What the network is given of each frame, (frames, FRAME_INPUTS): sound and noise in bands, levels, voicing.

    All of it is relative to the speaker, who is followed frame by frame: neither gain nor a microphone's tone counts.
    """
    frames = np.empty((len(sound), FRAME_INPUTS), np.float32)
    for index, (bands, level, voicing) in enumerate(zip(sound.bands, sound.level.tolist(), sound.voicing, strict=True)):
        floor = speaker.follow(bands, level)
        frames[index, :BANDS] = bands - speaker.bands
        frames[index, BANDS:-BANDS] = level - speaker.level, level - speaker.floor_level, 10.0 * voicing
        frames[index, -BANDS:] = floor - speaker.bands
    inputs: Floats = np.clip(frames * 0.1, -5.0, 4.0)
    return inputs


def stack_frames(frames: Floats) -> Floats:
    """The inputs of each frame but the first STACK - 1."""
    count = max(0, len(frames) - STACK + 1)
    return np.concatenate([frames[place : place + count] for place in range(STACK)], axis=1)


def load_network(path: Path = WEIGHTS_FILE) -> VisemeNetwork:
    """The trained network; ValueError where the file holds another one."""
    with np.load(path, allow_pickle=False) as stored:
        kept = {name: stored[name].astype(np.float32) for name in stored.files}
    try:
        dense = [Dense(kept[f"{name}_weight"], kept[f"{name}_bias"]) for name in ("first", "last")]
        names = ("weight", "bias", "back", "back_bias")
        count = sum(name.endswith("_back") for name in kept)
        gated = tuple(Gated(*(kept[f"gated_{place}_{name}"] for name in names)) for place in range(count))
    except KeyError as error:
        raise ValueError(f"{path} holds no network of visemes: {error} is missing") from error
    return VisemeNetwork(dense[0], gated, dense[1])
