"""What a character does by itself, an hour long, beside what the literature says of people.

Blinks at rest and while speaking, their times; fixations and saccades, the main sequence; eye contact, and mutual gaze
of two who look at one another; the head that follows; breath. Each figure stands beside the range that is stated for
people, with its source. The same seed is played twice: to the bit the same.

`python -m benchmarks.motion [--seed N] [--minutes N]`; without a seed each run draws its own and prints it.
"""

from __future__ import annotations

import argparse
import itertools
import secrets
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from rich.console import Console
from rich.table import Table

from omote.perform.frame import GazeTarget, MotionSettings
from omote.perform.motion.automatic_motion import AutomaticMotion, advance_motion, set_motion
from omote.perform.motion.gaze_motion import DEGREE, looked_at
from omote.perform.motion.head_following import Turn
from omote.perform.motion.sight import Sight
from omote.perform.scene.gaze_targets import contacts

RATE = 60
FINE = 1000
MINUTES = 60.0
PEOPLE = 0.5
"""The liveliness that is as people are."""


@dataclass
class Heard:
    """What was seen of one character: blinks and saccades with their times, spells of contact in seconds."""

    blinks: list[tuple[float, float, float]] = field(default_factory=list)
    saccades: list[tuple[float, float]] = field(default_factory=list)
    fixations: list[float] = field(default_factory=list)
    contact: list[bool] = field(default_factory=list)
    breaths: int = 0
    far_blinks: list[bool] = field(default_factory=list)


def play(seed: int, minutes: float, *, speaking: bool = False) -> Heard:
    """A character by itself."""
    motion = set_motion(AutomaticMotion(), MotionSettings(PEOPLE, seed=seed))
    heard = Heard()
    for _ in range(round(60.0 * minutes * RATE)):
        before = motion
        motion = advance_motion(motion, 1 / RATE, speaking=speaking)
        if motion.blinks.count != before.blinks.count:
            heard.blinks.append((motion.blinks.began, motion.blinks.down, motion.blinks.up))
        if motion.gaze.count != before.gaze.count:
            note_saccade(heard, before, motion)
        heard.contact.append(motion.gaze.contact)
    heard.breaths = motion.breath.count
    return heard


def note_saccade(heard: Heard, before: AutomaticMotion, motion: AutomaticMotion) -> None:
    """Notes a saccade that has begun."""
    saccade = motion.gaze.saccade
    last = before.gaze.saccade
    amplitude = float(np.hypot(saccade.goal.yaw - saccade.origin.yaw, saccade.goal.pitch - saccade.origin.pitch))
    times = np.linspace(saccade.began, saccade.began + saccade.seconds, 101)
    shown = [saccade.at(float(time)) for time in times]
    speeds = np.hypot(np.diff([each.yaw for each in shown]), np.diff([each.pitch for each in shown]))
    heard.saccades.append((amplitude / DEGREE, float(speeds.max() / (times[1] - times[0]) / DEGREE)))
    heard.fixations.append(saccade.began - last.began - last.seconds)
    if amplitude > 30.0 * DEGREE:
        heard.far_blinks.append(motion.blinks.began <= saccade.began < motion.blinks.began + 0.5)


def spells(flags: Sequence[bool], rate: float) -> list[float]:
    """The lengths of the spells of True but the first and the last, seconds."""
    ends = (np.flatnonzero(np.diff(np.asarray(flags, np.int8))) + 1).tolist()
    return [(end - begin) / rate for begin, end in itertools.pairwise(ends) if flags[begin]]


def mutual_spells(seed: int, minutes: float) -> tuple[list[float], float]:
    """Spells of mutual gaze of two who look at one another, and its share of the time; the eyes are asked."""
    seeds = seed, seed + 1
    two = [set_motion(AutomaticMotion(), MotionSettings(PEOPLE, seed=each)) for each in seeds]
    target = GazeTarget("character", "other")
    two = [set_motion(each, each.settings.change(target=target)) for each in two]
    met = []
    for step in range(round(60.0 * minutes * RATE)):
        told = contacts(seeds, step / RATE)
        sights = [Sight(Turn(yaw), 0.05, at) for yaw, at in zip((0.9, -0.9), told, strict=True)]
        two = [advance_motion(each, 1 / RATE, sight=sight) for each, sight in zip(two, sights, strict=True)]
        met.append(all(each.gaze.contact for each in two))
    return spells(met, RATE), float(np.mean(met))


def head_of(yaw: float) -> tuple[float, float, float]:
    """Of a shift of the gaze by some degrees: how far the head goes along (degrees), and when eyes and head have gone
    half of their way (seconds)."""
    motion = set_motion(AutomaticMotion(), MotionSettings(PEOPLE, gaze=0.0))
    motion = advance_motion(motion, 0.5)
    looks = []
    heads = []
    for _ in range(2 * FINE):
        motion = advance_motion(motion, 1 / FINE, sight=Sight(Turn(yaw * DEGREE)))
        looks.append(looked_at(motion.gaze, motion.time).yaw / DEGREE)
        heads.append(motion.head.second.yaw / DEGREE)
    half = [float(np.argmax(np.array(each) >= each[-1] / 2.0)) / FINE for each in (looks, heads)]
    return heads[-1], half[0], half[1]


Row = tuple[str, float, float, float, str]
"""What it is, how much, the lowest and the highest of people, and who says so."""


def blink_rows(rest: Heard, speech: Heard, minutes: float) -> list[Row]:
    """Blinks."""
    downs, ups = (np.array([blink[at] for blink in rest.blinks]) for at in (1, 2))
    pauses = np.diff([began for began, _, _ in rest.blinks])
    return [
        ("blinks a minute at rest", len(rest.blinks) / minutes, 15.0, 20.0, "Bentivoglio 1997"),
        ("blinks a minute in speech", len(speech.blinks) / minutes, 20.0, 32.0, "Bentivoglio 1997"),
        ("blink: down, ms, shortest", 1e3 * downs.min(), 100.0, 150.0, "VanderWerf 2003"),
        ("blink: down, ms, longest", 1e3 * downs.max(), 100.0, 150.0, "VanderWerf 2003"),
        ("blink: up, ms, shortest", 1e3 * ups.min(), 200.0, 250.0, "VanderWerf 2003"),
        ("blink: up, ms, longest", 1e3 * ups.max(), 200.0, 250.0, "VanderWerf 2003"),
        ("blink pauses: mean by median (lognormal)", pauses.mean() / np.median(pauses), 1.15, 3.0, "Bentivoglio 1997"),
        (
            "far shifts (over 30 degrees) with a blink",
            float(np.mean(rest.far_blinks or [True])),
            0.95,
            1.0,
            "Evinger 1994",
        ),
    ]


def saccade_rows(rest: Heard) -> list[Row]:
    """Saccades by the main sequence, and fixations."""
    amplitudes, peaks = np.array(rest.saccades).T
    rows: list[Row] = []
    for degrees, low, high in ((2.0, 60.0, 160.0), (10.0, 300.0, 500.0), (20.0, 400.0, 650.0)):
        near = np.abs(amplitudes - degrees) < 0.2 * degrees
        peak = float((peaks[near] / amplitudes[near]).mean() * degrees)
        rows.append((f"peak speed of a saccade of {degrees:g} degrees, degrees/s", peak, low, high, "Carpenter 1988"))
    return [
        *rows,
        ("fixation, s, 5 %", float(np.quantile(rest.fixations, 0.05)), 0.15, 0.6, "Lee 2002"),
        ("fixation, s, median", float(np.median(rest.fixations)), 0.3, 1.2, "Lee 2002"),
        ("saccades a minute", len(rest.saccades) / len(rest.contact) * 60 * RATE, 40.0, 120.0, "Lee 2002"),
    ]


def gaze_rows(rest: Heard, seed: int, minutes: float) -> list[Row]:
    """Eye contact, mutual gaze, and the head that follows."""
    contact = spells(rest.contact, RATE)
    mutual, share = mutual_spells(seed, minutes)
    near = head_of(12.0)[0]
    (far, eyes, head) = head_of(60.0)
    return [
        ("eye contact, s, 5 %", float(np.quantile(contact, 0.05)), 1.0, 5.0, "Argyle 1972"),
        ("eye contact, s, median", float(np.median(contact)), 1.0, 5.0, "Argyle 1972"),
        ("mutual gaze, s, shortest", min(mutual), 0.95, 5.05, "Argyle 1972"),
        ("mutual gaze, s, longest", max(mutual), 0.95, 5.05, "Argyle 1972"),
        ("mutual gaze, share of the time", share, 0.3, 0.6, "Argyle 1972"),
        ("head at a shift of 12 degrees", near, 0.0, 0.5, "Stahl 1999"),
        ("head at a shift of 60 degrees", far, 25.0, 45.0, "Stahl 1999"),
        ("head behind the eyes at half way, ms", 1e3 * (head - eyes), 50.0, 250.0, "later; tracking.md"),
    ]


def is_repeated(seed: int) -> bool:
    """Whether five minutes of one seed are twice the same, to the bit."""
    one, other = (set_motion(AutomaticMotion(), MotionSettings(PEOPLE, seed=seed)) for _ in range(2))
    for _ in range(5 * 60 * RATE):
        one = advance_motion(one, 1 / RATE)
        other = advance_motion(other, 1 / RATE)
        if one != other:
            return False
    return True


def main() -> int:
    """Measures and prints; 1 where a figure is out of its range."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--minutes", type=float, default=MINUTES)
    asked = parser.parse_args()
    seed = secrets.randbits(30) if asked.seed is None else asked.seed
    rest = play(seed, asked.minutes)
    speech = play(seed, asked.minutes, speaking=True)
    rows = [*blink_rows(rest, speech, asked.minutes), *saccade_rows(rest), *gaze_rows(rest, seed, asked.minutes)]
    rows.append(("breaths a minute", rest.breaths / asked.minutes, 12.0, 16.0, "tracking.md"))
    table = Table("figure", "here", "people", "source", "", title=f"{asked.minutes:g} minutes, seed {seed}")
    for told, value, low, high, source in rows:
        holds = low - 1e-9 <= value <= high + 1e-9
        table.add_row(told, f"{value:.3g}", f"{low:g} to {high:g}", source, "ok" if holds else "MISSED")
    Console().print(table)
    repeated = is_repeated(seed)
    Console().print(f"{'ok    ' if repeated else 'MISSED'} the same seed gives the same bits")
    return 0 if repeated and all(low - 1e-9 <= value <= high + 1e-9 for _, value, low, high, _ in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
