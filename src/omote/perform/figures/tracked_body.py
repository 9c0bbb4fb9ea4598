"""The body of a performer whom a source sees: its pose is followed, and takes the place of what is called."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Mask, Values
from omote.model.body.pose_regions import POSE_REGIONS, PoseRegion
from omote.perform.figures.packed_pose import BESIDE_BONES, PLACES, pack_pose
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.frame import TrackedPose, with_fields
from omote.perform.layers.columns import STREAM_SECONDS, TRUST_SECONDS
from omote.perform.layers.follower import follow, follow_number, rate_of, steps_of
from omote.perform.layers.layer_names import LayerName, check_driven
from omote.perform.layers.source_frame import LOSS_SECONDS, BodyFrame
from omote.perform.limits import check_within

UNSEEN = 1e-6
"""A share that is less has faded out."""
NOTHING = ((0.0, 0.0),) * len(POSE_REGIONS)


@dataclass(frozen=True)
class TrackedBody:
    """What is followed. layer, source: who drives it; regions: those that are seen; goal: the newest pose; first,
    second: what follows it (`follow`), numbers of poses as float64; shares: of each region after the first filter and
    after both; silent: seconds since the source saw its performer."""

    layer: LayerName
    source: str
    regions: tuple[PoseRegion, ...]
    goal: bytes
    first: bytes
    second: bytes
    shares: tuple[tuple[float, float], ...] = NOTHING
    silent: float = 0.0

    @property
    def is_seen(self) -> bool:
        """Whether its source sees somebody, or did a moment ago."""
        return self.silent < LOSS_SECONDS


def check_tracked(body: TrackedBody) -> None:
    """Rejects a body that nobody can have followed."""
    check_driven(body.layer)
    lengths = {len(body.goal), len(body.first), len(body.second)}
    numbers = (
        np.frombuffer(body.goal + body.first + body.second, np.float64) if len(lengths) == 1 else np.array([np.nan])
    )
    shares = [number for share in body.shares for number in share]
    if not (np.isfinite(numbers).all() and len(body.shares) == len(POSE_REGIONS)):
        raise ValueError("the tracked body of a snapshot is none: its numbers are of several lengths, or no numbers")
    if not all(0.0 <= share <= 1.0 for share in shares) or not set(body.regions) <= set(POSE_REGIONS):
        raise ValueError("the tracked body of a snapshot has shares out of 0 to 1, or regions that there are not")
    check_within(body.silent, 0.0, LOSS_SECONDS, "the silence of a tracked body (seconds)")


def track_body(
    before: TrackedBody | None, layer: LayerName, source: str, frame: BodyFrame, *, found: bool
) -> TrackedBody | None:
    """The body after a frame of a source. A body has one source: another waits until it is lost.

    before: what was followed; layer, source: who sends; frame: the pose and its regions; found: whether it sees its
    performer.
    """
    mine = before is not None and (before.layer, before.source) == (layer, source)
    if not found or not (mine or before is None or not before.is_seen):
        return before
    goal = frame.numbers.tobytes()
    if before is None or len(before.goal) != len(goal):
        return TrackedBody(layer, source, frame.regions, goal, goal, goal)
    unseen = all(share < UNSEEN for _, share in before.shares)
    moves = {"first": goal, "second": goal} if unseen else {}
    return with_fields(
        before, layer=layer, source=source, regions=frame.regions, goal=goal, silent=0.0, **moves
    )  # fmt: skip


def lose_body(body: TrackedBody | None, layer: LayerName, source: str) -> TrackedBody | None:
    """The body when a source has gone, from which it fades out; another's stays. layer, source: who has gone."""
    gone = body is not None and (body.layer, body.source) == (layer, source)
    return with_fields(body, silent=LOSS_SECONDS) if body is not None and gone else body


def advance_body(body: TrackedBody, dt: float, *, on: bool) -> TrackedBody | None:
    """The body `dt` seconds later; None where it has faded out. on: whether its layer plays."""
    goal, first, second = (np.frombuffer(each, np.float64) for each in (body.goal, body.first, body.second))
    rates = np.full(len(goal), rate_of(STREAM_SECONDS))
    haste = np.zeros(len(goal))
    for step in steps_of(dt):
        first, second = follow(first, second, goal, rates, haste, step)
    silent = min(body.silent + dt, LOSS_SECONDS)
    trusted = on and silent < LOSS_SECONDS
    shares = tuple(
        _near(follow_number(*share, float(trusted and region in body.regions), rate_of(TRUST_SECONDS), dt))
        for region, share in zip(POSE_REGIONS, body.shares, strict=True)
    )
    if silent >= LOSS_SECONDS and shares == NOTHING:
        return None
    return with_fields(body, first=first.tobytes(), second=second.tobytes(), shares=shares, silent=silent)


def _near(share: tuple[float, float]) -> tuple[float, float]:
    first, second = share
    if abs(first) + abs(second) < UNSEEN:
        return 0.0, 0.0
    return (1.0, 1.0) if 2.0 - first - second < UNSEEN else share


def tracked_pose(body: TrackedBody) -> TrackedPose | None:
    """What shows of a body; None while it is nothing."""
    shares = tuple(share for _, share in body.shares)
    return TrackedPose(shares, pack_pose(np.frombuffer(body.second, np.float64))) if any(shares) else None


def with_tracked(pose: MixedPose, shares: tuple[float, ...], numbers: Values, bones: tuple[Mask, ...]) -> MixedPose:
    """A pose with that of a tracked body in its place, by shares: `(1 - share) pose + share tracked`, region by region.

    pose: the mix that is called; shares: of `POSE_REGIONS`; numbers: of the tracked pose, as of `pose_numbers`; bones:
    which (J,) belong to each region.
    """
    count = len(numbers) - BESIDE_BONES
    turns = pose.turns.copy()
    for share, of in zip(shares, bones, strict=True):
        turns[of] += share * (numbers[:count].reshape(-1, 3)[of] - turns[of])
    stance = shares[POSE_REGIONS.index("stance")]
    travel, feet, feet_turns = np.split(numbers[count:], (3, PLACES))
    return MixedPose(
        turns,
        pose.travel + stance * (travel - pose.travel),
        pose.feet + stance * (feet.reshape(-1, 3) - pose.feet),
        pose.feet_turns + stance * (feet_turns.reshape(-1, 3) - pose.feet_turns),
    )
