"""Whether gums, teeth and lips hold together on every face, wearing every expression and sums of them (issue 10).

From 15 turns of the head (yaw to 60, pitch to 30 degrees), in millimetres:

* pierced: how deep teeth lie outside of the skin; buried: crowns in the walls of the mouth;
* bare: how far the edge of a gum that is seen ends from the mouth's lining: from a millimetre or two on, teeth float;
* hole: what of the open mouth is seen from behind or not at all, square millimetres;
* slit: how far one can look through between lips that are closed (faces at rest).

All expressions of the cast, sums of two to five units drawn anew (`--seed`), and heavy layers: sums at weights of 1.5.
The bars of the sums say in how many of a hundred a limit is passed. `--faces kaori,dog`, `--sums N`, `--heavy N`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.maps.mouth_views import MouthViews, Seen
from omote.builtin import load_cast
from omote.model.cast import NEUTRAL, Cast
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame

LIMITS: Mapping[str, float] = {"pierced": 0.3, "buried": 0.5, "bare": 2.0, "hole": 2.0}
"""Millimetres, square millimetres for holes."""
MOUTH = ("mouth", "jaw", "cheek", "nose", "tongue", "neck")
HEAVY = 1.5


@dataclass(frozen=True)
class Row:
    """One compound or sum on one face, and what was seen of it."""

    kind: str
    face: str
    worn: str
    seen: Seen


def sums(cast: Cast, count: int, rng: np.random.Generator, weight: float) -> list[dict[str, float]]:
    """Channels: two to five units of the mouth, by weight."""
    units = [
        name for name, title in cast.titles.items() if title.kind in ("arkit", "makehuman") and name.startswith(MOUTH)
    ]
    drawn = [rng.choice(units, rng.integers(2, 6), replace=False) for _ in range(count)]
    return [{str(name): weight for name in names} for names in drawn]


def measure(cast: Cast, faces: Sequence[str], wanted: Mapping[str, list[dict[str, float]]]) -> list[Row]:
    """Every face with every mix of channels, by their kind."""
    views, found = MouthViews(cast.space), list[Row]()
    for face in track(faces, "faces", console=Console(stderr=True)):
        for kind, mixes in wanted.items():
            for channels in mixes:
                frame = Frame({face: 1.0}, {NEUTRAL: 1.0}, channels)
                seen = views.look(evaluate(cast, frame).astype(np.float64), evaluate_parts(cast, frame))
                found.append(Row(kind, face, " + ".join(channels) or NEUTRAL, seen))
    return found


def show(title: str, rows: Sequence[Row], by: str) -> None:
    """Prints the worst, and in how many of a hundred a limit is passed, face by face or kind by kind."""
    table = Table(title=title, title_justify="left")
    table.add_column(by)
    for name, limit in LIMITS.items():
        table.add_column(f"{name}, worst", justify="right")
        table.add_column(f"over {limit:g}, %", justify="right")
        table.add_column("worst in")
    for group in dict.fromkeys(getattr(row, by) for row in rows):
        among = [row for row in rows if getattr(row, by) == group]
        cells = list[str]()
        for name in LIMITS:
            worst = max(among, key=lambda row: getattr(row.seen, name))
            cells += [
                f"{getattr(worst.seen, name):.2f}",
                f"{passed(among, name):.1f}",
                f"{worst.face} {worst.worn}"[:30],
            ]
        table.add_row(group, *cells)
    Console(width=200).print(table)


def passed(rows: Sequence[Row], name: str) -> float:
    """In how many of a hundred rows a limit is passed."""
    return 100.0 * float(np.mean([getattr(row.seen, name) > LIMITS[name] for row in rows])) if rows else 0.0


BARS: Mapping[str, Mapping[str, float]] = {
    "units": {"pierced": 0.0, "buried": 3.0, "bare": 1.0, "hole": 2.0},
    "sums": {"pierced": 2.0, "buried": 10.0, "bare": 2.0, "hole": 5.0},
    "heavy": {"pierced": 5.0, "buried": 20.0, "bare": 5.0, "hole": 10.0},
}
"""In how many of a hundred a limit may be passed."""


def verdict(rows: Sequence[Row]) -> bool:
    """Prints the bars; whether all hold."""
    table, held = Table(title="bars", title_justify="left"), True
    for column in ("bar", "found", "allowed", "met"):
        table.add_column(column)
    bars = [
        (f"{kind}: {name} over {LIMITS[name]:g}, of a hundred", passed(among, name), most)
        for kind, limits in BARS.items()
        if (among := [row for row in rows if row.kind == kind])
        for name, most in limits.items()
    ]
    bars.append(("slit at rest, mm", max(row.seen.slit for row in rows if row.worn == NEUTRAL), 0.0))
    for bar, found, most in bars:
        held &= found <= most
        table.add_row(bar, f"{found:.2f}", f"{most:g}", "yes" if found <= most else "NO")
    Console(width=120).print(table)
    return held


def main() -> int:
    """Measures, prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--faces", default="")
    parser.add_argument("--sums", type=int, default=30)
    parser.add_argument("--heavy", type=int, default=10)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    given = parser.parse_args()
    print(f"seed {given.seed}")
    cast, rng = load_cast(), np.random.default_rng(given.seed)
    faces = [name for name in given.faces.split(",") if name] or list(cast.faces)
    units = [{}, *({name: 1.0} for name in cast.expressions if name != NEUTRAL)]
    wanted = {"units": units, "sums": sums(cast, given.sums, rng, 1.0), "heavy": sums(cast, given.heavy, rng, HEAVY)}
    rows = measure(cast, faces, wanted)
    for kind in wanted:
        show(kind, [row for row in rows if row.kind == kind], "face")
    show("all", rows, "kind")
    return 0 if verdict(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
