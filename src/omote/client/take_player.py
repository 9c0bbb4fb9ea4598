"""Plays a recording into a running show, frame by frame at its times."""

from __future__ import annotations

import time
from collections.abc import Callable

from omote.inputs.takes.take import Take

LONGEST_STEP = 1.0 / 60.0
"""Seconds between two frames that are sent at least: a show has sixty ticks a second."""


def play_take(
    take: Take,
    drive: Callable[..., object],
    *,
    layer: str = "playback",
    start: float = 0.0,
    speed: float = 1.0,
    clock: Callable[[], float] = time.monotonic,
    sleep: Callable[[float], None] = time.sleep,
) -> int:
    """Plays a recording once, to its end; returns how many frames were sent. drive: of a character of a running show;
    start: seconds from its beginning; speed: 1 is as it was recorded.

    A frame that is late is left out for the newer one; one that lasts is sent again, so that the layer does not count
    as lost. take: the recording; layer: the one that follows; clock: seconds; sleep: waits for some seconds.
    """
    begun = clock()
    sent = 0
    while True:
        now = start + speed * (clock() - begun)
        frame = take.frame_at(now)
        weights = dict(zip(take.names, take.values[frame], strict=True))
        drive(weights, layer=layer, head=take.head(frame), gaze=take.gaze(frame))
        sent += 1
        if now >= take.seconds:
            return sent
        sleep(LONGEST_STEP)
