"""What consoles are told of the pads of a show, beside the states: they are many numbers that rarely change."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.pads.blend_space import Pad
from omote.perform.snapshot import Playable
from omote.show.objects.hand.pads import PadList, PadState

AGAIN_SECONDS = 0.1
"""Between two lists: a look that is dragged changes them with each frame of a page."""


def list_pads(pads: Mapping[str, Pad], cast: Playable) -> PadList:
    """The list of some pads. cast: what their looks may be of."""
    return PadList(
        [
            PadState(
                pad.name,
                pad.part,
                pad.dimensions,
                list(pad.looks),
                pad.lost(cast.faces if pad.part == "face" else cast.expressions),
            )
            for pad in pads.values()
        ]
    )


class PadListing:
    """What consoles were told of pads last, and when. pads, cast: those of the begin, which a welcome tells."""

    def __init__(self, pads: Mapping[str, Pad], cast: Playable) -> None:
        self._told = pads, cast
        self._told_at = -AGAIN_SECONDS

    def news(self, pads: Mapping[str, Pad], cast: Playable, now: float) -> PadList | None:
        """The list, where it is new. pads: of the scene; cast: that plays; now: seconds, monotonic."""
        if (self._told[0] is pads and self._told[1] is cast) or now - self._told_at < AGAIN_SECONDS:
            return None
        self._told = pads, cast
        self._told_at = now
        return list_pads(pads, cast)
