"""What stays with the show when its sources have gone: whom they drive, and their performers' measures; who was told
what is on air."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

import msgspec

from omote.perform.layers.layer_names import LAYER_PARTS, LayerName, LayerPart, RoutePart
from omote.show.sources.calibration import Calibration

MOST_REMEMBERED = 64
"""Routes and measures; the oldest goes."""


@dataclass(frozen=True)
class Route:
    """Which characters a source drives, on which layer, in which parts of the face. number: of two that play the same,
    the one with the higher number has it; it was routed later. waits: it plays nobody because another did when it came;
    nobody has said so. body: whether its performer's body plays."""

    characters: tuple[str, ...] = ()
    layer: LayerName = "tracker"
    parts: tuple[LayerPart, ...] = LAYER_PARTS
    number: int = 0
    waits: bool = False
    body: bool = True

    @property
    def regions(self) -> list[RoutePart]:
        """All that it plays."""
        return [*self.parts, "body"] if self.body else [*self.parts]


@dataclass(frozen=True)
class SourcesSnapshot:
    """Routes by the names of sources, measures by the names of performers: plain values."""

    routes: Mapping[str, Route] = field(default_factory=dict)
    calibrations: Mapping[str, Calibration] = field(default_factory=dict)


@dataclass(frozen=True)
class SurfaceSubscription:
    """A surface that asked to be told what is on air: where it hears, and when it was heard last, by the clock of this
    start of the machine (seconds)."""

    host: str
    port: Annotated[int, msgspec.Meta(ge=1, le=65535)]
    heard: float
