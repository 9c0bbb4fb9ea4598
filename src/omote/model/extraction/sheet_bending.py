"""How much a displacement of the generic face bends its sheet, and the same displacement bent less: the squared
Laplacian, integrated (a thin plate; docs/method.md, "Which field is meant")."""

from __future__ import annotations

from dataclasses import dataclass, field
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.model.space.face_fit import generic_face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.smooth_map import prepare_smooth_map

Values = NDArray[np.float64]

_known: WeakKeyDictionary[ParameterSpace, SheetBending] = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class SheetBending:
    """The sheet of the generic face as a thin plate.

    positions (n, 3): its vertices at rest, metres; mass (n,): the area of each; laplacian (n, n): times mass.
    """

    positions: Values
    mass: Values
    laplacian: sparse.csr_array
    _solvers: dict[float, splu] = field(default_factory=dict)

    def measure(self, displacement: Values, /) -> float:
        """How much a displacement (n, 3) is bent: its squared Laplacian, integrated."""
        bent = self.laplacian @ displacement
        return float((bent**2 / self.mass[:, None]).sum())

    def smooth(self, displacement: Values, length: float, /) -> Values:
        """The displacement (n, 3) without what is shorter than a length, metres: (M + length^4 B) s = M u."""
        if length not in self._solvers:
            bending = self.laplacian.T @ sparse.diags_array(1.0 / self.mass) @ self.laplacian
            self._solvers[length] = splu(sparse.csc_array(sparse.diags_array(self.mass) + length**4 * bending))
        result: Values = self._solvers[length].solve(np.ascontiguousarray(self.mass[:, None] * displacement))
        return result

    def smooth_around(self, displacement: Values, vertex: int, length: float, radius: float, /) -> Values:
        """The same (n, 3), smoothed around one vertex only, by a Gaussian bell of so many metres."""
        far = ((self.positions - self.positions[vertex]) ** 2).sum(axis=1)
        bell = np.exp(-far / radius**2)[:, None]
        result: Values = displacement + bell * (self.smooth(displacement, length) - displacement)
        return result


def prepare_bending(space: ParameterSpace, /) -> SheetBending:
    """The plate of a space's generic face, assembled at the first call and remembered."""
    if space not in _known:
        ready = prepare_smooth_map(space, generic_face(space))
        detail, count = ready.detail, len(ready.geometry.triangles)
        place = np.searchsorted(detail.used, ready.geometry.triangles)
        mass = np.bincount(place.ravel(), np.repeat(detail.areas[:count] / 3.0, 3)).astype(np.float64)
        stiffness = detail.slopes.T @ sparse.diags_array(detail.areas) @ detail.slopes
        _known[space] = SheetBending(ready.generic[detail.used], mass, sparse.csr_array(stiffness))
    return _known[space]
