"""A recording: whole, and its frame at any time."""

import pytest

from omote.inputs.takes.take import Take

TAKE = Take(("a", "b"), (0.0, 0.5, 0.5, 2.0), ((0.0, 0.1),) * 4, ((3.0, 0.0, 0.0),) * 4)


@pytest.mark.parametrize(("seconds", "frame"), [(-1.0, 0), (0.0, 0), (0.49, 0), (0.5, 2), (1.9, 2), (2.0, 3), (9.0, 3)])
def test_the_newest_frame_at_a_time_is_found(seconds: float, frame: int) -> None:
    assert TAKE.frame_at(seconds) == frame
    assert TAKE.seconds == 2.0


def test_a_head_is_turned_as_far_as_ours_and_a_gaze_that_is_not_there_is_none() -> None:
    head = TAKE.head(1)
    assert head is not None
    assert 1.5 < head[0] < 1.6
    assert TAKE.gaze(1) is None


def test_what_is_not_whole_is_rejected() -> None:
    with pytest.raises(ValueError, match="no frames"):
        Take(("a",), (), ())
    with pytest.raises(ValueError, match="1 times"):
        Take(("a",), (0.0,), ((0.0,),), heads=((0.0, 0.0, 0.0),) * 2)
