"""Bodies of clips: over what is called, over a performer, faded, and left by a panic."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.cut_clip import cut_curve, record
from omote.perform.clips.played_body import PlayedBody, wear_body
from omote.perform.figures.figure_axes import AT_REST, figure_frame
from omote.perform.figures.packed_pose import BESIDE_BONES, TURN_STEP, pack_pose, unpack_pose
from omote.perform.frame import TrackedPose, with_fields
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE
from omote.perform.performer import Performer
from omote.show.objects.clips import StoredClip, clip_of, stored_clip
from omote.show.objects.documents import read_document

DT = 1.0 / 60.0
CAST = omote.load_cast()


def bowing(cast: Cast = CAST) -> Clip:
    """One who bows and rises again."""
    performer = Performer(cast)
    performer.call_pose("bow", seconds=0.5)
    return Clip([Lane(record(performer, cast, seconds=1.0))], blend_in=0.0, blend_out=0.0)


def skin(frame: omote.Frame) -> omote.arrays.Floats:
    return omote.evaluate_figure(CAST, frame)


def test_a_clip_of_a_called_pose_is_that_pose() -> None:
    called = Performer(CAST)
    called.call_pose("bow", seconds=0.5)
    plays = Performer(CAST)
    plays.play_clip(bowing(), seconds=0)
    for _ in range(20):
        expected, shown = called.advance(DT), plays.advance(DT)
    assert shown.figure is not None
    assert shown.figure.tracked is not None
    apart = np.abs(skin(expected) - skin(shown)).max()
    assert apart < 1e-4, apart  # metres: sixteen bits of a turn at the end of an arm


def test_a_clip_outlives_its_file_and_is_worn_by_parts() -> None:
    from omote.perform.clips.packed_motion import pack_motion, unpack_motion

    clip = bowing()
    (lane,) = clip.lanes
    again = Clip([Lane(unpack_motion(pack_motion(lane.curve)))])
    assert again.parts[-1] == "body"
    performer = Performer(CAST)
    performer.play_clip(again, seconds=0, weights={"mouth": 1.0})
    assert performer.advance(0.5).figure is None


@pytest.mark.parametrize("above", [0.0, 0.3, 1.0])
def test_a_clip_lies_over_a_performer_region_by_region(above: float) -> None:
    random = np.random.default_rng(4)
    count = 3 * len(CAST.bones) + BESIDE_BONES
    called, tracked, played = random.uniform(-1.0, 1.0, (3, count))
    shares = np.array([0.0, 0.25, 0.5, 1.0, 0.75])
    regions = random.integers(0, 5, count)
    figure = with_fields(figure_frame(AT_REST), tracked=TrackedPose(tuple(shares.tolist()), pack_pose(tracked)))
    if not above:
        return
    mixed = wear_body(figure, PlayedBody(played, regions, above)).tracked
    assert mixed is not None
    left = 1.0 - np.array(mixed.shares)[regions]
    shown = left * called + (1.0 - left) * unpack_pose(mixed.pose, len(CAST.bones))
    below = called + shares[regions] * (tracked - called)
    assert np.abs(shown - (below + above * (played - below))).max() < 3 * TURN_STEP


def test_a_panic_leaves_the_body_of_a_clip_without_a_jump() -> None:
    performer = Performer(CAST)
    performer.play_clip(bowing(), seconds=0)
    frames = [performer.advance(DT) for _ in range(40)]
    performer.panic()
    frames += [performer.advance(DT) for _ in range(60)]
    skins = np.array([skin(frame) for frame in frames[30:60:1]])
    steps = np.abs(np.diff(skins, axis=0)).max(axis=(1, 2))
    assert steps.max() < 0.2, steps.max()
    last = performer.advance(5.0)
    assert last.figure is None or last.figure.tracked is None


def test_a_pass_of_a_body_that_plays_has_the_body() -> None:
    plays = Performer(CAST)
    plays.play_clip(bowing(), seconds=0)
    shown = [(frame * DT, plays.advance(DT if frame else 0.0)) for frame in range(30)]
    curve = cut_curve(shown, CAST, start=0.0, stop=1.0)
    assert "body" in curve.parts
    again = Performer(CAST)
    again.play_clip(Clip([Lane(curve)], blend_out=0.0), seconds=0)
    assert np.abs(skin(again.advance(20 * DT)) - skin(shown[20][1])).max() < 2e-4


def test_a_clip_of_a_show_file_from_before_bodies_opens_as_it_was() -> None:
    """Its lanes name six parts, and its columns have places that count the whole face as the seventh."""
    curve = record(Performer(CAST), CAST, seconds=0.1)
    before = stored_clip(Clip([Lane(curve, parts=LAYER_PARTS)]))
    assert max(before.lanes[0].motion.parts) <= WHOLE
    clip = clip_of(read_document(StoredClip, before.encode()))
    assert clip.parts == LAYER_PARTS
    assert (clip.lanes[0].curve.table == curve.table.astype(np.float32)).all()
