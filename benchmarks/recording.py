"""The recording that is always on: what it costs a tick and the disk, and whether a replay is the same to the last bit.

Two nights of `cue_night` (four characters, two trackers at 60 Hz with other values in each frame, 300 cues) play by
turns, one of them recorded. Then another process replays the recording: every state's bytes must be those that were
sent, and so must be what 50 seeks at random arrive at.

* the tick with recording, in the median: at most 1.25 of the tick without;
* the log, packed, with its snapshots: at most 1.5 MB a minute;
* every state the same; every seek the same, in at most 1 s of waiting at the pace of the machine.

`python -m benchmarks.recording [--minutes M]`, 2 without it.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

import numpy as np
from rich.console import Console

import omote
from benchmarks.cue_night import CUES, Night
from benchmarks.four_characters import RATE, track, tracked_names
from benchmarks.pace import Pace
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread
from omote.show.recording.recorder import Recorder
from omote.show.wire import encode
from omote.showfile.recording_file import open_recording

BAR_SHARE = 1.25
BAR_LOG = 1.5e6
"""Bytes a minute."""
BAR_SEEK = 1.0
"""Seconds, where the pace is 1."""
SEEKS = 50


class RecordedNight(Night):
    """A night that is recorded. path: of the recording."""

    def __init__(self, cast: omote.Cast, path: Path) -> None:
        super().__init__(cast, with_cues=True)
        self.recording = RecordingThread(path, lambda said: sys.exit(said), "benchmark")
        self.recording.note_cast(cast, {})
        self.recorder = Recorder(self.session)

    def play(self, frame: int, values: list[bytes]) -> None:
        """One tick with its recording; the time of both counts."""
        super().play(frame, values)
        begun = time.thread_time()
        self.recording.note(self.recorder.take(zlib.crc32(self.state)))
        self.processor[-1] += time.thread_time() - begun


def replay(path: Path, seed: int) -> int:
    """Replays a recording and seeks in it; prints what it saw, and gives 1 where something differs."""
    reading = RecordedShow(open_recording(path), omote.load_cast())
    span = reading.find_span()
    begun = time.perf_counter()
    sent: list[tuple[float, int]] = []
    different = 0
    for tick in reading.replay(span):
        sent.append((tick.now, zlib.crc32(encode(tick.state))))
        different += not tick.same
    times = span.seconds / (time.perf_counter() - begun)
    pace = Pace()
    rng = np.random.default_rng(seed)
    waits = []
    wrong = 0
    for place in rng.integers(0, len(sent) - 1, SEEKS).tolist():
        begun = time.perf_counter()
        tick = next(reading.replay(span, after=sent[place][0]))
        waits.append(time.perf_counter() - begun)
        wrong += zlib.crc32(encode(tick.state)) != sent[place + 1][1]
        pace.measure()
    longest = max(waits) / pace.ratio()
    console = Console()
    console.print(f"{len(sent)} states replayed in another process, {times:.1f} times real; {different} differ")
    console.print(
        f"{SEEKS} seeks (seed {seed}): median {np.median(waits):.2f} s, longest {max(waits):.2f}; {wrong} differ"
    )
    console.print(
        f"{'ok    ' if longest <= BAR_SEEK else 'MISSED'} longest seek at the pace: {longest:.2f} of {BAR_SEEK}"
    )
    return int(bool(different or wrong or longest > BAR_SEEK))


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=2.0)
    parser.add_argument("--replay", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=31)
    asked = parser.parse_args()
    if asked.replay is not None:
        return replay(asked.replay, asked.seed)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "show.omote-recording"
        failed = record(path, asked.minutes)
        command = [sys.executable, "-m", "benchmarks.recording", "--replay", str(path), "--seed", str(asked.seed)]
        return subprocess.run(command, check=False, env={**os.environ, "PYTHONHASHSEED": "7"}).returncode or failed


def record(path: Path, minutes: float) -> int:
    """Plays both nights, and prints what the recording cost; 1 where a bar is missed. path: of the recording."""
    cast = omote.load_cast()
    channels = len(tracked_names(cast))
    recorded = RecordedNight(cast, path)
    shows = [Night(cast, with_cues=True), recorded]
    every = round(6.0 * RATE)
    rng = np.random.default_rng(5)
    for frame in range(round(minutes * 60 * RATE)):
        tracked = track(frame, channels, rng)
        for turn in range(2):
            show = shows[(frame + turn) % 2]
            if frame % every == 0:
                show.go(frame // every % CUES, frame)
            show.play(frame, tracked)
    recorded.recording.close()
    without, with_recording = (np.array(show.processor) for show in shows)
    share = float(np.median(with_recording) / np.median(without))
    late = float(np.quantile(with_recording, 0.99) / np.quantile(without, 0.99))
    file = open_recording(path)
    size = sum(len(file.read(piece.id)) for piece in file.pieces()) / minutes
    file.close()
    console = Console()
    console.print(f"{minutes:g} minutes; 99 % of the tick with recording: {late:.2f} of that without")
    claims = (
        (f"median of the tick: {share:.3f} of {BAR_SHARE}", share <= BAR_SHARE),
        (f"log: {size / 1e6:.2f} MB a minute of {BAR_LOG / 1e6}", size <= BAR_LOG),
    )
    for told, holds in claims:
        console.print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
