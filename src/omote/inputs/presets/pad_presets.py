"""Presets of gamepads and space mice, by the standard mapping of the Gamepad API and by the axes of a 3D mouse."""

from __future__ import annotations

from typing import Any

from omote.inputs.bindings.target import DOWNWARD, STICK_DEGREES
from omote.inputs.presets.preset import Preset, PresetControl

# Axes 0 and 1 are the left stick, 2 and 3 the right one, + right and down; buttons 0-3 below, right, left, above,
# 4 and 5 bumpers, 6 and 7 triggers (levels too), 8 and 9 middle, 10 and 11 sticks, 12-15 cross: up, down, left, right.
_STICK: dict[str, Any] = {"pick_up": False}
_CALLS = {
    "button0": "smile",
    "button1": "angry",
    "button2": "sad",
    "button3": "surprise",
    "button12": "joy",
    "button13": "neutral",
    "button14": "fear",
    "button15": "disgust",
}
_HELD = {"button4": "eyeBlinkRight", "button5": "eyeBlinkLeft"}


def _standard(name: str, label: str, *matches: str) -> Preset:
    return Preset(name, label, "gamepad", matches, STANDARD)


def _turn(control: str, to: str, along: str) -> PresetControl:
    farthest = STICK_DEGREES[to, along]
    low, high = (farthest, -farthest) if control in DOWNWARD else (-farthest, farthest)
    return PresetControl(control, to, along, more={"pick_up": False, "low": low, "high": high})


STANDARD = (
    # the audience sees the character turn where the stick goes: its own left is the picture's right
    _turn("axis0", "gaze", "yaw"),
    _turn("axis1", "gaze", "pitch"),
    _turn("axis2", "head", "yaw"),
    _turn("axis3", "head", "pitch"),
    PresetControl("trigger6", "channel/mouthPucker", more=_STICK),
    PresetControl("trigger7", "channel/jawOpen", more=_STICK),
    *(PresetControl(key, "expression", arguments=(feeling, 0.5)) for key, feeling in _CALLS.items()),
    *(PresetControl(key, f"channel/{unit}", more={"button": "momentary", **_STICK}) for key, unit in _HELD.items()),
    PresetControl("button8", "/omote/panic"),
)

XBOX = _standard("xbox", "Xbox controller", r"xbox", r"xinput", r"vendor: 045e", r"\(045e:")
DUALSHOCK = _standard(
    "dualshock", "DualShock or DualSense", r"dualshock", r"dualsense", r"vendor: 054c", r"\(054c:", r"playstation"
)
OTHER_PAD = _standard("gamepad", "Gamepad (standard mapping)", r"gamepad", r"controller", r"\bpad\b")
SPACE_MOUSE = Preset(
    "space-mouse",
    "3D mouse",
    "space_mouse",
    (r"",),
    (
        _turn("rz", "head", "yaw"),
        _turn("rx", "head", "pitch"),
        _turn("ry", "head", "roll"),
        _turn("x", "gaze", "yaw"),
        _turn("z", "gaze", "pitch"),
        PresetControl("button0", "/omote/panic"),
    ),
)

PAD_PRESETS = (XBOX, DUALSHOCK, OTHER_PAD, SPACE_MOUSE)
