"""A preset becomes bindings of a device for a character."""

import pytest

from omote.inputs.presets.preset import LEVELS, PresetControl, directions, faces, faders, feelings


def test_a_control_becomes_a_binding_of_its_device_and_character() -> None:
    binding = PresetControl("1/cc7", "head", "yaw", more={"low": -10.0, "high": 10.0}).binding("pad", "two")
    assert (binding.device, binding.target.path, binding.low, binding.high) == ("pad", "/omote/two/head", -10.0, 10.0)
    assert PresetControl("1/cc42", "/omote/panic").binding("pad", "two").target.path == "/omote/panic"
    assert PresetControl("1/cc43", "bank:B").binding("pad", "two").target.bank == "B"


def test_rows_end_where_the_controls_or_what_they_play_end() -> None:
    names = [str(number) for number in range(40)]
    assert len(faders(names)) == sum(map(len, LEVELS))
    assert len(faders(names[:1])) == len(LEVELS[0])
    assert [each.name for each in feelings(names[:3], first=1)] == names[:3]
    assert feelings(names[:1], first=1)[0].arguments == ("smile", 0.5)
    assert faces(names[:1], ("dog",))[0].arguments == ("dog", 2.0)
    assert len(directions(names)) == 5


def test_a_control_that_cannot_be_is_rejected() -> None:
    with pytest.raises(ValueError, match="near are"):
        PresetControl("1/cc7", "nose").binding("pad", "one")
