"""What macros cost a tick, and what several sources of one target look like at its limit.

Forty-eight mappings of four targets each, all of them moved before every tick: curves of five knots, halves below zero,
followers, a condition on every third; the targets are all units of the cast, head and gaze. What is timed is what they
add to a tick of a performer: they go on, and what hands hold is put together. Beside it stand the same without anything
moving, and a tick of a show's session (one character that lives, with calls) with twenty such mappings and a hand on
all of them, as a ratio to the same session whose hand moves twenty faders of channels, ticks by turns. Times are of the
processor, the median.

* 48 mappings of 4 targets: at most .5 ms a tick at the pace of the machine (`benchmarks/pace.py`);
* the largest change of slope from one thousandth of a source's way to the next, where two sources of a target meet its
  limit, in parts of its slope: soft limit beside a clip. At most .15: the clip's is 1.

`python -m benchmarks.mappings [--ticks N]`.
"""

from __future__ import annotations

import os

from omote.show.declaration import ClientMessage
from omote.show.objects.calls import CallExpression
from omote.show.objects.faders import SetChannel
from omote.show.objects.hand.macros import MoveMacro, SetMapping
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetMotion

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import gc
import sys
import time
from collections.abc import Sequence

import numpy as np
from rich.console import Console
from rich.table import Table

import omote
from benchmarks.pace import Pace
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget
from omote.perform.mappings.soft_limit import soft_sum
from omote.show.messages import PROTOCOL_VERSION
from omote.show.session import ShowSession

RATE = 60
TICKS = 2000
MANY = 48
SHOWN = 20
TARGETS = 4
BAR_TICK = 0.5e-3
"""Processor seconds where the pace is 1."""
BAR_KINK = 0.15
WHO = "ana"
CURVE = ((0.0, 0.0), (0.2, 0.05), (0.5, 0.6), (0.8, 0.7), (1.0, 1.0))
STEP = 1e-3


def make_mappings(cast: omote.Cast, count: int) -> list[MacroMapping]:
    """Mappings of four targets each, of all units, head and gaze by turns."""
    units = [name for name, title in cast.titles.items() if title.kind == "arkit" and "Look" not in name]
    reached = [*(f"channel/{unit}" for unit in units), "head/yaw", "head/pitch", "head/roll", "gaze/yaw", "gaze/pitch"]
    mappings = []
    for number in range(count):
        names = [reached[(number * TARGETS + place) % len(reached)] for place in range(TARGETS)]
        targets = [
            MacroTarget(to, 0.0, 0.4, CURVE, HalfBelow(-0.3) if place % 2 else None, rise=0.1, fall=0.3)
            for place, to in enumerate(names)
        ]
        when = MacroCondition(f"macro/m{(number + 1) % count}", -0.9) if number % 3 == 0 else None
        mappings.append(MacroMapping(f"m{number}", tuple(targets), when))
    return mappings


def hands(tick: int, count: int) -> list[float]:
    """Where macros are at a tick: each swings in its own time."""
    return [float(np.sin(0.05 * tick + number)) for number in range(count)]


def time_macros(cast: omote.Cast, ticks: int, *, moved: bool) -> list[float]:
    """Seconds that macros take in each of some ticks; moved: whether hands move them all, or they rest."""
    performer = omote.Performer(cast)
    for mapping in make_mappings(cast, MANY):
        performer.set_mapping(mapping)
        performer.move_macro(mapping.name, 0.5)
    performer.advance(8.0)
    spent = []
    for tick in range(ticks):
        for number, value in enumerate(hands(tick, MANY) if moved else ()):
            performer.move_macro(f"m{number}", value)
        before = time.thread_time()
        performer._advance_macros(1 / RATE)
        performer._held()
        spent.append(time.thread_time() - before)
        performer.advance(0.0)
    return spent


class Show:
    """A session in which a character lives. mappings: those that hands move; faders: of channels that hands move."""

    def __init__(self, cast: omote.Cast, mappings: Sequence[MacroMapping], faders: int = 0) -> None:
        self.session = ShowSession(cast)
        self.session.receive(WHO, Hello("console", PROTOCOL_VERSION, WHO), 0.0)
        self.session.receive(WHO, SetMotion("one", 0.6, idle=True), 0.0)
        self.count = len(mappings)
        self.faders = [name for name, title in cast.titles.items() if title.kind == "arkit"][:faders]
        self.worn = [name for name, title in cast.titles.items() if title.kind == "performed"]
        self.spent = list[float]()
        for mapping in mappings:
            self.session.receive(WHO, SetMapping("one", mapping.name, mapping), 0.0)

    def tick(self, number: int) -> None:
        """One tick, with what hands do before it."""
        now = number / RATE
        if number % 30 == 0:
            self.session.receive(WHO, CallExpression("one", f"e{number}", self.worn[number % len(self.worn)], 0.4), now)
        moves: list[ClientMessage] = [
            *(MoveMacro("one", f"m{place}", value) for place, value in enumerate(hands(number, self.count))),
            *(
                SetChannel("one", name, 0.4 + 0.4 * value)
                for name, value in zip(self.faders, hands(number, len(self.faders)), strict=True)
            ),
        ]
        before = time.thread_time()
        for move in moves:
            self.session.receive(WHO, move, now)
        self.session.tick(now)
        self.spent.append(time.thread_time() - before)


def kinks() -> tuple[float, float]:
    """The largest change of slope where a second source meets the limit, softly limited and clipped."""
    others = np.linspace(0.0, 0.95, 20)
    ways = np.arange(0.0, 0.999, STEP)
    soft = [[soft_sum(np.array([way, other]), -0.5, 1.0) for way in ways] for other in others]
    clipped = np.minimum(ways + others[:, None], 1.0)
    soft_kink, clip_kink = (
        float(np.abs(np.diff(values, 2)).max() / STEP) for values in (np.array(soft), np.asarray(clipped))
    )
    return soft_kink, clip_kink


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ticks", type=int, default=TICKS)
    ticks = parser.parse_args().ticks
    cast = omote.load_cast()
    pace = Pace()
    gc.collect()
    gc.freeze()
    moved = time_macros(cast, ticks, moved=True)
    rest = time_macros(cast, ticks, moved=False)
    shows = {"none": Show(cast, (), SHOWN), "twenty": Show(cast, make_mappings(cast, SHOWN))}
    for number in range(1, ticks):
        for show in shows.values():
            show.tick(number)
        pace.measure()
    soft_kink, clip_kink = kinks()
    table = Table("processor, ms", "median", "99 %", title=f"{ticks} ticks")
    for name, spent in (
        (f"{MANY} mappings of {TARGETS}, moved", moved),
        ("the same at rest", rest),
        (f"a session's tick with {SHOWN} faders", shows["none"].spent),
        (f"with {SHOWN} mappings and their hands", shows["twenty"].spent),
    ):
        table.add_row(name, *(f"{1e3 * each:.3f}" for each in np.quantile(spent, [0.5, 0.99])))
    console = Console()
    console.print(table)
    ratio = float(np.median(shows["twenty"].spent) / np.median(shows["none"].spent))
    console.print(f"a tick with {SHOWN} mappings is {ratio:.2f} of one with as many faders; pace {pace.ratio():.2f}")
    middle = float(np.median(moved))
    bars = [
        (
            middle <= BAR_TICK * pace.ratio(),
            f"{MANY} mappings: {1e3 * middle:.3f} ms of {1e3 * BAR_TICK * pace.ratio():.3f}",
        ),
        (soft_kink <= BAR_KINK, f"largest kink {soft_kink:.3f} of {BAR_KINK}; clipped {clip_kink:.2f}"),
    ]
    for holds, said in bars:
        console.print(f"{'ok    ' if holds else 'MISSED'} {said}")
    return 0 if all(holds for holds, _ in bars) else 1


if __name__ == "__main__":
    sys.exit(main())
