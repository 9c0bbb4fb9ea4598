"""Presets: every control plays something that there is, and each device is known by its names."""

import pytest

from omote.builtin import load_cast
from omote.inputs.bindings.binding_document import document_of, read_document
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import OscMessage
from omote.inputs.presets.preset import Preset
from omote.inputs.presets.preset_list import PRESETS, find_preset, preset_for

NAMES = {
    "nanoKONTROL2 SLIDER/KNOB": ("midi", "nanokontrol2"),
    "nanoKONTROL2": ("midi", "nanokontrol2"),
    "X-TOUCH MINI": ("midi", "x-touch-mini"),
    "Launchpad Mini MK3 LPMiniMK3 MIDI": ("midi", "launchpad-mini-mk3"),
    "LPMiniMK3 MIDI Out": ("midi", "launchpad-mini-mk3"),
    "Xbox 360 Controller (XInput STANDARD GAMEPAD)": ("gamepad", "xbox"),
    "Xbox Wireless Controller (045e:0b13)": ("gamepad", "xbox"),
    "Wireless Controller (STANDARD GAMEPAD Vendor: 054c Product: 09cc)": ("gamepad", "dualshock"),
    "DualSense Wireless Controller (054c:0ce6)": ("gamepad", "dualshock"),
    "8BitDo Pro 2 Gamepad": ("gamepad", "gamepad"),
    "SpaceMouse Compact": ("space_mouse", "space-mouse"),
    "nanoKONTROL Studio": ("midi", None),
    "X-Touch One": ("midi", None),
}


@pytest.mark.parametrize("device", NAMES)
def test_a_device_is_known_by_its_name(device: str) -> None:
    kind, wanted = NAMES[device]
    found = preset_for(device, kind)
    assert (None if found is None else found.name) == wanted


def test_a_name_alone_does_not_make_a_device_of_another_kind() -> None:
    assert preset_for("Xbox", "midi") is None


@pytest.mark.parametrize("preset", PRESETS.values(), ids=lambda preset: preset.name)
def test_all_that_a_preset_binds_can_be_played_on_the_built_in_cast(preset: Preset) -> None:
    reader = OrderReader(load_cast(), {"one": "One", "two": "Two"})
    for binding in preset.bindings("device", "*"):
        target = binding.target
        values = tuple(value.low for value in target.values) or target.arguments
        assert reader.read(OscMessage(target.path, values), "c")
        assert read_document(document_of(binding)) == binding


@pytest.mark.parametrize("preset", PRESETS.values(), ids=lambda preset: preset.name)
def test_no_control_of_a_preset_calls_two_things_and_every_lamp_has_a_control(preset: Preset) -> None:
    bindings = preset.bindings("device", "one")
    called = [each.control for each in bindings if not each.target.is_level]
    assert len(set(called)) == len(called)
    assert set(preset.lamps) <= {each.control for each in bindings}
    assert find_preset(preset.name) is preset


def test_a_preset_that_there_is_not_is_named_with_those_near() -> None:
    with pytest.raises(ValueError, match="there is no preset 'xbx'; near are xbox"):
        find_preset("xbx")
