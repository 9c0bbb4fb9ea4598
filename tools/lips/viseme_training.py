"""Trains the network that reads visemes: `python -m tools.lips.viseme_training`. Needs espeak-ng, festival, flite.

The packages: tools/lips/README.md. Why the weights are committed: docs/decisions/microphone-and-speech.md.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from omote.inputs.microphone.viseme_network import (
    AHEAD,
    INPUTS,
    STACK,
    WEIGHTS_FILE,
    Dense,
    Gated,
    VisemeNetwork,
    load_network,
)
from omote.perform.speech.visemes import SIL, VISEMES
from tools.lips.corpus import make_recordings
from tools.lips.network_gradients import Piece, find_gradients, parameters
from tools.lips.spoken import UNKNOWN

HIDDEN = 160
UNITS = (192, 128)
STREAMS = 64
PIECE = 64
"""How many streams a step learns from, and how many frames of each."""
FORGETS = 0.05
"""Share of the streams that begin a piece as if nothing had been before."""
SMOOTHING = 0.04
"""Share of a label that is given to all visemes."""
ONSET_FRAMES = 5
ONSET_COUNTS = 2.5
"""The first frames of speech, by which a mouth opens, and how much more they count."""
STEEPEST = 1.0
"""The longest gradient that is taken as it is."""


class Frames:
    """All frames of the recordings, and of each the viseme that it is asked for and how much that counts."""

    def __init__(self, paths: Sequence[Path]) -> None:
        parts = [dict(np.load(path)) for path in paths]
        self.frames, labels = (np.concatenate([part[name] for part in parts]) for name in ("frames", "labels"))
        starts = np.cumsum([0, *(len(part["labels"]) for part in parts)])
        self.ends = np.concatenate([part["ends"] + start for part, start in zip(parts, starts, strict=False)])
        shifted = np.roll(labels, AHEAD).astype(int)
        for start in (0, *self.ends[:-1].tolist()):
            shifted[start : start + AHEAD + STACK] = UNKNOWN
        self.labels = shifted
        self.counts = _importance(shifted)

    def pieces(self, rng: np.random.Generator) -> Iterator[Piece]:
        """Pieces of all recordings in a random order, as many streams side by side, each going on where it was."""
        bounds = list(zip([0, *self.ends[:-1].tolist()], self.ends.tolist(), strict=True))
        order = np.concatenate([np.arange(*bounds[place]) for place in rng.permutation(len(bounds))])
        length = len(order) // STREAMS
        streams = order[: length * STREAMS].reshape(STREAMS, length).T
        for start in range(STACK - 1, length - PIECE + 1, PIECE):
            seen = self.frames[streams[start - STACK + 1 : start + PIECE]].astype(np.float32)
            inputs = np.concatenate([seen[place : place + PIECE] for place in range(STACK)], axis=2)
            here = streams[start : start + PIECE]
            goals = np.full((*here.shape, len(VISEMES)), SMOOTHING / len(VISEMES), np.float32)
            np.put_along_axis(goals, np.maximum(self.labels[here], 0)[..., None], 1 - SMOOTHING, axis=2)
            yield Piece(inputs, goals, self.counts[here])


def _importance(labels: np.ndarray) -> np.ndarray:
    """How much each frame counts: rare visemes more, the begin of speech more, what nobody knows not at all."""
    known = labels != UNKNOWN
    shares = np.bincount(labels[known], minlength=len(VISEMES)) / max(1, known.sum())
    counts = np.clip((1 / len(VISEMES) / np.maximum(shares, 1e-4)) ** 0.5, 0.5, 3.0)[np.maximum(labels, 0)]
    begins = np.flatnonzero((labels[1:] > SIL) & (labels[:-1] == SIL)) + 1
    for frame in range(ONSET_FRAMES):
        counts[np.minimum(begins + frame, len(labels) - 1)] *= ONSET_COUNTS
    return np.where(known, counts, 0.0).astype(np.float32)


def make_frames(path: Path, count: int, festival: int, seed: int) -> None:
    """Makes the recordings and writes their frames.

    path: the file; count, festival: recordings, as of `make_recordings`; seed: of all that is random.
    """
    rng = np.random.default_rng(seed)
    made = []
    for index, recording in enumerate(make_recordings(count, festival, rng)):
        made.append(recording)
        if index % 50 == 0:
            print(index, sum(len(each.labels) for each in made), flush=True)
    ends = np.cumsum([len(each.labels) for each in made])
    np.savez(path, ends=ends, frames=np.concatenate([each.frames for each in made]),
             labels=np.concatenate([each.labels for each in made]))  # fmt: skip


class Adam:
    """Steps of Adam with a falling rate and a little decay of weights; changes the values that it is given."""

    def __init__(self, values: list[np.ndarray], steps: int, rate: float) -> None:
        self._values = values
        self._steps = steps
        self._rate = rate
        self._step = 0
        self._means, self._squares = ([np.zeros_like(each) for each in values] for _ in range(2))

    def take(self, gradients: list[np.ndarray]) -> None:
        """One step against these gradients."""
        self._step += 1
        step = self._step
        rate = self._rate * min(1.0, step / 200) * (0.5 + 0.5 * np.cos(np.pi * min(1.0, step / self._steps))) + 1e-5
        length = float(np.sqrt(sum(float(np.sum(each**2)) for each in gradients)))
        shrink = np.float32(min(1.0, STEEPEST / max(length, 1e-9)))
        for value, found, mean, square in zip(self._values, gradients, self._means, self._squares, strict=True):
            gradient = found * shrink
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (gradient**2 - square)
            way = (mean / (1 - 0.9**step)) / (np.sqrt(square / (1 - 0.999**step)) + 1e-8)
            value -= (rate * way).astype(np.float32)
            value *= 1.0 - 1e-2 * rate


def train(frames: Frames, epochs: int, seed: int, out: Path, network: VisemeNetwork | None, rate: float) -> None:
    """Trains, and writes the network after each epoch. network: where it begins, at random without one.

    frames: of the recordings; epochs: how often each is seen; seed: of order and noise; out: the file; rate: of
    learning.
    """
    rng = np.random.default_rng(seed)
    network = network or begin_network(rng)
    adam = Adam(parameters(network), epochs * (len(frames.labels) // STREAMS // PIECE), rate)
    for epoch in range(epochs):
        state = tuple(np.zeros((STREAMS, layer.units), np.float32) for layer in network.gated)
        began = time.process_time()
        told = []
        for piece in frames.pieces(rng):
            forget = (rng.random((STREAMS, 1)) >= FORGETS).astype(np.float32)
            gradients, loss, scores, state = find_gradients(network, piece, tuple(s * forget for s in state), rng)
            adam.take(gradients)
            right = (np.argmax(scores, axis=2) == np.argmax(piece.goals, axis=2))[piece.counts > 0]
            told.append((loss, np.mean(right)))
        loss, right = np.mean(told, axis=0)
        print(f"epoch {epoch}: loss {loss:.4f}, right {right:.4f}, {time.process_time() - began:.0f} s", flush=True)
        write_network(network, out)


def begin_network(rng: np.random.Generator) -> VisemeNetwork:
    """A network that knows nothing."""

    def draw(rows: int, columns: int, scale: float) -> np.ndarray:
        return rng.normal(0, scale / np.sqrt(rows), (rows, columns)).astype(np.float32)

    gated = []
    before = HIDDEN
    for units in UNITS:
        back = np.concatenate([np.linalg.qr(rng.normal(size=(units, units)))[0] for _ in range(3)], axis=1)
        biases = (np.zeros(3 * units, np.float32) for _ in range(2))
        weight = draw(before, 3 * units, 1.0)
        bias = next(biases)
        bias[units : 2 * units] = 1.0  # it begins by remembering
        gated.append(Gated(weight, bias, back.astype(np.float32), next(biases)))
        before = units
    first = Dense(draw(INPUTS, HIDDEN, np.sqrt(2)), np.zeros(HIDDEN, np.float32))
    return VisemeNetwork(
        first, tuple(gated), Dense(draw(before, len(VISEMES), 1.0), np.zeros(len(VISEMES), np.float32))
    )


def write_network(network: VisemeNetwork, path: Path) -> None:
    """Writes the weights in 16 bits.

    network: as trained; path: the file.
    """
    stored: dict[str, np.ndarray] = {}
    for name, layer in (("first", network.first), ("last", network.last)):
        stored |= {f"{name}_weight": layer.weight, f"{name}_bias": layer.bias}
    for place, gated in enumerate(network.gated):
        stored |= {f"gated_{place}_{n}": getattr(gated, n) for n in ("weight", "bias", "back", "back_bias")}
    np.savez_compressed(path, **{name: each.astype(np.float16) for name, each in stored.items()})  # type: ignore[arg-type]


def main() -> None:
    """Makes the recordings, unless they are there, and trains."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=Path, nargs="+", default=[Path("build/lips/frames.npz")])
    parser.add_argument("--out", type=Path, default=WEIGHTS_FILE)
    parser.add_argument("--begin", type=Path, default=None, help="a network to go on from")
    parser.add_argument("--recordings", type=int, default=440)
    parser.add_argument("--festival", type=int, default=12)
    parser.add_argument("--epochs", type=int, default=10)
    parser.add_argument("--rate", type=float, default=3e-3)
    parser.add_argument("--seed", type=int, default=12)
    options = parser.parse_args()
    if not options.frames[0].exists():
        options.frames[0].parent.mkdir(parents=True, exist_ok=True)
        make_frames(options.frames[0], options.recordings, options.festival, options.seed)
    begin = load_network(options.begin) if options.begin else None
    train(Frames(options.frames), options.epochs, options.seed, options.out, begin, options.rate)


if __name__ == "__main__":
    main()
