"""Recordings of trackers as clips."""

from __future__ import annotations

import pytest

from omote.inputs.takes.take import Take
from omote.inputs.takes.take_clip import clip_of_take
from omote.model.cast import Cast


def test_a_recording_is_a_clip_with_its_own_times(cast: Cast) -> None:
    take = Take(
        ("jawOpen", "eyeLookUpLeft"),
        [0.0, 0.1, 0.1, 0.3],
        [(0.1, 0.5), (9.0, 0.5), (0.2, 0.5), (1.6, 0.5)],
        [(0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.2, 0.0, 0.0), (9.0, 0.0, 0.0)],
        [(0.1, 0.0)] * 4,
    )
    clip = clip_of_take(take, cast, lane="a")
    (lane,) = clip.lanes
    curve = lane.curve
    assert (lane.name, curve.times.tolist(), clip.seconds) == ("a", [0.0, 0.1, 0.3], 0.3)
    column = {name: curve.table[:, place].tolist() for place, name in enumerate(curve.layout.columns)}
    assert column["channel/jawOpen"] == pytest.approx([0.1, 0.2, 1.5])
    assert column["head/yaw"] == pytest.approx([0.0, 0.2, 1.5707963])  # as far as ours turns
    assert "channel/eyeLookUpLeft" not in column  # the gaze turns the eyes
    assert clip_of_take(Take(("jawOpen",), [0.0, 1.0], [(0.0,), (1.0,)]), cast).parts == (
        "brows",
        "eyes",
        "mouth",
        "rest",
    )


def test_one_frame_is_no_clip(cast: Cast) -> None:
    with pytest.raises(ValueError, match="where it has not begun"):
        clip_of_take(Take(("jawOpen",), [0.0], [(0.5,)]), cast)
