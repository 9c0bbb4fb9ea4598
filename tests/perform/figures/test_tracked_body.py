"""A performer's body comes and goes without a jump, takes the place of what is called, and has one source."""

from collections.abc import Sequence

import numpy as np

from omote.arrays import Values
from omote.model.body.pose_regions import POSE_REGIONS
from omote.perform.figures.packed_pose import BESIDE_BONES, unpack_pose
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.figures.tracked_body import (
    NOTHING,
    TrackedBody,
    advance_body,
    lose_body,
    track_body,
    tracked_pose,
    with_tracked,
)
from omote.perform.layers.source_frame import LOSS_SECONDS, BodyFrame

BONES = 2 * len(POSE_REGIONS)
COUNT = 3 * BONES + BESIDE_BONES
TICK = 1.0 / 60.0


def frame(value: float, regions: Sequence[str] = POSE_REGIONS) -> BodyFrame:
    return BodyFrame(np.full(COUNT, value), tuple(region for region in POSE_REGIONS if region in regions))


def heard(before: TrackedBody | None, value: float, source: str = "suit") -> TrackedBody:
    body = track_body(before, "tracker", source, frame(value), found=True)
    assert body is not None
    return body


def shown(body: TrackedBody | None) -> Values:
    """Its shares, then what is seen of its numbers: shares times numbers."""
    pose = None if body is None else tracked_pose(body)
    if pose is None:
        return np.zeros(len(POSE_REGIONS) + COUNT)
    return np.concatenate([pose.shares, min(pose.shares) * unpack_pose(pose.pose, BONES)])


def test_it_comes_follows_and_goes_without_a_jump_and_is_gone_in_the_end() -> None:
    body: TrackedBody | None = None
    steps = []
    before = shown(body)
    for tick in range(900):
        if tick < 360:
            body = heard(body, 0.5 if tick < 60 else 1.0)
        if body is not None:
            body = advance_body(body, TICK, on=True)
        now = shown(body)
        steps.append(np.abs(now - before).max())
        before = now
        if tick == 359:
            assert np.abs(now[: len(POSE_REGIONS)] - 1.0).max() == 0.0
            assert np.abs(now[len(POSE_REGIONS) :] - 1.0).max() < 0.01
    assert body is None
    assert max(steps) < 0.2, "of the whole way in a tick"


def test_a_layer_that_is_off_shows_nothing_of_it_and_unseen_regions_fade() -> None:
    body: TrackedBody | None = heard(None, 1.0)
    for _ in range(360):
        assert body is not None
        body = advance_body(
            track_body(body, "tracker", "suit", frame(1.0, ["trunk"]), found=True) or body, TICK, on=True
        )
    assert body is not None
    assert [share for _, share in body.shares] == [float(region == "trunk") for region in POSE_REGIONS]
    for _ in range(360):
        assert body is not None
        body = advance_body(heard(body, 1.0), TICK, on=False)
    assert body is not None
    assert (body.shares, tracked_pose(body)) == (NOTHING, None)


def test_it_has_one_source_until_that_is_lost() -> None:
    body = heard(None, 1.0)
    assert heard(body, 2.0, "other") is body
    assert lose_body(body, "tracker", "other") is body
    assert track_body(body, "tracker", "suit", frame(2.0), found=False) is body
    lost = lose_body(body, "tracker", "suit")
    assert lost is not None
    assert lost.silent == LOSS_SECONDS
    assert heard(lost, 2.0, "other").source == "other"


def test_it_takes_the_place_of_the_mix_by_the_share_of_each_region() -> None:
    masks = tuple(np.arange(BONES) // 2 == at for at in range(len(POSE_REGIONS)))
    called = MixedPose(np.full((BONES, 3), 4.0), np.full(3, 4.0), np.full((2, 3), 4.0), np.full((2, 3), 4.0))
    shares = tuple(np.linspace(0.0, 1.0, len(POSE_REGIONS)).tolist())
    mixed = with_tracked(called, shares, np.zeros(COUNT), masks)
    assert mixed.turns[:, 0].tolist() == [4.0 * (1.0 - share) for share in shares for _ in range(2)]
    stance = 4.0 * (1.0 - shares[POSE_REGIONS.index("stance")])
    for part in (mixed.travel, mixed.feet, mixed.feet_turns):
        assert np.unique(part).tolist() == [stance]
