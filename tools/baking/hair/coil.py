"""Hair that is bound: a coil wound around a ball on the head, and a tail that falls."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tools.baking.heads.basemesh import Floats

SUNK = 0.45  # of its radius, that the ball lies in the hair beneath it


@dataclass(frozen=True, eq=False)
class Coil:
    """A ball of `radius` metres on the head at `foot` (3,), wound from `count` strands, `turns` times each."""

    foot: Floats
    radius: float
    count: int = 160
    turns: float = 0.8

    def wind(self, outward: Floats, stations: int, *, seed: int) -> Floats:
        """The strands (count, stations, 3), spread over the ball; outward (3,): away from the head at its foot.

        seed: of its small irregularities.
        """
        chance = np.random.default_rng(seed).uniform(size=(self.count, 3))
        along = np.linspace(0.0, 1.0, stations)
        level = 1.9 * ((np.arange(self.count) + chance[:, 0]) / self.count) - 0.9
        height = np.clip(level[:, None] + 0.35 * (along - 0.5) * (chance[:, 1:2] - 0.2), -0.98, 0.98)
        angle = 2 * np.pi * (chance[:, 2:3] + self.turns * along)
        across, aside = _upright(outward)
        round_ = np.sqrt(1.0 - height**2)
        ball = (
            height[..., None] * outward
            + (round_ * np.cos(angle))[..., None] * across
            + (round_ * np.sin(angle))[..., None] * aside
        )
        size = self.radius * (0.9 + 0.12 * chance[:, :1, None])
        return np.asarray(self.foot + (1.0 - SUNK) * self.radius * outward + size * ball)


@dataclass(frozen=True, eq=False)
class Tail:
    """`count` strands bound at `foot` (3,) in a bundle of `radius` metres, which fall `length` metres at most."""

    foot: Floats
    radius: float
    length: float
    count: int = 220
    arc: float = 0.028  # metres that it stands off before it falls

    def wind(self, outward: Floats, stations: int, *, seed: int) -> Floats:
        """The strands (count, stations, 3); outward (3,): away from the head at its foot.

        seed: of its small irregularities.
        """
        chance = np.random.default_rng(seed).uniform(size=(self.count, 4))
        along = np.linspace(0.0, 1.0, stations)
        across, aside = _upright(outward)
        angle = 2 * np.pi * chance[:, :1]
        bundle = self.radius * np.sqrt(chance[:, 1:2]) * (1.0 + 0.9 * np.sin(np.pi * along**0.7) - 0.45 * along)
        off = self.arc * (1.0 - np.exp(-7.0 * along)) * (1.0 + 0.25 * (chance[:, 2:3] - 0.5))
        fall = self.length * (0.72 + 0.28 * chance[:, 3:]) * along * np.clip(along / 0.35, 0.25, 1.0)
        return np.asarray(
            self.foot
            + (bundle * np.cos(angle))[..., None] * across
            + (bundle * np.sin(angle))[..., None] * aside
            + off[..., None] * outward
            + fall[..., None] * np.array([0.0, -1.0, 0.0])
        )


def _upright(outward: Floats) -> tuple[Floats, Floats]:
    """Two unit vectors (3,) square to one and to each other."""
    across = np.cross(outward, [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    return np.asarray(across), np.asarray(np.cross(outward, across))
