"""Trains a small network by Adam (Kingma and Ba 2015), the same every time."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
BATCH = 256
FIRST = 0.9
SECOND = 0.998
"""How much of the gradients' means is kept."""


@dataclass(frozen=True)
class Schedule:
    """How a network is trained. rate falls to nothing along a cosine; drop: the share of hidden units left out at each
    step (Srivastava et al. 2014); noise: on features; decay: of weights (Loshchilov and Hutter 2019)."""

    hidden: tuple[int, ...] = (512, 512)
    epochs: int = 40
    rate: float = 2e-3
    drop: float = 0.3
    noise: float = 0.2
    decay: float = 1e-4
    seed: int = 12


class Network:
    """Layers with swish between them, and a linear part from the inputs to the outputs."""

    def __init__(self, inputs: int, outputs: int, schedule: Schedule, draw: np.random.Generator) -> None:
        sizes = (inputs, *schedule.hidden, outputs)
        self.weights = [
            (draw.standard_normal((a, b)) * np.sqrt(1.5 / a)).astype(np.float32) for a, b in pairwise(sizes)
        ]
        self.weights[-1] *= np.float32(0.1)
        self.offsets = [np.zeros(size, np.float32) for size in sizes[1:]]
        self.linear = np.zeros((inputs, outputs), np.float32)
        self._inputs: list[Floats] = []
        self._slopes: list[Floats] = []

    @property
    def parameters(self) -> list[Floats]:
        """Everything that is trained."""
        return [*self.weights, *self.offsets, self.linear]

    def forward(self, features: Floats, draw: np.random.Generator, drop: float) -> Floats:
        """Outputs of a batch; keeps what `backward` needs.

        features (n, f); draw: of the units that are left out; drop: their share.
        """
        self._inputs = [features]
        self._slopes = []
        hidden = features
        for weights, offsets in zip(self.weights[:-1], self.offsets[:-1], strict=True):
            values = hidden @ weights + offsets
            gate = 1.0 / (1.0 + np.exp(-np.clip(values, -30.0, 30.0)))
            kept = (draw.random(values.shape, np.float32) >= drop) / np.float32(1.0 - drop)
            hidden = values * gate * kept
            self._slopes.append(gate * (1.0 + values * (1.0 - gate)) * kept)
            self._inputs.append(hidden)
        result: Floats = hidden @ self.weights[-1] + self.offsets[-1] + features @ self.linear
        return result

    def backward(self, error: Floats) -> list[Floats]:
        """Gradients of the parameters."""
        linear = self._inputs[0].T @ error
        weights = []
        offsets = []
        for layer in range(len(self.weights) - 1, -1, -1):
            weights.append(self._inputs[layer].T @ error)
            offsets.append(error.sum(axis=0))
            if layer:
                error = (error @ self.weights[layer].T) * self._slopes[layer - 1]
        return [*weights[::-1], *offsets[::-1], linear]


def train(features: Floats, targets: Floats, metric: Floats, schedule: Schedule) -> Network:
    """A network that gives targets (n, k) from features (n, f), where an error e costs e metric e; metric (k, k).

    schedule: how.
    """
    draw = np.random.default_rng(schedule.seed)
    network = Network(features.shape[1], targets.shape[1], schedule, draw)
    parameters = network.parameters
    means = [np.zeros_like(each) for each in parameters]
    squares = [np.zeros_like(each) for each in parameters]
    steps = schedule.epochs * (len(features) // BATCH)
    step = 0
    for _ in range(schedule.epochs):
        order = draw.permutation(len(features))
        for first in range(0, len(features) - BATCH + 1, BATCH):
            rows = order[first : first + BATCH]
            step = step + 1
            seen = features[rows]
            seen = seen + draw.standard_normal(seen.shape, np.float32) * np.float32(schedule.noise)
            error = network.forward(seen, draw, schedule.drop) - targets[rows]
            gradients = network.backward(((error @ metric) / np.float32(BATCH)).astype(np.float32))
            rate = schedule.rate * 0.5 * (1.0 + np.cos(np.pi * step / steps)) * min(1.0, step / 50)
            _adam(parameters, gradients, means, squares, step, rate, schedule.decay)
    return network


def _adam(
    parameters: list[Floats], gradients: list[Floats], means: list[Floats], squares: list[Floats], step: int,
    rate: float, decay: float,
) -> None:  # fmt: skip
    for value, gradient, mean, square in zip(parameters, gradients, means, squares, strict=True):
        mean += np.float32(1 - FIRST) * (gradient - mean)
        square += np.float32(1 - SECOND) * (gradient * gradient - square)
        root = np.sqrt(square / np.float32(1 - SECOND**step)) + np.float32(1e-7)
        move = mean / np.float32(1 - FIRST**step) / root
        if value.ndim > 1:
            move += np.float32(decay) * value
        value -= np.float32(rate) * move
