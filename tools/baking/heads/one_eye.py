"""Keeps units of one eye out of the other's socket: the published blink moves the lining of both by 5 mm."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.socket_skin import find_socket_lining
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.basemesh import Floats
from tools.baking.heads.moves import Move

# What units of one eye end in, and on which side of the middle (the sign of x) that eye lies: left is the head's own.
SIDES: Mapping[str, float] = {"Left": 1.0, "Right": -1.0}


def leave_other_socket(space: ParameterSpace, moves: Mapping[str, Move], /) -> dict[str, Move]:
    """The moves with the lining of one socket at rest in what moves the other eye, and so in what is performed with it.

    The lids of that socket are at rest there already.

    space: of the generic face; moves: by expression.
    """
    lining = find_socket_lining(space)
    if lining is None:
        return dict(moves)
    inside = np.isin(space.welded, lining.vertices)
    strays = {name: _stray(space, inside, name, move) for name, move in moves.items() if name not in PERFORMED}
    found = {name: strays[name] for name in moves if name in strays}
    for name in PERFORMED.keys() & moves.keys():
        weights = unit_weights(PERFORMED[name])
        found[name] = sum((weight * strays[unit] for unit, weight in weights.items()), np.zeros_like(space.points))
    return {name: Move(move.skin - found[name], move.parts) for name, move in moves.items()}


def _stray(space: ParameterSpace, inside: np.ndarray, name: str, move: Move) -> Floats:
    """What a unit does to the lining of the socket that is not its own, (V, 3) metres; nothing for any other unit."""
    side = next((sign for end, sign in SIDES.items() if name.startswith("eye") and name.endswith(end)), 0.0)
    other = inside & (side * space.points[:, 0] < 0.0)
    return np.asarray(np.where(other[:, None], move.skin, 0.0))
