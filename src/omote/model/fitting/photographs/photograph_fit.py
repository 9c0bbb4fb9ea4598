"""Fits the generic head to photographs of somebody: a face with our topology, where each camera was, and doubts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from omote.model.fitting.fit_face import Follow, close_face, say_nothing
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.photographs.bundle import adjust
from omote.model.fitting.photographs.bundle_problem import Bundle
from omote.model.fitting.photographs.face_at_rest import describe_unrest
from omote.model.fitting.photographs.landmark_table import LandmarkTable, refuse_other_space
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.skin_evidence import SkinSamples
from omote.model.fitting.skin_repair import find_folds
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace

TURNED = np.radians(25.0)
"""From so far on a head shows its profile, and its other cheek no more."""
STRANGE = 2.0
LARGE = 0.015
FOLDS = 5
SIDES = {"front": 0.0, "left": -1.0, "right": 1.0}
"""Of a photograph that was said to show a side of the head, the sign of the turn that shows it."""


def find_photograph_doubts(
    photographs: Sequence[Photograph], bundle: Bundle, units: Sequence[Mapping[str, float]],
    residual: Sequence[float], spread: float, folds: int, /,
) -> tuple[str, ...]:  # fmt: skip
    """Sentences on a fit, none where it is sure.

    photographs, bundle: what was fitted, and how; units: what the face does in each photograph, weights by the name of
    an expression; residual: pixels of each photograph; spread: millimetres; folds: how many triangles are folded.
    """
    yaws = [camera.yaw for camera in bundle.cameras]
    return (
        *_of_views(yaws, spread),
        *_of_each(photographs, bundle, residual),
        *_of_rest(photographs, yaws, units),
        *_of_shape(bundle, folds),
    )


def _of_views(yaws: Sequence[float], spread: float) -> list[str]:
    """What is not seen from where the cameras were."""
    if len(yaws) == 1:
        return [
            "One photograph shows how wide and tall a face is; only shades and what people's faces have in common tell "
            f"how far nose, brow and chin stand out, about {spread:.1f} mm off. Add one from each side, or turn the "
            "head."
        ]
    doubts = []
    if max(yaws) < TURNED:
        doubts.append("No photograph shows the head from its right; that side is made up.")
    if min(yaws) > -TURNED:
        doubts.append("No photograph shows the head from its left; that side is made up.")
    if min(abs(yaw) for yaw in yaws) > TURNED:
        doubts.append("No photograph shows the head from the front; add one.")
    return doubts


def _of_each(photographs: Sequence[Photograph], bundle: Bundle, residual: Sequence[float]) -> list[str]:
    """What is odd about single photographs."""
    doubts = []
    for number, (photograph, camera, left) in enumerate(zip(photographs, bundle.cameras, residual, strict=True), 1):
        if left * float(-camera.shift[2]) / camera.focal > LARGE:
            doubts.append(f"Photograph {number} does not fit: its landmarks lie {left:.0f} pixels off; look at them.")
        said = SIDES.get(photograph.side or "")
        if said and said * camera.yaw < 0.0 and abs(camera.yaw) > TURNED:
            doubts.append(f"Photograph {number} was said to show the {photograph.side}, and shows the other side.")
    return doubts


def _of_rest(
    photographs: Sequence[Photograph], yaws: Sequence[float], units: Sequence[Mapping[str, float]]
) -> list[str]:
    """What faces do that are not at rest, and what can be done."""
    said = []
    for number, (photograph, yaw, worn) in enumerate(zip(photographs, yaws, units, strict=True), 1):
        if words := describe_unrest(photograph, yaw, worn):
            said.append(
                f"Photograph {number} shows {' and '.join(words)}. That was taken out as far as it is known, and what "
                "is between lips is left out of the colours; lips and cheeks may stay off. Better is one with the "
                "face at rest: lips together, eyes open."
            )
    return said


def _of_shape(bundle: Bundle, folds: int) -> list[str]:
    """What is odd about the head."""
    doubts = []
    strange = float(np.sqrt((bundle.weights**2).mean()))
    if strange > STRANGE:
        doubts.append("The head is unlike those of people; look whether all photographs show one person.")
    if folds > FOLDS:
        doubts.append(f"The skin stays folded at {folds} triangles; look at them, or smooth them.")
    return doubts


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
    bundle = adjust(space, modes, table, photographs, skin)
    tell(0.8, "eyes and mouth")
    head = modes.shape_skin(bundle.weights)
    parts = modes.shape_parts(bundle.weights)
    face = close_face(space, name, space.points, head, parts)
    residual = tuple(
        float(np.sqrt((error**2).sum() * 2 / len(error))) * camera.focal / float(-camera.shift[2])
        for error, camera in zip(bundle.errors, bundle.cameras, strict=True)
    )
    spread = _measure_spread(modes, bundle)
    tell(1.0, "done")
    folds = len(find_folds(space, space.points, face.positions.astype(np.float64)))
    units = _worn(table, bundle)
    doubts = find_photograph_doubts(photographs, bundle, units, residual, spread, folds)
    return PhotographFit(face, bundle.cameras, units, residual, spread, doubts)


def _worn(table: LandmarkTable, bundle: Bundle) -> tuple[dict[str, float], ...]:
    return tuple(
        {name: float(weight) for name, weight in zip(table.units, units, strict=True) if weight > 0.0}
        for units in bundle.units
    )


def _measure_spread(modes: IdentityModes, bundle: Bundle) -> float:
    """Millimetres: what the modes' standard deviations make of the skin."""
    flat = modes.moves.reshape(len(modes.moves), -1)
    variance = ((bundle.deviations[:, None] * flat) ** 2).sum() / modes.skin.shape[0]
    return 1000.0 * float(np.sqrt(variance))
