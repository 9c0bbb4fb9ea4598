"""How far apart two faces are, in millimetres of mesh.

A morph is even in it by construction: a mix of faces is a sum of their positions, at rest and in any one expression.
"""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.model.space.parameter_space import ParameterSpace


def measure_distance(space: ParameterSpace, one: Values, other: Values, /) -> float:
    """The root mean square of how far the vertices of the skin are apart, millimetres.

    space: of both, whose inner skin does not count; one, other (V, 3): metres.
    """
    away = (one - other)[space.on_sheet]
    return 1000.0 * float(np.sqrt((away**2).sum(axis=1).mean()))
