"""What a voice becomes every 10 ms: the weights of 15 visemes, and how loud it is."""

from __future__ import annotations

import math
from dataclasses import dataclass

from omote.perform.speech.visemes import SIL, VISEMES, Viseme

SUM_TOLERANCE = 1e-3


@dataclass(frozen=True)
class VisemeFrame:
    """10 ms of a voice. time: seconds of sound before the end of the frame; weights: of the 15 visemes, sum 1.

    level: dB of full scale, 0 the loudest; gate: 0..1, how far it is above the noise.
    """

    time: float
    weights: tuple[float, ...]
    level: float
    gate: float

    def __post_init__(self) -> None:
        """Rejects weights that are no shares of one mouth; ValueError with the value."""
        if len(self.weights) != len(VISEMES):
            raise ValueError(f"a frame has {len(self.weights)} visemes; there are {len(VISEMES)}")
        total = math.fsum(self.weights)
        if not abs(total - 1.0) < SUM_TOLERANCE or min(self.weights) < 0.0:
            raise ValueError(f"the weights of the visemes sum to {total}; they are shares of 1")
        if not 0.0 <= self.gate <= 1.0:
            raise ValueError(f"the gate is {self.gate}; it is 0 to 1")
        if not math.isfinite(self.level):
            raise ValueError(f"the level is {self.level}; it is a number of dB")

    @property
    def speaks(self) -> float:
        """How sure it is that somebody speaks, 0..1."""
        return self.gate * (1.0 - self.weights[SIL])

    @property
    def strongest(self) -> Viseme:
        """The viseme of the largest weight."""
        return VISEMES[max(range(len(VISEMES)), key=self.weights.__getitem__)]
