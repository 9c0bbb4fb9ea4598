"""Who drives which part of a layer: several sources share one, each in the parts where it may play."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.frame import with_fields
from omote.perform.layers.columns import Columns
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE, LayerName, LayerPart
from omote.perform.layers.source_frame import AUTOMATIC, CLIP, LOSS_SECONDS, SPEECH, SourceFrame

Owners = tuple[str | None, ...]
"""Of each part, and of what acts on the whole face, the name of a source; None where none plays."""
NOBODY: Owners = (None,) * (WHOLE + 1)
STEADY_SECONDS = 0.5
"""Of frames without a gap, after which a source is followed as fast as its layer is."""
GAP_SECONDS = 0.08
LIPS_GAP_SECONDS = 0.06
"""Of silence, after which it counts as less and less steady: what comes then may be a jump. Lips are followed
soonest; thirty frames a second have no gap."""
UNSTEADY_SECONDS = 0.1
"""In which a source that is silent for longer is no longer steady at all: at once, what follows it would brake
in a step."""
GONE_SECONDS = 0.25
"""Of silence, after which a source may come back elsewhere; ten frames a second, and a frame that is lost, have no such
gap. One that says that it does not see its performer may do so after any time."""
BACK_ACCELERATION = 12.0
"""1/s^2: the largest of a weight on its way to where a source is that came back elsewhere: .2 a second in a tick."""
LONGEST_WAY_BACK = 2.0
"""Seconds; from one end of a weight to the other it takes .98."""
_QUINTIC = 10.0 / math.sqrt(3.0)
"""The largest acceleration of the quintic over a way of 1 in a second."""
_EASING = EASINGS[DEFAULT_EASING]


@dataclass(frozen=True)
class Driver:
    """What drives a layer: a source with its channels. silent: seconds since it was last found, no more than count.

    leaves: it has gone. steady: seconds since its frames come without a gap, no more than count. lost: it has said that
    it does not see its performer. way, away: seconds of its way back from where it was seen last, and what is left of
    them. share: how much of its layer it takes. route_number: of two that may play the same parts, the higher one has
    them. part_shares: as of a frame.
    """

    source: str
    names: tuple[str, ...]
    head: bool = False
    gaze: bool = False
    parts: tuple[LayerPart, ...] = LAYER_PARTS
    silent: float = 0.0
    leaves: bool = False
    smoothing: float = 0.0
    steady: float = 0.0
    share: float = 1.0
    route_number: int = 0
    part_shares: tuple[float, ...] = ()
    lost: bool = False
    way: float = 0.0
    away: float = 0.0

    @property
    def may_be_elsewhere(self) -> bool:
        """Whether its next frame may be far from its last."""
        return self.lost or self.silent >= GONE_SECONDS

    @property
    def way_left(self) -> float:
        """How much of its way back is left, 1 to 0: no jump of speed at either end."""
        return _EASING.value(self.away / self.way) if 0.0 < self.away <= self.way else 0.0

    @property
    def is_trusted(self) -> bool:
        """Whether its layer goes to where it can be seen."""
        return self.silent < LOSS_SECONDS and not self.leaves


def driver_of(frame: SourceFrame) -> Driver:
    """What drives a layer by such frames."""
    return Driver(
        frame.source, frame.names, frame.head is not None, frame.gaze is not None, frame.parts,
        smoothing=frame.smoothing, share=frame.share, route_number=frame.route_number, part_shares=frame.part_shares,
    )  # fmt: skip


def find_driver(drivers: Sequence[Driver], source: str) -> Driver | None:
    """The driver of a source, None where it drives none of these. drivers: those of the layer."""
    return next((driver for driver in drivers if driver.source == source), None)


def way_back(distance: float) -> float:
    """Seconds in which a weight goes a distance from rest to rest."""
    return min(math.sqrt(_QUINTIC * distance / BACK_ACCELERATION), LONGEST_WAY_BACK)


def fits(driver: Driver, frame: SourceFrame) -> bool:
    """Whether a frame comes from what drives the layer already, with the same channels for the same parts.

    driver: the one that is meant.
    """
    same = frame.names is driver.names or frame.names == driver.names
    turns = (frame.head is not None, frame.gaze is not None) == (driver.head, driver.gaze)
    route = (frame.source, frame.parts, frame.route_number) == (driver.source, driver.parts, driver.route_number)
    return same and (turns or not frame.found) and route


def parts_of(driver: Driver, columns: Columns) -> tuple[LayerPart, ...]:
    """The parts of the face that it plays: those where its channels act, as far as it may; one that plays expressions
    too plays every region.

    driver: the one that is meant; columns: those of the character's layers.
    """
    places = {int(place) for place in columns.parts[columns.places(driver.names)]}
    if WHOLE in places or driver.part_shares:
        places |= set(range(4))
    plays = {part for place, part in enumerate(LAYER_PARTS) if place in places}
    plays |= {"head"} if driver.head else set()
    plays |= {"gaze"} if driver.gaze else set()
    return tuple(part for part in driver.parts if part in plays)


def owners_of(drivers: Sequence[Driver], columns: Columns) -> Owners:
    """Who has each part of a layer: of those that play it and are not lost, the one that may play the fewest parts, of
    equals what the character says, else the one that was routed last, else the newest. What acts on the whole face is
    of the one that has the most regions.

    drivers: those of the layer; columns: those of the character's layers.
    """
    owners = list(NOBODY)
    ranked = sorted((driver for driver in drivers if driver.is_trusted), key=_rank)
    for driver in ranked:
        for part in parts_of(driver, columns):
            owners[LAYER_PARTS.index(part)] = driver.source
    regions = owners[:4]
    whole = [driver.source for driver in ranked if WHOLE in columns.parts[columns.places(driver.names)]]
    owners[WHOLE] = max((source for source in reversed(whole) if source in regions), key=regions.count, default=None)
    return tuple(owners)


def _rank(driver: Driver) -> tuple[int, bool, int]:
    """The higher it is, the more it has."""
    return -len(driver.parts), driver.source == SPEECH, driver.route_number


def with_driver(drivers: Sequence[Driver], driver: Driver) -> tuple[Driver, ...]:
    """The drivers with one more, the newest last; one of the same source and parts keeps its place. A character's own
    motion makes way for any other.

    driver: the one that is meant.
    """
    others = [other for other in drivers if other.source != AUTOMATIC or driver.source == AUTOMATIC]
    before = find_driver(others, driver.source)
    if before is not None and before.parts == driver.parts and not before.leaves:
        return tuple(driver if other is before else other for other in others)
    return (*(other for other in others if other is not before), driver)


def replace_driver(drivers: Sequence[Driver], driver: Driver) -> tuple[Driver, ...]:
    """The drivers with another state of one of them. driver: the one that is meant."""
    return tuple(driver if other.source == driver.source else other for other in drivers)


def advance_driver(driver: Driver, dt: float, layer: LayerName) -> Driver:
    """A driver of a layer `dt` seconds later; a clip is never lost, for it says when it is over."""
    silent = 0.0 if driver.source == CLIP else min(driver.silent + dt, LOSS_SECONDS)
    gap = LIPS_GAP_SECONDS if layer == "lips" else GAP_SECONDS
    change = dt if silent < gap else -dt * STEADY_SECONDS / UNSTEADY_SECONDS
    steady = min(max(driver.steady + change, 0.0), STEADY_SECONDS)
    return with_fields(driver, silent=silent, steady=steady, away=max(driver.away - dt, 0.0))
