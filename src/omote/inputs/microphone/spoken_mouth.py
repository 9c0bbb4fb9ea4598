"""The mouth of a voice: visemes followed, and how much of the layer *lips* they take; silence takes nothing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from omote.arrays import Values
from omote.inputs.microphone.sound_features import FRAME_SECONDS
from omote.inputs.microphone.viseme_frame import VisemeFrame
from omote.perform.layers.follower import follow_number, rate_of
from omote.perform.speech.viseme_stream import VisemeStream, follow_visemes
from omote.perform.speech.visemes import SIL, VISEMES

RISE_SECONDS = 0.03
FALL_SECONDS = 0.4
"""In which a voice takes its layer when it begins, and lets it go."""
HOLD_SECONDS = 0.3
"""The longest pause in which the layer is not let go: a closure, a breath between words."""
SPEAKS = 0.35
GONE = 1e-3
"""A share that cannot be seen."""
_SILENCE = np.array([float(place == SIL) for place in range(len(VISEMES))])


class SpokenMouth:
    """The mouth of one voice."""

    def __init__(self) -> None:
        self._stream = VisemeStream()
        self._first = self._second = 0.0
        self._since = HOLD_SECONDS

    @property
    def mouth(self) -> Values:
        """Weights of `MOUTH_UNITS`."""
        return self._stream.mouth

    @property
    def share(self) -> float:
        """How much of its layer the voice takes, 0..1."""
        return self._second if self._second > GONE else 0.0

    def follow(self, frames: Sequence[VisemeFrame]) -> None:
        """Goes on by these frames."""
        for frame in frames:
            self._step(np.array(frame.weights), frame.gate, frame.speaks > SPEAKS, FRAME_SECONDS)

    def rest(self, seconds: float) -> None:
        """Goes on without a sound."""
        self._step(_SILENCE, 0.0, False, seconds)

    def _step(self, weights: Values, level: float, speaks: bool, seconds: float) -> None:
        self._stream = follow_visemes(self._stream, weights, level, seconds)
        self._since = 0.0 if speaks else self._since + seconds
        goal = float(self._since < HOLD_SECONDS)
        rate = rate_of(RISE_SECONDS if goal else FALL_SECONDS)
        self._first, self._second = follow_number(self._first, self._second, goal, rate, seconds)
