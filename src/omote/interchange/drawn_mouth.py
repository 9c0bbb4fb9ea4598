"""Teeth, gums and tongue of an exported head as stages draw them, and the rows of the cast that they come from.

Each row is kept as a triangle of no area, which nothing draws: so a head that another program has shaped brings its
rows back, and what is drawn of the mouth needs no inverse.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Indices, Points, Rows, Values
from omote.geometry import mesh
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.interchange.formats.glb_writer import NO_ROW
from omote.interchange.part_textures import ARCH, ARCH_DEPTH, tongue_uv
from omote.interchange.teeth_sheet import COLUMNS, TeethSheet, cage_columns, teeth_sheet
from omote.interchange.tooth_profiles import TEETH
from omote.model.cast import Look
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.gum_line import GUMS

TONGUE = "tongue"
OPENING = 8e-4
"""Square metres of an open mouth, through which light comes in."""
DEEPEST = 0.3
"""What is left of the light where none comes in straight."""
FURROW = 0.0014
FURROW_WIDTH = 0.0026
THINNER = 0.0012
THINNER_BEHIND = 0.0026
"""Of a tongue, metres: its furrow's depth and half its width; how much thinner its sides are at the tip, and how much
more at the root (web/src/face/head/tongue.ts)."""
SINKS = 0.30
ROOT_SINKS = 0.25
SIDES_SINK = 0.16
OPENS = (0.06, 0.6)
OWN = (0.08, 0.2)
"""How far a tongue that does nothing of its own lies down in an open jaw, in widths of the arch, how much less its root
and how much more its sides; between which gaps of the edges it does so, and how far its tip has left its place where it
does not (`sunk` in web/src/face/head/mouth_shaders.ts)."""
Parts = Mapping[str, NDArray[np.floating]]


@dataclass(frozen=True, eq=False)
class DrawnPart:
    """A part of the mouth as it is drawn, with the rows of the cast at its end.

    rows (m,): of the cast, NO_ROW for what is drawn alone; triangles (t, 3); uv (m, 2): for the picture of such a part;
    shade (m,): what is left of the light.
    """

    rows: Rows
    triangles: Indices
    uv: Floats
    shade: Floats


class DrawnMouth:
    """The mouth of a head as stages draw it; `parts` is empty where it has no teeth in columns, or no look is given.

    space: of the head; look: whose teeth they are; None for the rows alone.
    """

    def __init__(self, space: ParameterSpace, look: Look | None) -> None:
        self.parts: dict[str, DrawnPart] = {}
        self._sheets: dict[str, TeethSheet] = {}
        points = {name: part.points for name, part in space.parts.items()}
        for name in GUMS:
            if look is None or name not in points:
                continue
            sheet = teeth_sheet(points[name], upper=_is_upper(name), look=look)
            if sheet is not None:
                self._sheets[name] = sheet
                self.parts[name] = _teeth(sheet, points[name])
        if len(self._sheets) == len(GUMS) and TONGUE in points:
            self._tongue = _Tongue(points, space.parts[TONGUE].triangles)
            at = points[TONGUE]
            uv = tongue_uv(at).astype(np.float64)
            self.parts[TONGUE] = _with_rows(len(at), space.parts[TONGUE].triangles, uv, _shade(at))

    def draw(self, meshes: Parts) -> dict[str, Points]:
        """Meshes of a head (n, 3), those of its mouth as they are drawn (m, 3), metres."""
        drawn = {name: np.asarray(points, np.float64) for name, points in meshes.items()}
        for name in self.parts:
            rows = drawn[name]
            own = self._tongue.place(meshes) if name == TONGUE else self._sheets[name].weights @ rows
            drawn[name] = np.concatenate([own, np.repeat(rows, 3, axis=0)])
        return drawn


class _Tongue:
    """The cast's tongue with a furrow and thin sides, which lies down in an open jaw."""

    def __init__(self, points: Mapping[str, Points], triangles: Indices) -> None:
        self._triangles = triangles
        at = points[TONGUE]
        self._tip = int(at[:, 2].argmax())
        self._behind = (at[self._tip, 2] - at[:, 2]) / ARCH_DEPTH
        normal = mesh.normals(at, triangles)
        thin = THINNER + THINNER_BEHIND * np.minimum(self._behind, 1.0)
        furrow = FURROW * np.exp(-((at[:, 0] / FURROW_WIDTH) ** 2)) * np.maximum(normal[:, 1], 0.0)
        self._over = -furrow - thin * normal[:, 0] ** 2
        aside = np.minimum((at[:, 0] / ARCH) ** 2, 1.0)
        self._sinks = SINKS * (1.0 - ROOT_SINKS * clamp_unit(self._behind)) + SIDES_SINK * aside
        columns = {name: cage_columns(points[name], upper=_is_upper(name)) for name in GUMS}
        upper, lower = (columns[name] for name in GUMS)
        assert upper is not None
        assert lower is not None
        middle = (COLUMNS - 1) // 2
        self._upper_edge = int(upper[middle, 2])
        self._jaw = (lower[middle, 0], lower[middle, 2], lower[0, 2], lower[-1, 2])
        self._rest = self._tip_place(points)[0]

    def place(self, parts: Parts) -> Points:
        """Its vertices (n, 3), metres."""
        at = np.asarray(parts[TONGUE], np.float64)
        own, up, width = self._tip_place(parts)
        upper, lower = (np.asarray(parts[name], np.float64) for name in GUMS)
        gap = (upper[self._upper_edge, 1] - lower[self._jaw[1], 1]) / width
        still = 1.0 - float(smooth_ramp(*OWN, np.asarray(np.linalg.norm(own - self._rest))))
        down = width * float(smooth_ramp(*OPENS, gap)) * still * self._sinks
        placed: Points = at + still * self._over[:, None] * mesh.normals(at, self._triangles) - down[:, None] * up
        return placed

    def _tip_place(self, parts: Parts) -> tuple[Values, Values, float]:
        """Where the tip lies in the jaw, up and ahead of its edge in widths of the arch, (2,); the jaw's way up, (3,);
        the arch's width, metres."""
        lower = np.asarray(parts[_LOWER], np.float64)
        gum, edge, right, left = (lower[row] for row in self._jaw)
        up = (edge - gum) / np.linalg.norm(edge - gum)
        ahead = edge - 0.5 * (right + left)
        ahead /= np.linalg.norm(ahead)
        width = float(np.linalg.norm(right - left))
        tip = parts[TONGUE][self._tip] - edge
        return np.array([tip @ up, tip @ ahead]) / width, up, width


_LOWER = next(name for name, way in GUMS.items() if way < 0.0)


def _is_upper(name: str) -> bool:
    return GUMS[name] > 0.0


def _teeth(sheet: TeethSheet, rows: Points) -> DrawnPart:
    uv = np.column_stack([sheet.numbers / (2.0 * TEETH), 0.5 - 0.5 * sheet.heights])
    return _with_rows(len(rows), sheet.triangles, uv, _shade(sheet.weights @ rows))


def _shade(points: Points) -> Values:
    """What is left of the light on points (n, 3) of an open mouth: by how large its opening looks from there."""
    behind = points[:, 2].max() - points[:, 2]
    left: Values = DEEPEST + (1.0 - DEEPEST) * OPENING / (OPENING + 6.0 * behind**2)
    return left


def _with_rows(count: int, triangles: Indices, uv: Values, shade: Values) -> DrawnPart:
    """A part and so many rows behind it, each a triangle of no area."""
    drawn = len(uv)
    apart = drawn + np.arange(3 * count).reshape(count, 3)
    return DrawnPart(
        np.concatenate([np.full(drawn, NO_ROW), np.repeat(np.arange(count), 3)]),
        np.concatenate([triangles, apart]).astype(np.int32),
        np.concatenate([uv, np.zeros((3 * count, 2))]).astype(np.float32),
        np.concatenate([shade, np.ones(3 * count)]).astype(np.float32),
    )
