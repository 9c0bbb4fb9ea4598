"""The network learns what can be learned, the same every time."""

import numpy as np

from tools.tracking.network import Network, Schedule, train

SMALL = Schedule(hidden=(24,), epochs=30, drop=0.0, noise=0.0)


def samples() -> tuple[np.ndarray, np.ndarray]:
    draw = np.random.default_rng(3)
    features = draw.standard_normal((2048, 6)).astype(np.float32)
    targets = np.stack([features[:, 0] * features[:, 1], np.abs(features[:, 2])], axis=1).astype(np.float32)
    return features, targets


def error(network: Network, features: np.ndarray, targets: np.ndarray) -> float:
    return float(((network.forward(features, np.random.default_rng(0), 0.0) - targets) ** 2).mean())


def test_it_learns_what_is_not_linear() -> None:
    features, targets = samples()
    linear = features @ np.linalg.lstsq(features, targets, rcond=None)[0]
    found = error(train(features, targets, np.eye(2, dtype=np.float32), SMALL), features, targets)
    assert found < 0.5 * float(((linear - targets) ** 2).mean())


def test_it_is_the_same_every_time() -> None:
    features, targets = samples()
    first, second = (train(features, targets, np.eye(2, dtype=np.float32), SMALL) for _ in range(2))
    assert all(np.array_equal(a, b) for a, b in zip(first.parameters, second.parameters, strict=True))


def test_gradients_are_slopes_of_the_error() -> None:
    features, targets = samples()
    draw = np.random.default_rng(1)
    network = Network(6, 2, SMALL, draw)
    rows = features[:16]
    aims = targets[:16]
    gradients = network.backward(network.forward(rows, draw, 0.0) - aims)
    for parameter, gradient in zip(network.parameters, gradients, strict=True):
        place = np.unravel_index(int(np.abs(gradient).argmax()), gradient.shape)
        costs = []
        for step in (1e-2, -1e-2):
            parameter[place] += step
            costs.append(0.5 * float(((network.forward(rows, draw, 0.0) - aims) ** 2).sum()))
            parameter[place] -= step
        slope = (costs[0] - costs[1]) / 2e-2
        assert abs(slope - gradient[place]) < 0.03 * abs(slope) + 1e-3
