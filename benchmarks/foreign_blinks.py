"""How far imported blinks leave eyes open: heads of files given, and random people of ICT-FaceKit where it is at hand.

Each head is fitted, and its blinks (shapes with "blink" in their names) are taken as expressions. Open, of the opening
at rest, over the whole eye and in each fifth of the slit from the nose outward:

* source: what somebody ahead of the eye sees between the lids of the stranger's own head
* worn: the rungs between the lids of the fitted face, and of faces of the cast that wear it
* folds: triangles of the sheet that it turns over there

    python -m benchmarks.foreign_blinks head.glb folder-with-Neutral.obj ... [--people 2] [--seed 7]
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

from benchmarks.scans.ict_people import at_hand, read_model, read_shapes
from omote.builtin import load_cast
from omote.builtin.own_face import fit_scan
from omote.geometry import mesh
from omote.model.cast import Cast
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.lids.scan_slits import find_slit
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_skin import keep_skin
from omote.model.fitting.scan_surface import face_outward, sample_mesh, whole_sheets
from omote.model.fitting.take_expressions import take_expressions
from omote.model.space.face import Face
from omote.model.space.lid_lip_lines import Line
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.smooth_map import prepare_smooth_map
from omote.server.sandbox.scan_files import read_scan_in_sandbox

Values = NDArray[np.float64]
MOST = 0.05
PARTS = 5
WEARERS = ("kaori", "old", "baby", "dog")
AROUND = 0.03


def read_heads(paths: list[Path], people: int, seed: int) -> Iterator[tuple[str, Scan, dict[str, Values]]]:
    """The names, heads with their blinks, and clicks."""
    for path in paths:
        if path.is_dir():
            rest = read_scan_in_sandbox(path / "Neutral.obj").scan
            shapes = {
                each.stem: read_scan_in_sandbox(each).scan.positions - rest.positions
                for each in sorted(path.glob("*link*.obj"))
            }
            yield path.name, replace(rest, shapes=shapes), {}
        else:
            scan = read_scan_in_sandbox(path).scan
            yield path.stem, replace(scan, shapes=_blinks(dict(scan.shapes))), {}
    for number in range(people if at_hand() else 0):
        model = read_model()
        person = model.draw((seed, number))
        yield f"person {number}", Scan(person, model.triangles, shapes=_blinks(read_shapes())), model.clicks(person)


def _blinks(shapes: dict[str, Values]) -> dict[str, Values]:
    return {name: moves for name, moves in shapes.items() if "blink" in name.lower()}


def shared_out(line: Line, opening: Values, lengths: Values) -> list[float]:
    """The mean of openings (RUNGS,) over the whole slit and its fifths from the nose outward, long rungs counting
    more; nan is left out."""
    parts = np.array_split(np.arange(len(opening)), PARTS)
    rows = [np.arange(len(opening)), *(parts if line.name == "lid_left" else parts[::-1])]
    weights = np.where(np.isfinite(opening), lengths, 0.0)
    return [float(np.nan_to_num(opening)[row] @ weights[row] / max(weights[row].sum(), 1e-9)) for row in rows]


def look_at_source(cast: Cast, fitted: Fit, scan: Scan, line: Line, name: str) -> list[float]:
    """What the stranger's own blink leaves open."""
    space = cast.space
    skin = fitted.face.positions.astype(np.float64)
    points = fitted.placement(scan.positions)
    triangles = np.asarray(scan.triangles)
    sampled = sample_mesh(points, triangles, np.stack([skin.min(axis=0), skin.max(axis=0)]), AROUND)
    outward = face_outward(sampled, (skin, mesh.normals(skin, space.triangles)))
    surface = keep_skin(outward, head_zones(space), skin)
    slit = find_slit(line, skin, points, triangles[whole_sheets(points, triangles, surface)])
    turn = fitted.placement.scale * fitted.placement.rotation
    return shared_out(line, slit.remains(points + scan.shapes[name] @ turn.T), slit.lengths)


def look_at_face(cast: Cast, face: Face, line: Line, worn: Values) -> tuple[list[float], int]:
    """What a face that wears a blink leaves open, and the folds."""
    rest = face.positions.astype(np.float64)
    rungs = line.rungs(rest)
    lengths = np.linalg.norm(rungs, axis=1)
    opening = (rungs * line.rungs(worn)).sum(axis=1) / lengths**2
    folds = find_folds(prepare_smooth_map(cast.space, face).geometry, worn, rest)
    return shared_out(line, opening, lengths), int(folds.sum())


def main() -> int:
    """Prints a table; 0 when blinks that shut the stranger's eye shut ours."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("heads", nargs="*", type=Path)
    parser.add_argument("--people", type=int, default=2)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    options = parser.parse_args()
    cast = load_cast()
    console = Console(width=140)
    table = Table(title=f"open, of the opening at rest; fifths from the nose outward; seed {options.seed}")
    for column in ("head", "blink", "of", "whole", "1", "2", "3", "4", "5", "folds"):
        table.add_column(column)
    worst = 0.0
    for head, scan, clicks in read_heads(options.heads, options.people, options.seed):
        _, fitted = fit_scan(cast.space, scan, landmarks=clicks, name=head)
        taken = take_expressions(cast.space, fitted, scan)
        console.print(f"{head}: notes {taken.notes}")
        for name, expression in taken.expressions.items():
            for line in (line for line in cast.space.lines if line.kind == "lids"):
                source = look_at_source(cast, fitted, scan, line, name)
                if source[0] > 0.5:
                    continue  # the other eye's
                table.add_row(head, name, "source", *(f"{each:.3f}" for each in source), "")
                for face in (fitted.face, *(cast.faces[each] for each in WEARERS)):
                    shares, folds = look_at_face(cast, face, line, compound(cast.space, face, expression).astype(float))
                    table.add_row("", "", face.name, *(f"{each:.3f}" for each in shares), str(folds))
                    worst = max(worst, *shares)
    console.print(table)
    console.print(f"worst {worst:.3f}, allowed {MOST}")
    return 0 if worst <= MOST else 1


if __name__ == "__main__":
    sys.exit(main())
