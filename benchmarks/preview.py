"""What the preview costs a tick: four characters, two trackers, four consoles, with nobody in preview and with one.

Three shows play the same calls at the same instants, tick by tick and by turns: one whose preview was never needed, one
in whose preview somebody has built a look up and gone, one in whose preview somebody looks on. Timed is all that the
server does once a tick, both buses' states encoded and the journal's entry each second tick included. Times are of the
processor, of one thread.

* where nobody looks, the median: at most 1.25 of a show without a preview (issue 31);
* where somebody looks: at most 2.2;
* beside: bytes of both states and of the journal's entry.

`python -m benchmarks.preview [--seconds S]`.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import sys
import time

import numpy as np
from rich.console import Console

import omote
from benchmarks.four_characters import RATE, begin_show, drive, track, tracked_names
from omote.server.persistence.restore import journal_entry
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.link import Bus, Hello
from omote.show.wire import encode

CALL_FRAMES = 45
BARS = {"forgotten": 1.25, "looked at": 2.2}
"""Of a tick of a show without a preview, in the median (issue 31)."""


class Show:
    """One of the shows, and the processor seconds of its ticks. preview: whether a look was built up, and stays looked
    at."""

    def __init__(self, cast: omote.Cast, preview: str) -> None:
        self.session = begin_show(cast)
        self.characters = list(self.session.scene)
        if preview != "none":
            self.meet("eve", "preview")
            self.call("eve", 0, cast)
        if preview == "forgotten":
            self.session.leave("eve")
        self.preview = preview
        self.processor = list[float]()
        self.sizes = (0, 0, 0)

    def meet(self, who: str, bus: Bus) -> None:
        """A console comes."""
        self.session.receive(who, Hello("console", PROTOCOL_VERSION, who, bus=bus), 0.0)

    def call(self, who: str, frame: int, cast: omote.Cast) -> None:
        """A face and an expression for all, by a console."""
        rng = np.random.default_rng(frame)
        worn = [name for name, title in cast.titles.items() if title.kind == "performed"]
        now = frame / RATE
        for character in self.characters:
            face = str(rng.choice(list(cast.faces)))
            expression = str(rng.choice(worn))
            self.session.receive(who, CallFace(character, f"{who}f{frame}{character}", face, 2.0), now)
            self.session.receive(who, CallExpression(character, f"{who}e{frame}{character}", expression, 0.5), now)

    def play(self, frame: int, values: list[bytes]) -> None:
        """One tick, after what has come since the last. values: of the trackers."""
        now = frame / RATE
        drive(self.session, frame, values)
        begun = time.thread_time()
        state = encode(self.session.tick(now))
        unseen = self.session.preview_state
        other = b"" if unseen is None else encode(unseen)
        entry = journal_entry(self.session) if frame % 2 else None
        self.processor.append(time.thread_time() - begun)
        self.sizes = (len(state), len(other), self.sizes[2] if entry is None else len(entry.snapshot or b""))


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=30.0)
    seconds = parser.parse_args().seconds
    cast = omote.load_cast()
    channels = len(tracked_names(cast))
    shows = [Show(cast, preview) for preview in ("none", "forgotten", "looked at")]
    rng = np.random.default_rng(5)
    for frame in range(round(seconds * RATE)):
        tracked = track(frame, channels, rng)
        for turn in range(len(shows)):
            show = shows[(frame + turn) % len(shows)]
            if frame % CALL_FRAMES == 0:
                show.call("bo", frame, cast)
                if show.preview == "looked at":
                    show.call("eve", frame, cast)
            show.play(frame, tracked)
    console = Console()
    alone = float(np.median(shows[0].processor))
    missed = 0
    for show in shows:
        median, high = np.quantile(show.processor, [0.5, 0.99]) * 1e3
        share = median * 1e-3 / alone
        bar = BARS.get(show.preview, 1.0)
        missed += share > bar
        air, unseen, journal = show.sizes
        console.print(
            f"{'ok    ' if share <= bar else 'MISSED'} preview {show.preview:9} {median:.2f} ms, 99 % {high:.2f}; "
            f"{share:.2f} of {bar}; states {air} and {unseen}, journal {journal} bytes"
        )
    return min(missed, 1)


if __name__ == "__main__":
    sys.exit(main())
