"""The body that clips play, over that of a performer whom a source sees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.body.pose_regions import POSE_REGIONS, regions_of_bones
from omote.perform.clips.body_columns import BodyReader
from omote.perform.clips.clip_parts import BODY
from omote.perform.clips.sample import Sample
from omote.perform.figures.figure_axes import AT_REST, figure_frame
from omote.perform.figures.packed_pose import BESIDE_BONES, pack_pose, unpack_pose
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.figures.tracked_body import TrackedBody
from omote.perform.frame import FigureFrame, TrackedPose, with_fields
from omote.perform.layers.layer_mix import CLIP_LAYER
from omote.perform.layers.source_frame import CLIP, LOSS_SECONDS


@dataclass(frozen=True, eq=False)
class PlayedBody:
    """numbers: of a pose, as of `pose_numbers`; regions: the place of each number's among `POSE_REGIONS`; share: how
    much of it shows, 0 to 1."""

    numbers: Values
    regions: NDArray[np.intp]
    share: float


class PlayedBodies:
    """Reads what clips play of a body. columns: of a layout; bones: of the cast's figures."""

    def __init__(self, columns: Sequence[str], bones: Sequence[str]) -> None:
        self._reader = BodyReader(columns, bones)
        self._regions = np.full(3 * len(bones) + BESIDE_BONES, POSE_REGIONS.index("stance"), np.intp)
        for place, of in enumerate(regions_of_bones(bones).values()):
            self._regions[: 3 * len(bones)][np.repeat(of, 3)] = place

    def body(self, sample: Sample) -> PlayedBody | None:
        """What clips play; None where nothing of it shows. sample: of the layout."""
        share = float(np.clip(sample.shares[BODY], 0.0, 1.0))
        if not self._reader.there or not share:
            return None
        return PlayedBody(numbers_of(self._reader.pose(sample.values)), self._regions, share)


def numbers_of(pose: MixedPose) -> Values:
    """A pose as one vector, as of `pose_numbers`."""
    return np.concatenate([np.ravel(part) for part in (pose.turns, pose.travel, pose.feet, pose.feet_turns)])


def wear_body(figure: FigureFrame | None, body: PlayedBody) -> FigureFrame:
    """A figure with the body of clips over what is called and over a performer's.

    figure: of a frame, None while it stands; body: what clips play, some of it.
    """
    worn = figure_frame(AT_REST) if figure is None else figure
    return with_fields(worn, tracked=_lay_over(worn.tracked, body, body.share))


def left_body(body: PlayedBody) -> TrackedBody:
    """The body of clips that are over at once, as that of a performer who is lost: it fades out from where it is."""
    numbers = body.numbers.tobytes()
    shares = ((body.share, body.share),) * len(POSE_REGIONS)
    return TrackedBody(CLIP_LAYER, CLIP, POSE_REGIONS, numbers, numbers, numbers, shares, LOSS_SECONDS)


def _lay_over(tracked: TrackedPose | None, body: PlayedBody, above: float) -> TrackedPose:
    """One body over another: `(1 - above) ((1 - below) called + below tracked) + above played`, region by region, as
    one pose with shares."""
    if tracked is None or above == 1.0:
        return TrackedPose((above,) * len(POSE_REGIONS), pack_pose(body.numbers))
    shares = 1.0 - (1.0 - above) * (1.0 - np.array(tracked.shares))
    below = unpack_pose(tracked.pose, (len(body.numbers) - BESIDE_BONES) // 3)
    part = (above / shares)[body.regions]
    return TrackedPose(tuple(shares.tolist()), pack_pose(below + part * (body.numbers - below)))
