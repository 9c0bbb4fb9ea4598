"""The mouth of a new face at rest: lips that meet, a bag that meets the gums and stays inside the head."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth.gum_line import find_gum_line, meet_gums
from omote.model.transfer.mouth.lip_closure import close_lips
from omote.model.transfer.mouth_bag_fit import fit_mouth_bag_at_rest, place_bag

Floats = NDArray[np.float32]


def fit_mouth_at_rest(
    space: ParameterSpace, positions: Floats, parts: Mapping[str, NDArray[np.floating]], /
) -> Floats:  # fmt: skip
    """A new face at rest (V, 3) with its mouth put in order, its parts placed: all else stays.

    Parameters
    ----------
    space : ParameterSpace
        The face's.
    positions : ndarray, (V, 3)
        Skin and inner skin, metres.
    parts : mapping of ndarray (n, 3), by name
        Where its teeth are.
    """
    closed = close_lips(space, positions)
    line = find_gum_line(space)
    if line is None:
        return fit_mouth_bag_at_rest(space, closed.astype(np.float32))
    placed = meet_gums(line, closed, parts)
    inside = fit_mouth_bag_at_rest(space, place_bag(space, line.bag, closed.astype(np.float32), placed))
    return close_lips(space, inside).astype(np.float32)  # the bag begins at the lips' inner edge
