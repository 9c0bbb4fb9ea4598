"""Trains the map of the camera's landmarks from the observations, in two or three minutes; the map is committed.

python -m tools.tracking.train_map
"""

from __future__ import annotations

import hashlib
import time
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.inputs.camera.landmark_map import ANGLES, FORMAT, MAP, UNITS, Compression, mirror_outputs
from omote.perform.blending.evaluate import evaluate
from omote.perform.frame import Frame
from tools.tracking.gather import OBSERVATIONS, STEPS
from tools.tracking.network import Floats, Network, Schedule, train

COMPRESSION = tuple(Compression.__dataclass_fields__)
ANGLE_COST = 9.0
"""Of a radian's error, over that of a weight's."""
FACES = ("generic", "old", "man", "round")
"""On whom units are worn to say how much each moves."""
EVEN_SHARE = 0.3
"""By how much each weight counts beside what it moves."""


def unit_metric() -> NDArray[np.float64]:
    """What errors of weights cost: (u, u), products of what units move on some faces, on average 1 on the diagonal."""
    cast = load_cast()
    total = np.zeros((len(UNITS), len(UNITS)))
    for face in FACES:
        rest = evaluate(cast, Frame({face: 1.0}, {"neutral": 1.0}))
        moved = [evaluate(cast, Frame({face: 1.0}, {"neutral": 1.0}, {unit: 1.0})) - rest for unit in UNITS]
        flat = np.array(moved, np.float64).reshape(len(UNITS), -1)
        total += flat @ flat.T
    result: NDArray[np.float64] = total * len(UNITS) / np.trace(total)
    return result


def read_observations(path: Path) -> tuple[dict[str, NDArray[np.float32]], Floats, Floats]:
    """The arrays of the compression and of its mirror; features and targets of all frames, each in the mirror too."""
    with np.load(path) as stored:
        arrays = {
            name: stored[name].astype(np.float32) for name in (*Compression.__dataclass_fields__, "order", "sign")
        }
        features = stored["features"].astype(np.float32) / np.float32(STEPS)
        angles = stored["angles"].astype(np.float32) / np.float32(1e4)
        targets = np.concatenate([stored["weights"].astype(np.float32) / np.float32(255), angles], axis=1)
    other = features[:, arrays["order"].astype(np.intp)] * arrays["sign"]
    swap, turn = mirror_outputs()
    both = np.concatenate([features, other.astype(np.float32)])
    return arrays, both, np.concatenate([targets, targets[:, swap] * turn.astype(np.float32)])


def digest_observations() -> str:
    """The SHA-256 of the committed observations; a map keeps it, so that a test says when the map is stale."""
    return hashlib.sha256(OBSERVATIONS.read_bytes()).hexdigest()


def write_map(path: Path, arrays: dict[str, NDArray[np.float32]], network: Network) -> None:
    """Writes the map: half precision is finer than what the network knows.

    arrays: of the compression and of the mirror, by name; network: what was trained.

    path: the file.
    """
    parts: dict[str, NDArray[Any]] = {name: value.astype(np.float16) for name, value in arrays.items()}
    parts |= {name: arrays[name] for name in ("centre", "spread")} | {"order": arrays["order"].astype(np.int16)}
    parts |= {f"weights{row}": each.astype(np.float16) for row, each in enumerate(network.weights)}
    parts |= {f"offsets{row}": each for row, each in enumerate(network.offsets)}
    parts |= {"observations": np.array(digest_observations()), "format": np.array(FORMAT)}
    parts |= {"linear": network.linear.astype(np.float16)}
    np.savez(path, **parts)  # type: ignore[arg-type]


def main() -> None:
    """Trains and writes."""
    began = time.monotonic()
    arrays, features, targets = read_observations(OBSERVATIONS)
    metric = np.eye(len(UNITS) + ANGLES) * ANGLE_COST
    metric[: len(UNITS), : len(UNITS)] = unit_metric() + EVEN_SHARE * np.eye(len(UNITS))
    network = train(features, targets, metric.astype(np.float32), Schedule())
    write_map(MAP, arrays, network)
    print(f"{MAP}: {len(features)} frames, {MAP.stat().st_size / 1e6:.2f} MB, {time.monotonic() - began:.0f} s")


if __name__ == "__main__":
    main()
