"""What of a photograph is behind a head, though a head that was fitted a little too wide lies over it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter

from omote.model.albedo import Light
from omote.model.appearance.lab import to_lab

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]
Rows = NDArray[np.intp]

BAND = 0.015
"""Metres in from where a fitted head ends, within which what is behind it may be seen."""
OUTSIDE, INSIDE, BLUR = 0.008, 0.006, 0.001
"""Metres beyond the end where only what is behind is, and beyond the band where only the head is; of the blur."""
MARGIN = 0.02
"""Metres around the head that are looked at."""
UNLIKE = 12.0
"""L*a*b* by which both have to differ where a place is told from one of them."""


def find_background(picture: Light, depth: NDArray[np.floating], at: Values, metre: float, /) -> Mask:
    """Which places of a head show what is behind it: those near its end in the picture that are more like what lies
    beside the head than like what lies farther in.

    Parameters
    ----------
    picture : ndarray, (h, w, 3)
        Linear light.
    depth : ndarray, (h, w)
        Of the fitted head; infinity beside it.
    at : ndarray, (n, 2)
        Places in the picture, pixels, right and down.
    metre : float
        Pixels that a metre takes at the head.
    """
    head, found = np.isfinite(depth), np.zeros(len(at), np.bool_)
    if head.all() or not head.any():
        return found
    left, top, right, low = _frame(head, round(MARGIN * metre))
    head, picture = head[top:low, left:right], picture[top:low, left:right]
    size = np.array(head.shape)
    places = np.clip((at - [left, top])[:, ::-1].astype(np.intp), 0, size - 1)
    away, nearest = distance_transform_edt(head, return_indices=True)
    far = away[places[:, 0], places[:, 1]]
    rows = np.flatnonzero((far > 0.0) & (far < BAND * metre))
    end = nearest[:, places[rows, 0], places[rows, 1]].T
    told, outer, inner = _look_across(head, end, (places[rows] - end) / far[rows, None], metre)
    rows = rows[told]
    soft = gaussian_filter(picture, (BLUR * metre, BLUR * metre, 0.0))
    here, behind, skin = (
        to_lab(light[where[:, 0], where[:, 1]].astype(np.float64))
        for light, where in ((picture, places[rows]), (soft, outer), (soft, inner))
    )
    to_behind, to_skin, apart = (
        np.linalg.norm(one - other, axis=1) for one, other in ((here, behind), (here, skin), (behind, skin))
    )
    found[rows] = (to_behind < to_skin) & (to_behind < 0.5 * apart) & (apart > UNLIKE)
    return found


def _look_across(head: Mask, end: Rows, inward: Values, metre: float) -> tuple[Rows, Rows, Rows]:
    """Which ends (n, 2) of the head have both sides in the picture, and the pixels (k, 2) beside and well inside it."""
    outer = np.rint(end - OUTSIDE * metre * inward).astype(np.intp)
    inner = np.rint(end + (BAND + INSIDE) * metre * inward).astype(np.intp)
    whole = ((np.minimum(outer, inner) >= 0) & (np.maximum(outer, inner) < head.shape)).all(axis=1)
    told = np.flatnonzero(whole)
    told = told[~head[tuple(outer[told].T)] & head[tuple(inner[told].T)]]
    return told, outer[told], inner[told]


def _frame(head: Mask, margin: int) -> tuple[int, int, int, int]:
    """The least and the first too large column and row of a head's pixels, so many pixels around it."""
    (top, low), (left, right) = (np.flatnonzero(head.any(axis=axis))[[0, -1]].tolist() for axis in (1, 0))
    return max(left - margin, 0), max(top - margin, 0), right + 1 + margin, low + 1 + margin
