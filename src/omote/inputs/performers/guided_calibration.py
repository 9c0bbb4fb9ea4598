"""A guided calibration: one step after the other, each held while the face is seen; the frames are kept by step."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.performers.calibration_steps import CALIBRATION_STEPS, READY_SECONDS, REST_STEP, CalibrationStep
from omote.perform.limits import check_known

LONGEST_GAP = 0.25
"""Seconds that one frame counts for at most: while pictures come late, a step waits."""
LEAST_FRAMES = 8
"""Of a step: fewer are no measure, and it goes on."""
MOST_FRAMES = 200
"""Of a step; what a fast camera has more is left out."""


@dataclass(frozen=True)
class StepState:
    """What a performer sees of a calibration. left: seconds of this phase; done: the steps that have their frames."""

    step: CalibrationStep
    phase: Literal["ready", "hold"]
    left: float
    done: tuple[str, ...]


class GuidedCalibration:
    """One run. guided: the whole minute, or a face at rest alone."""

    def __init__(self, *, guided: bool, ready: float = READY_SECONDS) -> None:
        self.guided = guided
        self._ready = ready if guided else 0.0
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

    def state(self) -> StepState | None:
        """The step that is being made; None when all are done."""
        if self.done:
            return None
        step = self._steps[self._order[0]]
        ready = self._elapsed < self._ready
        end = self._ready if ready else self._ready + step.hold
        done = tuple(name for name in self._steps if name in self._kept and name not in self._order)
        return StepState(step, "ready" if ready else "hold", max(end - self._elapsed, 0.0), done)

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
        self._elapsed, self._held = 0.0, []

    def finish(self) -> None:
        """Leaves out the steps that are not made; the one that is being made counts as before it began."""
        self._order, self._elapsed, self._held = [], 0.0, []

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
            self._order, self._elapsed, self._held = self._order[1:], 0.0, []
