"""Writes the reference of OSC as Markdown, from the table that the show itself parses with."""

from __future__ import annotations

from omote.inputs.osc_addresses import ADDRESSES, BY_HAND, Address
from omote.inputs.osc_feedback import QUIET_SECONDS
from omote.inputs.osc_input import ERROR, SUBSCRIBE, SURFACE_SECONDS, UNSUBSCRIBE
from omote.perform.scene.character_names import FIRST_CHARACTER
from omote.show.osc import CALL_SECONDS, Value

HEAD = f"""# OSC

Written from `src/omote/inputs/osc_addresses.py` by `tools/website/osc_reference.py`. How to connect a surface:
[the how-to](../howto/osc.md).

`omote show` hears OSC 1.0 on port 9000 (UDP, and TCP with SLIP or lengths) of the address that it serves pages on;
`--osc 9001` takes another port, `--osc off` none; `--allow` names who may send beside this machine. The first character
of a new show is called `{FIRST_CHARACTER}`; in the place of a character `*` means all, and the other patterns of OSC
(`?`, `[a-c]`, `{{one,two}}`) work too.

| address | arguments | what it does |
|---|---|---|
"""

TAIL = f"""
* A number comes as float, double, integer, boolean or as numeric text, a switch as 0, 1, true or false.
  Angles are in degrees: + is the character's left, up, tilt to its left. A value out of its range is
  rejected, never clipped.
* A framing is `*`, all that are on the stage, or names of characters joined by `+` or spaces: `one+two`.
* Names are found in any case, with spaces, hyphens or underscores: `Crooked Smile` is `crooked_smile`.
* A call takes {CALL_SECONDS:g} second where no seconds are given, but `black`, which follows a fader at once;
  `"{BY_HAND}"` in their place makes a call by hand, which the T-bar moves.
* Arguments in brackets may be left out. A `press` of 0 is a button that is let go: it does nothing.
* The messages of a bundle are obeyed when they come, whatever time its tag says; each stands for itself.

The same as a tree, with names, ranges and values, for surfaces that build themselves (OSCQuery):
`http://127.0.0.1:8090/omote` while a show runs.

## Feedback

| address | arguments | what it does |
|---|---|---|
| `{SUBSCRIBE}` | [port] | tells the sender what is on air: at this port, else where it sends from |
| `{UNSUBSCRIBE}` | [port] | ends that |

A surface hears all of it once, then what changes, at most 30 times a second, at the addresses above: `face` and
`expression` with the name that is called or weighs most, `expression/brows`, `eyes`, `mouth` and `rest` with what shows
there, channels, `head`, `gaze`, both `fade`s, `light`, `framing`, `black`.
What it sends itself it hears {QUIET_SECONDS:g} seconds after its last message, so that no motor fights a hand. On TCP
all this comes on the surface's own connection. Why a message of its own was rejected comes to `{ERROR}`.
A surface that has been silent for {SURFACE_SECONDS / 60:g} minutes is told no more until it subscribes again; so is
every surface after the server has started anew.
"""


def osc_page() -> str:
    """The page: a row for each address."""
    return HEAD + "".join(_row(address) for address in ADDRESSES) + TAIL


def _row(address: Address) -> str:
    in_path = address.path.count("{")
    values = ", ".join(_value(value) for value in address.values[in_path:])
    return f"| `{address.pattern}` | {values} | {address.tells} |\n"


def _value(value: Value) -> str:
    if value.kind == "number":
        unit = f" {value.unit}" if value.unit else ""
        return f"{value.name} {value.low:g} to {value.high:g}{unit}"
    if value.kind == "switch":
        return f"{value.name} 0 or 1"
    if value.kind == "framing":
        return value.name
    return f"[{value.name}]" if value.may_be_left_out else f"{value.name} of a {value.kind}"
