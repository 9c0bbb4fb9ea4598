"""What cues, the recording and the preview cost a tick together: four characters, two trackers, four consoles.

Four nights of `cue_night` play the same calls at the same instants, tick by tick and by turns: one without any of the
three, one with cues that is recorded, one in whose preview somebody has built a look up and gone besides, and one in
whose preview somebody looks on and calls. Timed is all that the server does once a tick, both buses' states encoded and
the journal's entry each second tick included. Times are of the processor, of one thread.

* with cues and recording, and where nobody looks at the preview, the median: at most 1.25 of the first (issue 31);
* where somebody looks: at most 2.2;
* beside: bytes of both states.

`python -m benchmarks.preview [--seconds S]`.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from rich.console import Console

import omote
from benchmarks.cue_night import CUES, Night
from benchmarks.four_characters import RATE, track, tracked_names
from benchmarks.recording import RecordedNight
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.link import Hello
from omote.show.wire import encode

CALL_SECONDS = 6
BARS = {"cues, recorded": 1.25, "and a preview left": 1.25, "and one looked at": 2.2}
"""Of a tick of the same calls without cues, recording and preview, in the median (issue 31)."""


class PreviewNight(RecordedNight):
    """A recorded night with a look in its preview. looks: whether somebody looks at it still."""

    def __init__(self, cast: omote.Cast, path: Path, *, looks: bool) -> None:
        super().__init__(cast, path)
        self.cast = cast
        self.looks = looks
        self.session.receive("eve", Hello("console", PROTOCOL_VERSION, "eve", bus="preview"), 0.0)
        self.call(0)
        if not looks:
            self.session.leave("eve")
        self.unseen = b""

    def call(self, frame: int) -> None:
        """A face and an expression for all, in preview."""
        rng = np.random.default_rng(frame)
        worn = [name for name, title in self.cast.titles.items() if title.kind == "performed"]
        now = frame / RATE
        for character in self.characters:
            face = str(rng.choice(list(self.cast.faces)))
            expression = str(rng.choice(worn))
            self.session.receive("eve", CallFace(character, f"f{frame}{character}", face, 2.0), now)
            self.session.receive("eve", CallExpression(character, f"e{frame}{character}", expression, 0.5), now)

    def go(self, number: int, frame: int) -> None:
        """Plays a cue on air, and calls in preview where somebody looks."""
        super().go(number, frame)
        if self.looks:
            self.call(frame)

    def play(self, frame: int, values: list[bytes]) -> None:
        """One tick with the preview's state; the time of both counts."""
        super().play(frame, values)
        begun = time.thread_time()
        unseen = self.session.preview_state
        self.unseen = b"" if unseen is None else encode(unseen)
        self.processor[-1] += time.thread_time() - begun


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=60.0)
    seconds = parser.parse_args().seconds
    cast = omote.load_cast()
    channels = len(tracked_names(cast))
    rng = np.random.default_rng(5)
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{number}.omote-recording" for number in range(len(BARS))]
        recorded = (
            RecordedNight(cast, paths[0]),
            PreviewNight(cast, paths[1], looks=False),
            PreviewNight(cast, paths[2], looks=True),
        )
        shows: list[Night] = [Night(cast, with_cues=False), *recorded]
        for frame in range(round(seconds * RATE)):
            tracked = track(frame, channels, rng)
            for turn in range(len(shows)):
                show = shows[(frame + turn) % len(shows)]
                if frame % (CALL_SECONDS * RATE) == 0:
                    show.go(frame // (CALL_SECONDS * RATE) % CUES, frame)
                show.play(frame, tracked)
        for each in recorded:
            each.recording.close()
    console = Console()
    alone = float(np.median(shows[0].processor))
    console.print(f"none of the three: {alone * 1e3:.2f} ms")
    missed = 0
    for (name, bar), show in zip(BARS.items(), recorded, strict=True):
        median, high = np.quantile(show.processor, [0.5, 0.99]) * 1e3
        share = median * 1e-3 / alone
        missed += share > bar
        unseen = len(show.unseen) if isinstance(show, PreviewNight) else 0
        told = f"{median:.2f} ms, 99 % {high:.2f}; {share:.2f} of {bar}; states {len(show.state)} and {unseen} bytes"
        console.print(f"{'ok    ' if share <= bar else 'MISSED'} {name:18} {told}")
    return min(missed, 1)


if __name__ == "__main__":
    sys.exit(main())
