"""A clip as frames at a rate."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.interchange.clips.clip_frames import sample_clip
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from tests.interchange.clips.motion import moving_clip


def test_frames_are_those_of_the_recording_at_its_rate(cast: Cast) -> None:
    clip = moving_clip(cast)
    curve = clip.lanes[0].curve
    column = {name: curve.table[:, place] for place, name in enumerate(curve.layout.columns)}
    frames = sample_clip(clip)
    assert frames.times == pytest.approx(curve.times, abs=1e-12)
    assert (frames.weights["jawOpen"] == column["channel/jawOpen"]).all()
    assert frames.weights["smile"] == pytest.approx(column["mouth/smile"], abs=1e-15)
    assert (frames.head[:, 0] == column["head/yaw"]).all()
    assert (frames.gaze[:, 1] == column["gaze/pitch"]).all()
    assert frames.notes == ()


def test_speed_and_trim_count_and_a_muted_clip_is_at_rest(cast: Cast) -> None:
    clip = moving_clip(cast)
    assert len(sample_clip(replace(clip, speed=2.0)).times) == 16
    assert len(sample_clip(replace(clip, start=0.25)).times) == 16
    still = sample_clip(Clip([replace(clip.lanes[0], muted=True)]))
    assert not still.weights
    assert not still.head.any()


def test_the_last_frame_has_the_end() -> None:
    """Of 30 rows of a take whose times are no frames: its length comes back within one."""
    times = np.arange(30) / 30.0 * 0.9999
    clip = Clip([Lane(make_curve(times, {"jawOpen": times}, {}))])
    frames = sample_clip(clip)
    assert 0.0 <= frames.times[-1] - clip.seconds < 1.0 / 60.0
    assert frames.weights["jawOpen"][-1] == times[-1]


def test_an_expression_of_some_regions_alone_is_said() -> None:
    curve = make_curve([0.0, 1.0], {}, {}, mixes={"mouth": {"joy": [0.8, 0.8], "neutral": [0.2, 0.2]}})
    frames = sample_clip(Clip([Lane(curve)]), rate=1.0)
    assert frames.notes == ("joy shows in some regions alone, and is written by its mean weight",)
    assert frames.weights["joy"] == pytest.approx(np.full(2, 0.2))


def test_a_weight_that_only_the_curve_between_frames_takes_below_0_ends_there() -> None:
    times = np.arange(6) / 10.0
    blink = np.array([0.0, 0.1, 0.2, 0.0, 0.0, 0.0])
    clip = Clip([Lane(make_curve(times, {"eyeBlinkLeft": blink, "jawOpen": blink - 0.1}, {}))])
    between = [clip.sample(at).values[clip.layout.columns.index("channel/eyeBlinkLeft")] for at in (0.31, 0.32, 0.33)]
    assert -0.02 < min(between) < -0.001, "the cubic goes below"
    weights = sample_clip(clip).weights
    assert weights["eyeBlinkLeft"].min() == 0.0
    assert weights["jawOpen"].min() < -0.1, "what somebody meant stays"


@pytest.mark.parametrize("rate", [0.0, 241.0])
def test_a_rate_that_is_none_is_refused(cast: Cast, rate: float) -> None:
    with pytest.raises(ValueError, match="the frames of a second"):
        sample_clip(moving_clip(cast), rate=rate)
