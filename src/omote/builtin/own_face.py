"""Scans as faces of the built-in head: found, placed and fitted with the modes that were baked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from omote.builtin import load_head_kinds, load_identity_modes, load_landmark_table
from omote.builtin.own_skin import load_skin_samples
from omote.model.fitting.doubt import PLACE, Doubt, join_doubts
from omote.model.fitting.find_head import HeadPlacement, find_head, validate_landmarks
from omote.model.fitting.fit_face import Fit, Follow, say_nothing
from omote.model.fitting.fit_kinds import fit_kinds
from omote.model.fitting.landmarks import FEWEST_LANDMARKS
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_fit import PhotographFit, fit_photograph_views
from omote.model.fitting.scan import Scan
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space

FOUND = 0.5
"""The share of the work on a scan that is done once its head is found."""


def fit(
    space: ParameterSpace, positions: ArrayLike, triangles: ArrayLike | None = None, /, *,
    colours: ArrayLike | None = None, landmarks: Mapping[str, ArrayLike] | None = None, name: str = "scan",
    shut: bool | None = None,
) -> Fit:  # fmt: skip
    """Fits the generic head to a scan, a mesh of any topology or a cloud of points, in any unit and about any axes.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    positions : array_like, (n, 3)
        Points.
    triangles : array_like of int, (t, 3), optional
        Rows of positions, counterclockwise from outside; without them the points are a cloud.
    colours : array_like of uint8, (n, 3), optional
        sRGB of each point.
    landmarks : mapping of array_like (3,), by name
        Where the head is not found by its shape: at least three of left_eye_outer, left_eye_inner, right_eye_inner,
        right_eye_outer, nose_tip, mouth_left, mouth_right, in the positions' frame; left is the character's own. Of an
        animal five or more.
    name : str
        The face's.
    shut : bool, optional
        Whether the eyes of the scan are shut; None looks.

    Returns
    -------
    Fit
        Its face, how far that is from the scan, what was seen, and doubts in words.

    Raises
    ------
    ValueError
        On arrays that are no scan, too few or unknown landmarks, and where no head is found.

    Examples
    --------
    >>> kaori = cast.faces["kaori"]
    >>> found = omote.fit(cast.space, 1000.0 * kaori.positions, cast.space.triangles, name="Kaori again")
    >>> found.face.name, found.placement.scale
    ('Kaori again', 0.001)

    References
    ----------
    K. Arai (1993), section 5.1.
    """
    refuse_no_space(space)
    scan = Scan(
        np.asarray(positions), None if triangles is None else np.asarray(triangles),
        None if colours is None else np.asarray(colours),
    )  # fmt: skip
    points = {} if landmarks is None else validate_landmarks(landmarks)
    return fit_scan(space, scan, landmarks=points, name=name, shut=shut)[1]


class NoFaceError(ValueError):
    """No face could be made of a scan; the message says why.

    Parameters
    ----------
    why : str
        A sentence without its full stop, or doubts.
    place : HeadPlacement, optional
        Where the head was taken to be; None where none was found.
    doubts : tuple of Doubt
        What should be looked at or said, so that a face can be made.
    """

    def __init__(self, why: str, place: HeadPlacement | None, doubts: tuple[Doubt, ...]) -> None:
        super().__init__(why)
        self.place = place
        self.doubts = doubts


def fit_scan(
    space: ParameterSpace, scan: Scan, /, *, landmarks: Mapping[str, ArrayLike], name: str, shut: bool | None = None,
    follow: Follow | None = None,
) -> tuple[HeadPlacement, Fit]:  # fmt: skip
    """Finds the head in a scan and fits the generic one to it: all faces of scans are made here.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    scan : Scan
        In its own frame and unit.
    landmarks : mapping of array_like (3,), by name
        Of the seven points, in the scan's frame: three or more say where the head is, fewer guide the fit alone, five
        or more that are no person's begin it from an animal.
    name, shut
        As of `fit`.
    follow : callable, optional
        Told how much is done, 0 to 1, and what is being done.

    Returns
    -------
    tuple of HeadPlacement, Fit
        Where the head is, and its face with the doubts of both.

    Raises
    ------
    NoFaceError
        Where no head is found, or none can be fitted.
    """
    tell = follow or say_nothing
    tell(0.0, "the head is sought")
    try:
        place = find_head(
            space, load_identity_modes(), scan, landmarks=landmarks if len(landmarks) >= FEWEST_LANDMARKS else None
        )
    except ValueError as error:
        raise NoFaceError(str(error), None, (Doubt(f"{error}.", PLACE),)) from error

    def tell_fit(done: float, what: str) -> None:
        tell(FOUND + (1.0 - FOUND) * done, what)

    try:
        fitted = fit_kinds(
            space, load_head_kinds(), scan, place, landmarks=landmarks, name=name, shut=shut, follow=tell_fit
        )
    except ValueError as error:
        # What is no face of our space was no head where it was looked for: that helps, the other is an engineer's.
        why = " ".join(place.doubts) or str(error)
        doubts = place.doubts or (Doubt(f"No face could be fitted: {error}.", PLACE),)
        raise NoFaceError(why, place, doubts) from error
    return place, replace(fitted, doubts=join_doubts(place.doubts, fitted.doubts))


def fit_photographs(
    space: ParameterSpace, photographs: Sequence[Photograph], /, *, name: str = "photograph",
    follow: Follow | None = None,
) -> PhotographFit:  # fmt: skip
    """Fits the generic head to photographs of one person in which a landmark model found a face.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    photographs : sequence of Photograph
        One or more; from the front and from both sides they say most. Nobody needs to know the cameras.
    name : str
        The face's.
    follow : callable, optional
        Told how much is done, 0 to 1, and what is being done.

    Returns
    -------
    PhotographFit
        The face, the cameras, and in doubts what the photographs do not say.

    Raises
    ------
    ValueError
        Without photographs, and on a space of another head.

    Examples
    --------
    >>> front = omote.Photograph(landmarks, 1200, 1600, focal=26.0)  # doctest: +SKIP
    >>> omote.fit_photographs(cast.space, [front]).doubts  # doctest: +SKIP
    ('One photograph shows how wide and tall a face is; only shades and what ...',)

    References
    ----------
    K. Arai (1993), section 5.1; docs/decisions/photographs.md.
    """
    refuse_no_space(space)
    return fit_photograph_views(
        space, load_identity_modes(), load_landmark_table(), photographs, skin=load_skin_samples(), name=name,
        follow=follow,
    )  # fmt: skip
