"""The lights that a show can call, and the colours that may stand behind a head instead.

A light is declared here alone: `tools/messages.py` writes the values for the pages (`web/src/link/constants.ts`).
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

Triple = tuple[float, float, float]

BACKGROUNDS: Mapping[str, str] = {
    "green": "#00b140",
    "blue": "#0047bb",
    "black": "#000000",
    "grey": "#808080",
    "white": "#ffffff",
}
"""The backgrounds that have a name; green and blue are those of keyers."""


@dataclass(frozen=True)
class Lamp:
    """Light from one direction.

    direction: to the lamp, a vector of any length but zero, kept as a unit vector; colour: of its light, linear.
    """

    direction: Triple
    colour: Triple

    def __post_init__(self) -> None:
        object.__setattr__(self, "direction", _unit(self.direction))
        _check_colours(self.colour)


@dataclass(frozen=True)
class Rims:
    """Light along the edges of a head, from behind on either side; left and right as `Lamp.direction`, one colour."""

    left: Triple
    right: Triple
    colour: Triple

    def __post_init__(self) -> None:
        object.__setattr__(self, "left", _unit(self.left))
        object.__setattr__(self, "right", _unit(self.right))
        _check_colours(self.colour)


@dataclass(frozen=True)
class Backdrop:
    """The stage behind a head: linear colours at the edge of the picture and around the head."""

    edge: Triple
    glow: Triple

    def __post_init__(self) -> None:
        _check_colours(self.edge, self.glow)


@dataclass(frozen=True)
class Light:
    """The light of a stage; colours are linear, (r, g, b), of any brightness.

    label: on the console; sky and ground: what comes from everywhere above and below; size: the key's apparent radius,
    radians: how soft its shadows are; shade: how much shadows and hollows count, 0 to 1; exposure: what all light is
    multiplied with before the tone curve.
    """

    label: str
    key: Lamp
    fill: Lamp
    rims: Rims
    sky: Triple
    ground: Triple
    size: float
    shade: float
    exposure: float
    backdrop: Backdrop

    def __post_init__(self) -> None:
        _check_colours(self.sky, self.ground)
        if not (0.0 < self.size < math.pi / 2 and 0.0 <= self.shade <= 1.0 and 0.0 < self.exposure < math.inf):
            raise ValueError(
                f"the light {self.label!r} has size {self.size}, shade {self.shade}, exposure {self.exposure}; "
                "give a size in radians below a quarter turn, a shade from 0 to 1, an exposure above 0"
            )


def _unit(direction: Triple) -> Triple:
    length = math.hypot(*direction)
    if not (len(direction) == 3 and 0.0 < length < math.inf):
        raise ValueError(f"the direction of a lamp is {direction}; give three finite numbers, not all 0")
    x, y, z = direction
    return x / length, y / length, z / length


def _check_colours(*colours: Triple) -> None:
    for colour in colours:
        if len(colour) != 3 or not all(0.0 <= part < math.inf for part in colour):
            raise ValueError(f"the colour of a light is {colour}; give three finite numbers from 0 on, linear light")


def linear_colour(text: str) -> Triple:
    """A colour of the display, `#rrggbb` in sRGB, in linear light, 0 to 1."""
    red, green, blue = (int(text[at : at + 2], 16) / 255.0 for at in (1, 3, 5))
    return _linear(red), _linear(green), _linear(blue)


def _linear(code: float) -> float:
    return code / 12.92 if code <= 0.04045 else float(((code + 0.055) / 1.055) ** 2.4)


_KEYED = linear_colour(BACKGROUNDS["green"])

LIGHTS: Mapping[str, Light] = {
    # A hard warm lamp from above left, strong light from behind, a dark house.
    "theatre": Light(
        label="Theatre",
        key=Lamp((-0.64, 0.68, 0.64), (2.05, 1.74, 1.46)),
        fill=Lamp((0.85, 0.0, 0.5), (0.16, 0.17, 0.22)),
        rims=Rims((-0.9, 0.25, -0.45), (0.9, 0.35, -0.5), (1.0, 1.08, 1.3)),
        sky=(0.085, 0.082, 0.095),
        ground=(0.055, 0.04, 0.037),
        size=0.12,
        shade=1.0,
        exposure=1.0,
        backdrop=Backdrop((0.0016, 0.0016, 0.002), (0.0105, 0.0094, 0.0118)),
    ),
    # A large soft lamp beside the camera, gentle fill, a calm grey wall.
    "portrait": Light(
        label="Portrait",
        key=Lamp((-0.5, 0.48, 0.8), (1.38, 1.3, 1.22)),
        fill=Lamp((0.8, 0.1, 0.6), (0.32, 0.31, 0.32)),
        rims=Rims((-0.9, 0.35, -0.45), (0.9, 0.45, -0.5), (0.42, 0.44, 0.5)),
        sky=(0.19, 0.19, 0.195),
        ground=(0.12, 0.105, 0.098),
        size=0.3,
        shade=1.0,
        exposure=1.0,
        backdrop=Backdrop((0.022, 0.024, 0.028), (0.115, 0.118, 0.124)),
    ),
    # Nearly the same from everywhere, with just enough from ahead for eyes to shine and a mouth to read, before a green
    # that a keyer takes out.
    "flat": Light(
        label="Flat (keying)",
        key=Lamp((-0.1, 0.3, 0.95), (0.55, 0.53, 0.51)),
        fill=Lamp((0.6, 0.1, 0.8), (0.0, 0.0, 0.0)),
        rims=Rims((-0.9, 0.25, -0.45), (0.9, 0.35, -0.5), (0.0, 0.0, 0.0)),
        sky=(0.82, 0.8, 0.78),
        ground=(0.8, 0.76, 0.73),
        size=0.3,
        shade=0.35,
        exposure=1.0,
        backdrop=Backdrop(_KEYED, _KEYED),
    ),
}
"""The lights in the order of the console."""
FIRST_LIGHT = next(iter(LIGHTS))
"""What a show begins with."""


def check_light(name: str) -> str:
    """Returns the name of a light; ValueError that lists all of them for an unknown one."""
    if name not in LIGHTS:
        raise ValueError(f"there is no light {name!r}; choose one of {', '.join(LIGHTS)}")
    return name


def find_background(text: str) -> str:
    """The colour of a background, `#rrggbb`, from that or from its name; ValueError for anything else."""
    word = text.strip().lower()
    if re.fullmatch("#?[0-9a-f]{6}", word):
        return f"#{word.removeprefix('#')}"
    if word in BACKGROUNDS:
        return BACKGROUNDS[word]
    near = difflib.get_close_matches(word, BACKGROUNDS, n=1)
    meant = f"did you mean {near[0]}? It is {BACKGROUNDS[near[0]]}" if near else f"give {', '.join(BACKGROUNDS)}"
    raise ValueError(f"the background {text!r} is no colour; {meant}; or write #rrggbb, as in #00b140")
