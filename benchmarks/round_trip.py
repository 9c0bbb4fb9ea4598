"""There and back: every unit on every face of the cast, with the paper's map and nothing stored beside the field.

What is applied is what is measured: each of the 86 units is worn by a face, the displacement extracted on that face,
and the new expression applied to it again. Vertices whose walk did not end in a triangle are counted apart.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

import omote
from omote.model.cast import Cast
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import compound, compound_parts, turn_eyes
from omote.model.transfer.paper_map import compile_expression, project_to_surface

BAR_SHEET = 0.001
BAR_REST = 0.1
BAR_INSIDE = 0.99
"""Millimetres on the sheet, millimetres of inner skin and parts, share of moved vertices whose walks ended inside."""
MOVED = 1e-6


@dataclass
class Found:
    """The worst of a face, millimetres, and what was counted."""

    inside: float = 0.0
    outside: float = 0.0
    inner: float = 0.0
    parts: float = 0.0
    moved: int = 0
    landed: int = 0
    shares: list[float] = field(default_factory=list)


def measure(cast: Cast, face: Face, expression: Expression, found: Found) -> None:
    """Adds one unit on one face to what was found."""
    space = cast.space
    fitted = fit(cast.space, face)
    worn = compound(space, face, expression).astype(np.float64)
    displacement = worn - face.positions
    parts = turn_eyes(space, compound_parts(space, face, expression), fitted.centres, expression.eyes)
    moves = {name: parts[name].astype(np.float64) - fitted.parts[name] for name in parts}
    again = extract(space, face, displacement, parts=moves)
    error = 1000 * np.linalg.norm(compound(space, face, again) - worn, axis=1)
    vertices = np.flatnonzero(space.on_sheet & (np.linalg.norm(displacement, axis=1) > MOVED)).astype(np.int32)
    landing = project_to_surface(space, face.positions.astype(np.float64), worn[vertices], vertices)
    inside = landing.inside & compile_expression(space, again).inside[vertices]
    found.moved += len(vertices)
    found.landed += int(inside.sum())
    found.shares.append(inside.mean() if len(vertices) else 1.0)
    found.inside = max(found.inside, error[vertices[inside]].max(initial=0.0))
    found.outside = max(found.outside, error[vertices[~inside]].max(initial=0.0))
    found.inner = max(found.inner, error[space.inner.vertices].max())
    back = turn_eyes(space, compound_parts(space, face, again), fitted.centres, again.eyes)
    found.parts = max(found.parts, *(1000 * float(np.abs(back[name] - parts[name]).max()) for name in parts))


def main() -> int:
    """Prints the table; 0 when every bar is held."""
    cast = omote.load_cast().under("paper")
    console = Console(width=120)
    units = {
        name: cast.expressions[name] for name, title in cast.titles.items() if title.kind in ("arkit", "makehuman")
    }
    table = Table(title=f"Extract, then apply: {len(units)} units on {len(cast.faces)} faces (errors in mm)")
    for column in ("face", "landed", "of moved", "least unit", "sheet", "not landed", "inner skin", "parts", "held"):
        table.add_column(column, justify="left" if column == "face" else "right")
    held = len(units) == 86
    for face in track(list(cast.faces.values()), "faces", console=console):
        found = Found()
        for expression in units.values():
            measure(cast, face, expression, found)
        share = found.landed / found.moved
        good = share >= BAR_INSIDE and found.inside <= BAR_SHEET and max(found.inner, found.parts) <= BAR_REST
        held &= good
        lost = f"{found.moved - found.landed}, {found.outside:.3f}"
        cells = f"{share:.4f}", str(found.moved), f"{min(found.shares):.4f}", f"{found.inside:.6f}", lost
        table.add_row(face.name, *cells, f"{found.inner:.5f}", f"{found.parts:.5f}", "yes" if good else "NO")
    console.print(table)
    console.print(f"bars: landed >= {BAR_INSIDE}, sheet <= {BAR_SHEET} mm, inner skin and parts <= {BAR_REST} mm")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
