"""Writes which channel is which action unit of FACS, as Markdown and as CSV, from `omote.model.action_units`."""

from __future__ import annotations

from omote.builtin import load_cast
from omote.model.action_units import ACTION_UNITS, action_units, explain_action_unit, find_units
from omote.model.cast import Cast

HEAD = """# Action units

Written from `src/omote/model/action_units.py` by `tools/website/action_unit_reference.py`. The same as data:
[action-units.csv](action-units.csv), `omote.action_units("mouthSmileLeft")`, the key `facs` of `omote cast --json`,
and the array `facs` of `omote export FACE -o FACE.npz`.

FACS is Ekman and Friesen's Facial Action Coding System (2002). The units of the cast are named movements and no scores
of a coder: each row names the action units that the channel is nearest to by what it moves. `L` and `R` are the
character's left and right, `T` and `B` the upper and the lower lip; `1+2` is both together. A dash: FACS has no unit
for it. `eyeLookInLeft` turns the left eye towards the nose, which is to the right. Weights are no intensities A to E:
a weight of 1 is the unit as it was sculpted. `AU12C` is answered with that, and with 0.6, its place among A to E.

Wherever the name of an expression or a channel is typed, its unit finds it: `--channel AU12=0.5`, `--channel "lip
corner puller"`, `AU12L` or `L12` for the left half, `--expressions AU26`; a console finds it by *Search*.

Of the head, in degrees of `--turn` or radians of `Performer.set_head`: yaw + is AU 51 (left), yaw - AU 52, pitch + AU
53 (up), pitch - AU 54, roll + AU 55 (tilt left), roll - AU 56. Of the gaze (`--gaze`, `Performer.set_gaze`): yaw + is
AU 61, yaw - AU 62, pitch + AU 63, pitch - AU 64.
"""
KINDS = {"arkit": "ARKit's shapes", "makehuman": "MakeHuman's units"}


def action_unit_page() -> str:
    """The page: a table of each kind of unit."""
    cast = load_cast()
    return "\n".join([HEAD, _units(cast), *(_table(cast, kind) for kind in KINDS)])


def action_unit_table() -> str:
    """The data: a line for each unit."""
    cast = load_cast()
    lines = ["channel,kind,label,facs,names"]
    for name, title in cast.titles.items():
        if title.kind in KINDS:
            lines.append(f'{name},{title.kind},"{title.label}",{"+".join(action_units(name))},"{names_of(name)}"')
    return "\n".join(lines) + "\n"


def names_of(channel: str) -> str:
    """The names of a channel's action units."""
    return ", ".join(ACTION_UNITS[int(code.strip("LRTB"))] for code in action_units(channel))


def _units(cast: Cast) -> str:
    """What each unit finds where it is typed."""
    rows = []
    for number, name in ACTION_UNITS.items():
        found = ", ".join(f"`{each}`" for each in find_units(f"AU{number}", cast.titles))
        rows.append(f"| AU{number} | {name} | {found or explain_action_unit(f'AU{number}', cast.titles)} |")
    return "\n".join(["## What a unit finds\n", "| unit | its name | channels |", "|---|---|---|", *rows, ""])


def _table(cast: Cast, kind: str) -> str:
    rows = [
        f"| `{name}` | {title.label} | {'+'.join(action_units(name)) or '-'} | {names_of(name)} |"
        for name, title in cast.titles.items()
        if title.kind == kind
    ]
    return "\n".join(
        [f"## {KINDS[kind]}\n", "| channel | label | action units | their names |", "|---|---|---|---|", *rows, ""]
    )
