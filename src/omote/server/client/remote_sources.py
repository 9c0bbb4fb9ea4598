"""Sources of a running show as a program routes, measures and tunes them: trackers, microphones, other programs."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable
from typing import Generic

from omote.perform.layers.layer_names import check_driven, check_part
from omote.perform.scene.character_names import ALL
from omote.server.client.remote_leases import Sent
from omote.show import messages as wire


class RemoteSources(Generic[Sent]):
    """Whom sources play and by what measure; by the names that the mixer shows."""

    send: Callable[[wire.FromClient], Sent]
    next_id: Callable[[], str]

    @abstractmethod
    def find_character(self, name: str) -> str:
        """The name of the character that a name or a label means."""

    def route_source(
        self, source: str, characters: Iterable[str], *, layer: str = "tracker", regions: Iterable[str] = ()
    ) -> Sent:
        """Lets a source play these characters, by name or label (`*`: all; none: nobody), on a layer, in these regions
        of the face (none: all). The show keeps it under the source's name, also of one that has not come yet. TypeError
        for a text instead of a list, ValueError for a character, a layer or a region that there is not."""
        if isinstance(characters, str) or isinstance(regions, str):
            raise TypeError("characters and regions are lists of names; give ['one'] for one")
        found = [each if each == ALL else self.find_character(each) for each in characters]
        parts = [check_part(each) for each in regions]
        return self.send(wire.RouteSource(self.next_id(), source, found, check_driven(layer), parts))

    def calibrate_source(self, source: str, step: wire.CalibrationStep, channels: Iterable[str] = ()) -> Sent:
        """Measures the performer before a source: `neutral` takes the face at rest, `range` listens to the largest
        moves of these channels (none: all) until `done`, `reset` forgets both. ValueError for a source that there is
        not, for a step without a frame, and for a channel that it does not send."""
        return self.send(wire.CalibrateSource(self.next_id(), source, step, list(channels)))

    def tune_source(
        self,
        source: str,
        *,
        mirror: bool = False,
        dead_zone: float = 0.0,
        curve: float = 0.0,
        gain: float = 1.0,
        smoothing: float = 0.0,
        lids: float = 1.0,
    ) -> Sent:
        """Sets how a source is read: left and right swapped; less than `dead_zone` (0 to 0.5) is nothing; `curve` -1 to
        1; `gain` 0 to 4, and `lids` beside it for those that shut the eyes; `smoothing` 0 to 2 seconds, 0 as usual.
        ValueError for a source that there is not and for numbers out of range."""
        return self.send(wire.TuneSource(self.next_id(), source, mirror, dead_zone, curve, gain, smoothing, lids))
