"""A lamp shows a position between its two ends."""

import pytest

from omote.inputs.presets.lamp import DeviceLamp


@pytest.mark.parametrize(("position", "value"), [(0.0, 1), (0.5, 7), (1.0, 13)])
def test_a_ring_shows_its_place(position: float, value: int) -> None:
    assert DeviceLamp(0xB0, 9, 1, 13).message(position) == bytes([0xB0, 9, value])
