"""What shapes of a scan do to a fitted skin: as the scan where that is sure, a thin plate where it is not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.geometry import mesh
from omote.geometry.laplacian import cotangents
from omote.model.fitting.foreign.scan_correspondence import Correspondence
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

# The plate's stiffness as a length beside a match that is sure, and how far it holds by itself, metres.
LENGTH, HOLD = 0.0003, 0.05
# What is sure no more than this is not asked.
LEAST = 1e-3


def carry_skin(space: ParameterSpace, skin: Values, found: Correspondence, shapes: list[Values], /) -> list[Values]:
    """The displacements (V, 3) of a skin (V, 3) by shapes (n, 3) of a scan, in the skin's frame; inner skin follows."""
    used, numbered = np.unique(space.sheet_triangles, return_inverse=True)
    sheet = numbered.reshape(-1, 3).astype(np.int32)
    points = skin[used]
    area = np.zeros(len(used))
    np.add.at(area, sheet.ravel(), np.repeat(mesh.areas(points, sheet) / 3.0, 3))
    area = np.maximum(area, 1e-10)
    sure = np.where(found.sure[used] > LEAST, found.sure[used], 0.0)
    links = cotangents(points, sheet)
    laplacian = sparse.csr_array(sparse.diags_array(links.sum(axis=1)) - links)
    stiff = LENGTH**4 * (laplacian.T @ sparse.diags_array(1.0 / area) @ laplacian)
    held = stiff + sparse.diags_array(area * (sure + (LENGTH / HOLD) ** 4))
    factor = splu(sparse.csc_array(held), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
    result = []
    for moves in shapes:
        goal = found.carry(moves)[used]
        result.append(_spread(space, used, factor.solve((area * sure)[:, None] * goal)))
    return result


def _spread(space: ParameterSpace, used: NDArray[np.integer], moved: Values) -> Values:
    """The displacements of the sheet's welded vertices as those of all (V, 3): doubled ones alike, inner skin by its
    anchors."""
    whole = np.zeros((space.vertex_count, 3))
    whole[used] = moved
    whole = whole[space.welded]
    inner = space.inner
    whole[inner.vertices] = np.einsum("nk,nkc->nc", inner.weights, whole[inner.anchors])
    return whole
