"""What consoles are told of mappings: all of them, whenever one has changed."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from omote.perform.mappings.mapping import CHANNEL, PAD, MacroMapping, TargetKind, axis_of_pad, places_in
from omote.perform.pads.blend_space import AXES
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Playable
from omote.show.objects.hand.macros import MappingList


class ToldMappings:
    """What consoles know of mappings. scene: on air now; cast: what plays."""

    def __init__(self, scene: Callable[[], Scene], cast: Callable[[], Playable]) -> None:
        self._scene = scene
        self._cast = cast
        self._seen: tuple[object, ...] = ()
        self._told = MappingList({})

    def news(self) -> MappingList | None:
        """What consoles were not told yet; None where they know all."""
        scene = self._scene()
        now = (self._cast().digest, scene.pads, *((name, scene[name].mappings) for name in scene))
        if now == self._seen:
            return None
        before = self._told
        self._seen = now
        self._told = self.list_now()
        return None if self._told == before else self._told

    def list_now(self) -> MappingList:
        """All mappings, and the targets of them that there are not."""
        scene = self._scene()
        mappings = {name: scene[name].mappings for name in scene if scene[name].mappings}
        missing = {name: self._missing(each) for name, each in mappings.items()}
        return MappingList(
            {name: [*each.values()] for name, each in mappings.items()},
            {name: targets for name, targets in missing.items() if targets},
        )

    def _missing(self, mappings: Mapping[str, MacroMapping]) -> list[str]:
        return [f"{kind}/{name}" for kind, name in places_in(mappings.values()) if not self._is_there(kind, name)]

    def _is_there(self, kind: TargetKind, name: str) -> bool:
        if kind == PAD:
            pad = self._scene().pads.get(axis_of_pad(name)[0])
            return pad is not None and axis_of_pad(name)[1] in AXES[: pad.dimensions]
        return kind != CHANNEL or name in self._cast().expressions
