"""What motion has at one instant: numbers by column, how much it takes of each part, and one motion over another.

A column is `channel/jawOpen`, `mouth/joy` (the weight of an expression in the mix of a play region), `head/yaw` or
`gaze/pitch`, or `body/spine05/x` of the body (`body_columns`). Each belongs to one part, or to the whole of a face.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.known_names import NEUTRAL, PLAY_REGIONS
from omote.perform.clips.clip_parts import BODY, CLIP_PARTS, PLACES
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS

CHANNEL = "channel"
HEAD_COLUMNS = tuple(f"head/{name}" for name in HEAD_LIMITS)
GAZE_COLUMNS = tuple(f"gaze/{name}" for name in GAZE_LIMITS)
AT_REST = tuple(f"{region}/{NEUTRAL}" for region in PLAY_REGIONS)
"""The columns that all motion has: what no expression takes of a region is neutral."""


@dataclass(frozen=True, eq=False)
class Layout:
    """The columns of motion, each with the place of its part (`place_of_part`), `WHOLE` for the whole face; made by
    `layout_of`, so that the same columns are one object."""

    columns: tuple[str, ...]
    parts: tuple[int, ...]
    places: NDArray[np.intp] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "places", np.array(self.parts, np.intp))


@lru_cache(maxsize=512)
def layout_of(columns: tuple[str, ...], parts: tuple[int, ...]) -> Layout:
    """The layout of some columns. columns: their names; parts: the place of each."""
    return Layout(columns, parts)


AT_REST_LAYOUT = layout_of(AT_REST, tuple(range(len(AT_REST))))


@dataclass(frozen=True, eq=False)
class Sample:
    """Motion at one instant: a value for each column of its layout, and how much of each part it takes (`PLACES`,),
    0 to 1."""

    layout: Layout
    values: Values
    shares: Values


def shares_of(by_part: Values) -> Values:
    """Shares (`PLACES`,) of shares by part (7,), in the order of `CLIP_PARTS`: of the whole face the mean of its
    regions."""
    shares = np.empty(PLACES)
    shares[: len(LAYER_PARTS)] = by_part[: len(LAYER_PARTS)]
    shares[BODY] = by_part[CLIP_PARTS.index("body")]
    shares[WHOLE] = (by_part[0] + by_part[1] + by_part[2] + by_part[3]) / len(PLAY_REGIONS)
    return shares


def empty_sample(layout: Layout) -> Sample:
    """A sample of a layout that takes nothing."""
    return Sample(layout, np.zeros(len(layout.columns)), np.zeros(PLACES))


def join_layouts(one: Layout, other: Layout) -> Layout:
    """The layout with the columns of two; one that has those of the other is itself."""
    return _joined(one, other)[0]


def lay_over(below: Sample, above: Sample) -> Sample:
    """One motion over another: the upper one shows by its shares, the lower one where it leaves any.

    Parameters
    ----------
    below : Sample
        What lies below.
    above : Sample
        What comes over it.

    Returns
    -------
    Sample
        With the columns of both. Where the upper one takes all, or the lower one nothing, its values to the bit.
    """
    layout, lower, upper = _joined(below.layout, above.layout)
    places = layout.places
    values = np.zeros(len(places))
    values[lower] = below.values
    wanted = np.zeros(len(places))
    wanted[upper] = above.values
    before = below.shares[places]
    own = above.shares[places]
    total = own + (1.0 - own) * before
    part = np.divide(own, total, out=np.zeros(len(places)), where=total > 0.0)
    mixed = values + part * (wanted - values)
    chosen = np.where((own == 1.0) | (before == 0.0), wanted, np.where(own == 0.0, values, mixed))
    return Sample(layout, chosen, above.shares + (1.0 - above.shares) * below.shares)


@lru_cache(maxsize=512)
def _joined(below: Layout, above: Layout) -> tuple[Layout, NDArray[np.intp], NDArray[np.intp]]:
    """The layout of two, and where the columns of each lie in it."""
    if below is above:
        every = np.arange(len(below.columns))
        return below, every, every
    parts = dict(zip(above.columns, above.parts, strict=True))
    parts |= dict(zip(below.columns, below.parts, strict=True))
    columns = below.columns if len(parts) == len(below.columns) else tuple(sorted(parts))
    index = {column: place for place, column in enumerate(columns)}
    layout = layout_of(columns, tuple(parts[column] for column in columns))
    lower, upper = (np.array([index[column] for column in each.columns], np.intp) for each in (below, above))
    return layout, lower, upper
