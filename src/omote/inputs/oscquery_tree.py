"""All addresses of OSC as a tree that control surfaces read (OSCQuery), from the table that the parser uses."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from typing import Any, Literal

from omote.inputs.osc_addresses import ADDRESSES, Address, fill_places
from omote.inputs.osc_feedback import REST, AddressValues
from omote.inputs.osc_orders import Names
from omote.model.body.pose_regions import POSE_REGIONS
from omote.model.known_names import NEUTRAL, PLAY_REGIONS
from omote.perform.complexion import SKIN_FADERS
from omote.perform.figures.pose_mix import IDLE_POSES
from omote.perform.gestures import GESTURES
from omote.perform.layers.layer_names import LAYER_PARTS, LAYERS
from omote.perform.lights import LIGHTS
from omote.perform.scene.character_names import ALL
from omote.perform.scene.framings import SHOT_SIZES
from omote.perform.snapshot import Playable
from omote.perform.speech.spelling import LANGUAGES
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.show.osc import ROOT, Value
from omote.show.ownership.parts import CHARACTER_PARTS, SCENE_PARTS, WORD_FOR_ALL

Node = dict[str, Any]
"""A node as JSON has it: `FULL_PATH`, and what the proposal calls attributes."""

NO_ACCESS = 0
WRITE = 2
READ_WRITE = 3
TYPES = {"number": "f", "time": "f", "switch": "T", "press": "I"}
"""The type tag of a value by its kind; names are texts."""
UNITS = {"degrees": "angle.degree"}
"""The proposal's names of units."""
ATTRIBUTES = ("FULL_PATH", "CONTENTS", "TYPE", "ACCESS", "RANGE", "VALUE", "DESCRIPTION", "UNIT")
"""What can be asked for by itself; every node has the first and ACCESS."""
HOST_INFO = "HOST_INFO"
NO_PADS: Mapping[str, int] = {}
NO_MACROS: Mapping[str, Sequence[str]] = {}
Transport = Literal["UDP", "TCP"]


def host_info(name: str, port: int, transport: Transport = "UDP") -> dict[str, Any]:
    """What a surface is told of this host: its name, and the port at which it hears OSC.

    transport: how it comes there.
    """
    optional = ("ACCESS", "VALUE", "RANGE", "DESCRIPTION", "UNIT")
    absent = ("LISTEN", "PATH_CHANGED", "CLIPMODE", "TAGS", "CRITICAL", "OVERLOADS", "HTML")
    extensions = {**dict.fromkeys(optional, True), **dict.fromkeys(absent, False)}
    return {"NAME": name, "OSC_PORT": port, "OSC_TRANSPORT": transport, "EXTENSIONS": extensions}


def build_addresses(
    cast: Playable,
    characters: Iterable[str],
    pads: Mapping[str, int] = NO_PADS,
    macros: Mapping[str, Sequence[str]] = NO_MACROS,
) -> Node:
    """The tree of all addresses without values: the same as long as cast, characters, pads and macros are.

    pads: the dimensions of each, by name; macros: the names of those of each character.
    """
    root = _container("/")
    names = Names(cast, {name: name for name in characters}, pads, macros)
    for address in ADDRESSES:
        for owner in [""] if address.of_show else names.characters:
            for path in _paths(address, owner, names):
                _insert(root, path, _leaf(address, path, names))
            place = _own_path(address, owner).partition("/{")[0]
            if find_node(root, place) is None:  # names that no cast has stand in it: a surface sees where they would be
                _insert(root, place, _container(place))
    return root


def with_values(node: Node, on_air: AddressValues) -> Node:
    """A copy of a node and of all below it, with the values on air. on_air: the values of addresses."""
    copied = dict(node)
    if node["ACCESS"] == READ_WRITE:
        values = on_air.get(node["FULL_PATH"], REST)
        copied["VALUE"] = [value == 1.0 for value in values] if node["TYPE"] == TYPES["switch"] else list(values)
    if "CONTENTS" in node:
        copied["CONTENTS"] = {name: with_values(below, on_air) for name, below in node["CONTENTS"].items()}
    return copied


def find_node(root: Node, path: str) -> Node | None:
    """The node at a path; None where there is none. root: the whole tree."""
    node: Node | None = root
    for part in path.strip("/").split("/") if path.strip("/") else ():
        node = None if node is None else node.get("CONTENTS", {}).get(part)
    return node


def _paths(address: Address, owner: str, names: Names) -> list[str]:
    """The full paths of an address for a character; one for each name where a name stands in the path."""
    own = _own_path(address, owner)
    choices = product(*(_names(value, names, owner) for value in address.values[: own.count("{")]))
    return [fill_places(own, chosen) for chosen in choices]


def _own_path(address: Address, owner: str) -> str:
    return f"/{ROOT}/{owner}/{address.path}" if owner else f"/{ROOT}/{address.path}"


def _leaf(address: Address, path: str, names: Names) -> Node:
    """The node of an address: what it takes but for times behind others, which may be left out."""
    own = address.values[address.path.count("{") :]
    if any(value.optional for value in own):
        own = own[: names.pads[path.rpartition("/")[2]]]
    taken = [value for value in own if value.kind not in ("seconds", "time") and value.default is None] or list(own)
    press = all(value.kind in ("press", "time", "speech") for value in taken)
    more = " (seconds may follow)" if len(taken) < len(own) else ""
    node: Node = {
        "FULL_PATH": path,
        "TYPE": "".join(TYPES.get(value.kind, "s") for value in taken),
        "ACCESS": WRITE if press else READ_WRITE,
        "DESCRIPTION": address.tells + more,
    }
    if all(value.kind == "press" for value in taken):
        return node
    node["RANGE"] = [_range(value, names) for value in taken]
    if any(value.unit in UNITS for value in taken):
        node["UNIT"] = [UNITS.get(value.unit) for value in taken]
    return node


def _range(value: Value, names: Names) -> dict[str, Any] | None:
    """What a value may be; None for a text of any kind."""
    if value.kind in ("speech", "text", "cue"):
        return None
    if value.kind in ("number", "time"):
        return {"MIN": value.low, "MAX": value.high}
    return {"VALS": [False, True] if value.kind == "switch" else _names(value, names)}


def _names(value: Value, names: Names, owner: str = "") -> list[str]:
    """The names that a value can have. owner: the character in its address."""
    if value.kind == "character":
        return [*names.characters]
    if value.kind == "framing":
        return [ALL, *names.characters]
    if value.kind == "pad":
        return [*names.pads]
    if value.kind == "macro":
        return [*names.macros.get(owner, ())]
    if value.kind == "text":
        return []  # of any kind: no path can list them
    listed: dict[str, Sequence[str]] = {
        "language": LANGUAGES, "gesture": GESTURES, "region": PLAY_REGIONS, "layer": LAYERS, "part": LAYER_PARTS,
        "spring": SPRING_NAMES, "skin": SKIN_FADERS, "pose_region": POSE_REGIONS, "shot": SHOT_SIZES,
        "lease": (*CHARACTER_PARTS, WORD_FOR_ALL), "scene_lease": (*SCENE_PARTS, WORD_FOR_ALL),
    }  # fmt: skip
    if value.kind in listed:
        return [*listed[value.kind]]
    cast = names.cast
    choices: Mapping[str, Any] = {"face": cast.faces, "light": LIGHTS, "pose": cast.poses, "body": cast.bodies}.get(
        value.kind, cast.expressions
    )
    left_out = {"channel": (NEUTRAL,), "pose": IDLE_POSES}.get(value.kind, ())
    return [name for name in choices if name not in left_out]


def _container(path: str) -> Node:
    return {"FULL_PATH": path, "ACCESS": NO_ACCESS, "CONTENTS": {}}


def _insert(root: Node, path: str, leaf: Node) -> None:
    *above, last = path.strip("/").split("/")
    node = root
    for count, part in enumerate(above, 1):
        node = node.setdefault("CONTENTS", {}).setdefault(part, _container("/" + "/".join(above[:count])))
    below = _below(node, last)
    node.setdefault("CONTENTS", {})[last] = leaf | ({"CONTENTS": below} if below else {})


def _below(node: Node, name: str) -> Node | None:
    """What lies below a name already: an address may end where others go on (`fade`)."""
    below: Node | None = node.get("CONTENTS", {}).get(name, {}).get("CONTENTS")
    return below
