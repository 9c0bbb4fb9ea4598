"""The observations of `observe_heads`, with the truth beside them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast, load_identity_modes
from omote.inputs.camera.landmark_map import UNITS
from omote.model.fitting.photographs.photograph import PhotographCamera
from omote.model.space.similarity import fit_similarity
from tools.photographs.sculpted_people import Sculpted, random_sculpted

Values = NDArray[np.float64]
Floats = NDArray[np.float32]
RIDGE = 0.05
"""Of the weights of modes that are found in a known head, as a share of a standard deviation."""


@dataclass(frozen=True, eq=False)
class Observation:
    """One photograph: landmarks (478, 3) as found, the camera, weights of units, the person's skin (V, 3) in it and
    weights (m,) of the modes, where the landmarks lie on the generic skin (478, 3)."""

    points: Floats
    camera: PhotographCamera
    units: Floats
    skin: Floats
    modes: Values
    lifted: Floats
    whose: tuple[int, int]


def read_observations(folder: Path) -> Iterator[Observation]:
    """All photographs of a folder's parts, person by person."""
    for path in sorted(folder.glob("*.npz")):
        with np.load(path) as part:
            arrays = dict(part)
        for number in np.unique(arrays["whose"]):
            person = random_sculpted(np.random.default_rng([int(arrays["seed"]), int(number)]))
            weights = find_weights(person.face.positions.astype(np.float64))
            for row in np.flatnonzero(arrays["whose"] == number):
                yield _observation(arrays, int(row), person, weights)


def _observation(arrays: dict[str, Floats], row: int, person: Sculpted, weights: Values) -> Observation:
    flat = arrays["cameras"][row].astype(np.float64)
    side = int(flat[13])
    camera = PhotographCamera(flat[:9].reshape(3, 3), flat[9:12], float(flat[12]), side, side)
    worn = {name: float(weight) for name, weight in zip(UNITS, arrays["weights"][row], strict=True) if weight}
    skin, _ = person.wear(worn, (0.0, 0.0))
    whose = int(arrays["seed"]), int(arrays["whose"][row])
    return Observation(
        arrays["points"][row], camera, arrays["weights"][row], skin, weights, arrays["lifted"][row], whose
    )  # fmt: skip


@cache
def _mode_products() -> tuple[Values, Values]:
    modes = load_identity_modes()
    sheet = load_cast().space.on_sheet
    moves = modes.moves[:, sheet].reshape(len(modes.moves), -1)
    matrix = moves @ moves.T
    return moves, matrix + np.eye(len(matrix)) * RIDGE**2 * np.trace(matrix) / len(matrix)


def find_weights(skin: Values) -> Values:
    """The weights (m,) of the modes of a known skin (V, 3), whatever its place and size."""
    modes = load_identity_modes()
    sheet = load_cast().space.on_sheet
    moves, matrix = _mode_products()
    weights: Values = np.zeros(len(moves))
    for _ in range(6):
        shape = modes.shape_skin(weights)[sheet]
        back = fit_similarity(skin[sheet], shape, np.ones(len(shape)))(skin[sheet])
        weights = np.asarray(np.linalg.solve(matrix, moves @ (back - modes.skin[sheet]).ravel()), np.float64)
    return weights
