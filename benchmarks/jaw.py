"""Teeth out of the skin where two sources open one jaw, on every face: as sums of fields, and as one jaw opens.

The rows of the cast's teeth by both rules, and of one jaw the teeth and gums that stages draw in them, which end short
of the rows' lower edge.

24 sums that people make: six performed expressions and the jaw's fader at a half, whole and at its most; four of them
with the fader of `mouth-open`, and both faders. Depths in millimetres, from straight ahead and turned heads.
`--faces kaori,dog`, `--made N` (faces made here as an editor makes them), `--turns N`, `--seed`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from unittest.mock import patch

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.maps.inside.mouth_views import TURNS, MouthViews
from benchmarks.mouths import made_faces
from omote.builtin import load_cast
from omote.interchange.drawn_mouth import DrawnMouth
from omote.interchange.formats.glb_writer import NO_ROW
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.transfer.gum_line import GUMS
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame

WORN = ("laugh", "joy", "shout", "surprise", "cry", "mouth-open")
FADER = (0.5, 1.0, 1.5)
SUMS: Sequence[tuple[str, Mapping[str, float]]] = (
    *((worn, {"jawOpen": weight}) for worn in WORN for weight in FADER),
    *((worn, {"mouth-open": 1.0}) for worn in WORN[:4]),
    (NEUTRAL, {"jawOpen": 1.0, "mouth-open": 0.5}),
    (NEUTRAL, {"jawOpen": 1.0, "mouth-open": 1.0}),
)
LIMIT = 0.3
"""Millimetres that an eye passes over (benchmarks/mouths.py)."""


@dataclass(frozen=True)
class Row:
    """How deep teeth lie outside of the skin of a sum on a face, millimetres: rows by both rules, and what is drawn."""

    face: str
    worn: str
    summed: float
    one_jaw: float
    drawn: float


def measure(cast: Cast, faces: Sequence[str], turns: Sequence[tuple[int, int]]) -> list[Row]:
    """Every sum on every face."""
    views = MouthViews(cast.space)
    found = list[Row]()
    for face in track(faces, "faces", console=Console(stderr=True)):
        mouth = DrawnMouth(cast.space, cast.looks[face].fur)
        for worn, channels in SUMS:
            frame = Frame({face: 1.0}, {worn: 1.0}, channels)
            one_jaw = _pierced(cast, views, frame, turns)
            drawn = _pierced_as_drawn(cast, views, frame, mouth)
            with patch("omote.perform.blending.evaluate.saturate", lambda _cast, _frame, weights: weights):
                summed = _pierced(cast, views, frame, turns)
            name = " + ".join([worn, *(f"{channel} {weight:g}" for channel, weight in channels.items())])
            found.append(Row(face, name, summed, one_jaw, drawn))
    return found


def _pierced(cast: Cast, views: MouthViews, frame: Frame, turns: Sequence[tuple[int, int]]) -> float:
    skin = evaluate(cast, frame).astype(np.float64)
    return views.look(skin, evaluate_parts(cast, frame), turns).pierced


def _pierced_as_drawn(cast: Cast, views: MouthViews, frame: Frame, mouth: DrawnMouth) -> float:
    skin = evaluate(cast, frame).astype(np.float64)
    drawn = mouth.draw(evaluate_parts(cast, frame))
    own = {
        name: (part.triangles, (part.rows[part.triangles] == NO_ROW).all(axis=1)) for name, part in mouth.parts.items()
    }
    teeth = [drawn[name][own[name][0][own[name][1]]] for name in GUMS]
    return 1e3 * views.measure_pierced(skin, np.concatenate(teeth))


def show(title: str, rows: Sequence[Row], by: str) -> None:
    """Prints how many are over the limit and the worst, by each measure."""
    table = Table(title=title, title_justify="left")
    for column in (
        by,
        "sums",
        f"summed, over {LIMIT:g}",
        "worst",
        f"one jaw, over {LIMIT:g}",
        "worst",
        "drawn",
        "worst",
    ):
        table.add_column(column, justify="left" if column == by else "right")
    for group in [*dict.fromkeys(getattr(row, by) for row in rows), "all"]:
        among = [row for row in rows if group in (getattr(row, by), "all")]
        cells = [str(len(among))]
        for depths in ([row.summed for row in among], [row.one_jaw for row in among], [row.drawn for row in among]):
            cells += [str(sum(depth > LIMIT for depth in depths)), f"{max(depths):.2f}"]
        table.add_row(group, *cells)
    Console(width=140).print(table)


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--faces", default="")
    parser.add_argument("--made", type=int, default=0)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    given = parser.parse_args()
    print(f"seed {given.seed}")
    cast = load_cast()
    rng = np.random.default_rng(given.seed)
    made = made_faces(cast, given.made, rng)
    others = [turn for turn in TURNS if turn != (0, 0)]
    turns = [(0, 0), *(others[at] for at in rng.choice(len(others), given.turns - 1, replace=False))]
    looks = {**cast.looks, **dict.fromkeys(made, cast.looks["generic"])}
    whole = replace(cast, faces={**cast.faces, **made}, looks=looks)
    rows = measure(whole, [name for name in given.faces.split(",") if name] or list(whole.faces), turns)
    show("by sum", rows, "worn")
    show("by face", rows, "face")


if __name__ == "__main__":
    main()
