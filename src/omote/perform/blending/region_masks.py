"""Masks of the play regions: how much of everything each owns, so that four mixes make one face without a seam."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Floats, Values
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.model.space.head_regions import REGIONS_OF, region_weights
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import Part
from omote.model.transfer.corrective_regions import CorrectiveRegions, find_corrective_regions
from omote.model.weak_cache import weakly_cached

SHARPNESS = 2.0
"""The power of the head's soft regions: the higher, the narrower the skin that two regions share. At 2 it is some 10 mm
wide, so that brows raised by 8 mm over still eyes turn no triangle over; at 3 half of that."""
FIRM = 0.025
"""What weighs less is nothing, what weighs more than all but this is all: lids and lips then belong to one region
whole, for lids of which a part stays behind do not close."""


@dataclass(frozen=True, eq=False)
class PlayMask:
    """How much of everything belongs to a play region, 0 to 1: skin (V, 1), parts (n, 1) by name, and what allowances
    of correctives count (`CorrectiveRegions.size`)."""

    skin: Floats
    parts: Mapping[str, Floats]
    allowances: Floats


@weakly_cached
def play_masks(space: ParameterSpace, /) -> Mapping[PlayRegion, PlayMask]:
    """The masks of the four play regions, made once; of each vertex they sum to one.

    Raises ValueError where the space has no two eyeballs to measure the head by.
    """
    skin = _skin_masks(space)
    parts = {name: _part_masks(part, skin) for name, part in space.parts.items()}
    correctives = find_corrective_regions(space)
    allowances = np.zeros((len(PLAY_REGIONS), 0)) if correctives is None else _allowance_masks(correctives, skin)
    return {
        region: PlayMask(
            _column(skin[row]), {name: _column(mask[row]) for name, mask in parts.items()},
            allowances[row].astype(np.float32),
        )
        for row, region in enumerate(PLAY_REGIONS)
    }  # fmt: skip


def _column(values: Values) -> Floats:
    return np.ascontiguousarray(values, np.float32)[:, None]


def _skin_masks(space: ParameterSpace) -> Values:
    """(4, V); inner skin belongs to what the sheet that it follows belongs to: the mouth's bag to the mouth."""
    weights = region_weights(space)
    masks = np.stack([sum((weights[region] for region in REGIONS_OF[play]), np.zeros(1)) for play in PLAY_REGIONS])
    masks = _shares(masks**SHARPNESS)
    masks = _shares(np.clip((masks - FIRM) / (1.0 - 2.0 * FIRM), 0.0, 1.0))
    inner = space.inner
    followed = np.einsum("rnk,nk->rn", masks[:, inner.anchors], np.abs(inner.weights))
    still = followed.sum(axis=0) == 0.0  # it follows nothing: it belongs to where it lies
    masks[:, inner.vertices] = np.where(still, masks[:, inner.vertices], followed)
    return _shares(masks)


def _shares(masks: Values) -> Values:
    return masks / masks.sum(axis=0)


def _part_masks(part: Part, skin: Values) -> Values:
    """(4, n): lashes by the lids that they stand on; eyeballs to the eyes, teeth and tongue to the mouth, as wholes."""
    if part.eye:
        return _whole("eyes", len(part.points))
    around = skin[:, part.ring].mean(axis=1)
    if around[PLAY_REGIONS.index("mouth")] > 0.5:
        return _whole("mouth", len(part.points))
    followed = np.einsum("rnk,nk->rn", skin[:, part.anchors], np.abs(part.weights))
    return _shares(np.where(followed.sum(axis=0) > 0.0, followed, around[:, None]))


def _whole(region: PlayRegion, count: int) -> Values:
    masks = np.zeros((len(PLAY_REGIONS), count))
    masks[PLAY_REGIONS.index(region)] = 1.0
    return masks


def _allowance_masks(regions: CorrectiveRegions, skin: Values) -> Values:
    """(4, size): of triangles the mean of their corners', of rungs the mean of both sides', of lids their own."""
    here = skin[:, regions.rows]
    rungs = [
        _shares(np.einsum("rnk,nk->rn", here[:, crossing.vertices], np.abs(crossing.weights)))
        for crossing in regions.crossings
    ]
    triangles = here[:, regions.triangles].mean(axis=2)
    return np.concatenate([triangles, *rungs, here[:, regions.lids]], axis=1)
