"""Figures of a stage beside a peer's of the same run, as ratios, and their bars."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

from benchmarks.peers.frame_costs import LEVELS, PEER, ROUGH, SHADED

Values = NDArray[np.float64]

SHARES = {"lowest": 1 / 6, "low": 1 / 3}
"""What a frame of a level may cost at most, of the peer's."""
STEP = 4.0
"""How often the frame of the level below a level's may cost at most."""
BUDGETS = {"lowest": 1.0, "low": 1.5, "medium": 3.0, "good": 5.0, "high": 1000 / 120}
"""Milliseconds of a frame with a graphics processor; the best level has half of a refresh at 60 Hz."""
SOFTWARE = re.compile("llvmpipe|swiftshader|software|basic render", re.IGNORECASE)


@dataclass(frozen=True)
class Comparison:
    """What of ours lies beside what of theirs, milliseconds a run each, and how much of theirs it may be at most."""

    name: str
    ours: Sequence[float] | Values
    beside: str
    theirs: Sequence[float] | Values
    most: float | None = None

    @property
    def ratio(self) -> float:
        """The median of the runs' ratios: what else the machine did in a run fell on both."""
        return float(np.median(np.asarray(self.ours) / np.asarray(self.theirs)))

    @property
    def holds(self) -> bool:
        """Whether the bar is kept."""
        return self.most is None or self.ratio <= self.most


def level_comparisons(costs: Mapping[str, Sequence[float]], renderer: str) -> list[Comparison]:
    """Every level beside the peer and beside the level below; with a graphics processor beside its budget too."""
    peers = [Comparison(f"a frame, {name}", costs[name], PEER, costs[PEER]) for name in (SHADED, ROUGH)]
    shares = [Comparison(f"a frame, {name}", costs[name], PEER, costs[PEER], SHARES.get(name)) for name in LEVELS]
    steps = [
        Comparison(f"a frame, {above}", costs[above], below, costs[below], STEP) for below, above in pairwise(LEVELS)
    ]
    if SOFTWARE.search(renderer):
        return [*peers, *shares, *steps]
    budgets = [Comparison(f"a frame, {name}", costs[name], "budget", [most], 1.0) for name, most in BUDGETS.items()]
    return [*peers, *shares, *steps, *budgets]


def verdict(title: str, rows: Sequence[Comparison]) -> bool:
    """Prints the figures beside their bars; whether all hold."""
    table = Table(title=title, title_justify="left")
    for column in ("what", "ms (median)", "beside", "its ms", "ratio (median)", "bar", "holds"):
        table.add_column(column)
    for row in rows:
        ours, theirs = (f"{np.median(values):.1f}" for values in (row.ours, row.theirs))
        bar, holds = ("", "") if row.most is None else (f"<= {row.most:.3g}", "yes" if row.holds else "NO")
        table.add_row(row.name, ours, row.beside, theirs, f"{row.ratio:.3f}", bar, holds)
    Console(width=130).print(table)
    return all(row.holds for row in rows)
