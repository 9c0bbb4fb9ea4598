"""Landmarks: seven named points of a face, and those of the 68 of iBUG that the space names by itself, as rows of the
generic head (Sagonas et al. 2013, "300 Faces in-the-Wild Challenge")."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace

SEVEN = (
    "left_eye_outer", "left_eye_inner", "right_eye_inner", "right_eye_outer", "nose_tip", "mouth_left", "mouth_right",
)  # fmt: skip
"""The points that people are asked to click; left is the character's own."""
FEWEST_LANDMARKS = 3
"""Fewer do not say where a face is."""
# A midline is so much wider than nothing, in widths of the mouth.
_MIDLINE = 0.01
# Bends of a profile are sought above what the mouth's opening and its lips take, in heights from mouth to nose tip.
_LIPS = 0.35


def find_landmarks(space: ParameterSpace, /) -> Mapping[str, int]:
    """The rows of the seven landmarks on the generic head: corners of lids and lips, the farthest point of the nose.

    Parameters
    ----------
    space : ParameterSpace
        With named lines of two pairs of lids and of the lips.

    Returns
    -------
    mapping of int, by name
        A row of `space.points` for each of `SEVEN`, in this order.

    Raises
    ------
    ValueError
        Where the space has no such lines, or no nose between them.

    Examples
    --------
    >>> from omote.model.fitting.landmarks import find_landmarks
    >>> rows = find_landmarks(cast.space)
    >>> bool(cast.space.points[rows["mouth_left"], 0] > 0)  # left is at +x
    True
    """
    left, right, lips = _face_lines(space)
    (left_inner, left_outer), (right_outer, right_inner) = _corners(space, left), _corners(space, right)
    mouth_right, mouth_left = _corners(space, lips)
    nose = _profile(space, left, right, lips)[-1]
    rows = (left_outer, left_inner, right_inner, right_outer, int(nose), mouth_left, mouth_right)
    return MappingProxyType(dict(zip(SEVEN, rows, strict=True)))


def find_ibug_landmarks(space: ParameterSpace, /) -> Mapping[int, int]:
    """The rows of those of iBUG's 68 landmarks, counted from 0, that lines and profile of the generic head name: nose
    bridge and tip (27 to 30), the nose's root above the lip (33), lids (36 to 47) and the inner lips (60 to 67).

    Parameters
    ----------
    space : ParameterSpace
        With named lines of two pairs of lids and of the lips.

    Returns
    -------
    mapping of int, by number
        A row of `space.points` for each. Contours of the jaw, brows, nostrils and the lips' red are not named: neither
        lines nor profile say where they are.

    Raises
    ------
    ValueError
        As `find_landmarks`.

    Examples
    --------
    >>> from omote.model.fitting.landmarks import find_ibug_landmarks, find_landmarks
    >>> find_ibug_landmarks(cast.space)[30] == find_landmarks(cast.space)["nose_tip"]
    True
    """
    left, right, lips = _face_lines(space)
    profile = _profile(space, left, right, lips)
    found = dict(zip(range(27, 31), _spread(space, profile, 4), strict=True))
    found[33] = _nose_root(space, int(profile[-1]), lips)
    found |= dict(zip((36, 37, 38, 39, 40, 41), _ring(space, right, 2), strict=True))
    found |= dict(zip((42, 43, 44, 45, 46, 47), _ring(space, left, 2), strict=True))
    found |= dict(zip(range(60, 68), _ring(space, lips, 3), strict=True))
    return MappingProxyType(found)


def _face_lines(space: ParameterSpace) -> tuple[Line, Line, Line]:
    """The lines of the left lids, the right lids and the lips."""
    lids = sorted((line for line in space.lines if line.kind == "lids"), key=lambda line: _middle(space, line)[0])
    lips = [line for line in space.lines if line.kind == "lips"]
    if len(lids) != 2 or len(lips) != 1:
        raise ValueError(
            f"the space names {len(lids)} pairs of lids and {len(lips)} pairs of lips; expected two and one, by which "
            "landmarks are found: name them with with_line"
        )
    return lids[1], lids[0], lips[0]


def _middle(space: ParameterSpace, line: Line) -> NDArray[np.float64]:
    middle: NDArray[np.float64] = space.points[line.loop].mean(axis=0)
    return middle


def _corners(space: ParameterSpace, line: Line) -> tuple[int, int]:
    """The rows of a line's two corners, the character's right one first."""
    across = space.points[line.loop, 0]
    return int(line.loop[across.argmin()]), int(line.loop[across.argmax()])


def _midline(space: ParameterSpace, lips: Line) -> NDArray[np.intp]:
    """The rows of the sheet's front on the plane of symmetry."""
    x, _, z = space.points.T
    near = np.abs(x - _middle(space, lips)[0]) < _MIDLINE * np.ptp(space.points[lips.loop, 0])
    return np.flatnonzero(near & space.on_sheet & (z > space.cylinder.z))


def _profile(space: ParameterSpace, left: Line, right: Line, lips: Line) -> NDArray[np.intp]:
    """The rows of the midline from between the eyes down to the nose's tip, its farthest point above the lips."""
    rows = _midline(space, lips)
    eyes = (_middle(space, left)[1] + _middle(space, right)[1]) / 2
    mouth = _middle(space, lips)[1]
    height = space.points[rows, 1]
    # The lips themselves may stand out farther than a small nose.
    nose = rows[(height < eyes) & (height > mouth + _LIPS * (eyes - mouth))]
    if not len(nose):
        raise ValueError("the space has no points between eyes and lips on its midline; expected a nose there")
    tip = nose[space.points[nose, 2].argmax()]
    bridge = rows[(height < eyes) & (height >= space.points[tip, 1])]
    result: NDArray[np.intp] = bridge[np.argsort(-space.points[bridge, 1], kind="stable")]
    return np.append(result[result != tip], tip)


def _nose_root(space: ParameterSpace, tip: int, lips: Line) -> int:
    """The row of the midline between nose tip and mouth that lies deepest beneath the straight line between them."""
    rows = _midline(space, lips)
    top, mouth = space.points[tip], _middle(space, lips)
    height = space.points[rows, 1]
    below = rows[(height < top[1]) & (height > mouth[1] + _LIPS * (top[1] - mouth[1]))]
    if not len(below):
        return tip
    share = (space.points[below, 1] - mouth[1]) / (top[1] - mouth[1])
    return int(below[(space.points[below, 2] - (mouth[2] + share * (top[2] - mouth[2]))).argmin()])


def _spread(space: ParameterSpace, rows: NDArray[np.intp], count: int) -> list[int]:
    """So many of the rows at equal shares of the heights from the first to the last, both included."""
    height = space.points[rows, 1]
    goals = np.linspace(height[0], height[-1], count)
    return [int(rows[np.abs(height - goal).argmin()]) for goal in goals]


def _ring(space: ParameterSpace, line: Line, between: int) -> list[int]:
    """The right corner, so many of the upper half, the left corner, as many of the lower half, at equal shares of
    arc."""
    upper, lower = chains(space.points, line.loop)
    shares = np.linspace(0.0, 1.0, between + 2)
    return [_at_share(space, upper, share) for share in shares] + [
        _at_share(space, lower, share) for share in shares[-2:0:-1]
    ]


def _at_share(space: ParameterSpace, chain: NDArray[np.int32], share: float) -> int:
    """The row of a chain nearest to a share of its length."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(space.points[chain], axis=0), axis=1))])
    return int(chain[np.abs(length / length[-1] - share).argmin()])
