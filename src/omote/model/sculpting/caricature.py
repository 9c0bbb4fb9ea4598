"""Caricature: what distinguishes a face from the generic one, drawn less or more than it is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.distance import cdist

from omote.model.sculpting.extrapolation import extrapolate, repair_folds
from omote.model.sculpting.regions import fit_with_lids, vertex_areas
from omote.model.space.eye_socket import ball_heights, radius_of, set_ball_heights
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.head_regions import eye_frame
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.skin_sheet import refuse_axis_outside

Values = NDArray[np.float64]

_BELL = 0.3
BEHIND = 0.012
"""The back of a caricature's head lies at least so far behind the axis, metres."""
_FARTHEST, _EXACT = 0.06, 1e-4
MOST_AMOUNT = 3.0
"""Of caricature: as far as people still read a face."""


def check_amount(amount: float) -> None:
    """Raises ValueError on an amount of caricature that is out of range, or no number."""
    if not 0.0 <= amount <= MOST_AMOUNT:
        raise ValueError(
            f"a caricature's amount is {amount!r}; expected a number from 0 (the generic face) to {MOST_AMOUNT:g}, 1 "
            "for the face itself, such as 1.5"
        )


def caricature(space: ParameterSpace, face: Face, amount: float, /) -> Face:
    """What distinguishes a face from the generic one, times amount: 0 the generic face, 1 the face, 2 twice itself.

    Up to one it is the linear mix; beyond, only the smooth form grows, by its turns and stretches, so that wrinkles and
    lids stay what they are and nothing folds.

    Parameters
    ----------
    space : ParameterSpace
        The space of the face.
    face : Face
        Who is drawn.
    amount : float
        How much of it.

    Returns
    -------
    Face
        Named after face and amount: "kaori_150".

    Raises
    ------
    ValueError
        On an amount that is not from 0 to 3, or that tears the face.

    Examples
    --------
    >>> omote.caricature(cast.space, cast.faces["kaori"], 1.5).name
    'kaori_150'

    References
    ----------
    docs/sculpts.md, "Mixes and caricature".
    """
    refuse_no_space(space)
    if isinstance(amount, bool) or not isinstance(amount, int | float | np.number):
        raise TypeError(f"a caricature's amount is {amount!r}; expected a number such as 1.5")
    check_amount(amount)
    fitted = fit(space, face)
    within, beyond = min(amount, 1.0), max(amount - 1.0, 0.0)
    name = f"{face.name}_{100 * amount:.0f}"
    skin = space.points + within * (fitted.positions - space.points)
    parts = {name: part.points + within * (fitted.parts[name] - part.points) for name, part in space.parts.items()}
    if beyond == 0.0:
        return fit_with_lids(space, name, skin, parts, {}, face.gains)
    grown = extrapolate(space.points, skin, space.triangles, beyond, _BELL * eye_frame(space)[1])
    further = stand_around_axis(space, grown, f"{face.name} drawn {amount:g} times")
    for part in space.parts.values():
        moves = _bell(space, further - skin, part.points)
        parts[part.name] = (
            _extrapolate_ball(parts[part.name], moves, part.points, beyond) if part.eye else parts[part.name] + moves
        )
    eyes = [name for name, part in space.parts.items() if part.eye]
    lidded = set_ball_heights(
        further,
        {eye: parts[eye] for eye in eyes},
        {eye: ball_heights(fitted.positions, fitted.parts[eye]) for eye in eyes},
    )
    return fit_with_lids(space, name, repair_folds(skin, lidded, space.skin_triangles), parts, {}, face.gains)


def stand_around_axis(space: ParameterSpace, skin: Values, what: str, /) -> Values:
    """The skin (V, 3), moved back as little as puts the cylinder's axis BEHIND metres inside it; itself where it is.

    A head that is smaller than the generic one has its back nearer to the eyes, twice as near when drawn twice. Raises
    ValueError, which names what was drawn, where no place is far enough back.
    """
    way = find_way_back(space, skin)
    if way is None:
        raise ValueError(
            f"{what} itself is too flat or too crooked to stand around the axis of the head; expected a smaller amount"
        )
    return skin - [0.0, 0.0, way] if way else skin


def find_way_back(space: ParameterSpace, skin: Values, /) -> float | None:
    """The least way back, metres, that puts the cylinder's axis BEHIND metres inside a skin (V, 3): 0 where it is; None
    where no place is far enough back."""
    if _is_around_axis(space, skin, 0.0):
        return 0.0
    nearest, farthest = 0.0, _FARTHEST
    if not _is_around_axis(space, skin, farthest):
        return None
    while farthest - nearest > _EXACT:
        middle = 0.5 * (nearest + farthest)
        nearest, farthest = (nearest, middle) if _is_around_axis(space, skin, middle) else (middle, farthest)
    return farthest


def _is_around_axis(space: ParameterSpace, skin: Values, back: float) -> bool:
    """Whether the axis and a line BEHIND metres behind it run inside of a skin (V, 3) that is moved back, metres."""
    axis = space.cylinder
    try:
        for behind in (0.0, BEHIND):
            refuse_axis_outside(skin, space.location_triangles, replace(axis, z=axis.z + back - behind))
    except ValueError:
        return False
    return True


def _extrapolate_ball(ball: Values, moves: Values, generic: Values, beyond: float) -> Values:
    """An eyeball (n, 3) that goes with its surroundings and grows once more as it did from the generic one."""
    size = (radius_of(ball) / radius_of(generic)) ** beyond
    middle = ball.mean(axis=0)
    result: Values = middle + moves.mean(axis=0) + size * (ball - middle)
    return result


def _bell(space: ParameterSpace, difference: Values, where: Values) -> Values:
    """The sheet's difference (V, 3), each point's the mean under a bell around it."""
    width = _BELL * eye_frame(space)[1]
    sheet = np.unique(space.skin_triangles)
    square = cdist(where, space.points[sheet], "sqeuclidean") / (2.0 * width * width)
    bell = vertex_areas(space)[sheet] * np.exp(square.min(axis=1, keepdims=True) - square)
    result: Values = bell @ difference[sheet] / bell.sum(axis=1, keepdims=True)
    return result
