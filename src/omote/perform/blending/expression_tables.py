"""Tables of all expressions' fields, so that a mix of them is one matrix product and one walk over S."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from omote.arrays import Floats, Indices, Mask, Values
from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import Compiled
from omote.model.weak_cache import weakly_cached
from omote.perform.blending.weighted_sum import sum_rows

SMALLEST_RATIO = 0.05
"""Many channels may add up to a radius below nothing; the surface stops short of the axis then."""


@dataclass(frozen=True, eq=False)
class TableRow:
    """An expression as tables hold it: field (3 s,), dtheta, dh and R - 1 of the sheet; residual (3 inner,)."""

    field: Floats
    residual: Floats

    @staticmethod
    def of(space: ParameterSpace, expression: Expression) -> TableRow:
        """The row of an expression that was made on a space."""
        field = _sheet_row(expression, np.flatnonzero(space.on_sheet).astype(np.int32))
        return TableRow(field.astype(np.float32), expression.residual.ravel().astype(np.float32))


@dataclass(frozen=True, eq=False)
class RegionalField:
    """Expressions by weight that are worn as far as a mask (V,) says: names of the tables, and rows of their own."""

    mask: Floats
    weights: Mapping[str, float]
    own: Sequence[tuple[TableRow, float]] = ()


class ExpressionTables:
    """Tables of the expressions on one space: sheet fields and residuals, one row per expression.

    expressions: those to mix, all made on the space. What is precomputed: the tables, and where each walk starts.
    """

    def __init__(self, space: ParameterSpace, expressions: Mapping[str, Expression]) -> None:
        self._rows = {name: row for row, name in enumerate(expressions)}
        self._space = space
        self._sheet = np.flatnonzero(space.on_sheet).astype(np.int32)
        self._starts = space.fans.triangles[space.fans.starts[self._sheet]]
        self._leaders = _leaders(space, self._sheet)
        self._corners = np.ascontiguousarray(space.location_triangles)
        self._places = space.theta[self._sheet], space.h[self._sheet]
        self._table = _table([_sheet_row(expression, self._sheet) for expression in expressions.values()])
        self._residuals = _table([expression.residual.ravel() for expression in expressions.values()])

    def mix(
        self,
        weights: Mapping[str, float],
        own: Sequence[tuple[TableRow, float]] = (),
        regions: Sequence[RegionalField] = (),
    ) -> Compiled:
        """The expression sum of weight times field, located on S: dtheta, dh, R - 1 and residuals add; no parts.

        own: expressions that are not in the tables, by their rows, and their weights. regions: what is added in some
        places only.
        """
        field, residual = self._sum(weights, own)
        for region in regions:
            more, beyond = self._sum(region.weights, region.own)
            field += region.mask[self._sheet] * more
            residual += region.mask[self._space.inner.vertices, None] * beyond
        return self._locate(field, residual)

    def _sum(self, weights: Mapping[str, float], own: Sequence[tuple[TableRow, float]]) -> tuple[Floats, Floats]:
        """Field (3, s) and residual (inner, 3) by weight."""
        names = list(weights)
        factors = np.array(list(weights.values()), np.float32)
        rows = np.array([self._rows[name] for name in names], np.int64)
        field = _product(self._table, rows, factors)
        residual = _product(self._residuals, rows, factors)
        for row, weight in own:
            field += np.float32(weight) * row.field
            residual += np.float32(weight) * row.residual
        return field.reshape(3, -1), residual.reshape(-1, 3)

    def _locate(self, field: Floats, residual: Floats) -> Compiled:
        space = self._space
        theta = self._places[0] + field[0]
        h = self._places[1] + field[1]
        landing = space.strip.locate(theta, h, self._starts, leaders=self._leaders)
        indices = np.empty((space.vertex_count, 3), np.int32)
        weights = np.empty((space.vertex_count, 3), np.float32)
        ratios = np.empty(space.vertex_count, np.float32)
        ended = np.empty(space.vertex_count, np.bool_)
        landed = landing.triangles, landing.weights, landing.inside
        _spread(self._sheet, self._corners, *landed, field[2], indices, weights, ratios, ended)
        return Compiled(indices, weights, ratios, residual, {}, ended)


@weakly_cached
def tables_of(cast: Cast) -> ExpressionTables:
    """The tables of a cast, cached as long as the cast lives."""
    return ExpressionTables(cast.space, cast.expressions)


def _leaders(space: ParameterSpace, sheet: Indices) -> Indices:
    """For each vertex of the sheet a neighbour that comes before it, or -1: neighbours come down near each other."""
    row = np.full(space.vertex_count, -1, np.int32)
    row[sheet] = np.arange(len(sheet), dtype=np.int32)
    corners = row[space.skin_triangles]
    ends = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    late = ends.max(axis=1)
    early = ends.min(axis=1)
    leaders = np.full(len(sheet), -1, np.int32)
    np.maximum.at(leaders, late[early >= 0], early[early >= 0])
    return leaders


def _sheet_row(expression: Expression, sheet: Indices) -> Values:
    return np.concatenate([expression.dtheta[sheet], expression.dh[sheet], expression.ratio[sheet] - 1.0])


def _table(rows: Sequence[Values]) -> Floats:
    return np.stack(rows).astype(np.float32)


def _product(table: Floats, rows: NDArray[np.int64], factors: Floats) -> Floats:
    total = np.empty(table.shape[1], np.float32)
    sum_rows(table, rows, factors, total)
    return total


@njit(cache=True)
def _spread(
    sheet: Indices, corners: Indices, triangles: Indices, landed: Values,
    inside: Mask, stretch: Floats, indices: Indices, weights: Floats, ratios: Floats,
    ended: Mask,
) -> None:  # fmt: skip
    """Writes the landings of the sheet's vertices into rows of all vertices; the others stay where they are."""
    for v in range(len(indices)):
        indices[v, 0] = indices[v, 1] = indices[v, 2] = v
        weights[v, 0], weights[v, 1], weights[v, 2] = 1.0, 0.0, 0.0
        ratios[v] = 1.0
        ended[v] = True
    for n in range(len(sheet)):
        v, t = sheet[n], triangles[n]
        for k in range(3):
            indices[v, k] = corners[t, k]
            weights[v, k] = landed[n, k]
        ratios[v] = max(SMALLEST_RATIO, 1.0 + stretch[n])
        ended[v] = inside[n]
