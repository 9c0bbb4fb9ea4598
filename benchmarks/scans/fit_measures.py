"""How far a fit is from the true skin, region by region, and whether the same vertex is the same place of everybody."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

from benchmarks.maps.measures import Creases
from benchmarks.scans.ict_people import SCLERA, Model
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.fitted_eyes import fit_sphere
from omote.model.fitting.head_zones import head_zones
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]
MILLIMETRE = 1000.0
FOLDED = np.deg2rad(150.0)
"""An edge whose triangles bend by more lies folded."""
FACE = "face"
PLAIN = "without lids, lips, nostrils"
LIDS = "lids"
LIPS = "lips"
NO_LIDS = "without lids"


# trimesh has no types for either.
_closest_point: Any = trimesh.proximity.closest_point
_barycentric: Any = trimesh.triangles.points_to_barycentric


def regions(space: ParameterSpace, /) -> dict[str, Mask]:
    """The vertices (V,) that are measured, by region."""
    zones = head_zones(space)
    plain = zones.face & ~zones.lids & ~zones.lips & ~zones.nostrils
    return {FACE: zones.face, PLAIN: plain, LIDS: zones.lids, LIPS: zones.lips, NO_LIDS: zones.face & ~zones.lids}


@dataclass(frozen=True, eq=False)
class Landings:
    """Where the sheet's vertices lie on a true surface: millimetres (V,), nan off the sheet; triangles (V,) and
    weights (V, 3) of the nearest point."""

    away: Values
    triangle: NDArray[np.int64]
    weights: Values


def land(space: ParameterSpace, skin: Values, points: Values, triangles: NDArray[np.integer], /) -> Landings:
    """Exact nearest points (trimesh) of a surface (n, 3), (t, 3) to a skin (V, 3)."""
    surface = trimesh.Trimesh(points, triangles, process=False)
    rows = np.flatnonzero(space.on_sheet)
    count = len(skin)
    nearest, away, owner = _closest_point(surface, skin[rows])
    found = Landings(np.full(count, np.nan), np.zeros(count, np.int64), np.zeros((count, 3)))
    found.away[rows], found.triangle[rows] = MILLIMETRE * away, owner
    found.weights[rows] = _barycentric(surface.triangles[owner], nearest)
    return found


def quantiles(away: Values, where: Mask, /) -> tuple[float, float]:
    """The median and the 95th percentile of millimetres (V,) where asked."""
    middle, high = np.quantile(away[where], (0.5, 0.95))
    return float(middle), float(high)


def count_folds(space: ParameterSpace, skin: Values, /) -> int:
    """How many edges of the sheet are folded on a skin (V, 3), and not on the generic head."""
    creases = Creases.of(space.sheet_triangles)
    before = np.abs(creases.angles(space.points))
    now = np.abs(creases.angles(skin))
    return int(((now > FOLDED) & (before <= FOLDED)).sum())


def eye_errors(fit: Fit, person: Values, /) -> list[float]:
    """Millimetres between the middles of the eyeballs and the true ones."""
    placed = fit.placement(person)
    return [
        MILLIMETRE * float(np.linalg.norm(fit.face.parts[name].mean(axis=0) - fit_sphere(placed[rows])[0]))
        for name, rows in SCLERA.items()
    ]


def spread(model: Model, landings: Sequence[Landings], where: Mask, /) -> Values:
    """How far apart a vertex lies on different people, brought to the mean head: millimetres from its mean place,
    people x vertices."""
    corners = model.points[model.skin]
    places = np.array(
        [np.einsum("vk,vkc->vc", each.weights[where], corners[each.triangle[where]]) for each in landings]
    )
    result: Values = MILLIMETRE * np.linalg.norm(places - places.mean(axis=0), axis=2)
    return result


def landmark_errors(
    space: ParameterSpace, model: Model, fits: Mapping[int, Fit], people: Mapping[int, Values], /
) -> Values:
    """Millimetres between the 68 landmarks of the second half of the people and where our head has them: (people, 68).

    Where, is taken from the first half: the mean place on the generic head of the points nearest to theirs.
    """
    sheet = space.sheet_triangles
    names = [*people]
    known = names[: len(names) // 2]
    asked = names[len(names) // 2 :]
    places = np.mean([_lift(space, space.points, fits[i], people[i][model.landmarks]) for i in known], axis=0)
    generic = trimesh.Trimesh(space.points, sheet, process=False)
    nearest, _, owner = _closest_point(generic, places)
    weights = _barycentric(generic.triangles[owner], nearest)
    errors = []
    for i in asked:
        ours = np.einsum("lk,lkc->lc", weights, fits[i].face.positions.astype(np.float64)[sheet[owner]])
        errors.append(np.linalg.norm(ours - fits[i].placement(people[i][model.landmarks]), axis=1))
    return MILLIMETRE * np.array(errors)


def _lift(space: ParameterSpace, to: Values, fit: Fit, points: Values) -> Values:
    """Points (n, 3) of a scan on its fit, carried to the same places of another skin (V, 3)."""
    surface = trimesh.Trimesh(fit.face.positions, space.sheet_triangles, process=False)
    nearest, _, owner = _closest_point(surface, fit.placement(points))
    weights = _barycentric(surface.triangles[owner], nearest)
    result: Values = np.einsum("lk,lkc->lc", weights, to[space.sheet_triangles[owner]])
    return result
