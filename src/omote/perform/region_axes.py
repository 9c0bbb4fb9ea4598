"""The axes of regions: an expression can be called in one region of the face alone, in its own time.

A region that has been called alone has an axis of its own, begun from what it showed with the whole face; a call of the
whole face calls it too, and where it shows again what the face does it goes with the face.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from omote.model.known_names import PlayRegion
from omote.perform import axis
from omote.perform.axis import Axis

RegionAxes = Mapping[PlayRegion, Axis]


def call_regions(regions: RegionAxes, face: Axis, call: Callable[[Axis], Axis]) -> dict[PlayRegion, Axis]:
    """All regions that go their own way, called with the whole face, whose T-bar they then have."""
    return {region: call(replace(on, hand=face.hand)) for region, on in regions.items()}


def move_with_face(regions: RegionAxes, face: Axis, move: Callable[[Axis], Axis]) -> dict[PlayRegion, Axis]:
    """The regions after the T-bar of the whole face has moved: it moves those whose call is the face's too, and passes
    the others by."""
    return {region: move(on) if _is_called_with(face, on) else on for region, on in regions.items()}


def _is_called_with(face: Axis, on: Axis) -> bool:
    if face.call is None or on.call is None:
        return False
    mine, own = face.call, on.call
    return (mine.target, mine.seconds, mine.elapsed, mine.easing) == (own.target, own.seconds, own.elapsed, own.easing)


def advance_regions(regions: RegionAxes, face: Axis, dt: float) -> dict[PlayRegion, Axis]:
    """The regions `dt` seconds later, without those that have come to show what the whole face does; face: its axis,
    advanced already."""
    later = {region: axis.advanced(on, dt) for region, on in regions.items()}
    return {region: on for region, on in later.items() if not _shows_the_same(on, face)}


def _shows_the_same(on: Axis, face: Axis) -> bool:
    return on.call is None and face.call is None and axis.weights(on) == axis.weights(face)
