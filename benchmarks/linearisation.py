"""The error of a page's linearised preview of a drag against the server's solve.

While a control point is dragged, pages add tangents times field to each face (`model.tangents`); on release the true
compound takes its place. Every point of the default net is dragged by 5 and 10 mm in a random direction, the points
around it following as the editor's falloff has it, on six faces that do not resemble each other. Per drag, over the
vertices that move: the median of (distance between both) / (how far it moves). The bar: the median drag below a tenth.
"""

from __future__ import annotations

import os
import sys

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.controls.tangents import tangents
from omote.model.recipes.compose_expression import add_field
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound

FACES = ("generic", "kaori", "baby", "heavy", "dog", "noh")
STEPS = (0.005, 0.010)
FALLOFF = 0.03
MOVED = 2e-4
BAR = 0.1
SEED = 5

Values = NDArray[np.float64]


def drags(space: ParameterSpace, net_field: NetField, step: float) -> list[Values]:
    """One field (V, 3) per point: it goes `step` metres in a random direction, its neighbours by a bell of FALLOFF."""
    rows = np.array(net_field.rows)
    random = np.random.default_rng(SEED)
    radius = space.cylinder.unroll(space.points[rows])[2]
    found = []
    for point, row in enumerate(rows):
        way = random.normal(size=3)
        way *= step / np.linalg.norm(way)
        distance = np.linalg.norm(space.points[rows] - space.points[row], axis=1) / FALLOFF
        share = np.cos(np.minimum(distance, 1.0) * np.pi / 2) ** 2
        # Around the axis, up, away from the axis.
        vector = np.array([way[0] / radius[point], way[1], way[2] / radius[point]])
        vectors = share[:, None] * vector + [0.0, 0.0, 1.0]
        found.append(net_field.field(vectors))
    return found


def errors(space: ParameterSpace, face: Face, fields: list[Values]) -> Values:
    """Per drag: the median error of what moves, as a share of its way."""
    slope = tangents(space, face)
    found = []
    for field in fields:
        way = compound(space, face, add_field(space, None, field)).astype(np.float64) - face.positions
        far = np.linalg.norm(way, axis=1)
        moved = space.on_sheet & (far > MOVED)
        apart = np.linalg.norm(np.einsum("vk,kvc->vc", field, slope) - way, axis=1)
        found.append(float(np.median(apart[moved] / far[moved])) if moved.any() else 0.0)
    return np.array(found)


def main() -> int:
    """Prints the error per face and length of drag; 0 when the bar is met."""
    cast = omote.load_cast()
    net_field = build_net_field(cast.space, default_net(cast.space))
    table = Table(title="Pictures of a drag against its compound, share of the way", title_justify="left")
    for column in ("face", *(f"{1000 * step:g} mm: median, 90 %, worst" for step in STEPS)):
        table.add_column(column)
    medians = []
    for name in FACES:
        cells = []
        for step in STEPS:
            found = errors(cast.space, cast.faces[name], drags(cast.space, net_field, step))
            medians.append(float(np.median(found)))
            cells.append(f"{medians[-1]:.3f}  {np.quantile(found, 0.9):.3f}  {found.max():.3f}")
        table.add_row(name, *cells)
    Console(width=120).print(table)
    verdict = "met" if max(medians) < BAR else "MISSED"
    print(f"worst median {max(medians):.3f}; bar {BAR:g}: {verdict} ({BAR / max(medians):.1f} times inside)")
    return int(max(medians) >= BAR)


if __name__ == "__main__":
    sys.exit(main())
