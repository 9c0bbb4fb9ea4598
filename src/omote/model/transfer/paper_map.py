"""The paper's map: an expression located on S once, then any face moved by it (paper, section 2.2).

`STAGES` are its steps on a face, in order. The smooth map begins with what they do to the generic face
(`displace_generic`, `omote.model.transfer.pipeline`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from numbers import Real

import numpy as np
from numba import njit

from omote.arrays import Floats, Indices, Mask, Values
from omote.geometry.locate import Landing, walk_face
from omote.geometry.mesh import FARTHEST
from omote.model.space.expression import Expression
from omote.model.space.face_fit import FittedFace, fit, generic_face
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space

_WEIGHTS = f"expected a number from {-FARTHEST:g} to {FARTHEST:g}"


@dataclass(frozen=True, eq=False)
class Compiled:
    """An expression located once, for any face: vertex v goes to weights[v] of indices[v] (V, 3), its radius times
    ratios[v].

    residual (inner, 3), the expression's parts and its turn of the ears (2, 3) come weighted; inside (V,) tells which
    walks ended in a triangle; signed: as of `Expression`.
    """

    indices: Indices
    weights: Floats
    ratios: Floats
    residual: Floats
    parts: Mapping[str, Values]
    inside: Mask
    ears: Values = field(default_factory=lambda: np.zeros((2, 3)))
    signed: bool = False


def _checked_weight(weight: object) -> float:
    if isinstance(weight, bool) or not isinstance(weight, Real):
        raise TypeError(f"weight must be a number, not {weight!r}; 1 wears the expression as it is")
    try:
        number = float(weight)
    except OverflowError as error:
        raise ValueError(f"weight is far too large; {_WEIGHTS}") from error
    if not abs(number) <= FARTHEST:  # also catches NaN
        raise ValueError(f"weight is {number}; {_WEIGHTS}")
    return number


def refuse_foreign(space: ParameterSpace, expression: Expression, /) -> None:
    """Rejects an expression of another space or rule (ValueError), and what is no space or expression (TypeError)."""
    refuse_no_space(space)
    if not isinstance(expression, Expression):
        raise TypeError(
            f"the expression is a {type(expression).__name__}; "
            "expected an omote.Expression, such as cast.expressions['smile']"
        )
    if len(expression.dtheta) != space.vertex_count or len(expression.residual) != len(space.inner.vertices):
        raise ValueError(
            f"the expression has {len(expression.dtheta)} vertices, {len(expression.residual)} of them inner skin; "
            f"expected {space.vertex_count} and {len(space.inner.vertices)}: it was made on another space"
        )
    for rule in ("radius", "transfer"):
        mine = getattr(expression, rule)
        own = getattr(space, rule)
        if mine != own:
            raise ValueError(
                f"the expression was taken with {rule}={mine!r} and the space has {rule}={own!r}; "
                "fields made under different rules do not mix: extract it again in this space"
            )
    for name, residual in expression.parts.items():
        if name not in space.parts or len(residual) != len(space.parts[name].points):
            raise ValueError(
                f"the expression moves a part {name!r} of {len(residual)} vertices; the space has {sorted(space.parts)}"
            )


def project_to_surface(space: ParameterSpace, points: Values, targets: Values, vertices: Indices, /) -> Landing:
    """Where targets (N, 3) come down on a face with points (V, 3) along their cylinder radius, walking from vertices
    (N,).

    space: the space of the generic head.
    """
    count = len(vertices)
    start = space.fans.triangles[space.fans.starts[vertices]]
    triangles = np.empty(count, np.int32)
    weights = np.empty((count, 3))
    inside = np.empty(count, np.bool_)
    walk_face(
        points, space.location_triangles, space.strip.neighbours, space.cylinder.x, space.cylinder.z,
        targets, start, triangles, weights, inside,
    )  # fmt: skip
    return Landing(triangles, weights, inside)


def compile_expression(space: ParameterSpace, expression: Expression, /, weight: float = 1.0) -> Compiled:
    """The expression located on S, to be worn by any face; weight scales the field: w dtheta, w dh, 1 + w (R - 1).

    Raises ValueError on an expression of another space or rule and on a weight that is not finite or turns a radius
    over; TypeError on what is no space, expression or number.
    """
    refuse_foreign(space, expression)
    weight = _checked_weight(weight)
    ratios = 1.0 + weight * (expression.ratio - 1.0)
    if ratios.min() <= 0:
        raise ValueError(
            f"weight {weight} brings a radius to {ratios.min():.3g} of itself; expected a weight that keeps it positive"
        )
    located = locate_field(
        space, weight * expression.dtheta, weight * expression.dh, ratios, weight * expression.residual,
        {name: weight * rest for name, rest in expression.parts.items()},
    )  # fmt: skip
    if not expression.ears.any():
        return located
    return replace(located, ears=weight * expression.ears, signed=expression.signed)


def locate_field(
    space: ParameterSpace, dtheta: Values, dh: Values, ratios: Values, residual: Values, parts: Mapping[str, Values], /
) -> Compiled:
    """A field on S located: one walk per moved vertex of the sheet (paper, section 2.2, step 2a).

    space: the space of the generic head; dtheta: (V,), radians; dh: (V,), metres; ratios: (V,), R; residual: (V, 3),
    metres; parts: what each part does beyond the skin, (n, 3), metres.
    """
    count = space.vertex_count
    indices = np.repeat(np.arange(count, dtype=np.int32)[:, None], 3, axis=1)
    weights = np.zeros((count, 3), np.float32)
    weights[:, 0] = 1.0
    inside = np.ones(count, np.bool_)
    moved = np.flatnonzero(space.on_sheet & ((dtheta != 0) | (dh != 0))).astype(np.int32)
    landing = space.locate(space.theta[moved] + dtheta[moved], space.h[moved] + dh[moved], moved)
    indices[moved] = space.location_triangles[landing.triangles]
    weights[moved] = landing.weights
    inside[moved] = landing.inside
    return Compiled(indices, weights, ratios.astype(np.float32), residual.astype(np.float32), dict(parts), inside)


def gather_landings(space: ParameterSpace, fitted: FittedFace, compiled: Compiled, out: Floats, /) -> None:
    """Moves each vertex of the sheet to the point of the face at which it lands on S, radius rescaled: one gather.

    space: the space of the generic head; fitted: the face, fitted; compiled: the expression, compiled; out: (V, 3)
    float32, metres; written.
    """
    axis = np.float32(space.cylinder.x), np.float32(space.cylinder.z)
    from_origin = space.radius == "origin"
    gather_points(
        fitted.positions, compiled.indices, compiled.weights, compiled.ratios, fitted.radii, *axis, from_origin, out
    )


def follow_inner_skin(space: ParameterSpace, fitted: FittedFace, compiled: Compiled, out: Floats, /) -> None:
    """Moves the inner skin by its anchors' mean displacement and the expression's own residual.

    space: the space of the generic head; fitted: the face, fitted; compiled: the expression, compiled; out: (V, 3)
    float32, metres; written.
    """
    inner = space.inner
    follow_anchors(fitted.positions, inner.vertices, inner.anchors, inner.weights, compiled.residual, fitted.scale, out)


STAGES = (gather_landings, follow_inner_skin)
"""What the paper's map does to a face, in order; each writes into out (V, 3)."""


def apply_paper_map(
    space: ParameterSpace, fitted: FittedFace, compiled: Compiled, /, out: Floats | None = None
) -> Floats:
    """The compound (V, 3) of a fitted face and a compiled expression, metres.

    space: the space of the generic head; out: (V, 3) float32, metres; written.
    """
    out = np.empty_like(fitted.positions) if out is None else out
    for stage in STAGES:
        stage(space, fitted, compiled, out)
    return out


def displace_generic(space: ParameterSpace, compiled: Compiled, /) -> Values:
    """What a compiled expression does to the generic face by the paper's map: displacement (V, 3), metres.

    space: the space of the generic head.
    """
    fitted = fit(space, generic_face(space))
    return apply_paper_map(space, fitted, compiled).astype(np.float64) - fitted.positions


@njit(cache=True, fastmath={"contract"}, error_model="numpy")
def gather_points(
    positions: Floats, indices: Indices, weights: Floats, ratios: Floats, radii: Floats, x: np.float32, z: np.float32,
    origin: bool, out: Floats,
) -> None:  # fmt: skip
    """Writes the compound on the sheet (paper, section 2.2, steps 2b, 2c); no trigonometry: theta and h are kept
    by scaling.

    positions: (V, 3), metres; indices: (n, 3) corners of the triangle of each point; weights: (n, 3), barycentric;
    ratios: (n,), R; radii: (V,), metres; x, z: of the axis, metres; origin: whether ratios are of the radius at rest,
    not of that on the face; out: (n, 3), metres.
    """
    for v in range(len(indices)):
        i, j, k = indices[v, 0], indices[v, 1], indices[v, 2]
        a, b, c = weights[v, 0], weights[v, 1], weights[v, 2]
        dx = a * positions[i, 0] + b * positions[j, 0] + c * positions[k, 0] - x
        dy = a * positions[i, 1] + b * positions[j, 1] + c * positions[k, 1]
        dz = a * positions[i, 2] + b * positions[j, 2] + c * positions[k, 2] - z
        if origin:
            here = np.sqrt(dx * dx + dz * dz)
            scale = ratios[v] * radii[v] / here if here > np.float32(0.0) else ratios[v]
        else:
            scale = ratios[v]
        out[v, 0] = x + scale * dx
        out[v, 1] = dy
        out[v, 2] = z + scale * dz


@njit(cache=True, fastmath={"contract"}, error_model="numpy")
def follow_anchors(
    positions: Floats, vertices: Indices, anchors: Indices, weights: Floats, residual: Floats, scale: Floats,
    out: Floats,
) -> None:  # fmt: skip
    """Moves the inner skin by its anchors' displacement and the expression's own residual; reads and writes out.

    positions: (V, 3), metres; vertices: (n,) rows of the inner skin; weights: (n, k), of their anchors; scale: (n,),
    how much larger the face is there.
    """
    for n in range(len(vertices)):
        v = vertices[n]
        dx, dy, dz = scale[n] * residual[n, 0], scale[n] * residual[n, 1], scale[n] * residual[n, 2]
        for k in range(anchors.shape[1]):
            w = weights[n, k]
            if w == np.float32(0.0):
                continue
            a = anchors[n, k]
            dx += w * (out[a, 0] - positions[a, 0])
            dy += w * (out[a, 1] - positions[a, 1])
            dz += w * (out[a, 2] - positions[a, 2])
        out[v, 0] = positions[v, 0] + dx
        out[v, 1] = positions[v, 1] + dy
        out[v, 2] = positions[v, 2] + dz
