"""A night of 300 cues on four characters with two trackers: what cues cost a tick, and what the whole night costs.

Two shows of four consoles and two trackers at 60 Hz play the same calls at the same instants, tick by tick and by
turns: one by GO of its cue list (twelve parts a cue, a third of them with delays, each second cue followed by itself),
one by the same moves sent as calls by hand. What is timed is all that the server does once a tick, the journal's entry
each second tick included. Times are of the processor, of one thread.

* the tick with cues in the median: at most 1.25 of the same calls without cues;
* its 99th percentile: at most 4 ms at the pace of the machine (`benchmarks/pace.py`);
* beside: how many times faster than the show's own time it goes, bytes of the state and of the journal's entry.

`python -m benchmarks.cue_night [--minutes M]`, 100 for the night; 1 without it.
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
from benchmarks.pace import Pace
from omote.perform.cues.cue import GoesOn
from omote.perform.scene.goals import rank_of
from omote.server.persistence.restore import journal_entry
from omote.show.cues.cue_book import FIRST_LIST, CueBook, edit_cues
from omote.show.objects.cues import Go
from omote.show.wire import encode

CUES = 300
BAR_SHARE = 1.25
BAR_TICK = 4e-3
"""Processor seconds of a tick at the 99th percentile, where the pace is 1 (issue 31)."""


def make_cues(cast: omote.Cast, characters: list[str]) -> list[omote.Cue]:
    """A list of cues of twelve parts each. characters: whom they move."""
    rng = np.random.default_rng(31)
    worn = [name for name, title in cast.titles.items() if title.kind == "performed"]
    cues = []
    for number in range(CUES):
        goals: dict[str, dict[str, float]] = {"*/light": {str(rng.choice(["flat", "theatre", "portrait"])): 1.0}}
        for who in characters:
            goals[f"{who}/face"] = {str(rng.choice(list(cast.faces))): 1.0}
            goals[f"{who}/expression"] = {str(rng.choice(worn)): 1.0}
            goals[f"{who}/head"] = {"yaw": float(rng.uniform(-0.3, 0.3)), "pitch": 0.0, "roll": 0.0}
        moves = {
            part: omote.Move(goal, float(rng.uniform(0.5, 4.0)), delay=float(rng.choice([0.0, 0.0, 0.7])))
            for part, goal in list(goals.items())[:12]
        }
        follows: GoesOn = "follow" if number % 2 else ""
        cues.append(omote.Cue(f"c{number}", str(number + 1), moves, goes_on=follows, post_wait=1.0))
    return cues


class Night:
    """One of the two shows, and the processor seconds of its ticks. played: its cues, where it has a list."""

    def __init__(self, cast: omote.Cast, *, with_cues: bool) -> None:
        self.session = begin_show(cast)
        self.characters = list(self.session.scene)
        self.cues = make_cues(cast, self.characters)
        if with_cues:
            listed: dict[str, omote.Cue | None] = {cue.identity: cue for cue in self.cues}
            self.session.cues.load(edit_cues(CueBook(), "write", "ana", listed, {FIRST_LIST: list(listed)}))
        self.with_cues = with_cues
        self.due = list[tuple[float, str, omote.Move]]()
        self.processor = list[float]()
        self.sizes = (0, 0)
        self.state = b""

    def go(self, number: int, frame: int) -> None:
        """Plays a cue (number, from 0): by GO, or by its moves as calls."""
        now = frame / RATE
        if self.with_cues:
            self.session.receive("ana", Go(f"go{frame}", cue=str(number + 1)), now)
            return
        moves = self.cues[number].moves
        self.due = sorted(((now + move.delay, part, move) for part, move in moves.items()), key=lambda one: one[0])

    def play(self, frame: int, values: list[bytes]) -> None:
        """One tick, after what has come since the last. values: of the trackers."""
        now = frame / RATE
        drive(self.session, frame, values)
        begun = time.thread_time()
        ready = [one for one in self.due if one[0] <= now]
        self.due = self.due[len(ready) :]
        for _, part, move in sorted(ready, key=lambda one: rank_of(one[1])):
            self.session.scene.call_goal(part, move.goal, seconds=move.seconds, easing=move.easing)
        self.state = encode(self.session.tick(now))
        entry = journal_entry(self.session) if frame % 2 else None
        self.processor.append(time.thread_time() - begun)
        self.sizes = (len(self.state), self.sizes[1] if entry is None else len(entry.snapshot or b""))


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=1.0)
    minutes = parser.parse_args().minutes
    cast = omote.load_cast()
    channels = len(tracked_names(cast))
    shows = [Night(cast, with_cues=with_cues) for with_cues in (False, True)]
    every = max(1, round(max(minutes * 60.0 / CUES, 6.0) * RATE))
    pace = Pace()
    rng = np.random.default_rng(5)
    for frame in range(round(minutes * 60 * RATE)):
        tracked = track(frame, channels, rng)
        for turn in range(2):
            show = shows[(frame + turn) % 2]
            if frame % every == 0:
                show.go(frame // every % CUES, frame)
            show.play(frame, tracked)
        pace.measure()
    without, with_cues = (np.array(show.processor) for show in shows)
    share = float(np.median(with_cues) / np.median(without))
    late = float(np.quantile(with_cues, 0.99)) / (BAR_TICK * pace.ratio(0.99))
    console = Console()
    console.print(f"{minutes:g} minutes, {CUES} cues, one each {every / RATE:.1f} s; 4 characters, 2 trackers")
    for name, spent, show in (("calls", without, shows[0]), ("cues", with_cues, shows[1])):
        median, high = np.quantile(spent, [0.5, 0.99]) * 1e3
        times = len(spent) / RATE / spent.sum()
        state, journal = show.sizes
        console.print(
            f"{name:6} {median:.2f} ms, 99 % {high:.2f}; {times:.1f} times real; state {state}, journal {journal} bytes"
        )
    console.print(f"pace {pace.ratio():.2f}, at 99 % {pace.ratio(0.99):.2f}")
    claims = (
        (f"cues beside calls: {share:.2f} of {BAR_SHARE}", share <= BAR_SHARE),
        (f"99 %: {late:.2f} of 1", late <= 1.0),
    )
    for told, holds in claims:
        console.print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
