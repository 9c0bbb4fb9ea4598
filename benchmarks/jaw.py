"""Teeth out of the skin where two sources open one jaw, on every face: as sums of fields, and as one jaw opens.

The rows of the cast's teeth by both rules, and of one jaw the teeth and gums that stages draw in them, which end short
of the rows' lower edge.

24 sums that people make: six performed expressions and the jaw's fader at a half, whole and at its most; four of them
with the fader of `mouth-open`, and both faders. Depths in millimetres. Then `--random N` sums of two to five units of
the mouth, of one jaw and as drawn alone, with what they turn over and no unit of theirs does.
`--faces kaori,dog`, `--made N` (faces made here as an editor makes them), `--fits N` (faces of heads from public
sources: one of Lee Perry-Smith's scan, the others of people of ICT-FaceKit), `--seed`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import omote
from benchmarks.maps.inside.mouth_views import MouthViews
from benchmarks.maps.measures import find_folds
from benchmarks.mouths import made_faces
from benchmarks.mouths import sums as draw_sums
from benchmarks.scans import ict_people, perry_smith
from omote.builtin import load_cast
from omote.interchange.drawn_mouth import DrawnMouth
from omote.interchange.formats.glb_writer import NO_ROW
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.space.face import Face
from omote.model.transfer.gum_line import GUMS
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame

WORN = ("laugh", "joy", "shout", "surprise", "cry", "mouth-open")
Values = NDArray[np.float64]
Parts = Mapping[str, NDArray[np.floating]]
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


def measure(cast: Cast, faces: Sequence[str]) -> list[Row]:
    """Every sum on every face."""
    views = MouthViews(cast.space)
    found = list[Row]()
    for face in track(faces, "faces", console=Console(stderr=True)):
        drawn = DrawnTeeth(cast, face)
        for worn, channels in SUMS:
            frame = Frame({face: 1.0}, {worn: 1.0}, channels)
            skin = evaluate(cast, frame).astype(np.float64)
            parts = evaluate_parts(cast, frame)
            with patch("omote.perform.blending.evaluate.saturate", lambda _cast, _frame, weights: weights):
                summed = _pierced(cast, views, evaluate(cast, frame).astype(np.float64), evaluate_parts(cast, frame))
            name = " + ".join([worn, *(f"{channel} {weight:g}" for channel, weight in channels.items())])
            one_jaw = _pierced(cast, views, skin, parts)
            found.append(Row(face, name, summed, one_jaw, 1e3 * views.measure_pierced(skin, drawn.triangles(parts))))
    return found


def _pierced(cast: Cast, views: MouthViews, skin: Values, parts: Parts) -> float:
    rows = [parts[name][cast.space.parts[name].triangles].astype(np.float64) for name in GUMS]
    return 1e3 * views.measure_pierced(skin, np.concatenate(rows))


class DrawnTeeth:
    """The teeth and gums that stages draw on a face."""

    def __init__(self, cast: Cast, face: str) -> None:
        self._mouth = DrawnMouth(cast.space, cast.looks[face])
        self._own = {
            name: part.triangles[(part.rows[part.triangles] == NO_ROW).all(axis=1)]
            for name, part in self._mouth.parts.items()
            if name in GUMS
        }

    def triangles(self, parts: Parts) -> Values:
        """Their triangles (t, 3, 3), metres, by the parts of a frame."""
        drawn = self._mouth.draw(parts)
        return np.concatenate([drawn[name][triangles] for name, triangles in self._own.items()])


@dataclass(frozen=True)
class RandomSum:
    """A sum of units on a face: how deep drawn teeth lie outside of the skin, millimetres, and how many triangles of
    the sheet it turns over that no unit of it does alone."""

    face: str
    worn: str
    drawn: float
    folds: int


def measure_random(cast: Cast, faces: Sequence[str], count: int, rng: np.random.Generator) -> list[RandomSum]:
    """Sums of two to five units of the mouth, other ones on each face, about so many in all."""
    views = MouthViews(cast.space)
    sheet = cast.space.sheet_triangles
    found = list[RandomSum]()
    for face in track(faces, "random sums", console=Console(stderr=True)):
        teeth = DrawnTeeth(cast, face)
        rest = cast.faces[face].positions.astype(np.float64)
        alone: dict[str, NDArray[np.bool_]] = {}

        def wear(channels: Mapping[str, float], face: str = face) -> tuple[Values, Parts]:
            frame = Frame({face: 1.0}, {NEUTRAL: 1.0}, channels)
            return evaluate(cast, frame).astype(np.float64), evaluate_parts(cast, frame)

        for channels in draw_sums(cast, -(-count // len(faces)), rng, 1.0):
            for unit in channels.keys() - alone.keys():
                alone[unit] = find_folds(rest, wear({unit: 1.0})[0], sheet)
            skin, parts = wear(channels)
            folded = find_folds(rest, skin, sheet) & ~np.any([alone[unit] for unit in channels], axis=0)
            depth = 1e3 * views.measure_pierced(skin, teeth.triangles(parts))
            found.append(RandomSum(face, " + ".join(channels), depth, int(folded.sum())))
    return found


def fitted_faces(cast: Cast, count: int, seed: int) -> dict[str, Face]:
    """So many fits of heads from public sources: of Lee Perry-Smith's scan, and of people of ICT-FaceKit."""
    points, triangles = perry_smith.read_scan()
    scan = omote.fit(cast.space, points, triangles, landmarks=perry_smith.clicks(points), shut=True)
    found = {"Perry-Smith": scan.face}
    model = ict_people.read_model()
    for number in range(1, count):
        person = model.draw((seed, number))
        fit = omote.fit(cast.space, person, model.triangles, landmarks=model.clicks(person))
        found[f"ICT {number}"] = fit.face
    return {name: replace(face, name=name) for name, face in found.items()}


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


def show_random(rows: Sequence[RandomSum]) -> None:
    """Prints, face by face, in how many drawn teeth are over the limit, what is turned over, and the worst."""
    table = Table(title="random sums", title_justify="left")
    for column in ("face", "sums", f"drawn, over {LIMIT:g}", "worst", "in", "with new folds", "triangles"):
        table.add_column(column)
    for group in [*dict.fromkeys(row.face for row in rows), "all"]:
        among = [row for row in rows if group in (row.face, "all")]
        worst = max(among, key=lambda row: row.drawn)
        out = sum(row.drawn > LIMIT for row in among)
        folded = sum(row.folds > 0 for row in among)
        counts = (len(among), out, f"{worst.drawn:.2f}", worst.worn, folded, sum(row.folds for row in among))
        table.add_row(group, *map(str, counts))
    Console(width=200).print(table)


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--faces", default="")
    for name in ("made", "fits", "random"):
        parser.add_argument(f"--{name}", type=int, default=0)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    given = parser.parse_args()
    print(f"seed {given.seed}")
    cast = load_cast()
    rng = np.random.default_rng(given.seed)
    others = made_faces(cast, given.made, rng)
    if given.fits:
        others |= fitted_faces(cast, given.fits, given.seed)
    looks = {**cast.looks, **dict.fromkeys(others, cast.looks["generic"])}
    whole = replace(cast, faces={**cast.faces, **others}, looks=looks)
    faces = [name for name in given.faces.split(",") if name] or list(cast.faces)
    faces += [name for name in others if name not in faces]
    rows = measure(whole, faces)
    show("by sum", rows, "worn")
    show("by face", rows, "face")
    if given.random:
        show_random(measure_random(whole, faces, given.random, rng))


if __name__ == "__main__":
    main()
