"""Writes the reference of files of bindings as Markdown, from the table that reads them."""

from __future__ import annotations

from dataclasses import fields

from omote.inputs.bindings.binding_file import KEYS, MOST_BINDINGS, NEEDED
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.dmx.dmx_universe import LOST_SECONDS, MOST_SOURCES

WORDS = {str: "text", bool: "true or false", list: "list", int: "number", float: "number"}
HEAD = f"""# Bindings

Written from `src/omote/inputs/bindings/binding_file.py` by `tools/website/binding_reference.py`. How to use them:
[Dials, pads and sticks at a browser](../howto/devices.md), [Play from a lighting desk](../howto/lighting-desk.md).

Pages make bindings by *Learn*, and the show file keeps them. Those of a file stand before them where both have the same
control in the same bank, and no page changes them.

A file for `omote show --bindings` is TOML with 1 to {MOST_BINDINGS} tables `[[binding]]`, each a control of a device
and what it plays. A control may stand in several. {", ".join(f"`{key}`" for key in NEEDED)} are needed.

| key | value | what it says | without it |
|---|---|---|---|
"""
TAIL = f"""
* `low` and `high` are 0 and 1 of a channel without them, and both ends of what the address takes else
  ([OSC](osc.md)). A value out of that range is rejected when the file is read.
* Without `pick_up`, faders of sACN and Art-Net act at once, all others once they have crossed the value on air.
* A device turns to a bank by a control bound to `bank:NAME`, or on the page; each device has a bank of its own.
* A button is pressed from one half of its way on, a key (a note) at any velocity. A note that plays a level without
  `button` plays its velocity.

## Controls

| device | control | what it is |
|---|---|---|
| `sACN` | `1/17` | universe (1 to 63999) and slot (1 to 512) |
| `Art-Net` | `0/17` | universe (0 to 32767: net, sub-net and universe in one number) and slot |
| MIDI | `1/cc7` | channel (from 1) and controller |
| MIDI | `1/cc7+39` | a controller and its fine part, 14 bits: once that came right behind it three times, or bound |
| MIDI | `1/note60`, `1/pressure60` | a note with its velocity, its pressure |
| MIDI | `1/bend`, `1/pressure`, `1/program5` | pitch bend (14 bits), pressure, a program (a press) |
| gamepad | `axis0`, `axis1`, `axis2`, `axis3` | left stick, right stick: 0 left and up, 0.5 in the middle |
| gamepad | `button0`, `trigger6` | a key, a trigger as a level, numbered as the standard mapping of browsers has them |
| 3D mouse | `x`, `y`, `z`, `rx`, `ry`, `rz`, `button0` | moved and turned along each axis; a key |

Of a universe {MOST_SOURCES} sources are heard; one is lost after {LOST_SECONDS:g} seconds of silence.
"""


def binding_page() -> str:
    """The page: a row for each key."""
    return HEAD + "".join(_row(key) for key in KEYS) + TAIL


def _row(key: str) -> str:
    kinds, tells = KEYS[key]
    value = " or ".join(dict.fromkeys(WORDS[kind] for kind in kinds))
    return f"| `{key}` | {value} | {tells} | {_default(key)} |\n"


def _default(key: str) -> str:
    default = next((field.default for field in fields(Binding) if field.name == key), None)
    told = key not in (*NEEDED, "low", "high", "pick_up")
    return f"{default:g}" if told and isinstance(default, float) else ""
