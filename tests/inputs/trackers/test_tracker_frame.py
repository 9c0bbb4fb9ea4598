"""A frame of a face: what no channel can take never gets in."""

import math

import pytest

from omote.inputs.trackers.tracker_frame import LONGEST_SUBJECT, TrackerError, TrackerFrame, check_weight, trim_subject


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -0.51, 1.51])
def test_a_weight_out_of_range_is_rejected_by_its_name(wrong: float) -> None:
    with pytest.raises(TrackerError, match="jawOpen is"):
        TrackerFrame({"jawOpen": wrong})


def test_angles_that_are_no_numbers_are_rejected() -> None:
    with pytest.raises(TrackerError, match="angle"):
        TrackerFrame({}, head=(0.0, math.nan, 0.0))
    with pytest.raises(TrackerError, match="angle"):
        TrackerFrame({}, gaze=(math.inf, 0.0))


def test_a_weight_is_a_number() -> None:
    assert check_weight("jawOpen", 1) == 1.0
    for wrong in ("1", None, True, b"1"):
        with pytest.raises(TrackerError, match="must be a number"):
            check_weight("jawOpen", wrong)


def test_a_subject_can_be_shown() -> None:
    assert trim_subject(" Ada\0\n ") == "Ada"
    assert trim_subject("x" * 200) == "x" * LONGEST_SUBJECT
