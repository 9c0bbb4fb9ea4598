"""Presets of MIDI desks: numbers as the makers' implementation charts have them."""

from __future__ import annotations

from omote.inputs.midi_stream import CONTROL, NOTE_ON
from omote.inputs.presets.lamp import DeviceLamp
from omote.inputs.presets.preset import Preset, PresetControl, directions, faces, faders, feelings
from omote.perform.lights import LIGHTS

FACES = ("kaori", "round", "child", "old", "man", "doll", "dog", "cat")

# Korg nanoKONTROL2 as it is delivered (CC mode, channel 1): sliders 0-7, knobs 16-23, S 32-39, M 48-55, R 64-71,
# transport: back 43, on 44, stop 42, play 41, record 45.
NANOKONTROL2 = Preset(
    "nanokontrol2",
    "Korg nanoKONTROL2",
    "midi",
    (r"nanokontrol2",),
    (
        *faders(f"1/cc{number}" for number in range(8)),
        *directions((f"1/cc{number}" for number in range(16, 21)), pick_up=True),
        PresetControl("1/cc22", "fade/face"),
        PresetControl("1/cc23", "fade/expression"),
        *feelings(f"1/cc{number}" for number in range(32, 40)),
        *feelings((f"1/cc{number}" for number in range(48, 56)), first=8),
        *faces((f"1/cc{number}" for number in range(64, 72)), FACES),
        PresetControl("1/cc42", "/omote/panic"),
        PresetControl("1/cc41", "enter", arguments=(1.0,)),
        PresetControl("1/cc45", "leave", arguments=(1.0,)),
    ),
)

# Behringer X-Touch Mini as it is delivered (standard mode, channel 11), layer A: encoders 1-8 (absolute), their pushes
# are notes 0-7, keys notes 8-23, the fader 9; layer B: encoders 11-18, pushes 24-31, keys 32-47, the fader 10.
# Rings are shown by controllers 9-16 (1 to 13: one lamp), keys by notes 0-15, both on channel 1.
X_TOUCH_MINI = Preset(
    "x-touch-mini",
    "Behringer X-Touch Mini",
    "midi",
    (r"x-?touch ?mini",),
    (
        *faders(f"11/cc{number}" for number in range(1, 9)),
        *feelings(f"11/note{number}" for number in range(8, 24)),
        PresetControl("11/cc9", "fade/face"),
        *directions((f"11/cc{number}" for number in range(11, 16)), pick_up=True),
        PresetControl("11/cc10", "fade/expression"),
        *faces((f"11/note{number}" for number in range(32, 40)), FACES),
        PresetControl("11/note47", "/omote/panic"),
    ),
    lamps={
        **{f"11/cc{number}": DeviceLamp(CONTROL, 8 + number, 1, 13) for number in range(1, 9)},
        **{f"11/note{number}": DeviceLamp(NOTE_ON, number - 8, 0, 1) for number in range(8, 24)},
    },
)

# Novation Launchpad Mini MK3 in programmer mode (channel 1): pads are notes ROW COLUMN, from 11 below left to 88 above
# right, keys above are controllers 91-98, at the right 19 to 89. A lamp's velocity is a colour of the palette.
DIM = 1
WHITE = 3
GREEN = 21
AMBER = 9
RED = 5
BLUE = 45
PADS = [f"1/note{row}{column}" for row in range(8, 0, -1) for column in range(1, 9)]
HOLDS = ("jawOpen", "mouthPucker", "cheekPuff", "tongueOut", "browInnerUp", "eyeBlinkLeft", "eyeBlinkRight", "wink")


def _pad(control: str, lit: int) -> DeviceLamp:
    return DeviceLamp(NOTE_ON, int(control.removeprefix("1/note")), DIM, lit)


LAUNCHPAD_MINI = Preset(
    "launchpad-mini-mk3",
    "Novation Launchpad Mini MK3",
    "midi",
    (r"launchpad mini mk3", r"lpminimk3"),
    (
        *feelings(PADS[:16]),
        *faces(PADS[16:24], FACES),
        *(
            PresetControl(pad, f"channel/{unit}", more={"button": "momentary", "pick_up": False})
            for pad, unit in zip(PADS[24:32], HOLDS, strict=True)
        ),
        *(
            PresetControl(pad, "/omote/light", arguments=(light, 1.0))
            for pad, light in zip(PADS[32:], LIGHTS, strict=False)
        ),
        PresetControl("1/cc29", "/omote/black", more={"button": "toggle", "pick_up": False}),
        PresetControl("1/cc19", "/omote/panic"),
    ),
    lamps={
        **{pad: _pad(pad, GREEN) for pad in PADS[:16]},
        **{pad: _pad(pad, BLUE) for pad in PADS[16:24]},
        **{pad: _pad(pad, AMBER) for pad in PADS[24 : 32 + len(LIGHTS)]},
        "1/cc29": DeviceLamp(CONTROL, 29, DIM, WHITE),
        "1/cc19": DeviceLamp(CONTROL, 19, RED, RED),
    },
    greeting=bytes.fromhex("f0 00 20 29 02 0d 0e 01 f7"),
)

MIDI_PRESETS = (NANOKONTROL2, X_TOUCH_MINI, LAUNCHPAD_MINI)
