"""The mouth of a new face at rest: lips that meet, a bag that meets the gums and stays inside the head."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth.gum_line import GumLine, find_gum_line, measure_gums, meet_gums
from omote.model.transfer.mouth.lip_closure import close_behind_lips, close_lips
from omote.model.transfer.mouth_bag_fit import fit_mouth_bag_at_rest, measure_shallow, place_bag

Floats = NDArray[np.float32]

# A mouth is out of order where a tenth of the gums' edges are farther from their places in the bag than FLOATING, a
# crown is through its wall, or the bag lies SHALLOW less deep than on the generic face, metres: no face of the cast's
# is.
FLOATING, SHALLOW = 0.0016, 0.0004
# What closes behind the lips brings the bag out again, by less each time: so many turns at most, until it lies less
# than LEFT, metres, too shallow.
TURNS, LEFT = 8, 0.0002


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
    found = place_bag(space, line.bag, closed.astype(np.float32), placed)
    for _ in range(TURNS):
        inside = fit_mouth_bag_at_rest(space, found)
        found = close_behind_lips(space, inside).astype(np.float32)  # the bag begins at the lips' inner edge
        if measure_shallow(space, found) <= LEFT:
            break
    return found


def mend_mouth(space: ParameterSpace, face: Face, /) -> Face:
    """A face made of others or from control points with its mouth in order; itself where that is so.

    Its lips are closed; its bag is fitted anew only where it is out of order, for faces in order mix to such.
    ValueError where the face does not belong to the space.
    """
    fitted = fit(space, face)
    line = find_gum_line(space)
    if line is not None and _is_out_of_order(space, line, fitted.positions, fitted.parts):
        positions = fit_mouth_at_rest(space, fitted.positions, fitted.parts)
    else:
        positions = close_lips(space, fitted.positions).astype(np.float32)
    return face if np.array_equal(positions, fitted.positions) else replace(face, positions=positions)


def _is_out_of_order(
    space: ParameterSpace, line: GumLine, positions: Floats, parts: Mapping[str, NDArray[np.floating]]
) -> bool:  # fmt: skip
    edges, crowns = measure_gums(line, positions.astype(np.float64), parts)
    return bool(np.quantile(edges, 0.9) > FLOATING or crowns.min() < 0.0) or measure_shallow(space, positions) > SHALLOW
