"""A tick of a show that one person plays with pads, macros, a hand before the camera and springs, beside today's.

Both shows are that of `four_characters`: two are tracked, two live by themselves. In one of them, between two ticks, a
person moves four pads and twenty macros of two targets on the two that live, a hand drives one of them by its parts,
and eight springs of both move; in the other the same person calls expressions alone. They go by turns in one run; what
is timed is all that the server does for a tick, messages included.

* the tick in the median: at most 1.3 of the other show's.

`python -m benchmarks.one_performer [--ticks N]`.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import gc
import math
import sys
import time

import numpy as np
from rich.console import Console
from rich.table import Table

import omote
from benchmarks.four_characters import CONSOLES, RATE, begin_show, drive, track, tracked_names
from benchmarks.mappings import make_mappings
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.hand.macros import MoveMacro, SetMapping
from omote.show.objects.hand.pads import MovePad, SetPad
from omote.show.objects.motion import SetSpring
from omote.show.objects.sources import Drive, Source
from omote.show.wire import encode

BAR = 1.3
MACROS = 20
WHO = CONSOLES[0]
PADS = ("mouth", "brows")
"""The regions whose pads are moved on both characters."""
HANDLED = ("jawOpen", "browInnerUp", "browDownLeft", "browDownRight")
"""What the hand before the camera sends beside the head."""


class Show:
    """A show that goes on tick by tick. by_hands: with pads, macros, a hand and springs."""

    def __init__(self, cast: omote.Cast, *, by_hands: bool) -> None:
        self.session = begin_show(cast)
        self.by_hands = by_hands
        self.played = list(self.session.scene)[2:]
        self.worn = [name for name, title in cast.titles.items() if title.kind == "performed"]
        self.spent = list[float]()
        for number, character in enumerate(self.played):
            self.session.receive(WHO, CallFace(character, f"f{number}", ("dog", "heavy")[number], 0.0), 0.0)
            for name in SPRING_NAMES:
                self.session.receive(WHO, SetSpring(character, name, 1.0 if by_hands else 0.0), 0.0)
        if by_hands:
            self._begin(cast)

    def _begin(self, cast: omote.Cast) -> None:
        for region in PADS:
            looks = [
                omote.PadLook(f"{place}", {name: 1.0}, (math.cos(place * 0.7), math.sin(place * 0.7)))
                for place, name in enumerate(self.worn[:8])
            ]
            self.session.receive(WHO, SetPad(f"p{region}", region, region, 2, looks), 0.0)
        for mapping in make_mappings(cast, MACROS):
            self.session.receive(WHO, SetMapping(self.played[0], mapping.name, mapping), 0.0)
        self.session.receive(WHO, Source("hand", "tracker", list(HANDLED), [self.played[0]]), 0.0)

    def tick(self, number: int, tracked: list[bytes]) -> None:
        """One tick, with what trackers and hands send before it."""
        now = number / RATE
        before = time.thread_time()
        if number % 60 == 0:
            name = self.worn[number // 60 % len(self.worn)]
            self.session.receive(WHO, CallExpression(self.played[0], f"e{number}", name, 0.4), now)
        drive(self.session, number, tracked)
        if self.by_hands:
            self._play(number, now)
        encode(self.session.tick(now))
        self.spent.append(time.thread_time() - before)

    def _play(self, number: int, now: float) -> None:
        phase = number / RATE * 2.0
        for place, character in enumerate(self.played):
            for region in PADS:
                at = phase + place
                self.session.receive(WHO, MovePad(character, region, math.sin(at), math.cos(1.3 * at)), now)
        for place in range(MACROS):
            self.session.receive(WHO, MoveMacro(self.played[0], f"m{place}", math.sin(phase + place)), now)
        weights = (0.4 + 0.3 * np.sin(phase + np.arange(len(HANDLED)))).astype("<f4").tobytes()
        swing = 0.3 * math.sin(phase)
        self.session.receive_bytes(WHO, encode(Drive(3, weights, (swing, 0.05, 0.0), None)), now)


def main() -> int:
    """Measures and prints; 1 where the bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ticks", type=int, default=1800)
    ticks = parser.parse_args().ticks
    cast = omote.load_cast()
    shows = {"calls": Show(cast, by_hands=False), "hands": Show(cast, by_hands=True)}
    channels = len(tracked_names(cast))
    rng = np.random.default_rng(32)
    gc.collect()
    gc.freeze()
    for number in range(1, ticks):
        tracked = track(number, channels, rng)
        for show in shows.values():
            show.tick(number, tracked)
    table = Table("processor, ms", "median", "99 %", title=f"{ticks} ticks; four characters, two tracked")
    for name, show in shows.items():
        table.add_row(name, *(f"{1e3 * each:.3f}" for each in np.quantile(show.spent, [0.5, 0.99])))
    console = Console()
    console.print(table)
    ratio = float(np.median(shows["hands"].spent) / np.median(shows["calls"].spent))
    holds = ratio <= BAR
    console.print(f"{'ok    ' if holds else 'MISSED'} with four pads, {MACROS} mappings, a hand and eight springs: "
                  f"{ratio:.2f} of {BAR}")  # fmt: skip
    return 0 if holds else 1


if __name__ == "__main__":
    sys.exit(main())
