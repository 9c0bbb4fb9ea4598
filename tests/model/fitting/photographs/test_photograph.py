"""Photographs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.model.fitting.photographs.photograph import Photograph

POINTS = np.full((478, 3), 50.0)


def test_landmarks_come_with_and_without_depth() -> None:
    assert Photograph(POINTS, 100, 80).has_depth
    flat = Photograph(POINTS[:, :2].astype(np.float32), 100, 80)
    assert not flat.has_depth
    assert flat.landmarks.dtype == np.float64
    assert not flat.landmarks.flags.writeable


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"landmarks": POINTS[:468]}, r"landmarks of a photograph have shape \(468, 3\)"),
        ({"landmarks": np.where(np.eye(478, 3), np.nan, POINTS)}, "landmarks of a photograph"),
        ({"landmarks": POINTS * 100}, "pictures outside"),
        ({"width": 0}, "the width of a photograph is 0"),
        ({"height": 10**6}, "the height of a photograph is 1000000"),
        ({"focal": 2.0}, "the focal length of a photograph is 2.0"),
        ({"picture": np.zeros((100, 80, 3), np.uint8)}, "a picture has shape"),
        ({"picture": np.zeros((80, 100, 3))}, "of uint8"),
    ],
)
def test_what_is_no_photograph_is_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Photograph(**{"landmarks": POINTS, "width": 100, "height": 80, **change})
