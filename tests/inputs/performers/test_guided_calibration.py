"""A guided calibration: time passes while the face is seen, each step keeps its frames, steps can be made again."""

import pytest

from omote.inputs.performers.calibration_steps import CALIBRATION_STEPS, READY_SECONDS, REST_STEP
from omote.inputs.performers.guided_calibration import LEAST_FRAMES, MOST_FRAMES, GuidedCalibration
from tests.inputs.performers.landmarks import landmarks

FRAME = 1.0 / 30.0


class Session:
    """A guide and its clock."""

    def __init__(self, *, guided: bool = True) -> None:
        self.guide = GuidedCalibration(guided=guided)
        self.now = 10.0

    def show(self, seconds: float, *, found: bool = True, every: float = FRAME) -> None:
        for _ in range(round(seconds / every)):
            self.now += every
            self.guide.hear(landmarks(self.now, found=found), self.now)

    def step(self) -> str:
        made = self.guide.step()
        return "" if made is None else made.step

    def make(self, count: int) -> None:
        for _ in range(count):
            before = self.step()
            while self.step() == before:
                self.show(FRAME)


def test_every_step_is_made_once_in_its_order() -> None:
    session = Session()
    made = []
    while not session.guide.done:
        made.append(session.step())
        session.make(1)
    assert made == list(CALIBRATION_STEPS)
    frames = session.guide.frames()
    assert list(frames) == made
    assert all(LEAST_FRAMES <= len(each) <= MOST_FRAMES for each in frames.values())
    assert session.guide.step() is None


def test_the_frames_of_a_step_are_those_after_it_was_got_ready() -> None:
    session = Session()
    begun = session.now
    session.make(1)
    first = session.guide.frames()["neutral"][0]
    assert first.time - begun >= READY_SECONDS


def test_a_step_waits_while_the_face_is_not_seen() -> None:
    session = Session()
    session.show(1.0)
    before = session.guide.step()
    session.show(60.0, found=False)
    assert session.guide.step() == before


def test_a_step_waits_for_pictures_that_come_late() -> None:
    session = Session()
    session.show(READY_SECONDS + 2.0 * FRAME)
    session.show(CALIBRATION_STEPS["neutral"].hold + 4.0, every=2.0)  # four frames are no measure
    assert session.step() == "neutral"
    session.show(3.0)
    assert session.step() == "shut"


def test_a_step_is_made_again_and_then_what_is_left() -> None:
    session = Session()
    session.make(3)
    kept = session.guide.frames()
    session.guide.redo(["shut"])
    assert session.step() == "shut"
    session.make(1)
    assert session.step() == "smile"
    assert session.guide.frames()["neutral"] == kept["neutral"]
    assert session.guide.frames()["shut"] != kept["shut"]


def test_a_step_is_made_again_when_all_are_done() -> None:
    session = Session()
    session.make(len(CALIBRATION_STEPS))
    session.guide.redo(["puff"])
    assert not session.guide.done
    session.make(1)
    assert session.guide.done


def test_what_is_left_out_stays_to_be_made_and_what_was_made_stays() -> None:
    session = Session()
    session.make(3)
    kept = session.guide.frames()
    session.guide.redo(["shut"])
    session.guide.finish()
    assert session.guide.done
    assert session.guide.frames() == kept
    assert session.guide.missing == list(CALIBRATION_STEPS)[3:]
    session.guide.redo([])
    assert session.step() == session.guide.missing[0]


def test_a_step_that_nobody_knows_is_rejected() -> None:
    with pytest.raises(ValueError, match="no step 'wink'"):
        GuidedCalibration(guided=True).redo(["wink"])


def test_a_start_needs_only_the_face_at_rest() -> None:
    session = Session(guided=False)
    session.show(REST_STEP.hold + 2.0 * FRAME)
    assert list(session.guide.frames()) == ["neutral"]
    assert session.guide.done
