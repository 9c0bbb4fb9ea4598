"""The layers of a character, lowest first; how each adds to those below it; the parts that an influence is of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Literal, get_args

from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.limits import check_known, check_switch, check_within

LayerName = Literal["breath", "gaze", "emotion", "blink", "tracker", "lips", "playback", "hands"]
LAYERS: tuple[LayerName, ...] = get_args(LayerName)
"""Lowest first: what is above replaces what is below."""
LayerPart = Literal["brows", "eyes", "mouth", "rest", "head", "gaze"]
LAYER_PARTS: tuple[LayerPart, ...] = get_args(LayerPart)
"""What an influence is of: the four play regions, how the head turns and how the eyes turn."""
RoutePart = Literal[LayerPart, "body"]
ROUTE_PARTS: tuple[RoutePart, ...] = (*LAYER_PARTS, "body")
"""What a source can play: those, and the body of its performer, which no layer has numbers of."""
DRIVEN: tuple[LayerName, ...] = ("breath", "gaze", "blink", "tracker", "lips", "playback")
"""The layers that sources drive; emotion is the mix of called expressions, hands are faders and pads."""
Rule = Literal["offset", "replace", "fill"]
_RULES: dict[LayerName, Rule] = {
    "breath": "offset", "gaze": "replace", "blink": "fill", "tracker": "replace", "lips": "replace",
    "playback": "replace",
}  # fmt: skip
RULES: Mapping[LayerName, Rule] = MappingProxyType(_RULES)
"""How a driven layer adds: an offset of at most `MOST_OFFSET` is added, a fill closes what is still open, and what
replaces takes the place of the layers below, by its influence."""
RANGES: Mapping[Rule, tuple[float, float]] = MappingProxyType({"offset": (-0.05, 0.05), "fill": (0.0, 1.0)})
"""The weights that layers of a rule take; those that replace take what a channel takes."""
WHOLE = len(LAYER_PARTS)
"""The place, after those of the parts, of what acts on the whole face: the mean of the four regions."""
_LIPS: Mapping[LayerPart, float] = MappingProxyType(dict.fromkeys(LAYER_PARTS, 0.0) | {"mouth": 0.7})


def check_layer(name: object) -> LayerName:
    """The layer of this name; ValueError where there is none."""
    return check_known(name, LAYERS, "layer")


def check_driven(name: object) -> LayerName:
    """The layer of this name that a source can drive; ValueError where there is none."""
    for layer in DRIVEN:
        if layer == name:
            return layer
    raise ValueError(f"there is no layer for a source {str(name)[:80]!r}; expected one of {', '.join(DRIVEN)}")


def check_part(name: object) -> LayerPart:
    """The part of this name; ValueError where there is none."""
    return check_known(name, LAYER_PARTS, "region of a layer")


@dataclass(frozen=True)
class LayerSetting:
    """What an operator has chosen for a layer: its influence on each part, 0 to 1, and whether it is on."""

    influence: Mapping[LayerPart, float] = field(default_factory=lambda: dict.fromkeys(LAYER_PARTS, 1.0))
    on: bool = True

    def __post_init__(self) -> None:
        """Rejects parts that there are not, and influences out of range."""
        influence = {check_part(part): value for part, value in self.influence.items()}
        if set(influence) != set(LAYER_PARTS):
            raise ValueError(
                f"the influence of a layer is of {', '.join(influence)}; expected {', '.join(LAYER_PARTS)}"
            )
        checked = {part: check_within(influence[part], 0.0, 1.0, f"the influence on {part}") for part in LAYER_PARTS}
        object.__setattr__(self, "influence", checked)

    @cached_property
    def by_part(self) -> tuple[float, ...]:
        """The influences in the order of `LAYER_PARTS`."""
        return tuple(self.influence[part] for part in LAYER_PARTS)

    @property
    def plays(self) -> bool:
        """Whether anything of it shows at all."""
        return self.on and any(self.influence.values())

    def change(self, part: LayerPart | None, influence: float | None, on: bool | None) -> LayerSetting:
        """The same with another influence on a part, on all parts where that is None; switched where `on` is given."""
        later = self if on is None else replace(self, on=check_switch(on, "the switch of a layer"))
        if influence is None:
            return later
        value = check_within(influence, 0.0, 1.0, "the influence of a layer")
        if part is not None:
            return replace(later, influence={**self.influence, part: value})
        return replace(later, influence=dict.fromkeys(LAYER_PARTS, value))


DEFAULT_SETTINGS: Mapping[LayerName, LayerSetting] = MappingProxyType(
    {layer: LayerSetting(_LIPS) if layer == "lips" else LayerSetting() for layer in LAYERS}
)
"""All layers on, lips by 0.7 on the mouth, so that a smile survives speech."""

_TITLES: Mapping[str, PlayRegion] = MappingProxyType(
    {
        "brows": "brows",
        "eyes": "eyes",
        "mouth": "mouth",
        "jaw": "mouth",
        "cheeks": "mouth",
        "tongue": "mouth",
        "nose": "rest",
        "ears": "rest",
    }
)


def part_of_channel(region: str) -> int:
    """The place of the part to which a channel belongs by the region of its title; `WHOLE` for one of the face."""
    part = _TITLES.get(region)
    return WHOLE if part is None else PLAY_REGIONS.index(part)
