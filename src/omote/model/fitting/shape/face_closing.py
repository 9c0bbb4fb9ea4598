"""Makes a face of a fitted skin: lids on its eyes, lips that meet, linings behind its skin, folds mended."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.shape.fitted_eyes import seat_lids
from omote.model.fitting.shape.fold_mending import mend_folds
from omote.model.sculpting.socket_depth import fit_lining_at_rest
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth.mouth_at_rest import fit_mouth_at_rest

Values = NDArray[np.float64]


def close_face(
    space: ParameterSpace, name: str, guide: Values, skin: Values, parts: Mapping[str, Values], /
) -> Face:  # fmt: skip
    """The face of a fitted skin (V, 3) and parts by name; guide (V, 3): a head without folds near it.

    ValueError where it is no face of this space.
    """
    seated = seat_lids(space, skin, {part: parts[part] for part in space.parts if space.parts[part].eye})
    seated = mend_folds(space, guide, seated)
    placed = {part: points.astype(np.float32) for part, points in parts.items()}
    closed = fit_mouth_at_rest(space, seated.astype(np.float32), placed)
    face = Face(name, fit_lining_at_rest(space, closed), placed)
    fit(space, face)  # refuses what is no face of this space
    return face
