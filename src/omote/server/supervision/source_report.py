"""Says on the terminal which performers play whom: as they come, and by each other route; those without too."""

from __future__ import annotations

from collections.abc import Callable

from omote.perform.scene.character_names import ALL
from omote.server.devices.device_source import DeviceSource
from omote.show.objects.sources import SourceState
from omote.show.objects.state import State
from omote.show.session import ShowSession

LOOK_SECONDS = 1.0
"""Between two looks: who comes and is routed at once is told once."""
TOLD_KINDS = "tracker", "lips"
"""Kinds of sources whose performers look for their face on the stage; a program knows whom it plays."""


class SourceReport(DeviceSource):
    """What sends of its own accord. session: the one that plays; report: prints a sentence."""

    def __init__(self, session: Callable[[], ShowSession], report: Callable[[str], None]) -> None:
        self._session = session
        self._report = report
        self._told: dict[str, frozenset[str]] = {}
        self._looked = -LOOK_SECONDS

    def tell(self, state: State, now: float) -> None:
        """Says what has changed since the last look. state: the newest; now: seconds, monotonic."""
        if now - self._looked < LOOK_SECONDS:
            return
        self._looked = now
        sources = [source for source in self._session().sources.states({}) if source.kind in TOLD_KINDS]
        labels = {name: character.label or name for name, character in state.characters.items()}
        for source in sources:
            if self._told.get(source.name) != frozenset(source.characters):
                self._report(_sentence(source, labels, _players(source, state)))
        self._told = {source.name: frozenset(source.characters) for source in sources}


def _players(source: SourceState, state: State) -> list[str]:
    """The other sources that have all parts which it may play, in all its characters; none where it plays itself."""
    layers = [state.characters[name].layers.get(source.layer) for name in source.characters if name in state.characters]
    sharing = [[] if layer is None else layer.sources for layer in layers]
    if not sharing or not all(
        any(player.source == source.name and not player.parts for player in players) for players in sharing
    ):
        return []
    return list(dict.fromkeys(player.source for players in sharing for player in players if player.parts))


def _sentence(source: SourceState, labels: dict[str, str], players: list[str]) -> str:
    """Whom a source plays, in words. players: those that it waits behind."""
    if ALL in source.characters:
        return f"{source.name} plays all characters."
    if not source.characters:
        whom = " or ".join(labels.values())
        return f"{source.name} sends and plays nobody: say at the console whom it plays ({whom})."
    played = " and ".join(labels.get(name, name) for name in source.characters)
    if players:
        return f"{source.name} waits: {' and '.join(players)} plays {played}; choose at the console who does."
    return f"{source.name} plays {played}."
