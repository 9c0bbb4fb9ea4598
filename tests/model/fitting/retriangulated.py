"""Heads of the cast with other triangles and vertices, in another unit and turned: nobody's topology."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import eye_rotation

Values = NDArray[np.float64]

TURN = eye_rotation(0.2, 0.1)


def retriangulate(space: ParameterSpace, face: Face, moves: Mapping[str, Values], seed: int = 0) -> Scan:
    """A face's skin and eyeballs as a scan in centimetres, turned: each triangle is split in three at a random place
    inside it, and the rows are shuffled. moves: displacements (V, 3) of the skin by name."""
    skin = face.positions.astype(np.float64)
    balls = {name: points for name, points in fit(space, face).parts.items() if space.parts[name].eye}
    points = np.concatenate([skin, *balls.values()])
    ends = np.cumsum([len(skin), *(len(each) for each in balls.values())])
    triangles = np.concatenate(
        [space.triangles, *(space.parts[name].triangles + end for name, end in zip(balls, ends, strict=False))]
    )
    draw = np.random.default_rng(seed)
    shares = draw.dirichlet([4.0, 4.0, 4.0], size=len(triangles))
    middles = np.arange(len(triangles)) + len(points)
    order = draw.permutation(len(points) + len(triangles))
    new = np.concatenate([np.column_stack([triangles[:, [k, (k + 1) % 3]], middles]) for k in range(3)])

    def spread(values: Values) -> Values:
        whole = np.concatenate([values, np.zeros((len(points) - len(values), 3))])
        both = np.concatenate([whole, np.einsum("tk,tkc->tc", shares, whole[triangles])])
        return np.asarray(100.0 * both[order] @ TURN.T)

    rank = np.argsort(order)
    return Scan(spread(points), rank[new], shapes={name: spread(each) for name, each in moves.items()})
