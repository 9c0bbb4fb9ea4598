"""Cuts a mesh along a level line of a number that its vertices have."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, eye_array, vstack

from omote.arrays import Triangles, Values


@dataclass(frozen=True, eq=False)
class CutMesh:
    """blend (m, n): the vertices as sums of those before, first themselves, then those on the line; under, over
    (t, 3): the triangles on both sides."""

    blend: csr_array
    under: Triangles
    over: Triangles


def cut_mesh(triangles: Triangles, values: Values, level: float, /) -> CutMesh:
    """The mesh cut where values, straight along its edges, reach a level.

    triangles (t, 3); values (n,): of the vertices; level: what is not above it is under.
    """
    above = values[triangles] > level
    count = above.sum(axis=1)
    parted = (count == 1) | (count == 2)
    alone = np.where(count == 1, above.argmax(axis=1), above.argmin(axis=1))[parted]
    turned = np.take_along_axis(triangles[parted], (alone[:, None] + np.arange(3)) % 3, axis=1)
    crossed = np.concatenate([turned[:, [0, 1]], turned[:, [0, 2]]])
    edges, place = np.unique(np.sort(crossed, axis=1), axis=0, return_inverse=True)
    first, second = edges.T
    share = (level - values[first]) / (values[second] - values[first])
    rows = np.arange(len(edges))
    lerp = csr_array(
        (np.concatenate([1.0 - share, share]), (np.tile(rows, 2), np.concatenate([first, second]))),
        shape=(len(edges), len(values)),
    )
    near, far = (len(values) + place.reshape(2, -1)).tolist()
    tips = np.column_stack([turned[:, 0], near, far])
    rests = np.concatenate(
        [np.column_stack([near, turned[:, 1], turned[:, 2]]), np.column_stack([near, turned[:, 2], far])]
    )
    tip_over = count[parted] == 1
    rest_over = np.tile(~tip_over, 2)
    return CutMesh(
        csr_array(vstack([eye_array(len(values), format="csr"), lerp])),
        np.concatenate([triangles[count == 0], tips[~tip_over], rests[~rest_over]]).astype(np.int32),
        np.concatenate([triangles[count == 3], tips[tip_over], rests[rest_over]]).astype(np.int32),
    )
