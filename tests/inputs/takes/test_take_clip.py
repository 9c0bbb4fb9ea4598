"""Recordings of trackers as clips."""

from __future__ import annotations

import numpy as np
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


def test_a_cut_has_the_motion_of_its_part(cast: Cast) -> None:
    random = np.random.default_rng(3)
    times = np.cumsum(random.uniform(0.01, 0.03, 200))
    take = Take(("jawOpen",), [*(times - times[0])], [(value,) for value in random.uniform(0.0, 1.0, 200).tolist()])
    whole = clip_of_take(take, cast)
    cut = clip_of_take(take, cast, start=1.25, stop=2.5)
    assert (cut.start, cut.seconds) == (0.0, 1.25)
    assert len(cut.lanes[0].curve.times) < 100
    for position in np.linspace(0.0, 1.25, 77).tolist():
        there, here = whole.sample(1.25 + position), cut.sample(position)
        assert here.values == pytest.approx(there.values, abs=1e-9)
        assert here.shares == pytest.approx(there.shares, abs=1e-12)


@pytest.mark.parametrize(("start", "stop"), [(2.0, 1.0), (0.0, 3.5), (4.0, None), (-1.0, None)])
def test_a_cut_that_is_not_in_the_recording_is_refused(cast: Cast, start: float, stop: float | None) -> None:
    take = Take(("jawOpen",), [0.0, 3.0], [(0.0,), (1.0,)])
    with pytest.raises(ValueError, match=r"is no part of the recording, which is 3\.000 s long"):
        clip_of_take(take, cast, start=start, stop=stop)
