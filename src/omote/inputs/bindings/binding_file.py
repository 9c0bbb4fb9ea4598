"""Reads bindings from TOML, a table `[[binding]]` for each: which control plays what."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.dmx.dmx_input import ARTNET, SACN, read_control

NUMBER = (int, float)
KEYS: Mapping[str, tuple[tuple[type, ...], str]] = {
    "device": ((str,), "the device's name, as it calls itself; `sACN`, `Art-Net`"),
    "control": ((str,), "the control's name on it"),
    "to": ((str,), "an address of OSC, with its character; or `bank:NAME`, and the button turns to that bank"),
    "axis": ((str,), "of a head or a gaze: `yaw`, `pitch`, `roll`"),
    "arguments": ((list,), "of a call: the name and, if wanted, the seconds or `hand`"),
    "low": (NUMBER, "the value at the control's lower end"),
    "high": (NUMBER, "the value at its upper end; a lower one than `low` turns the control round"),
    "curve": (NUMBER, "exponent of the way between: 1 even, 2 fine below, 0.5 fine above"),
    "pick_up": ((bool,), "a fader acts once it has crossed the value on air; else at once"),
    "button": ((str,), "a button moves the level: `momentary` while it is held, `toggle` at each press"),
    "relative": ((str,), "an encoder without ends, by its code: `twos_complement`, `binary_offset`, `sign_magnitude`"),
    "step": (NUMBER, "the part of the range that one step of an encoder moves"),
    "dead_zone": (NUMBER, "how far from its middle a stick counts as there, 0 to 0.45 of its way"),
    "bank": ((str,), "the bank in which it plays; without it, in all"),
}
"""The keys of a table: what each may be, and what it says."""
NEEDED = ("device", "control", "to")
MOST_BINDINGS = 1024


class BindingFileError(ValueError):
    """A file of bindings cannot be read, and where and why."""


def read_bindings(text: str) -> list[Binding]:
    """The bindings of a file, in their order; BindingFileError for anything that is not as expected."""
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise BindingFileError(f"it is no TOML: {error}") from error
    tables = document.pop("binding", [])
    if document or not isinstance(tables, list) or not 1 <= len(tables) <= MOST_BINDINGS:
        raise BindingFileError(f"it holds something else than 1 to {MOST_BINDINGS} tables [[binding]]")
    bindings = []
    for number, table in enumerate(tables, 1):
        try:
            bindings.append(read_binding(table))
        except ValueError as error:
            raise BindingFileError(f"binding {number}: {error}") from error
    return bindings


def read_binding(table: Any) -> Binding:
    """The binding of a table; ValueError where it is none."""
    if not isinstance(table, dict):
        raise ValueError(f"{str(table)[:80]!r} is no table")
    for key, value in table.items():
        if key not in KEYS:
            raise ValueError(f"there is no key {key[:80]!r}; there are {', '.join(KEYS)}")
        kinds, _ = KEYS[key]
        if not isinstance(value, kinds) or (isinstance(value, bool) and bool not in kinds):
            raise ValueError(f"{key} is {str(value)[:80]!r}; expected {' or '.join(t.__name__ for t in kinds)}")
    missing = [key for key in NEEDED if key not in table]
    if missing:
        raise ValueError(f"{', '.join(missing)} missing")
    fields = {"pick_up": table["device"] not in (SACN, ARTNET), **table}  # a desk of lights says what counts
    target = read_target(fields.pop("to"), fields.pop("arguments", ()), fields.pop("axis", None))
    low, high = target.usual_range if target.is_level else (0.0, 1.0)
    if fields["device"] in (SACN, ARTNET):
        read_control(fields["control"])
    return Binding(**{"target": target, "low": low, "high": high, **fields})
