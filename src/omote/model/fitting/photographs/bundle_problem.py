"""What is adjusted where photographs are fitted: the unknowns, and how far landmarks lie from a head in a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from omote.arrays import Rows, Values
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.photographs.landmark_table import LandmarkTable
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.space.parameter_space import ParameterSpace

POSE = 7
"""A camera changes by a turn (3,), a shift (3,) and the logarithm of its focal length."""
LIGHTS = 9
PAINTS = 3
"""Numbers of a photograph's light, and of what is painted on a person's skin."""


def measure_errors(pixels: Values, camera: PhotographCamera, places: Values, /) -> Values:
    """How far landmarks (p, 2) in pixels lie right of and above the places (p, 3) of a head, at their depth, (2 p,)
    metres.

    pixels (p, 2): right and down; camera: of the photograph; places (p, 3): metres.
    """
    seen = camera.view(places)
    off = (pixels - camera.project(seen)) * (-seen[:, 2:] / camera.focal)
    return (off * [1.0, -1.0]).ravel()


def change_by_places(camera: PhotographCamera, places: Values, moves: Values, /) -> Values:
    """How the errors change with moves (n, p, 3) of the places (p, 3): (2 p, n).

    camera: of the photograph; places (p, 3), moves (n, p, 3): metres.
    """
    seen = camera.view(places)
    moved = moves @ camera.rotation.T
    return -_in_picture(seen, moved)


def change_by_pose(camera: PhotographCamera, places: Values, /) -> Values:
    """How the errors change with `PhotographCamera.move`: (2 p, 7).

    camera: of the photograph; places (p, 3): metres.
    """
    seen = camera.view(places)
    turned = places @ camera.rotation.T
    turns = np.stack([np.cross(axis, turned) for axis in np.eye(3)])
    shifts = np.broadcast_to(np.eye(3)[:, None], (3, len(places), 3))
    return -np.column_stack([_in_picture(seen, np.concatenate([turns, shifts])), seen[:, :2].ravel()])


def _in_picture(seen: Values, moved: Values) -> Values:
    """How moves (n, p, 3) in the camera's frame show at each point's own depth: (2 p, n)."""
    aside = moved[..., :2] - seen[:, :2] * (moved[..., 2:] / seen[:, 2:])
    return aside.reshape(len(moved), -1).T


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

    def columns(self, view: int) -> Rows:
        """The unknowns on which a photograph depends: modes, person, turn, shift, lens, units."""
        first = self.common + view * self.own
        lens = self.common + len(self.photographs) * self.own + self.lenses[view]
        return np.r_[: self.common, first : first + POSE - 1, lens, first + POSE - 1 : first + self.own]
