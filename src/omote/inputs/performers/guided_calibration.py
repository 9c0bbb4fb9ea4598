"""A guided calibration: one step after the other, each held while the face is seen; the frames are kept by step."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.performers.calibration_steps import CALIBRATION_STEPS, READY_SECONDS, REST_STEP, CalibrationStep
from omote.inputs.performers.camera_messages import GuideStep
from omote.perform.limits import check_known

LONGEST_GAP = 0.25
"""Seconds that one frame counts for at most: while pictures come late, a step waits."""
LEAST_FRAMES = 8
"""Of a step: fewer are no measure, and it goes on."""
MOST_FRAMES = 200
"""Of a step; what a fast camera has more is left out."""


class GuidedCalibration:
    """One run. guided: the whole minute, or a face at rest alone."""

    def __init__(self, *, guided: bool) -> None:
        self.guided = guided
        self._ready = READY_SECONDS if guided else 0.0
        self._steps: Mapping[str, CalibrationStep] = CALIBRATION_STEPS if guided else {REST_STEP.name: REST_STEP}
        self._kept: dict[str, tuple[LandmarkFrame, ...]] = {}
        self._held: list[LandmarkFrame] = []
        self._elapsed = 0.0
        self._heard: float | None = None
        self._order: list[str] = list(self._steps)

    @property
    def done(self) -> bool:
        """Whether every step has its frames."""
        return not self._order

    def step(self) -> GuideStep | None:
        """The step that is being made, as its page shows it; None when all are done."""
        if self.done:
            return None
        step = self._steps[self._order[0]]
        ready = self._elapsed < self._ready
        left = max(self._ready + (0.0 if ready else step.hold) - self._elapsed, 0.0)
        done = [name for name in self._steps if name in self._kept and name not in self._order]
        return GuideStep(
            step=step.name,
            advice=step.advice,
            phase="ready" if ready else "hold",
            left=round(left, 2),
            seconds=READY_SECONDS if ready else step.hold,
            number=len(done) + 1,
            of=len(self._steps),
            done=done,
        )

    def frames(self) -> dict[str, tuple[LandmarkFrame, ...]]:
        """The frames of each step that was made, in the order of the steps."""
        return {name: self._kept[name] for name in self._steps if name in self._kept}

    @property
    def missing(self) -> list[str]:
        """The steps that have no frames yet."""
        return [name for name in self._steps if name not in self._kept]

    def redo(self, names: Iterable[str]) -> None:
        """Makes steps again, next, then those that are missing; a step's frames stay until it has others. ValueError
        for a name that is none of them."""
        again = [check_known(name, self._steps, "step") for name in names]
        self._order = [*again, *(name for name in self.missing if name not in again)]
        self._elapsed = 0.0
        self._held = []

    def finish(self) -> None:
        """Leaves out the steps that are not made; the one that is being made counts as before it began."""
        self._order = []
        self._elapsed = 0.0
        self._held = []

    def hear(self, frame: LandmarkFrame, now: float) -> None:
        """Takes a frame; time passes while the face is seen. now: seconds of a clock that never jumps back."""
        passed = 0.0 if self._heard is None else min(max(now - self._heard, 0.0), LONGEST_GAP)
        self._heard = now
        if self.done or not frame.found:
            return
        self._elapsed += passed
        if self._elapsed < self._ready:
            return
        if len(self._held) < MOST_FRAMES:
            self._held.append(frame)
        name = self._order[0]
        if self._elapsed >= self._ready + self._steps[name].hold and len(self._held) >= LEAST_FRAMES:
            self._kept[name] = tuple(self._held)
            self._order = self._order[1:]
            self._elapsed = 0.0
            self._held = []
