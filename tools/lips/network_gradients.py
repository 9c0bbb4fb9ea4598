"""Gradients of the network that reads visemes: many streams at once, back through time over one piece of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from omote.inputs.microphone.viseme_network import Gated, Remembered, VisemeNetwork

DROPPED = 0.1
"""Share of the values between two layers that one piece does without (Zaremba et al. 2014)."""

Array = np.ndarray


@dataclass(frozen=True, eq=False)
class Piece:
    """Frames of many streams. inputs: (time, streams, INPUTS); goals: (time, streams, 15) shares that are right;
    counts: (time, streams), how much each frame counts."""

    inputs: Array
    goals: Array
    counts: Array


@dataclass(frozen=True, eq=False)
class _Pass:
    """What a gated layer did: gates and new values (time, streams, units), the part that was reset, what it knew."""

    reset: Array
    update: Array
    new: Array
    own: Array
    before: Array
    values: Array


def parameters(network: VisemeNetwork) -> list[Array]:
    """All weights and biases, in one order."""
    gated = [each for layer in network.gated for each in (layer.weight, layer.bias, layer.back, layer.back_bias)]
    return [network.first.weight, network.first.bias, *gated, network.last.weight, network.last.bias]


def find_gradients(
    network: VisemeNetwork, piece: Piece, state: Remembered, rng: np.random.Generator | None
) -> tuple[list[Array], float, Array, Remembered]:
    """Gradients of the mean cross entropy for `parameters`, the entropy, the scores, and what the layers remember then.

    state: (streams, units) of each layer. rng: of the values that are left out; without it none is.

    network: as it is; piece: of recordings side by side.
    """
    values = np.maximum(piece.inputs @ network.first.weight + network.first.bias, 0.0)
    masks = [_mask(values.shape, rng)]
    kept = [values * masks[0]]
    passes = []
    after = []
    for layer, before in zip(network.gated, state, strict=True):
        passes.append(_run(layer, kept[-1], before))
        masks.append(_mask(passes[-1].values.shape, rng))
        kept.append(passes[-1].values * masks[-1])
        after.append(passes[-1].values[-1])
    scores = kept[-1] @ network.last.weight + network.last.bias
    logarithms = scores - _log_sum(scores)
    share = (piece.counts / max(float(piece.counts.sum()), 1e-9))[..., None].astype(np.float32)
    error = (np.exp(logarithms) - piece.goals) * share
    gradients = [_flat(kept[-1]).T @ _flat(error), _flat(error).sum(axis=0)]
    error = (error @ network.last.weight.T) * masks[-1]
    for place in range(len(passes) - 1, -1, -1):
        found, error = _back(network.gated[place], passes[place], kept[place], error)
        gradients = [*found, *gradients]
        error = error * masks[place]
    error = error * (values > 0)
    gradients = [_flat(piece.inputs).T @ _flat(error), _flat(error).sum(axis=0), *gradients]
    return gradients, float(-np.sum(piece.goals * logarithms * share)), scores, tuple(after)


def _mask(shape: Sequence[int], rng: np.random.Generator | None) -> Array:
    if rng is None:
        return np.ones((), np.float32)
    return (rng.random(shape, dtype=np.float32) > DROPPED) * np.float32(1.0 / (1.0 - DROPPED))


def _log_sum(scores: Array) -> Array:
    most = scores.max(axis=-1, keepdims=True)
    found: Array = most + np.log(np.exp(scores - most).sum(axis=-1, keepdims=True))
    return found


def _flat(values: Array) -> Array:
    return values.reshape(-1, values.shape[-1])


def _run(layer: Gated, inputs: Array, before: Array) -> _Pass:
    """A layer over one piece; the same as `Gated.step` for each frame."""
    given = inputs @ layer.weight + layer.bias
    units = layer.units
    made = _Pass(*(np.empty((*inputs.shape[:2], units), np.float32) for _ in range(6)))
    for time in range(len(inputs)):
        own = before @ layer.back + layer.back_bias
        gates = 0.5 + 0.5 * np.tanh(0.5 * (given[time, :, : 2 * units] + own[:, : 2 * units]))
        made.reset[time], made.update[time] = gates[:, :units], gates[:, units:]
        made.own[time], made.before[time] = own[:, 2 * units :], before
        new = made.new[time] = np.tanh(given[time, :, 2 * units :] + made.reset[time] * made.own[time])
        before = made.values[time] = new + made.update[time] * (before - new)
    return made


def _back(layer: Gated, done: _Pass, inputs: Array, error: Array) -> tuple[list[Array], Array]:
    """Gradients of a layer's weight, bias, back and back_bias, and of its inputs."""
    units = layer.units
    given = np.empty((*error.shape[:2], 3 * units), np.float32)
    own = np.empty_like(given)
    later = np.zeros_like(error[0])
    slope = 1.0 - done.new**2
    rising = done.update * (1.0 - done.update)
    falling = done.reset * (1.0 - done.reset)
    for time in range(len(error) - 1, -1, -1):
        whole = error[time] + later
        new = whole * (1.0 - done.update[time]) * slope[time]
        given[time, :, units : 2 * units] = whole * (done.before[time] - done.new[time]) * rising[time]
        given[time, :, :units] = new * done.own[time] * falling[time]
        given[time, :, 2 * units :] = new
        own[time, :, : 2 * units], own[time, :, 2 * units :] = given[time, :, : 2 * units], new * done.reset[time]
        later = whole * done.update[time] + own[time] @ layer.back.T
    gradients = [_flat(inputs).T @ _flat(given), _flat(given).sum(axis=0),
                 _flat(done.before).T @ _flat(own), _flat(own).sum(axis=0)]  # fmt: skip
    return gradients, given @ layer.weight.T
