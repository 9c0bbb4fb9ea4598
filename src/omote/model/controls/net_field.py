"""Control nets on vertices of the generic head, and the fields that they interpolate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy import sparse

from omote.arrays import Values
from omote.model.controls.control_net import ControlNet
from omote.model.controls.mirror import mirror_rows
from omote.model.space.parameter_space import ParameterSpace

MOST = 400
"""Points of a net at most."""


@dataclass(frozen=True, eq=False)
class NetField:
    """A control net with its points on vertices: a point's vector is the field there. Made by `build_net_field`."""

    rows: tuple[int, ...]
    net: ControlNet

    def field(self, vectors: ArrayLike, /) -> Values:
        """The field (V, 3) of vectors (n, 3): dtheta (radians), dh (metres), and R - 1 of their R.

        Raises ValueError on other shapes and on values that are not finite.
        """
        given = np.asarray(vectors, dtype=np.float64)
        if given.shape != (len(self.rows), 3):
            raise ValueError(f"vectors have shape {given.shape}; expected ({len(self.rows)}, 3), one for each point")
        bad = np.flatnonzero(~np.isfinite(given).all(axis=1))
        if len(bad):
            raise ValueError(f"vector {bad[0]} is {given[bad[0]]}; expected finite dtheta, dh and R")
        return np.asarray(self._basis @ (given - [0.0, 0.0, 1.0]))

    @cached_property
    def mirror(self) -> tuple[int, ...]:
        """For each point the place of its mirror image, its own on the midline, -1 where no point stands there."""
        place = {row: number for number, row in enumerate(self.rows)}
        try:
            across = mirror_rows(self.net.space)
        except ValueError:
            return (-1,) * len(self.rows)
        return tuple(place.get(int(across[row]), -1) for row in self.rows)

    @cached_property
    def _basis(self) -> sparse.csr_array:
        return sparse.csr_array(self.net.basis[:, : len(self.rows)])


def build_net_field(space: ParameterSpace, rows: Sequence[int], /) -> NetField:
    """Builds the net through vertices of the sheet. Raises ValueError on rows that are none, twice the same, or too few
    to join around the head.

    space: the space of the generic head.
    """
    _refuse_rows(space, rows)
    at = np.array(rows, np.int64)
    net = ControlNet.build(space, space.theta[at], space.h[at])
    return NetField(tuple(int(row) for row in rows), net)


def _refuse_rows(space: ParameterSpace, rows: Sequence[int]) -> None:
    if not 3 <= len(rows) <= MOST:
        raise ValueError(f"a net of {len(rows)} control points; expected from 3 to {MOST}")
    seen = set[int]()
    for row in rows:
        if isinstance(row, bool) or not isinstance(row, int | np.integer) or not 0 <= row < space.vertex_count:
            raise ValueError(
                f"a control point stands on vertex {row!r}; expected a row of the skin, from 0 to "
                f"{space.vertex_count - 1}"
            )
        if not space.on_sheet[row]:
            raise ValueError(
                f"a control point stands on vertex {row}, which is inner skin; expected one of the sheet: choose a "
                "place that can be seen"
            )
        place = int(space.welded[row])
        if place in seen:
            raise ValueError(f"two control points stand on vertex {row}; expected each at its own: remove one")
        seen.add(place)
