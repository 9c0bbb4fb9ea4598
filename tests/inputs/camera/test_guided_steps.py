"""Steps of the guided minute ask for what faces can do."""

import numpy as np
import pytest

from omote.inputs.camera.guided_steps import GUIDED, LOOKS, NEUTRAL, STEPS, guided_weights
from omote.inputs.camera.landmark_map import UNITS


def test_every_step_is_a_face_or_a_look() -> None:
    assert sorted(STEPS) == sorted([NEUTRAL, *GUIDED, *LOOKS])
    assert STEPS[0] == NEUTRAL


@pytest.mark.parametrize("step", GUIDED)
def test_a_step_asks_both_sides_for_the_same(step: str) -> None:
    weights = dict(zip(UNITS, guided_weights(step), strict=True))
    assert 0.5 <= max(weights.values()) <= 1.0
    for name, weight in weights.items():
        if name.endswith("Left") and (other := name.replace("Left", "Right")) in weights:
            assert weights[other] == weight


def test_all_that_is_asked_for_is_a_unit() -> None:
    for step, groups in GUIDED.items():
        asked = [name for group in groups for name in (group, f"{group}Left") if name in UNITS]
        assert len(asked) == len(groups), step
        assert np.count_nonzero(guided_weights(step)) >= len(groups)


def test_looks_are_to_both_sides_alike() -> None:
    assert LOOKS["left"][0] == -LOOKS["right"][0] > 0
    assert LOOKS["up"][1] == -LOOKS["down"][1] > 0
