"""The default control points of a new expression, placed by facial landmarks (lids, lips, brows, nose), symmetric."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from omote.arrays import Mask, Values
from omote.model.controls.mirror import mirror_rows
from omote.model.space.head_regions import Region, eye_frame, region_weights
from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

COUNT = 104
"""Points of the default net, one more or less."""

# How far points stand from each other, in distances between the eyes.
_SPACING: dict[Region, float] = {
    "brows": 0.28, "eyes": 0.26, "nose": 0.3, "cheeks": 0.36, "mouth": 0.26, "jaw": 0.42, "ears": 1.1, "skull": 1.4,
}  # fmt: skip
# Shares of the arc of a lid, and of a lip, where points stand, up to the middle; the corners are always there.
_LID = (0.22, 0.5, 0.78)
_LIP = (0.16, 0.33, 0.5)
# Points of brows and forehead in front view, in distances between the eyes from the point between them.
_BROW = ((0.14, 0.3), (0.34, 0.38), (0.58, 0.4), (0.82, 0.3))
_FOREHEAD = ((0.0, 0.62), (0.32, 0.78), (0.7, 0.72), (0.0, 1.1), (0.55, 1.2))
# A point nearer to the midline than this share of the spacing would crowd its mirror image.
_ASIDE = 0.45


@weakly_cached
def default_net(space: ParameterSpace, /) -> tuple[int, ...]:
    """Rows of the sheet under the default control points, chosen by feature: lids and lips, brows, nose and chin, then
    the widest gaps; a point's mirror image is one of them. ValueError where the head is not symmetric."""
    seeds = [row for line in space.lines for row in _on_line(space, line)]
    return _fill(space, [*seeds, *_features(space)])


def _on_line(space: ParameterSpace, line: Line) -> list[int]:
    rows = list[int]()
    for chain in chains(space.points, line.loop):
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(space.points[chain], axis=0), axis=1))])
        shares = (0.0, *(_LID if line.kind == "lids" else _LIP), *((1.0,) if line.kind == "lids" else ()))
        rows += [int(chain[np.abs(length / length[-1] - share).argmin()]) for share in shares]
    return rows


def _features(space: ParameterSpace) -> list[int]:
    """Brows and forehead, the tip and the wings of the nose, and the chin."""
    middle, unit = eye_frame(space)
    shares = region_weights(space)
    local = (space.points - middle) / unit
    front = _candidates(space) & (local[:, 2] > np.median(local[:, 2]))
    rows = [_row_of_least(np.hypot(local[:, 0] - x, local[:, 1] - y), front) for x, y in (*_BROW, *_FOREHEAD)]
    nose = front & (shares["nose"] > 0.5)
    jaw = front & (shares["jaw"] > 0.5)
    midline = np.abs(local[:, 0]) < 1e-6
    rows.append(_row_of_least(-local[:, 2], nose & midline))
    rows.append(_row_of_least(-local[:, 0], nose))
    rows.append(_row_of_least(-local[:, 2], jaw & midline))
    return [row for row in rows if row >= 0]


def _row_of_least(values: Values, among: Mask) -> int:
    return int(np.where(among, values, np.inf).argmin()) if among.any() else -1


def _candidates(space: ParameterSpace) -> Mask:
    """The sheet's vertices off its upper and lower edge, each place once."""
    h = space.h[space.on_sheet]
    margin = 0.02 * np.ptp(h)
    once = space.welded == np.arange(space.vertex_count)
    return space.on_sheet & once & (space.h > h.min() + margin) & (space.h < h.max() - margin)


def _fill(space: ParameterSpace, seeds: Sequence[int]) -> tuple[int, ...]:
    """The seeds with their mirror images, then always the vertex farthest from all points, counted in its region's
    spacing."""
    mirror = mirror_rows(space)
    unit = eye_frame(space)[1]
    spacing = unit * sum((_SPACING[region] * share for region, share in region_weights(space).items()), np.zeros(1))
    aside = np.abs(space.points[:, 0])
    free = _candidates(space) & ((aside < 1e-6) | (aside > _ASIDE * spacing))
    nearness = np.where(free, np.inf, -np.inf)
    chosen = list[int]()

    def choose(row: int) -> None:
        for one in dict.fromkeys((row, int(mirror[row]))):
            if one not in chosen:
                chosen.append(one)
                nearness[:] = np.minimum(nearness, np.linalg.norm(space.points - space.points[one], axis=1) / spacing)

    for seed in seeds:
        choose(seed)
    while len(chosen) < COUNT and (nearness > 0).any():
        choose(int(nearness.argmax()))
    return tuple(chosen)
