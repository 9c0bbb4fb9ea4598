"""The throat put where the chin expects it.

Where the jaw opens, the chin passes in front of the throat, so its new place is measured on the throat (method.md,
section 3, step 1). People's throats lie up to 25 mm higher or lower under the chin than the generic one's, and an
opened jaw would jump by as much. So the skin of the throat slides up or down with the jaw line above it; the neck keeps
its girth and its depth.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array, diags_array
from scipy.sparse.linalg import spsolve

from tools.baking.basemesh import Floats, Ints

# Seen from the side, the generic jaw line falls from the ear to the chin; metres.
CHIN_Z, CHIN_Y, SLOPE = 0.135, -0.119, 0.60
WIDEST = np.deg2rad(110.0)  # the nape stays


def settle_throat(points: Floats, generic: Floats, triangles: Ints) -> Floats:
    """A face (V, 3) whose throat moves, from the generic face to this one, up and down as its jaw line does; metres."""
    free = _throat(generic)
    if not free.any():
        return points
    lift = points[:, 1] - generic[:, 1]
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    count = len(points)
    links = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count)).tocsr()
    links = ((links + links.T) > 0).astype(np.float64)
    laplacian = (diags_array(links.sum(axis=1)) - links).tocsr()
    inside, outside = np.flatnonzero(free), np.flatnonzero(~free)
    lift[inside] = spsolve(laplacian[inside][:, inside].tocsc(), -laplacian[inside][:, outside] @ lift[outside])
    return np.stack([points[:, 0], generic[:, 1] + lift, points[:, 2]], axis=1)


def _throat(generic: Floats) -> np.ndarray:
    """Whether a vertex (V,) of the generic face lies under the jaw line, in front of the nape."""
    x, y, z = generic.T
    line = CHIN_Y + SLOPE * np.clip(CHIN_Z - z, 0.0, 0.105)
    return np.asarray((y < line) & (np.abs(np.arctan2(x, z - 0.02)) < WIDEST))
