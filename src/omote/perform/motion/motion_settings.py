"""What an operator sets of a character's automatic motion."""

from __future__ import annotations

from dataclasses import dataclass, replace

from omote.perform.limits import check_within

MOST_SEED = 2**31 - 1
DETAILS = ("blinks", "gaze", "breath")
DETAIL_LIMIT = 2.0


@dataclass(frozen=True)
class MotionSettings:
    """How much a character moves by itself.

    Parameters
    ----------
    liveliness : float
        0 off; 0.5 as people are, by the literature; 1 lively.
    blinks, gaze, breath : float
        Each beside the others, 0 (none) to 2 (twice as much); the head that follows goes with the gaze, noise with
        the breath.
    seed : int
        Which of all ways to move, 0 to 2147483647: the same seed moves the same.

    Raises
    ------
    ValueError
        On a number out of range.
    TypeError
        On what is no number.
    """

    liveliness: float = 0.0
    blinks: float = 1.0
    gaze: float = 1.0
    breath: float = 1.0
    seed: int = 0

    def __post_init__(self) -> None:
        """Rejects what is out of range."""
        object.__setattr__(self, "liveliness", check_within(self.liveliness, 0.0, 1.0, "the liveliness"))
        for name in DETAILS:
            value = check_within(getattr(self, name), 0.0, DETAIL_LIMIT, f"the {name} of the automatic motion")
            object.__setattr__(self, name, value)
        check_within(self.seed, 0, MOST_SEED, "the seed of the automatic motion")
        if self.seed != int(self.seed):
            raise ValueError(f"the seed of the automatic motion is {self.seed}; expected a whole number")
        object.__setattr__(self, "seed", int(self.seed))

    @property
    def blink_rate(self) -> float:
        """How often lids close, 1 as at rest; 0 never."""
        return self.blinks * (0.6 + 0.8 * self.liveliness) if self.liveliness else 0.0

    @property
    def reach(self) -> float:
        """How far eyes go elsewhere, 1 as people's do."""
        return self.gaze * 2.0 * self.liveliness

    @property
    def depth(self) -> float:
        """How much breath and noise move, 1 as they are stated."""
        return self.breath * 2.0 * self.liveliness

    def change(self, **given: float | None) -> MotionSettings:
        """The same with what is given; None leaves a setting as it is."""
        return replace(self, **{name: value for name, value in given.items() if value is not None})  # type: ignore[arg-type]
