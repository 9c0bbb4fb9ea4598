"""Scans as faces of the built-in head: found, placed and fitted with the modes that were baked."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from omote.builtin import load_identity_modes
from omote.model.fitting.fit_face import Fit, fit_face
from omote.model.fitting.landmarks import FEWEST_LANDMARKS, SEVEN, find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.similarity import Similarity, fit_similarity


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
        At least three of left_eye_outer, left_eye_inner, right_eye_inner, right_eye_outer, nose_tip, mouth_left,
        mouth_right, in the positions' frame; left is the character's own.
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
        On arrays that are no scan, too few or unknown landmarks, and where there is no head.

    Examples
    --------
    >>> kaori = cast.faces["kaori"]
    >>> rows = {"left_eye_outer": 2427, "right_eye_outer": 2438, "nose_tip": 54}  # doctest: +SKIP
    >>> clicks = {name: kaori.positions[row] for name, row in rows.items()}  # doctest: +SKIP
    >>> omote.fit(cast.space, kaori.positions, cast.space.triangles, landmarks=clicks).doubts  # doctest: +SKIP
    ()

    References
    ----------
    K. Arai (1993), section 5.1; docs/own-faces.md.
    """
    refuse_no_space(space)
    scan = Scan(
        np.asarray(positions), None if triangles is None else np.asarray(triangles),
        None if colours is None else np.asarray(colours),
    )  # fmt: skip
    placement = _place_by_landmarks(space, landmarks or {})
    return fit_face(space, load_identity_modes(), scan, placement, landmarks=landmarks, name=name, shut=shut)


def _place_by_landmarks(space: ParameterSpace, landmarks: Mapping[str, ArrayLike]) -> Similarity:
    known = [name for name in SEVEN if name in landmarks]
    if len(known) < FEWEST_LANDMARKS:
        raise ValueError(
            f"{len(known)} landmarks are given; expected at least {FEWEST_LANDMARKS} of {', '.join(SEVEN)}"
        )
    rows = find_landmarks(space)
    points = np.array([np.asarray(landmarks[name], np.float64) for name in known])
    return fit_similarity(points, space.points[[rows[name] for name in known]], np.ones(len(known)))
