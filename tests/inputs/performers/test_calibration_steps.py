"""The guided minute: the steps that the fit knows, and a minute together."""

from omote.inputs.camera.guided_steps import NEUTRAL, STEPS
from omote.inputs.performers.calibration_steps import CALIBRATION_STEPS, READY_SECONDS, REST_STEP


def test_the_steps_are_those_that_the_fit_knows_and_take_a_minute() -> None:
    assert tuple(CALIBRATION_STEPS) == STEPS
    assert 50.0 <= sum(READY_SECONDS + step.hold for step in CALIBRATION_STEPS.values()) <= 65.0
    assert all(step.advice for step in CALIBRATION_STEPS.values())


def test_a_start_needs_two_seconds_at_rest() -> None:
    assert (REST_STEP.name, REST_STEP.hold) == (NEUTRAL, 2.0)
