"""The throat put where the chin expects it.

Where the jaw opens, the chin passes in front of the throat, so its new place is measured on the throat
(docs/method.md, "Extract"). People's throats lie up to 25 mm higher or lower under the chin than the generic one's, and
an opened jaw would jump by as much. So the skin of the throat slides up or down with the jaw line above it; the neck
keeps its girth and its depth. Where the head ends it stays with its person, for the body goes on there: levelled to
the rim it met the body in a crease of 87 degrees (heavy).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array, diags_array
from scipy.sparse.linalg import spsolve

from omote.geometry.mesh import boundary_edges
from tools.baking.heads.basemesh import Floats, Ints

# Seen from the side, the generic jaw line falls from the ear to the chin; metres.
CHIN_Z = 0.135
CHIN_Y = -0.119
SLOPE = 0.60
REACH = 0.105
AXIS_Z = 0.02
NAPE = np.deg2rad(110.0)  # from here on the neck keeps its height
AROUND = 0.02  # stiffness around the neck, of that along it


def level_throat(points: Floats, generic: Floats, triangles: Ints) -> Floats:
    """A face (V, 3) whose throat moves, from the generic face (V, 3) to this one, up and down as its jaw line does.

    points, generic: metres; triangles (t, 3).
    """
    free = _throat(generic)
    free[_rim(triangles)] = False
    inside = np.flatnonzero(free)
    outside = np.flatnonzero(~free)
    lift = points[:, 1] - generic[:, 1]
    laplacian = _laplacian(generic, triangles)
    lift[inside] = spsolve(laplacian[inside][:, inside].tocsc(), -laplacian[inside][:, outside] @ lift[outside])
    return np.stack([points[:, 0], generic[:, 1] + lift, points[:, 2]], axis=1)


def _throat(generic: Floats) -> NDArray[np.bool_]:
    """Whether a vertex (V,) of the generic face lies under the jaw line, in front of the nape."""
    x, y, z = generic.T
    line = CHIN_Y + SLOPE * np.clip(CHIN_Z - z, 0.0, REACH)
    return np.asarray((y < line) & (np.abs(np.arctan2(x, z - AXIS_Z)) < NAPE))


def _rim(triangles: Ints) -> Ints:
    """The rows at which the head ends, and those one edge away from them."""
    ends = np.unique(boundary_edges(triangles))
    return np.unique(triangles[np.isin(triangles, ends).any(axis=1)])


def _laplacian(generic: Floats, triangles: Ints) -> csr_array:
    """A Laplacian (V, V) that smooths along the neck, from the jaw line down, and hardly around it."""
    corners = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges = np.unique(np.sort(corners, axis=1), axis=0)
    along = generic[edges[:, 1]] - generic[edges[:, 0]]
    middle = generic[edges].mean(axis=1) - [0.0, 0.0, AXIS_Z]
    tangent = np.stack([middle[:, 2], -middle[:, 0]], axis=1) / np.hypot(middle[:, 0], middle[:, 2])[:, None]
    around = (along[:, [0, 2]] * tangent).sum(axis=1) ** 2 / (along**2).sum(axis=1)
    shape = (len(generic), len(generic))
    links = coo_array((1.0 + AROUND - around, (edges[:, 0], edges[:, 1])), shape=shape).tocsr()
    links = links + links.T
    return csr_array(diags_array(links.sum(axis=1)) - links)
