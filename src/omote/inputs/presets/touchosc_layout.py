"""A layout for TouchOSC, built from the addresses of a show: buttons call, faders and pads move and follow."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import py2tosc
from py2tosc import Control, ControlType, OscMessage, ui

from omote.inputs.oscquery_tree import NO_PADS, Node, build_addresses, find_node
from omote.perform.scene.character_names import ALL
from omote.perform.snapshot import Playable
from omote.show.osc import ROOT

FRAME = (0, 0, 1024, 768)
"""Points of the canvas; TouchOSC fits it to the screen."""
OF_CHARACTER = {
    "faces": ("face", "fade/face", "enter", "leave", "panic"),
    "expressions": ("expression", "fade/expression", "panic"),
    "poses": ("pose", "fade/pose", "body"),
    "head and gaze": ("head", "gaze"),
    "pads": ("pad",),
    "layers": ("layer",),
    "channels": ("channel",),
    "leases": ("lease", "take_over", "release_lease"),
}
"""The pages of a character: the addresses on each, below the character's own; a name with others below means these."""
OF_SHOW = ("light", "framing", "black", "panic", "lease", "take_over", "release_lease")
"""The addresses on the page of the whole show."""
LEASES = ("lease", "take_over", "release_lease")
MOST_ON_PAGE = 32
"""Controls that fingers find on a tablet's screen."""
FOLLOW_PORT = 9001
"""Where TouchOSC listens unless it is told otherwise in its connections."""
COLORS = {"s": "#3a6ea5", "f": "#4d8f5a", "ff": "#8a6bb0", "": "#b03a3a"}
"""By what a control sends: a name, a number, two of them, nothing."""
SPACE = 6


def build_touchosc_layout(cast: Playable, characters: Iterable[str], pads: Mapping[str, int] = NO_PADS) -> bytes:
    """The file of a layout (`.tosc`) that plays these characters with the names of a cast.

    pads: the dimensions of each, by name."""
    named = list(characters)
    named += [ALL] if len(named) > 1 else []
    tree = build_addresses(cast, named, pads)
    pages = [_character_page(tree, name) for name in named]
    document = py2tosc.Document(
        root=ui.stack(ui.pager(*pages, _show_page(tree), name="characters"), frame=FRAME, name="Omote")
    )
    document.resolve()
    return zlib.compress(document.dumps(validate=True).encode())


def _character_page(tree: Node, character: str) -> Control:
    """The page of a character, with a page for each group of its addresses."""
    pages = [
        _page(tree, [f"/{ROOT}/{character}/{path}" for path in paths], title) for title, paths in OF_CHARACTER.items()
    ]
    flat = [control for group in pages for control in group]
    return ui.stack(ui.pager(*flat, name=f"{character} pages"), name="all" if character == ALL else character)


def _show_page(tree: Node) -> Control:
    """The page of the whole show, with the button that lets the controls follow it."""
    follow = ui.osc(
        f"/{ROOT}/subscribe",
        args=[ui.const(str(FOLLOW_PORT), conversion="INTEGER")],
        on="RISE",
        receive=False,
    )
    controls = [_button("follow the show", follow, COLORS["ff"])]
    for path in OF_SHOW:
        controls += _controls(tree, f"/{ROOT}/{path}")
    return _tiles(controls, "show")


def _page(tree: Node, paths: Sequence[str], title: str) -> list[Control]:
    """One page of these addresses, or several where they are many."""
    controls = [control for path in paths for control in _controls(tree, path)]
    parts = [controls[start : start + MOST_ON_PAGE] for start in range(0, len(controls), MOST_ON_PAGE)]
    titles = [title] if len(parts) == 1 else [f"{title} {number}" for number in range(1, len(parts) + 1)]
    return [_tiles(part, name) for part, name in zip(parts, titles, strict=True)]


def _controls(tree: Node, path: str) -> Iterator[Control]:
    """The controls of an address: a button for each name that it takes or one to press, a fader, a pad; of a name
    without an address, those of all below it."""
    node = find_node(tree, path)
    if node is None or "TYPE" not in node:
        for below in () if node is None else node["CONTENTS"].values():
            yield from _controls(tree, below["FULL_PATH"])
    elif node["TYPE"] == "s":
        for name in node["RANGE"][0]["VALS"]:
            yield _button(name, _call(path, [ui.const(name)]), COLORS["s"])
    elif set(node["TYPE"]) == {"f"} and "RANGE" in node and path.rpartition("/")[2] not in ("enter", "leave"):
        yield _mover(path, node["RANGE"])
    else:
        yield _button(_press_name(path), _call(path, []), COLORS[""])


def _press_name(path: str) -> str:
    """What a button to press is called: `panic`, `take over face`."""
    *_, above, last = path.split("/")
    return f"{above} {last}".replace("_", " ") if above in LEASES else last


def _call(path: str, arguments: list[py2tosc.Partial]) -> OscMessage:
    """Sends when a button goes down, not when it is let go; takes nothing in, for names light no button."""
    return ui.osc(path, args=arguments, on="RISE", receive=False)


def _mover(path: str, ranges: Sequence[dict[str, Any]]) -> Control:
    """A fader of an address of one number; a pad of one of more, of which those behind the second stay at 0."""
    spans = [(value_range["MIN"], value_range["MAX"]) for value_range in ranges]
    values = [ui.value(key, scale=span) for key, span in zip(("x", "y"), spans, strict=False)]
    rest = [ui.const("0", conversion="FLOAT") for _ in spans[2:]]
    message = ui.osc(path, args=[*values, *rest], triggers=[py2tosc.Trigger(axis_value.value) for axis_value in values])
    name = path.rpartition("/")[2]
    starts = [_share(0.0, span) for span in spans[:2]]
    live = [py2tosc.Value(key, default=start) for key, start in zip(("x", "y"), starts, strict=False)]
    kind, color = (ControlType.FADER, COLORS["f"]) if len(spans) == 1 else (ControlType.XY, COLORS["ff"])
    control = Control(kind, name=name, color=color, messages=[message], values=[*live, py2tosc.Value()])
    return _captioned(control, name)


def _share(value: float, span: tuple[float, float]) -> float:
    """Where a value stands in its range, 0 to 1."""
    low, high = span
    return min(max((value - low) / (high - low), 0.0), 1.0)


def _button(name: str, message: OscMessage, color: str) -> Control:
    return _captioned(py2tosc.button(name=name, color=color, messages=[message]), name)


def _captioned(control: Control, name: str) -> Control:
    return ui.labelled(control, name, size=14, name=f"{name} captioned")


def _tiles(controls: Sequence[Control], name: str) -> Control:
    """A page: as many columns as make its controls about square."""
    columns = max(2, math.ceil(math.sqrt(len(controls) * 4 / 3)))
    return ui.tiles(*controls, columns=columns, gap=SPACE, pad=SPACE, name=name)
