"""The committed map is the one of the committed observations."""

import numpy as np

from omote.inputs.camera.landmark_map import MAP
from tools.tracking.train_map import digest_observations


def test_the_map_was_trained_from_the_observations_beside_it() -> None:
    with np.load(MAP) as file:
        assert str(file["observations"]) == digest_observations(), "run: python -m tools.tracking.train_map"
