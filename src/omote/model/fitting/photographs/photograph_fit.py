"""Fits the generic head to photographs of somebody: a face with our topology, and where each camera was."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.fit_face import Follow, say_nothing
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.photographs.bundle import adjust
from omote.model.fitting.photographs.bundle_problem import Bundle
from omote.model.fitting.photographs.landmark_table import LandmarkTable, refuse_other_space
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.fitting.photographs.photograph_doubts import find_photograph_doubts
from omote.model.fitting.photographs.skin.skin_samples import SkinSamples
from omote.model.fitting.shape.face_closing import close_face
from omote.model.fitting.shape.fold_mending import find_folds
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PhotographFit:
    """Photographs as a face.

    Attributes
    ----------
    face : Face
        With our topology, at rest, in the space's frame.
    cameras : tuple of PhotographCamera
        Of each photograph, relative to the face.
    units : tuple of mapping of float, by the name of an expression
        What the face does in each photograph, as far as its landmarks say.
    residual : tuple of float
        How far the landmarks of each lie from the face, beside what they err by as a rule: root mean square, pixels.
    spread : float
        How far the face may lie from the person's, millimetres, standard deviation over the face, as far as people are
        as those from whom this was learned.
    doubts : tuple of str
        What the photographs do not say, and what should be looked at, in sentences.

    Examples
    --------
    >>> fit = omote.fit_photographs(cast.space, [front, left, right])  # doctest: +SKIP
    >>> cast.with_faces(fit.face)  # doctest: +SKIP

    References
    ----------
    K. Arai (1993), section 5.1 and [8]: faces from photographs.
    """

    face: Face
    cameras: tuple[PhotographCamera, ...]
    units: tuple[dict[str, float], ...]
    residual: tuple[float, ...]
    spread: float
    doubts: tuple[str, ...]


def fit_photograph_views(
    space: ParameterSpace, modes: IdentityModes, table: LandmarkTable, photographs: Sequence[Photograph], /, *,
    skin: SkinSamples | None = None, name: str = "photograph", follow: Follow | None = None,
) -> PhotographFit:  # fmt: skip
    """Fits the generic head to photographs of one person: shape, cameras and expressions together.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    modes : IdentityModes
        What heads differ by.
    table : LandmarkTable
        How the landmark model errs.
    photographs : sequence of Photograph
        One or more, of one person.
    skin : SkinSamples, optional
        Where the skin is looked at in photographs that come with pictures; without it landmarks and outlines count.
    name : str
        The face's.
    follow : callable, optional
        Told how much is done, 0 to 1, and what is being done.

    Returns
    -------
    PhotographFit
        The face, the cameras, what is not known.

    Raises
    ------
    ValueError
        Without photographs, and where modes or table are of another head than the space's.

    References
    ----------
    Blanz and Vetter (1999), "A morphable model for the synthesis of 3D faces"; Akimoto, Suenaga and Wallace (1993), [8]
    of the paper.
    """
    refuse_other_topology(space, modes)
    refuse_other_space(space, table)
    if not photographs:
        raise ValueError("there are no photographs; expected at least one")
    tell = follow or say_nothing
    tell(0.0, "shape and cameras")
    found = adjust(space, modes, table, photographs, skin)
    tell(0.8, "eyes and mouth")
    head, parts = modes.shape_skin(found.weights), modes.shape_parts(found.weights)
    face = close_face(space, name, space.points, head, parts)
    residual = tuple(
        float(np.sqrt((error**2).sum() * 2 / len(error))) * camera.focal / float(-camera.shift[2])
        for error, camera in zip(found.errors, found.cameras, strict=True)
    )
    spread = _spread(modes, found)
    tell(1.0, "done")
    folds = len(find_folds(space, space.points, face.positions.astype(np.float64)))
    doubts = find_photograph_doubts(photographs, found, residual, spread, folds)
    return PhotographFit(face, found.cameras, _worn(table, found), residual, spread, doubts)


def _worn(table: LandmarkTable, found: Bundle) -> tuple[dict[str, float], ...]:
    return tuple(
        {name: float(weight) for name, weight in zip(table.units, units, strict=True) if weight > 0.0}
        for units in found.units
    )


def _spread(modes: IdentityModes, found: Bundle) -> float:
    """Millimetres: what the modes' standard deviations make of the skin."""
    flat = modes.moves.reshape(len(modes.moves), -1)
    variance = ((found.deviations[:, None] * flat) ** 2).sum() / modes.skin.shape[0]
    return 1000.0 * float(np.sqrt(variance))
