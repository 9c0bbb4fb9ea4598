"""A frame of a face: what no channel can take never gets in, and costs nothing else."""

import math

import pytest

from omote.inputs.trackers.tracker_frame import LONGEST_SUBJECT, TrackerError, TrackerFrame, read_weight, trim_subject


@pytest.mark.parametrize(
    ("wrong", "taken", "why"),
    [
        (math.nan, None, "no number"),
        (math.inf, None, "no number"),
        (-0.51, -0.5, "-0.51, so -0.5 is taken"),
        (3e38, 1.5, "3e"),
    ],
)
def test_a_weight_that_no_channel_takes_costs_itself_and_is_said(wrong: float, taken: float | None, why: str) -> None:
    frame = TrackerFrame({"jawOpen": wrong, "cheekPuff": 0.5}, head=(0.1, 0.2, 0.3))
    assert frame.weights == {"cheekPuff": 0.5} | ({} if taken is None else {"jawOpen": taken})
    assert frame.head == (0.1, 0.2, 0.3)
    ((name, reason),) = frame.left_out
    assert name == "jawOpen"
    assert why in reason


@pytest.mark.parametrize("wrong", [math.nan, -math.inf, 1e30])
def test_an_angle_that_is_none_costs_its_head_or_its_gaze(wrong: float) -> None:
    frame = TrackerFrame({"jawOpen": 0.5}, head=(0.0, wrong, 0.0), gaze=(0.1, 0.0))
    assert (frame.weights, frame.head, frame.gaze) == ({"jawOpen": 0.5}, None, (0.1, 0.0))
    assert [name for name, _ in frame.left_out] == ["head"]
    assert TrackerFrame(gaze=(wrong, 0.0)).gaze is None


def test_a_weight_is_a_number_of_any_size() -> None:
    assert read_weight("jawOpen", 1) == 1.0
    assert read_weight("jawOpen", 72.0) == 72.0
    for wrong in ("1", None, True, b"1"):
        with pytest.raises(TrackerError, match="must be a number"):
            read_weight("jawOpen", wrong)


def test_a_subject_can_be_shown() -> None:
    assert trim_subject(" Ada\0\n ") == "Ada"
    assert trim_subject("x" * 200) == "x" * LONGEST_SUBJECT
