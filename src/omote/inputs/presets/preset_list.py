"""All presets, and which of them is made for a device."""

from __future__ import annotations

from omote.inputs.presets.midi_presets import MIDI_PRESETS
from omote.inputs.presets.pad_presets import PAD_PRESETS
from omote.inputs.presets.preset import Preset
from omote.perform.name_lookup import find_name

PRESETS = {preset.name: preset for preset in (*MIDI_PRESETS, *PAD_PRESETS)}


def preset_for(device: str, kind: str) -> Preset | None:
    """The first preset that is made for a device of this name and kind; None where there is none."""
    return next((preset for preset in PRESETS.values() if preset.fits(device, kind)), None)


def find_preset(name: str) -> Preset:
    """The preset of a name; ValueError with those that there are."""
    return PRESETS[find_name(name, PRESETS, "preset", where="")]
