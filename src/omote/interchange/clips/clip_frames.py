"""A clip as frames at a rate: weights by name, head and gaze, which every format of motion begins from."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from omote.arrays import Values
from omote.interchange.clips.clip_names import gaze_weights
from omote.model.known_names import NEUTRAL, PLAY_REGIONS
from omote.model.space.expression import Expression
from omote.perform.clips.clip import Clip
from omote.perform.clips.sample import CHANNEL, GAZE_COLUMNS, HEAD_COLUMNS
from omote.perform.limits import check_within

USUAL_RATE = 60.0
MOST_RATE = 240.0
APART = 1e-6
"""Weights by which regions of one expression may differ and still be one."""


UNDERSHOOT = 0.02
"""Weight by which a curve between frames may be below 0 where no frame is: the cubic's own doing, and no shape of a
face. A show plays it; programs that read a file may draw lids apart by it, and formats begin at 0."""


@dataclass(frozen=True, eq=False)
class ClipFrames:
    """Frames of a clip. rate: of a second; times (n,): seconds from its start; weights: by expression or channel, (n,)
    each; head (n, 3), gaze (n, 2): radians; notes: what of it no weight can say, in sentences."""

    rate: float
    times: Values
    weights: Mapping[str, Values]
    head: Values
    gaze: Values
    notes: tuple[str, ...] = field(default=())

    def turning_eyes(self, expressions: Mapping[str, Expression]) -> dict[str, Values]:
        """The weights, with those that turn the eyes by the gaze. expressions: of the cast, by name."""
        turned = gaze_weights(expressions, self.gaze)
        return {**self.weights, **{name: self.weights.get(name, 0.0) + values for name, values in turned.items()}}


def sample_clip(clip: Clip, *, rate: float = USUAL_RATE) -> ClipFrames:
    """The frames of a clip, from its start to its end or, where no frame falls on it, the first after it, which has
    what the end has.

    Parameters
    ----------
    clip : Clip
        With its lanes as they are set; where none plays, all is at rest. Its speed counts, fades and loop do not.
    rate : float
        Frames of a second, 1 to 240.

    Returns
    -------
    ClipFrames
        An expression that some regions alone show has their mean weight, and is among the notes. A weight that goes
        below 0 by no more than .02 ends at 0.

    Raises
    ------
    ValueError
        On a rate out of range.
    """
    check_within(rate, 1.0, MOST_RATE, "the frames of a second")
    count = math.ceil(clip.seconds / clip.speed * rate - 1e-6) + 1
    times = np.arange(count) / rate
    layout = clip.layout
    samples = [clip.sample(min(time * clip.speed, clip.seconds)) for time in times.tolist()]
    table = np.array([sample.values * sample.shares[layout.places] for sample in samples])
    columns = {name: table[:, place] for place, name in enumerate(layout.columns)}
    weights: dict[str, Values] = {}
    for name, values in columns.items():
        part, _, of = name.partition("/")
        if part == CHANNEL:
            weights[of] = values
    notes = []
    for name in sorted({column.partition("/")[2] for column in columns if column.partition("/")[0] in PLAY_REGIONS}):
        if name == NEUTRAL:
            continue
        regions = np.array([columns.get(f"{region}/{name}", np.zeros(count)) for region in PLAY_REGIONS])
        if np.ptp(regions, axis=0).max() > APART:
            notes.append(f"{name} shows in some regions alone, and is written by its mean weight")
        weights[name] = weights.get(name, np.zeros(count)) + regions.mean(axis=0)
    head, gaze = (_turns(columns, names, count) for names in (HEAD_COLUMNS, GAZE_COLUMNS))
    weights = {name: _without_undershoot(values) for name, values in weights.items()}
    return ClipFrames(rate, times, weights, head, gaze, tuple(notes))


def _without_undershoot(values: Values) -> Values:
    """A weight (n,) that ends at 0 where only the curve between frames goes below; as it is where somebody meant it."""
    return np.maximum(values, 0.0) if values.min() >= -UNDERSHOOT else values


def _turns(columns: Mapping[str, Values], names: tuple[str, ...], count: int) -> Values:
    return np.array([columns.get(name, np.zeros(count)) for name in names]).T
