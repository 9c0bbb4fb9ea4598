"""Trains the network that reads visemes: `python -m tools.lips.viseme_training`. Needs espeak-ng, festival, flite.

The packages, and why the weights are committed: docs/decisions/0136-lips-from-a-microphone.md.
"""

from __future__ import annotations

import argparse
import time
from itertools import pairwise
from pathlib import Path

import numpy as np

from omote.inputs.microphone.viseme_network import (
    AHEAD,
    FRAME_INPUTS,
    HISTORY,
    INPUTS,
    OFFSETS,
    WEIGHTS_FILE,
    VisemeNetwork,
)
from omote.perform.speech.visemes import VISEMES
from tools.lips.corpus import make_recordings
from tools.lips.spoken import UNKNOWN

HIDDEN = (256, 128)
BATCH = 1024
SMOOTHING = 0.04
"""Share of a label that is given to all visemes."""


class Frames:
    """All frames of the recordings. places: of those that have a label; labels: of these."""

    def __init__(self, path: Path) -> None:
        with np.load(path) as stored:
            self.frames, self.floors, labels, ends = (stored[n] for n in ("frames", "floors", "labels", "ends"))
        usable = labels != UNKNOWN
        for end in [0, *ends.tolist()]:
            usable[end : end + HISTORY - 1 - AHEAD] = False
            usable[max(0, end - AHEAD) : end] = False
        self.places = np.flatnonzero(usable)
        self.labels = labels[self.places].astype(int)

    def inputs(self, places: np.ndarray) -> np.ndarray:
        """What the network is given at these frames."""
        values = np.empty((len(places), INPUTS), np.float32)
        for index, offset in enumerate(OFFSETS):
            values[:, index * FRAME_INPUTS : (index + 1) * FRAME_INPUTS] = self.frames[places + offset]
        values[:, len(OFFSETS) * FRAME_INPUTS :] = self.floors[places + AHEAD]
        return values


def make_frames(path: Path, count: int, festival: int, seed: int) -> None:
    """Makes the recordings and writes their frames."""
    rng = np.random.default_rng(seed)
    made = []
    for index, recording in enumerate(make_recordings(count, festival, rng)):
        made.append(recording)
        if index % 50 == 0:
            print(index, sum(len(each.labels) for each in made), flush=True)
    ends = np.cumsum([len(each.labels) for each in made])
    stacked = {name: np.concatenate([getattr(each, name) for each in made]) for name in ("frames", "floors", "labels")}
    np.savez(path, ends=ends, **stacked)  # type: ignore[arg-type]


class Adam:
    """Steps of Adam with a falling rate and a little decay of weights; changes the values that it is given."""

    def __init__(self, values: list[np.ndarray], steps: int) -> None:
        self._values, self._steps, self._step = values, steps, 0
        self._means, self._squares = ([np.zeros_like(each) for each in values] for _ in range(2))

    def take(self, gradients: list[np.ndarray]) -> None:
        """One step against these gradients."""
        self._step += 1
        step = self._step
        rate = 2e-3 * min(1.0, step / 200) * (0.5 + 0.5 * np.cos(np.pi * step / self._steps)) + 1e-5
        for value, gradient, mean, square in zip(self._values, gradients, self._means, self._squares, strict=True):
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (gradient**2 - square)
            way = (mean / (1 - 0.9**step)) / (np.sqrt(square / (1 - 0.999**step)) + 1e-8)
            value -= (rate * way).astype(np.float32)
            value *= 1.0 - 1e-2 * rate


def train(frames: Frames, epochs: int, seed: int, out: Path) -> None:
    """Trains, and writes the network after each epoch."""
    rng = np.random.default_rng(seed)
    network = _begin(rng)
    adam = Adam([*network.weights, *network.biases], epochs * (len(frames.places) // BATCH))
    shares = np.bincount(frames.labels, minlength=len(VISEMES)) / len(frames.labels)
    importance = np.clip((1 / len(VISEMES) / np.maximum(shares, 1e-4)) ** 0.5, 0.5, 3.0).astype(np.float32)
    for epoch in range(epochs):
        order = rng.permutation(len(frames.places))
        began, told = time.process_time(), []
        for start in range(0, len(order) - BATCH + 1, BATCH):
            chosen = order[start : start + BATCH]
            inputs = frames.inputs(frames.places[chosen])
            gradients, loss, right = _gradients(network, inputs, frames.labels[chosen], importance, rng)
            adam.take(gradients)
            told.append((loss, right))
        loss, right = np.mean(told, axis=0)
        print(f"epoch {epoch}: loss {loss:.4f}, right {right:.4f}, {time.process_time() - began:.0f} s", flush=True)
        write_network(network, out)


def write_network(network: VisemeNetwork, path: Path) -> None:
    """Writes the weights in 16 bits."""
    stored = {f"weight_{i}": each.astype(np.float16) for i, each in enumerate(network.weights)}
    stored |= {f"bias_{i}": each.astype(np.float16) for i, each in enumerate(network.biases)}
    np.savez_compressed(path, **stored)  # type: ignore[arg-type]


def _begin(rng: np.random.Generator) -> VisemeNetwork:
    sizes = [INPUTS, *HIDDEN, len(VISEMES)]
    weights = [rng.normal(0, np.sqrt(2 / a), (a, b)).astype(np.float32) for a, b in pairwise(sizes)]
    return VisemeNetwork(tuple(weights), tuple(np.zeros(size, np.float32) for size in sizes[1:]))


def _gradients(
    network: VisemeNetwork, inputs: np.ndarray, labels: np.ndarray, importance: np.ndarray, rng: np.random.Generator
) -> tuple[list[np.ndarray], float, float]:
    """Gradients of the cross entropy for weights and biases, its mean, and the share of frames that are right."""
    kept = [inputs]
    for weight, bias in zip(network.weights[:-1], network.biases[:-1], strict=True):
        values = np.maximum(kept[-1] @ weight + bias, 0.0)
        values *= (rng.random(values.shape, dtype=np.float32) > 0.1) * np.float32(1 / 0.9)
        kept.append(values)
    scores = kept[-1] @ network.weights[-1] + network.biases[-1]
    scores -= np.max(scores, axis=1, keepdims=True)
    logarithms = scores - np.log(np.sum(np.exp(scores), axis=1, keepdims=True))
    goal = np.full_like(scores, SMOOTHING / len(VISEMES))
    goal[np.arange(len(labels)), labels] += 1 - SMOOTHING
    counted = importance[labels][:, None] / len(labels)
    error = (np.exp(logarithms) - goal) * counted
    weights, biases = [], []
    for layer in range(len(network.weights) - 1, -1, -1):
        weights.append(kept[layer].T @ error)
        biases.append(np.sum(error, axis=0))
        if layer:
            error = (error @ network.weights[layer].T) * (kept[layer] > 0)
    right = float(np.mean(np.argmax(scores, axis=1) == labels))
    return [*weights[::-1], *biases[::-1]], float(-np.sum(goal * logarithms * counted)), right


def main() -> None:
    """Makes the recordings, unless they are there, and trains."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=Path, default=Path("build/lips/frames.npz"))
    parser.add_argument("--out", type=Path, default=WEIGHTS_FILE)
    parser.add_argument("--recordings", type=int, default=700)
    parser.add_argument("--festival", type=int, default=10)
    parser.add_argument("--epochs", type=int, default=12)
    parser.add_argument("--seed", type=int, default=12)
    options = parser.parse_args()
    if not options.frames.exists():
        options.frames.parent.mkdir(parents=True, exist_ok=True)
        make_frames(options.frames, options.recordings, options.festival, options.seed)
    train(Frames(options.frames), options.epochs, options.seed, options.out)


if __name__ == "__main__":
    main()
