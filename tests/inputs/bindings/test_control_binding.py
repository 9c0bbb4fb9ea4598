"""A binding: its range and curve, and what it refuses to be."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target

JAW = read_target("/omote/one/channel/jawOpen")
TURN = read_target("/omote/one/macro/turn")
PANIC = read_target("/omote/panic")


@given(st.floats(0.0, 1.0), st.floats(0.2, 5.0), st.booleans())
def test_the_position_of_a_value_is_where_the_control_stands(position: float, curve: float, turned: bool) -> None:
    low, high = (1.5, -0.5) if turned else (-0.5, 1.5)
    binding = Binding("pad", "1/cc7", JAW, low, high, curve)
    assert binding.value_at(binding.position_of(binding.value_at(position))) == pytest.approx(
        binding.value_at(position), abs=1e-9
    )
    assert (binding.value_at(0.0), binding.value_at(1.0)) == (low, high)


@given(st.floats(0.0, 1.0), st.floats(0.0, 0.45))
def test_a_stick_counts_as_in_its_middle_near_it_and_has_its_whole_way_beyond(position: float, zone: float) -> None:
    binding = Binding("pad", "axis0", TURN, -1.0, 1.0, dead_zone=zone)
    value = binding.value_at(position)
    assert (value == 0.0) or abs(position - 0.5) >= zone
    assert binding.value_at(binding.position_of(value)) == pytest.approx(value, abs=1e-9)
    assert binding.value_at(1.0 - position) == pytest.approx(-value, abs=1e-9)
    assert (binding.value_at(0.0), binding.value_at(1.0)) == (-1.0, 1.0)
    assert abs(binding.value_at(0.5 + zone + 1e-6)) < 1e-4


def test_a_value_out_of_the_control_s_range_lies_at_its_nearer_end() -> None:
    binding = Binding("pad", "1/cc7", JAW, 0.0, 1.0)
    assert (binding.position_of(-0.5), binding.position_of(1.5)) == (0.0, 1.0)


def test_encoders_of_all_kinds_count_the_same_steps() -> None:
    for steps in range(-63, 64):
        bytes_ = {
            "twos_complement": steps % 128,
            "binary_offset": steps + 64,
            "sign_magnitude": abs(steps) | (64 if steps < 0 else 0),
        }
        for encoding, byte in bytes_.items():
            binding = Binding("pad", "1/cc7", JAW, relative=encoding)  # type: ignore[arg-type]
            assert binding.steps(byte / 127.0) == steps


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"device": ""}, "give its name"),
        ({"control": "x" * 81}, "give its name"),
        ({"low": -1.0}, "low is -1.0"),
        ({"high": float("nan")}, "high is nan"),
        ({"high": 0.0}, "needs a range"),
        ({"curve": 0.0}, "curve is 0.0"),
        ({"curve": float("nan")}, "curve is nan"),
        ({"step": 2.0}, "step is 2.0"),
        ({"dead_zone": 0.5}, "dead_zone is 0.5"),
        ({"button": "press"}, "button is one of"),
        ({"relative": "signed"}, "relative one of"),
        ({"button": "toggle", "relative": "binary_offset"}, "not both"),
        ({"target": PANIC, "button": "toggle"}, "called by a press"),
    ],
)
def test_what_cannot_be_is_said(changes: dict[str, Any], why: str) -> None:
    with pytest.raises(ValueError, match=why):
        Binding(**{"device": "pad", "control": "1/cc7", "target": JAW, **changes})
