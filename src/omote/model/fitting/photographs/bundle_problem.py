"""What is adjusted where photographs are fitted: the unknowns and where each stands among them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.photographs.landmark_table import LandmarkTable
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.fitting.photographs.view_errors import POSE
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

LIGHTS, PAINTS = 9, 3
"""Numbers of a photograph's light, and of what is painted on a person's skin."""


@dataclass(frozen=True, eq=False)
class Bundle:
    """What explains the photographs: weights (m,) of the modes, their standard deviations (m,); what each person is
    beside that (q,); of each photograph a camera, weights (u,) of units and errors (2 p,) in metres.

    lights (v, 9): of each photograph, the logarithm of its brightness on the person's skin and how it falls off, as
    shares; paint (3,): how much lips, brows and cheeks are lighter than that, logarithms; empty where nobody looked.
    """

    weights: Values
    deviations: Values
    person: Values
    cameras: tuple[PhotographCamera, ...]
    units: tuple[Values, ...]
    errors: tuple[Values, ...]
    lights: Values
    paint: Values


@dataclass(frozen=True, eq=False)
class Problem:
    """What is adjusted: photographs on a space; of the p landmarks, where they lie on the mean head (p, 3), and how
    modes (m, p, 3) and units (u, p, 3) move them; each photograph's lens, counted; brightness of the pictures."""

    space: ParameterSpace
    modes: IdentityModes
    table: LandmarkTable
    photographs: Sequence[Photograph]
    mean: Values
    moves: Values
    units: Values
    lenses: list[int]
    luma: list[Values | None]

    @property
    def own(self) -> int:
        """How many unknowns each photograph has beside its lens: six of a pose, units."""
        return POSE - 1 + len(self.units)

    @property
    def common(self) -> int:
        """How many unknowns all photographs share: modes, the person beside them."""
        return len(self.moves) + int(self.table.person.shape[2])

    @property
    def lit(self) -> int:
        """Where the lights of the photographs stand, after modes, person, views and lenses; then paint."""
        return self.common + len(self.photographs) * self.own + max(self.lenses) + 1

    @property
    def size(self) -> int:
        """How many unknowns there are."""
        return self.lit + LIGHTS * len(self.photographs) + PAINTS

    def columns(self, view: int) -> NDArray[np.intp]:
        """The unknowns on which a photograph depends: modes, person, turn, shift, lens, units."""
        first = self.common + view * self.own
        lens = self.common + len(self.photographs) * self.own + self.lenses[view]
        found: NDArray[np.intp] = np.r_[
            : self.common, first : first + POSE - 1, lens, first + POSE - 1 : first + self.own
        ]
        return found
