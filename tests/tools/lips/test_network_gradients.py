"""The gradients of the network are those of its entropy, and its pass is the one that the show runs."""

import numpy as np
import pytest

from omote.inputs.microphone.viseme_network import INPUTS, Dense, Gated, VisemeNetwork
from omote.perform.speech.visemes import VISEMES
from tools.lips.network_gradients import Piece, find_gradients, parameters

UNITS = (5, 4)
STREAMS = 3
TIME = 6
RNG = np.random.default_rng(3)


def draw(*shape: int) -> np.ndarray:
    return RNG.normal(0, 0.3, shape).astype(np.float32)


@pytest.fixture
def network() -> VisemeNetwork:
    gated = []
    before = 7
    for units in UNITS:
        gated.append(Gated(draw(before, 3 * units), draw(3 * units), draw(units, 3 * units), draw(3 * units)))
        before = units
    return VisemeNetwork(Dense(draw(INPUTS, 7), draw(7)), tuple(gated), Dense(draw(before, 15), draw(15)))


@pytest.fixture
def piece() -> Piece:
    goals = np.eye(len(VISEMES), dtype=np.float32)[RNG.integers(0, len(VISEMES), (TIME, STREAMS))]
    return Piece(draw(TIME, STREAMS, INPUTS), goals, RNG.random((TIME, STREAMS)).astype(np.float32))


def test_gradients_are_the_slopes_of_the_entropy(network: VisemeNetwork, piece: Piece) -> None:
    state = tuple(draw(STREAMS, units) for units in UNITS)
    gradients = find_gradients(network, piece, state, None)[0]
    for values, gradient in zip(parameters(network), gradients, strict=True):
        assert gradient.shape == values.shape
        place = tuple(int(RNG.integers(size)) for size in values.shape)
        step = 2e-2
        kept = values[place]
        losses = []
        for side in (1.0, -1.0):
            values[place] = kept + side * step
            losses.append(find_gradients(network, piece, state, None)[1])
        values[place] = kept
        assert (losses[0] - losses[1]) / (2 * step) == pytest.approx(float(gradient[place]), abs=2e-4, rel=2e-2)


def test_the_show_runs_what_was_trained(network: VisemeNetwork, piece: Piece) -> None:
    state = tuple(np.zeros((STREAMS, units), np.float32) for units in UNITS)
    scores = find_gradients(network, piece, state, None)[2]
    shares = np.exp(scores[:, 1]) / np.exp(scores[:, 1]).sum(axis=1, keepdims=True)
    run, _ = network.run(piece.inputs[:, 1], network.begin())
    assert run == pytest.approx(shares, abs=1e-5)
