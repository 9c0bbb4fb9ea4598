"""Ten thousand random interruptions of poses, ours beside the eased freeze on the same log (issue 34, item 3).

Each call brings one of the library's poses in .5 to 4 s (log-uniform); the next comes at a random moment inside it. The
freeze forgets the velocity that a call takes over. What is asked is the step of each joint's angular velocity at the
moment of the call, from turns .1 ms before and after it; the sums of rotation vectors never leave the box of the poses.
`--count N`, `--seed N`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.interruptions import Order, orders
from omote.builtin import load_figures
from omote.perform.axis import Axis, advanced, called, weights
from omote.perform.easing import DEFAULT_EASING

MOMENT = 1e-4
"""Seconds before and after a call."""
BAR = 1 / 16
"""Of the freeze's largest step."""
Values = NDArray[np.float64]


class Played:
    """An axis of poses through a log, with the freeze or without."""

    def __init__(self, turns: dict[str, Values], *, inertial: bool) -> None:
        self._turns = turns
        self._inertial = inertial
        self._axis = Axis(next(iter(turns)))
        self.most = 0.0
        self.outside = 0.0
        self._low = np.min([*turns.values()], axis=0)
        self._high = np.max([*turns.values()], axis=0)

    def step(self, wait: float, order: Order) -> None:
        """Plays on for `wait` seconds, then calls the next pose, and keeps the largest step of angular velocity."""
        before = self._turned(advanced(self._axis, wait - MOMENT))
        here = advanced(self._axis, wait)
        at = self._turned(here)
        self._axis = called(here, order.name, order.seconds, DEFAULT_EASING)
        if not self._inertial and self._axis.call is not None:
            self._axis = replace(self._axis, call=replace(self._axis.call, velocity={}, decay=0.0))
        after = self._turned(advanced(self._axis, MOMENT))
        kick = _rate(at, after) - _rate(before, at)
        self.most = max(self.most, float(np.linalg.norm(kick, axis=1).max()))

    def _turned(self, axis: Axis) -> Values:
        """The rotation vectors (J, 3) of a mix, radians; keeps how far any lies outside of the box of the poses."""
        mixed = sum((weight * self._turns[name] for name, weight in weights(axis).items()), np.zeros_like(self._low))
        self.outside = max(self.outside, float(np.maximum(self._low - mixed, mixed - self._high).max()))
        return np.asarray(mixed)


def _rate(one: Values, other: Values) -> Values:
    """Angular velocities (J, 3), radians a second, from one set of turns to another a moment later."""
    step = Rotation.from_rotvec(one).inv() * Rotation.from_rotvec(other)
    return np.asarray(step.as_rotvec()) / MOMENT


def main(words: Sequence[str] | None = None) -> int:
    """Prints the largest steps; 1 where ours is above its bar."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1993)
    asked = parser.parse_args(words)
    turns = {name: pose.turns for name, pose in load_figures().poses.items()}
    log = orders(np.random.default_rng(asked.seed), [*turns], asked.count)
    ours = Played(turns, inertial=True)
    freeze = Played(turns, inertial=False)
    since = 0.0
    for order in track(log, "interruptions", console=Console(stderr=True)):
        for played in (ours, freeze):
            played.step(order.time - since, order)
        since = order.time
    table = Table("", "step of angular velocity, rad/s", "outside of the poses' box, rad")
    for name, played in (("ours", ours), ("eased freeze", freeze)):
        table.add_row(name, f"{played.most:.3g}", f"{max(played.outside, 0.0):.3g}")
    share = ours.most / freeze.most
    Console().print(table, f"ours is 1/{1 / share:.0f} of the freeze's, at most 1/{1 / BAR:.0f}")
    return int(share > BAR)


if __name__ == "__main__":
    sys.exit(main())
