"""Ten thousand random hand-overs between a noisy source and an operator's steps, ours beside what others do.

A tracker sends 24 channels at 30 Hz: slow moves with noise, and now and then it loses its performer. An operator takes
each channel at a random moment, moves it in steps, and lets it go; meanwhile influences of regions and switches change
and expressions are called. Shown at 60 Hz on the built-in cast by one `Performer`; each hand-over is a take or a let-go
of one channel. Measured is the largest change of step from one frame to the next (second difference) of any channel:

* last message wins: whoever sent last shows, as with channels alone;
* linear fade: at each take, step and let-go what shows fades in a third of a second to who has it now;
* glide: what shows glides (cubic, its speed taken over) in a third of a second to each message;
* layers: ours. At most 1/30 of last message wins; every value in its range; weights of every region sum to one.

`python -m benchmarks.hand_over [--seed N] [--count N]`; without a seed each run draws its own and prints it.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import math
import secrets
import sys
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

import omote
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import Frame
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST
from omote.perform.mix import mix_in
from omote.perform.performer import Performer

COUNT = 10_000
CHANNELS = 24
RATE = 60
NOISE = 0.03
FADE_SECONDS = 0.33
MEAN_REST = 1.5
MEAN_HOLD = 1.5
MEAN_STEP = 0.5
"""Seconds, in the mean: between two holds, of a hold, and between two steps of one."""
BAR = 1 / 30
BAR_SUM = 1e-9

Values = NDArray[np.float64]


@dataclass
class Operator:
    """A hand on each channel: what it holds (NaN: nothing), and when it next moves or lets go. Counts hand-overs."""

    rng: np.random.Generator
    held: Values = field(default_factory=lambda: np.full(CHANNELS, np.nan))
    next_move: Values = field(default_factory=lambda: np.zeros(CHANNELS))
    until: Values = field(default_factory=lambda: np.zeros(CHANNELS))
    count: int = 0

    def moves(self, now: float) -> list[tuple[int, float]]:
        """The channels that it moves now, each with its value; 0 lets it go."""
        found = []
        for channel in np.flatnonzero(now >= self.next_move):
            holds = not math.isnan(self.held[channel])
            if holds and now >= self.until[channel]:
                self.held[channel], wait = np.nan, self.rng.exponential(MEAN_REST)
                self.count += 1
                found.append((int(channel), 0.0))
            else:
                if not holds:
                    self.until[channel] = now + self.rng.exponential(MEAN_HOLD)
                    self.count += 1
                self.held[channel], wait = self.rng.uniform(0.01, 1.0), self.rng.exponential(MEAN_STEP)
                found.append((int(channel), float(self.held[channel])))
            self.next_move[channel] = now + wait
        return found


class Tracker:
    """Slow moves between 0 and 1 with noise, at 30 Hz; NaN where it does not see its performer."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng = rng
        self.speed = rng.uniform(0.2, 2.0, CHANNELS)
        self.phase = rng.uniform(0.0, 6.3, CHANNELS)
        self.blind_until = -1.0

    def frame(self, now: float) -> Values | None:
        """What it sends now; None while it sees nobody."""
        if self.rng.random() < 1 / 900:  # twice a minute
            self.blind_until = now + self.rng.exponential(1.0)
        if now < self.blind_until:
            return None
        values = 0.5 + 0.45 * np.sin(self.speed * now + self.phase) + NOISE * self.rng.standard_normal(CHANNELS)
        return np.minimum(np.abs(values), 1.0)


class LastWins:
    """Whoever sent last shows."""

    def __init__(self) -> None:
        self.shown = np.zeros(CHANNELS)

    def hear(self, sent: Values | None, moves: list[tuple[int, float]], _: Values, __: float) -> Values:
        """What shows after these messages."""
        self.shown = self.shown.copy() if sent is None else sent.copy()
        for channel, value in moves:
            self.shown[channel] = value
        return self.shown


class LinearFade:
    """What shows fades to who has the channel now."""

    def __init__(self) -> None:
        self.origin = np.zeros(CHANNELS)
        self.start = np.full(CHANNELS, -10.0)
        self.sent = np.zeros(CHANNELS)
        self.shown = np.zeros(CHANNELS)

    def hear(self, sent: Values | None, moves: list[tuple[int, float]], held: Values, now: float) -> Values:
        """What shows after these messages."""
        self.sent = self.sent if sent is None else sent
        for channel, _ in moves:
            self.origin[channel], self.start[channel] = self.shown[channel], now
        part = np.minimum((now - self.start + 1 / RATE) / FADE_SECONDS, 1.0)
        goal = np.where(np.isnan(held), self.sent, held)
        self.shown = (1.0 - part) * self.origin + part * goal
        return self.shown


class Gliding:
    """What shows glides with its speed to each message."""

    def __init__(self) -> None:
        self.origin = np.zeros(CHANNELS)
        self.rate = np.zeros(CHANNELS)
        self.goal = np.zeros(CHANNELS)
        self.elapsed = np.full(CHANNELS, FADE_SECONDS)
        self.sent = np.zeros(CHANNELS)

    def hear(self, sent: Values | None, _: list[tuple[int, float]], held: Values, __: float) -> Values:
        """What shows after these messages."""
        self.sent = self.sent if sent is None else sent
        goal = np.where(np.isnan(held), self.sent, held)
        news = goal != self.goal
        value, rate = self._state()
        self.origin = np.where(news, value, self.origin)
        self.rate = np.where(news, rate, self.rate)
        self.elapsed = np.where(news, 0.0, self.elapsed)
        self.goal = goal
        self.elapsed = np.minimum(self.elapsed + 1 / RATE, FADE_SECONDS)
        return self._state()[0]

    def _state(self) -> tuple[Values, Values]:
        """As `easing.glide_state`, of all channels at once."""
        u = self.elapsed / FADE_SECONDS
        reach = self.goal - self.origin
        carried = self.rate * FADE_SECONDS
        value = self.origin + reach * u * u * (3.0 - 2.0 * u) + carried * u * (1.0 - u) ** 2
        return value, (reach * 6.0 * u * (1.0 - u) + carried * (1.0 - u) * (1.0 - 3.0 * u)) / FADE_SECONDS


class Layered:
    """Ours: one performer of the built-in cast."""

    def __init__(self, cast: omote.Cast, names: list[str], rng: np.random.Generator) -> None:
        self.performer = Performer(cast)
        self.names = names
        self.rng = rng
        self.expressions = [name for name, title in cast.titles.items() if title.kind == "performed"]
        self.worst_sum = 0.0
        self.outside = 0

    def hear(self, sent: Values | None, moves: list[tuple[int, float]], _: Values, __: float) -> Values:
        """What shows after these messages; at random an influence, a switch or the called expression changes."""
        if sent is not None:
            self.performer.drive(dict(zip(self.names, sent.tolist(), strict=True)), layer="tracker")
        for channel, value in moves:
            self.performer.set_channel(self.names[channel], value)
        if self.rng.random() < 1 / 60:
            part = str(self.rng.choice(LAYER_PARTS))
            self.performer.set_layer("tracker", region=part, influence=float(self.rng.random()))
        if self.rng.random() < 1 / 300:
            self.performer.set_layer("tracker", on=bool(self.rng.random() < 0.7))
        if self.rng.random() < 1 / 120:
            self.performer.call_expression(str(self.rng.choice(self.expressions)), seconds=0.7)
        frame = self.performer.advance(1 / RATE)
        self._check(frame)
        return np.array([frame.channels.get(name, 0.0) for name in self.names])

    def _check(self, frame: Frame) -> None:
        self.outside += sum(not CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST for value in frame.channels.values())
        for region in PLAY_REGIONS:
            total = math.fsum(mix_in(region, frame.expressions, frame.regions).values())
            self.worst_sum = max(self.worst_sum, abs(total - 1.0))


def measure(cast: omote.Cast, seed: int, count: int) -> tuple[dict[str, float], Layered, int, int]:
    """The largest change of step of each way, ours with its checks, hand-overs and frames."""
    rng = np.random.default_rng(seed)
    names = [name for name, title in cast.titles.items() if title.kind == "arkit" and not name.startswith("eyeLook")]
    names = [str(name) for name in rng.permutation(names)[:CHANNELS]]
    operator = Operator(rng)
    tracker = Tracker(rng)
    ours = Layered(cast, names, rng)
    operator.next_move = rng.exponential(MEAN_REST, CHANNELS)
    ways = {"last message wins": LastWins(), "linear fade": LinearFade(), "glide": Gliding(), "layers": ours}
    before = {name: [np.zeros(CHANNELS)] * 2 for name in ways}
    worst = dict.fromkeys(ways, 0.0)
    frames = 0
    sent = None
    while operator.count < count:
        now = frames / RATE
        sent = tracker.frame(now) if frames % 2 == 0 else None
        moves = operator.moves(now)
        for name, way in ways.items():
            shown = way.hear(sent, moves, operator.held, now)  # type: ignore[attr-defined]
            first, second = before[name]
            if frames > 2 * RATE:  # all begin at rest
                worst[name] = max(worst[name], float(np.abs(shown - 2.0 * second + first).max()))
            before[name] = [second, shown]
        frames += 1
    return worst, ours, operator.count, frames


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--count", type=int, default=COUNT)
    asked = parser.parse_args()
    seed = secrets.randbits(32) if asked.seed is None else asked.seed
    worst, ours, count, frames = measure(omote.load_cast(), seed, asked.count)
    table = Table(title=f"{count} hand-overs of {CHANNELS} channels in {frames} frames, seed {seed}")
    for column in ("way", "largest change of step", "of last message wins"):
        table.add_column(column)
    for name, value in worst.items():
        table.add_row(name, f"{value:.4f}", f"1/{worst['last message wins'] / value:.1f}")
    Console().print(table)
    share = worst["layers"] / worst["last message wins"]
    claims = (
        (f"change of step {share:.4f} of last message wins, at most {BAR:.4f}", share <= BAR),
        (f"{ours.outside} values out of range", ours.outside == 0),
        (f"weights of a region sum to one within {ours.worst_sum:.1e}", ours.worst_sum <= BAR_SUM),
    )
    for told, holds in claims:
        Console().print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
