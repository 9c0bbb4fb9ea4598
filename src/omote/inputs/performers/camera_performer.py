"""One performer before the camera of one page: landmarks in, frames of a tracker out, and the guide in between."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from omote.inputs.camera.landmark_frame import LandmarkFrame, read_landmark_frame
from omote.inputs.camera.performer_calibration import PerformerCalibration, fit_calibration
from omote.inputs.camera.performer_tracker import PerformerTracker
from omote.inputs.camera.rest_check import advise_on_rest
from omote.inputs.performers.camera_messages import Calibrated
from omote.inputs.performers.guided_calibration import GuidedCalibration
from omote.inputs.trackers.tracker_frame import TrackerFrame

MOST_WAITING = 8
"""Packets that wait for the next tick; the newest push the oldest out."""


@dataclass(frozen=True)
class CalibrationFit:
    """Frames of a guide that has ended, for `fit`, which may take longer than a tick."""

    performer: str
    frames: Mapping[str, Sequence[LandmarkFrame]]
    guided: bool

    def fit(self) -> PerformerCalibration:
        """The calibration; ValueError with what to do where the frames give none."""
        return fit_calibration(self.frames)


@dataclass(eq=False)
class CameraPerformer:
    """name: whose face it is. calibrated: how it is read. chosen: the characters that a page wants it to play, until
    they are routed. unrest: what the face that was taken as at rest does, in a sentence, "" where it rests. unused:
    whether faces were made that no calibration is fitted to. heard, rejected: counts of packets."""

    name: str
    tracker: PerformerTracker | None = None
    calibrated: Calibrated = "no"
    unrest: str = ""
    guide: GuidedCalibration | None = None
    fitting: bool = False
    unused: bool = False
    chosen: list[str] | None = None
    heard: int = 0
    found: bool = False
    weights: dict[str, float] = field(default_factory=dict)
    _made: GuidedCalibration | None = None
    _waiting: deque[bytes] = field(default_factory=lambda: deque(maxlen=MOST_WAITING))

    def use(self, calibration: PerformerCalibration | None, calibrated: Calibrated) -> None:
        """Reads the face by a calibration from now on; with none it is first looked at for a moment at rest.

        calibrated: how that was made.
        """
        self.tracker = None if calibration is None else PerformerTracker(calibration)
        self.unrest = "" if calibration is None else advise_on_rest(calibration)
        self.calibrated = calibrated
        self.fitting = False
        if calibration is None:
            self.begin_guide(rest=True)

    def begin_guide(self, *, rest: bool) -> None:
        """Begins to collect frames: of the guided minute, or of the face at rest alone."""
        self.guide = GuidedCalibration(guided=not rest)

    def redo(self, step: str) -> None:
        """Makes a step again; ValueError where none has been made, or for a name that is no step."""
        guide = self._open_guide()
        guide.redo([step])
        self.guide = guide

    def cancel_guide(self) -> None:
        """Ends a guide; the faces that were made stay. Without a calibration the face at rest is still needed."""
        if self.guide is not None and self.guide.guided and self.guide.frames():
            self.guide.finish()
            self._made = self.guide
        self.guide = None
        self.unused = bool(self.missing)
        if self.tracker is None:
            self.begin_guide(rest=True)

    def continue_guide(self) -> None:
        """Goes on with a guided minute that was ended, at the next face; ValueError where none is missing."""
        guide = self._open_guide()
        if not guide.missing:
            raise ValueError("all faces are made; make one of them again, or the whole minute")
        guide.redo([])
        self.guide = guide

    def take_faces(self, other: CameraPerformer) -> None:
        """Keeps the faces that were made under another name."""
        other.cancel_guide()
        self._made = other._made
        self.unused = other.unused

    def forget_faces(self) -> None:
        """Forgets the faces of a guided minute, also of one that runs."""
        self.guide = None
        self._made = None
        self.unused = False

    def use_faces(self) -> None:
        """Has the calibration fitted to the faces that were made; ValueError where none were."""
        guide = self._open_guide()
        if not guide.frames():
            raise ValueError("no face is made yet; look straight ahead until the first one is")
        guide.finish()
        self.guide = guide

    @property
    def missing(self) -> list[str]:
        """The steps of a guided minute that were not made, where others were."""
        guide = self._guided()
        return guide.missing if guide is not None and guide.frames() else []

    @property
    def redoable(self) -> list[str]:
        """The steps that can be made again without the others."""
        guide = self._guided()
        return [] if guide is None else list(guide.frames())

    def receive(self, data: bytes) -> None:
        """Keeps a packet for the next tick."""
        self.heard += 1
        self._waiting.append(data)

    def read(self, now: float) -> list[TrackerFrame]:
        """The frames that have come since the last tick; PacketError for one that cannot be read, with the reason."""
        frames = []
        while self._waiting:
            frame = read_landmark_frame(self._waiting.popleft())
            self.found = frame.found
            if self.guide is not None:
                self.guide.hear(frame, now)
            if self.tracker is not None:
                frames.append(replace(self.tracker.step(frame), subject=self.name))
        if frames:
            self.weights = dict(frames[-1].weights) or self.weights
        return frames

    def take_fit(self) -> CalibrationFit | None:
        """What is to be fitted, once the guide has all its frames."""
        guide = self.guide
        if guide is None or not guide.done:
            return None
        self.guide = None
        self.fitting = True
        self.unused = self.unused and not guide.guided
        self._made = guide if guide.guided else self._made
        return CalibrationFit(self.name, guide.frames(), guide.guided)

    def _guided(self) -> GuidedCalibration | None:
        """The guided minute that runs, or the last that was made."""
        return self.guide if self.guide is not None and self.guide.guided else self._made

    def _open_guide(self) -> GuidedCalibration:
        """The same; ValueError where there is none."""
        guide = self._guided()
        if guide is None:
            raise ValueError("no step has been made yet; begin the guided minute")
        return guide
