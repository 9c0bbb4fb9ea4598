"""Soft masks of the regions of a head: how much of each vertex belongs to brows, eyes, nose, mouth, ears, ..."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np

from omote.arrays import Values
from omote.model.known_names import PlayRegion
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

Region = Literal["brows", "eyes", "nose", "cheeks", "mouth", "jaw", "ears", "skull"]
REGIONS: tuple[Region, ...] = get_args(Region)
REGIONS_OF: Mapping[PlayRegion, tuple[Region, ...]] = MappingProxyType(
    {"brows": ("brows", "skull"), "eyes": ("eyes",), "mouth": ("mouth", "jaw", "cheeks"), "rest": ("nose", "ears")}
)
"""The regions of the head that each owns: the forehead moves with the brows, cheeks and throat with the mouth."""


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
    middle, unit = eye_frame(space)
    local = (points - middle) / unit
    local[:, 0] = np.abs(local[:, 0])
    nearness = np.stack([-(((local - spot.middle) / spot.widths) ** 2).sum(axis=1) for spot in _SPOTS])
    share = np.exp(nearness - nearness.max(axis=0))
    share /= share.sum(axis=0)
    weights: dict[Region, Values] = {region: np.zeros(len(points)) for region in REGIONS}
    for spot, row in zip(_SPOTS, share, strict=True):
        weights[spot.region] = weights[spot.region] + row
    return weights


def eye_frame(space: ParameterSpace) -> tuple[Values, float]:
    """The point midway between the eyes (3,) and their distance, metres, on the generic face; ValueError where
    it has no two eyeballs."""
    eyes = [part.points.mean(axis=0) for part in space.eyes.values()]
    if len(eyes) != 2:
        raise ValueError(
            f"the space has {len(eyes)} eyeballs; expected two, by which the regions of the head are measured"
        )
    return (eyes[0] + eyes[1]) / 2, float(np.linalg.norm(eyes[0] - eyes[1]))


def check_region(name: str, /) -> Region:
    """The region of this name; ValueError where there is none."""
    for region in REGIONS:
        if region == name:
            return region
    raise ValueError(f"there is no region {name!r}; expected some of {', '.join(REGIONS)}")


@dataclass(frozen=True, eq=False)
class RegionMask:
    """How much of everything belongs to a region, 0 to 1: skin (V,), parts (n,) by name, the eyeballs' turn (2,)."""

    skin: Values
    parts: Mapping[str, Values]
    eyes: Values


def region_mask(space: ParameterSpace, region: Region, /) -> RegionMask:
    """The mask of a region, made once; parts belong to it by where they lie, eyeballs and their turn to the eyes alone,
    for who looks half-way looks nowhere. ValueError as `region_weights`.

    space: the space of the generic head.
    """
    return _region_masks(space)[region]


@weakly_cached
def _region_masks(space: ParameterSpace) -> dict[Region, RegionMask]:
    weights = {name: region_weights(space, part.points) for name, part in space.parts.items() if not part.eye}
    masks: dict[Region, RegionMask] = {}
    for region, skin in region_weights(space).items():
        eyes = 1.0 if region == "eyes" else 0.0
        parts = {
            name: np.full(len(part.points), eyes) if part.eye else weights[name][region]
            for name, part in space.parts.items()
        }
        masks[region] = RegionMask(skin, parts, np.full(2, eyes))
    return masks
