"""Landmarks: seven named points of a face, as rows of the generic head."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from omote.arrays import Values

if TYPE_CHECKING:  # who asks for the names of the points alone waits for no SciPy
    from omote.model.space.lid_lip_lines import Line
    from omote.model.space.parameter_space import ParameterSpace

SEVEN = (
    "left_eye_outer", "left_eye_inner", "right_eye_inner", "right_eye_outer", "nose_tip", "mouth_left", "mouth_right",
)  # fmt: skip
"""The points that people are asked to click; left is the character's own."""
FEWEST_LANDMARKS = 3
"""Fewer do not say where a face is."""
# A midline is so much wider than nothing, in widths of the mouth.
_MIDLINE = 0.01
# The nose is sought above what the mouth's opening and its lips take, in heights from mouth to nose tip.
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
    (left_inner, left_outer) = _corners(space, left)
    (right_outer, right_inner) = _corners(space, right)
    mouth_right, mouth_left = _corners(space, lips)
    nose = _nose_tip(space, left, right, lips)
    rows = (left_outer, left_inner, right_inner, right_outer, nose, mouth_left, mouth_right)
    return MappingProxyType(dict(zip(SEVEN, rows, strict=True)))


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


def _middle(space: ParameterSpace, line: Line) -> Values:
    return space.points[line.loop].mean(axis=0)


def _corners(space: ParameterSpace, line: Line) -> tuple[int, int]:
    """The rows of a line's two corners, the character's right one first."""
    across = space.points[line.loop, 0]
    return int(line.loop[across.argmin()]), int(line.loop[across.argmax()])


def _nose_tip(space: ParameterSpace, left: Line, right: Line, lips: Line) -> int:
    """The row of the midline's farthest point between eyes and lips."""
    x, height, ahead = space.points.T
    near = np.abs(x - _middle(space, lips)[0]) < _MIDLINE * np.ptp(space.points[lips.loop, 0])
    eyes = (_middle(space, left)[1] + _middle(space, right)[1]) / 2
    mouth = _middle(space, lips)[1]
    # The lips themselves may stand out farther than a small nose.
    between = (height < eyes) & (height > mouth + _LIPS * (eyes - mouth))
    nose = np.flatnonzero(near & between & space.on_sheet & (ahead > space.cylinder.z))
    if not len(nose):
        raise ValueError("the space has no points between eyes and lips on its midline; expected a nose there")
    return int(nose[ahead[nose].argmax()])
