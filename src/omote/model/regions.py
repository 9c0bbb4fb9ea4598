"""Regions of the face, for mixes of faces part by part, and caricature; both are smooth over the skin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.distance import cdist

from omote.geometry import mesh
from omote.model.face import Face
from omote.model.fitted import Fitted, fit
from omote.model.socket import NEAR, falling, heights, rolled, rolled_at, seated
from omote.model.space import ParameterSpace

Values = NDArray[np.float64]
Region = Literal["brows", "eyes", "nose", "cheeks", "mouth", "jaw", "ears", "skull"]
REGIONS: tuple[Region, ...] = get_args(Region)

# What a caricature enlarges is the form that a bell of this width leaves, in distances between the eyes.
_BELL = 0.3
# Up to so many radii of the ball the surroundings of an eye go and grow with it, less and less.
_EYE = 2.4


@dataclass(frozen=True)
class _Spot:
    """Where a region lies on the generic head: its middle and its half-widths."""

    region: Region
    middle: tuple[float, float, float]
    widths: tuple[float, float, float]


# In distances between the eyes, from the point midway between them; x counts on both sides.
_SPOTS = (
    _Spot("brows", (0.45, 0.40, 0.30), (0.55, 0.20, 0.45)),
    _Spot("eyes", (0.50, 0.00, 0.15), (0.32, 0.20, 0.40)),
    _Spot("nose", (0.00, -0.42, 0.50), (0.24, 0.42, 0.45)),
    _Spot("cheeks", (0.80, -0.65, 0.00), (0.30, 0.40, 0.50)),
    _Spot("mouth", (0.00, -1.10, 0.35), (0.50, 0.25, 0.50)),
    _Spot("jaw", (0.35, -1.60, 0.10), (0.70, 0.35, 0.80)),
    _Spot("ears", (1.30, -0.20, -1.35), (0.25, 0.75, 0.55)),
    _Spot("skull", (0.00, 1.20, -1.10), (1.20, 0.80, 1.40)),
    _Spot("skull", (0.00, -0.40, -2.00), (1.00, 1.60, 0.90)),
)


def region_weights(space: ParameterSpace, where: Values | None = None, /) -> dict[Region, Values]:
    """How much each region owns of each point, (n,) from 0 to 1, summing to one; without points: of the skin (V, 3).

    A soft choice of the nearest spot (Gaussian falloff), so it changes smoothly over the skin and through space. Raises
    ValueError where the space has no two eyeballs to measure the head by.
    """
    points = space.points if where is None else where
    middle, unit = _frame(space)
    local = (points - middle) / unit
    local[:, 0] = np.abs(local[:, 0])
    nearness = np.stack([-(((local - spot.middle) / spot.widths) ** 2).sum(axis=1) for spot in _SPOTS])
    share = np.exp(nearness - nearness.max(axis=0))
    share /= share.sum(axis=0)
    found: dict[Region, Values] = {region: np.zeros(len(points)) for region in REGIONS}
    for spot, row in zip(_SPOTS, share, strict=True):
        found[spot.region] = found[spot.region] + row
    return found


def regional(
    space: ParameterSpace, name: str, faces: Mapping[Region, Face], /, *, rest: Face | None = None
) -> Face:  # fmt: skip
    """A face with each region from another face, smooth at the borders; regions that are not named come from `rest`
    (without it from the generic face). One face everywhere gives that face. ValueError on a region that is none."""
    strange = [region for region in faces if region not in REGIONS]
    if strange:
        raise ValueError(f"there is no region {strange[0]!r}; expected some of {', '.join(REGIONS)}")
    generic = rest or Face("generic", space.points, {name: part.points for name, part in space.parts.items()})
    chosen = {region: fit(space, faces.get(region, generic)) for region in REGIONS}
    weights = region_weights(space)
    skin = sum((weights[region][:, None] * face.positions for region, face in chosen.items()), np.zeros((1, 3)))
    parts = {}
    for part in space.parts.values():
        # An eyeball is round: one weight for all of it, that of the skin that places it; the others bend like the skin.
        shares = region_weights(space, part.points)
        if part.eye:
            shares = {region: np.full(len(part.points), weights[region][part.ring].mean()) for region in REGIONS}
        rows = (shares[region][:, None] * face.parts[part.name] for region, face in chosen.items())
        parts[part.name] = sum(rows, np.zeros((1, 3)))
    wanted = {}
    for eye in _eyes(space):
        over = ((weights[region], _heights(face, eye)) for region, face in chosen.items())
        wanted[eye] = sum((weight * height for weight, height in over), np.zeros(1))
    return _checked(space, name, skin, parts, wanted)


def caricature(space: ParameterSpace, face: Face, amount: float, /) -> Face:
    """What distinguishes a face from the generic one, times amount: 0 the generic face, 1 the face, 2 twice itself.

    Up to one it is the linear mix; beyond, only the smooth form grows, so wrinkles and lids stay what they are. It is
    named after face and amount ("kaori_150"). Raises ValueError on an amount that is not finite or that tears the face.
    """
    if not np.isfinite(amount):
        raise ValueError(f"a caricature's amount is {amount!r}; expected a finite number such as 1.5")
    fitted = fit(space, face)
    within, beyond = min(amount, 1.0), max(amount - 1.0, 0.0)
    difference = fitted.positions - space.points
    skin = space.points + within * difference
    parts = {name: part.points + within * (fitted.parts[name] - part.points) for name, part in space.parts.items()}
    if beyond > 0.0:
        skin += beyond * _form(space, fitted, space.points)
        for name, part in space.parts.items():
            further = part.points + beyond * _form(space, fitted, part.points)
            parts[name] = rolled(parts[name], part.points, further) if part.eye else parts[name] + further - part.points
    return _checked(
        space,
        f"{face.name}_{100 * amount:.0f}",
        skin,
        parts,
        {eye: _heights(fitted, eye) for eye in _eyes(space) if beyond > 0.0},
    )


def _form(space: ParameterSpace, fitted: Fitted, where: Values) -> Values:
    """The face's difference from the generic one without its details, at any points (n, 3) of the generic head: what
    lies behind the skin goes where the skin goes, what lies around an eye goes and grows with the eyeball."""
    result = _bell(space, fitted.positions - space.points, where)
    for eye in _eyes(space):
        ball = space.parts[eye].points
        hold = falling((heights(where, ball) - NEAR) / (_EYE - NEAR))
        with_ball = rolled_at(where, ball, fitted.parts[eye]) - where
        result += hold[:, None] * (with_ball - result)
    return result


def _bell(space: ParameterSpace, difference: Values, where: Values) -> Values:
    """The sheet's difference (V, 3), each point's the mean under a bell around it."""
    width = _BELL * _frame(space)[1]
    sheet = np.unique(space.skin_triangles)
    area = np.zeros(space.vertex_count)
    for corner in range(3):
        np.add.at(area, space.skin_triangles[:, corner], mesh.areas(space.points, space.skin_triangles))
    square = cdist(where, space.points[sheet], "sqeuclidean") / (2.0 * width * width)
    bell = area[sheet] * np.exp(square.min(axis=1, keepdims=True) - square)
    result: Values = bell @ difference[sheet] / bell.sum(axis=1, keepdims=True)
    return result


def _frame(space: ParameterSpace) -> tuple[Values, float]:
    """The point midway between the eyes and the distance between them, on the generic face."""
    eyes = [part.points.mean(axis=0) for part in space.parts.values() if part.eye]
    if len(eyes) != 2:
        raise ValueError(
            f"the space has {len(eyes)} eyeballs; expected two, by which the regions of the head are measured"
        )
    return (eyes[0] + eyes[1]) / 2, float(np.linalg.norm(eyes[0] - eyes[1]))


def _eyes(space: ParameterSpace) -> list[str]:
    return [name for name, part in space.parts.items() if part.eye]


def _heights(fitted: Fitted, eye: str) -> Values:
    return heights(fitted.positions, fitted.parts[eye])


def _checked(
    space: ParameterSpace, name: str, skin: Values, parts: dict[str, Values], wanted: Mapping[str, Values]
) -> Face:  # fmt: skip
    """The face, fitted, its lids at the wanted heights over its eyeballs."""
    face = Face(name, seated(skin, {eye: parts[eye] for eye in wanted}, wanted), parts)
    fit(space, face)
    return face
