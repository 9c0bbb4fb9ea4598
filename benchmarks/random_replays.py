"""Ten random shows of ten minutes, replayed in another process: every state's bytes must be those that were sent.

The shows (`tests/show/recording/random_show.py`) have two trackers, four consoles of which one looks at the preview,
own faces and recasts, sounds, leases, panics, cues with lines, clips and passes, characters that come and go. Each is
recorded as a show is, by the thread and its file, and replayed with another hash seed; five seeks in each end at the
states that were sent.

`python -m benchmarks.random_replays [--shows N] [--minutes M] [--seed S]`; 10 shows of 10 minutes without them, and a
fresh seed.
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
from omote.model.cast import Look
from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.recording_thread import RecordingThread
from omote.show.wire import encode
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_face
from omote.showfile.recording_file import open_recording
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast
from tests.show.recording.random_show import RandomShow

SEEKS = 5
BAR_SEEK = 1.0
"""Seconds of waiting."""


def make_casts(cast: omote.Cast) -> tuple[list[PlayingCast], dict[str, bytes]]:
    """The built-in cast with one own face and with two, and the contents of these."""
    own: list[Own] = []
    contents: dict[str, bytes] = {}
    for name, of in (("cousin", "kaori"), ("uncle", "old")):
        data = pack_face(cast.faces[of], Look())
        key = content_key(data)
        contents[key] = data
        own.append(Own("face", name, name.title(), (), float(len(own)), key))
    return [build_playing_cast(cast, tuple(own[:count]), contents, check=False) for count in (1, 2)], contents


def record(path: Path, seed: int, minutes: float) -> None:
    """Records a random show. path: of the recording."""
    casts, contents = make_casts(omote.load_cast())
    writer = RecordingThread(path, lambda said: sys.exit(said), "benchmark")
    for cast in casts:
        writer.note_cast(cast, contents)
    show = RandomShow(seed, {cast.digest: cast for cast in casts}, calm=0.3)
    for _ in range(round(3600 * minutes)):
        show.tick()
        writer.note(list(show.entries))
        show.entries.clear()
        show.states.clear()
    writer.close()


def replay(path: Path, seed: int) -> int:
    """Replays a recording and seeks in it; prints what it saw, and gives 1 where something differs."""
    reading = RecordedShow(open_recording(path), omote.load_cast())
    span = reading.find_span()
    begun = time.perf_counter()
    checks: list[tuple[float, int]] = []
    different: float | None = None
    for tick in reading.replay(span):
        checks.append((tick.now, zlib.crc32(encode(tick.state))))
        if tick.same is False and different is None:
            different = tick.now - span.first
    times = span.seconds / (time.perf_counter() - begun)
    wrong = 0
    waits = []
    for place in np.random.default_rng(seed).integers(0, len(checks) - 1, SEEKS).tolist():
        begun = time.perf_counter()
        tick = next(reading.replay(span, after=checks[place][0]))
        waits.append(time.perf_counter() - begun)
        wrong += zlib.crc32(encode(tick.state)) != checks[place + 1][1]
    reading.close()
    said = "the same" if different is None else f"DIFFERENT from {different:.3f} s on"
    Console().print(
        f"seed {seed}: {len(checks)} states {said}, {times:.1f} times real; {SEEKS} seeks, {wrong} differ, "
        f"longest {max(waits):.2f} s"
    )
    return int(different is not None or wrong > 0)


def main() -> int:
    """Records and replays, each in a process of its own; 1 where a replay differs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shows", type=int, default=10)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--record", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--replay", type=Path, help=argparse.SUPPRESS)
    asked = parser.parse_args()
    seed = int(np.random.default_rng().integers(2**31)) if asked.seed is None else asked.seed
    if asked.record is not None:
        record(asked.record, seed, asked.minutes)
        return 0
    if asked.replay is not None:
        return replay(asked.replay, seed)
    failed = 0
    for number in range(asked.shows):
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "show.omote-recording")
            own = [sys.executable, "-m", "benchmarks.random_replays", "--seed", str(seed + number)]
            subprocess.run([*own, "--record", path, "--minutes", str(asked.minutes)], check=True)
            other = {**os.environ, "PYTHONHASHSEED": str(number + 1)}
            failed += subprocess.run([*own, "--replay", path], check=False, env=other).returncode != 0
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
