"""What shapes of strangers' heads are called: by which units of the cast, and by which part of the face, each name is
found.

One table of all spellings: ARKit's, VRM's presets (1.0, 0.x and VRoid's), visemes of Oculus and VRChat, action units of
FACS and units of MakeHuman.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS, ARKIT_NAMES, plain_spelling
from omote.interchange.avatar.preset_expressions import EMOTIONS, UNITS, VOWELS
from omote.interchange.avatar.vrm0_extension import PRESETS as VRM0
from omote.model.action_units import MAKEHUMAN, find_units
from omote.perform.speech.visemes import VISEMES

GAZE = "gaze"
LIDS = "lids"
BROWS = "brows"
LIPS = "lips"
JAW = "jaw"
TONGUE = "tongue"
WHOLE = "face"
_PARTS = {
    "eyeLook": GAZE, "eyebrows": BROWS, "eye": LIDS, "brow": BROWS, "jaw": JAW, "mouth-open": JAW, "mouth": LIPS,
    "cheek": "cheeks", "nose": "nose", "tongue": TONGUE, "neck": "neck",
}  # fmt: skip
"""Which part of the face a unit moves, by how its name begins; the first that fits."""
_BEFORE = re.compile(r"^(?:.*fcl_(?:all|mth|eye|brw|ha)_|vrc[._]v_|viseme[_-]|v_)", re.IGNORECASE)
"""What VRoid, VRChat and Oculus write before a name."""
_VISEME = re.compile(r"(?:^|[._])(?:viseme|v)[_-]([a-z]+)$", re.IGNORECASE)
_CODES = re.compile(r"(?:au)?[ _-]?[lrtb]?[ _-]?\d{1,2}[ _-]?(?:[lrtb]|left|right)?", re.IGNORECASE)
"""A FACS code; several are joined by +."""


class ShapeMeaning(NamedTuple):
    """What a name means: units of the cast that move so, else the name of a viseme or an expression of the cast; the
    part of the face. All empty where nothing is known of it."""

    units: tuple[str, ...] = ()
    named: str = ""
    part: str = ""

    @property
    def tags(self) -> tuple[str, ...]:
        """Words to find the shape by."""
        return tuple(word for word in (*self.units, self.named, self.part) if word)

    @property
    def is_gaze(self) -> bool:
        """Whether eyes turn by it."""
        return self.part == GAZE


def read_shape_name(name: str, /) -> ShapeMeaning:
    """What a shape of that name does; nothing is guessed of other names."""
    if match := _VISEME.search(name):
        return _read_viseme(match[1])
    bare = _BEFORE.sub("", name.rpartition(".")[2].strip())
    spelling = plain_spelling(bare)
    if spelling in _KNOWN:
        return _KNOWN[spelling]
    units = (
        ARKIT_CHANNELS.find(bare) or _other_sides(spelling) or _MAKEHUMAN.get(_letters(bare), ()) or _read_codes(bare)
    )
    return ShapeMeaning(units, part=_part_of(units)) if units else ShapeMeaning()


def _read_viseme(spelling: str) -> ShapeMeaning:
    small = {viseme_name.lower(): viseme_name for viseme_name in VISEMES} | VOWELS
    viseme = small.get(spelling.lower(), "")
    return ShapeMeaning(named=viseme, part=LIPS) if viseme else ShapeMeaning()


def _other_sides(spelling: str) -> tuple[str, ...]:
    """The halves of a unit that is named as a whole (mouthSmile), or the whole of one that is named by half."""
    halves = [unit for side in ("left", "right") for unit in ARKIT_CHANNELS.find(spelling + side)]
    return tuple(halves) or ARKIT_CHANNELS.find(spelling.removesuffix("left").removesuffix("right"))


def _read_codes(typed: str) -> tuple[str, ...]:
    """The units that action units joined by + are; none where one of them is unknown."""
    codes = typed.split("+")
    if not re.match(r"au", typed, re.IGNORECASE) or not all(_CODES.fullmatch(code.strip()) for code in codes):
        return find_units(typed, _CHANNELS) if re.fullmatch(r"[lr]\d{1,2}|[a-z _-]{8,}", typed, re.IGNORECASE) else ()
    plain = (re.sub(r"left$", "l", re.sub(r"right$", "r", code.strip().lower())) for code in codes)
    units_of_codes = [find_units(code if code.startswith("au") else f"au{code}", _CHANNELS) for code in plain]
    return tuple(dict.fromkeys(unit for units in units_of_codes for unit in units)) if all(units_of_codes) else ()


def _part_of(units: Iterable[str]) -> str:
    """The part that all units move, or the whole face."""
    parts = {next((part for start, part in _PARTS.items() if unit.startswith(start)), WHOLE) for unit in units}
    return parts.pop() if len(parts) == 1 else WHOLE


def _letters(name: str) -> str:
    return re.sub(r"[^a-z]", "", name.lower())


def _makehuman() -> dict[str, tuple[str, ...]]:
    """The units of MakeHuman by their letters; those with sides by both and by either."""
    units_of: dict[str, tuple[str, ...]] = {}
    for name in MAKEHUMAN:
        first, _, rest = name.partition("-")
        sides = tuple(f"{first}-{side}-{rest}" for side in ("left", "right"))
        sided = first.startswith("eye") or name in ("nose-dilatation", "nose-elevation")
        units_of[_letters(name)] = sides if sided else (name,)
        units_of |= {_letters(side): (side,) for side in sides if sided}
    return units_of


def _presets() -> dict[str, ShapeMeaning]:
    """VRM's presets by their spellings in 1.0 and in 0.x."""
    presets = {preset: ShapeMeaning(named=name, part=WHOLE) for preset, name in EMOTIONS.items()}
    presets |= {preset: ShapeMeaning(named=viseme, part=LIPS) for preset, viseme in VOWELS.items()}
    presets |= {preset: ShapeMeaning(units, part=_part_of(units)) for preset, units in UNITS.items() if units}
    spelled = {plain_spelling(preset): meaning for preset, meaning in presets.items()}
    spelled |= {plain_spelling(VRM0[preset]): meaning for preset, meaning in presets.items() if preset in VRM0}
    close = {f"close{side}": presets[f"blink{side.capitalize()}"] for side in ("", "left", "right")}
    named = {name: presets[preset] for preset, name in EMOTIONS.items()}
    return named | spelled | close | {"eyesclosed": presets["blink"]}


_MAKEHUMAN: Mapping[str, tuple[str, ...]] = MappingProxyType(_makehuman())
_KNOWN: Mapping[str, ShapeMeaning] = MappingProxyType(_presets())
_CHANNELS = (*ARKIT_NAMES, *dict.fromkeys(unit for units in _MAKEHUMAN.values() for unit in units))
