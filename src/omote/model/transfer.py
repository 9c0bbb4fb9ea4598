"""The paper's map between a face and S: extract, compile, compound (paper, section 2.2; method.md, section 3)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.geometry.locate import Landing, walk_face
from omote.model.expression import Expression
from omote.model.face import Face
from omote.model.fitted import Fitted, fit
from omote.model.parts import eye_angles, eye_rotation
from omote.model.space import ParameterSpace

Floats = NDArray[np.float32]
Indices = NDArray[np.int32]

# Displacements below a nanometre are rest: fields stay empty where nothing moves.
_REST = 1e-9


@dataclass(frozen=True, eq=False)
class Compiled:
    """An expression located once, for any face: vertex v goes to weights[v] of indices[v] (V, 3), its radius times
    ratios[v].

    residual (inner, 3) and the expression's parts come weighted; inside (V,) tells which walks ended in a triangle.
    """

    indices: Indices
    weights: Floats
    ratios: Floats
    residual: Floats
    parts: Mapping[str, NDArray[np.float64]]
    inside: NDArray[np.bool_]


def _refuse_foreign(space: ParameterSpace, expression: Expression) -> None:
    if len(expression.dtheta) != space.vertex_count or len(expression.residual) != len(space.inner.vertices):
        raise ValueError(
            f"the expression has {len(expression.dtheta)} vertices, {len(expression.residual)} of them inner skin; "
            f"expected {space.vertex_count} and {len(space.inner.vertices)}: it was made on another space"
        )
    if expression.radius != space.radius:
        raise ValueError(
            f"the expression was taken with radius={expression.radius!r} and the space has radius={space.radius!r}; "
            "fields made under different rules do not mix: extract it again in this space"
        )
    for name, residual in expression.parts.items():
        if name not in space.parts or len(residual) != len(space.parts[name].points):
            raise ValueError(
                f"the expression moves a part {name!r} of {len(residual)} vertices; the space has {sorted(space.parts)}"
            )


def extract(
    space: ParameterSpace, face: Face, displacement: ArrayLike, /, *, parts: Mapping[str, ArrayLike] | None = None
) -> Expression:
    """The expression that moves a face by a displacement (paper, section 2.2, steps 1a-1d).

    displacement (V, 3) metres on the face; parts: displacements (n, 3) of parts by name (an eyeball's is read as a turn
    about its centre and a rest). Raises ValueError on other shapes and on values that are not finite.
    """
    fitted = fit(space, face)
    moved = mesh.checked_points(displacement, name="displacement")
    if len(moved) != space.vertex_count:
        raise ValueError(
            f"displacement has {len(moved)} rows; expected {space.vertex_count}, one per vertex of the skin"
        )
    before = face.positions.astype(np.float64)
    after = before + moved
    vertices = np.flatnonzero(space.on_sheet & (np.abs(moved) > _REST).any(axis=1)).astype(np.int32)
    landing = slide(space, before, after[vertices], vertices)
    dtheta, dh, ratio = np.zeros(len(before)), np.zeros(len(before)), np.ones(len(before))
    corners = space.location_triangles[landing.triangles]
    from_first = wrap(space.theta[corners] - space.theta[corners[:, :1]])
    theta = space.theta[corners[:, 0]] + (landing.weights * from_first).sum(axis=1)
    dtheta[vertices] = wrap(theta - space.theta[vertices])
    dh[vertices] = (landing.weights * space.h[corners]).sum(axis=1) - space.h[vertices]
    reference = (
        before[vertices] if space.radius == "origin" else (landing.weights[..., None] * before[corners]).sum(axis=1)
    )
    ratio[vertices] = _radius(space, after[vertices]) / np.maximum(_radius(space, reference), 1e-9)
    bare = Expression(dtheta, dh, ratio, np.zeros((len(space.inner.vertices), 3)), radius=space.radius)
    return _with_rest(space, face, fitted, bare, moved, parts or {})


def _radius(space: ParameterSpace, points: NDArray[np.float64]) -> NDArray[np.float64]:
    return space.cylinder.unroll(points)[2]


def slide(
    space: ParameterSpace, points: NDArray[np.float64], targets: NDArray[np.float64], vertices: Indices, /
) -> Landing:
    """Where targets (N, 3) come down on a face with points (V, 3) along their cylinder radius, walking from vertices
    (N,)."""
    count = len(vertices)
    start = space.fans.triangles[space.fans.starts[vertices]]
    triangles, weights, inside = np.empty(count, np.int32), np.empty((count, 3)), np.empty(count, np.bool_)
    walk_face(
        points, space.location_triangles, space.strip.neighbours, space.cylinder.x, space.cylinder.z,
        targets, start, triangles, weights, inside,
    )  # fmt: skip
    return Landing(triangles, weights, inside)


def _with_rest(
    space: ParameterSpace, face: Face, fitted: Fitted, bare: Expression, moved: NDArray[np.float64], parts:
    Mapping[str, ArrayLike]
) -> Expression:  # fmt: skip
    """The expression with its residuals: what inner skin and parts do over what the sheet's motion predicts."""
    sheet = compound(space, face, bare).astype(np.float64) - face.positions
    inner = space.inner.vertices
    residual = (moved[inner] - sheet[inner]) / fitted.scale[:, None]
    residual[np.abs(residual).max(axis=1) < _REST] = 0.0
    eyes = np.zeros((2, 2))
    rest: dict[str, NDArray[np.float64]] = {}
    for name, given in parts.items():
        if name not in space.parts:
            raise ValueError(f"parts has a displacement of {name!r}; expected one of {sorted(space.parts)}")
        part, before = space.parts[name], fitted.parts[name].astype(np.float64)
        shift = mesh.checked_points(given, name=f"displacement of part {name!r}")
        if len(shift) != len(before):
            raise ValueError(f"displacement of part {name!r} has {len(shift)} rows; expected {len(before)}")
        after = before + shift
        if part.eye:
            angles = eye_angles(before, after)
            eyes[0 if part.eye == "left" else 1] = angles
            # Turned back about the centre, so that what remains is turned with the ball.
            after = (after - fitted.centres[name]) @ eye_rotation(*angles) + fitted.centres[name]
        rest[name] = (after - before - predicted(space, name, sheet)) / fitted.sizes[name]
    return Expression(bare.dtheta, bare.dh, bare.ratio, residual, rest, eyes, space.radius)


def predicted(space: ParameterSpace, name: str, displacement: NDArray[np.float64], /) -> NDArray[np.float64]:
    """The displacement (n, 3) of a part that follows from that of the skin (V, 3)."""
    part = space.parts[name]
    result: NDArray[np.float64] = np.einsum("nk,nkc->nc", part.weights, displacement[part.anchors])
    return result


def compile_expression(space: ParameterSpace, expression: Expression, /, weight: float = 1.0) -> Compiled:
    """The expression located on S, to be worn by any face; weight scales the field: w dtheta, w dh, 1 + w (R - 1).

    Raises ValueError on an expression of another space or rule and on a weight that is not finite or turns a radius
    over.
    """
    _refuse_foreign(space, expression)
    if not np.isfinite(weight):
        raise ValueError(f"weight is {weight}; expected a finite number")
    ratios = 1.0 + weight * (expression.ratio - 1.0)
    if ratios.min() <= 0:
        raise ValueError(
            f"weight {weight} brings a radius to {ratios.min():.3g} of itself; expected a weight that keeps it positive"
        )
    return locate_field(
        space, weight * expression.dtheta, weight * expression.dh, ratios, weight * expression.residual,
        {name: weight * rest for name, rest in expression.parts.items()},
    )  # fmt: skip


def locate_field(
    space: ParameterSpace, dtheta: NDArray[np.float64], dh: NDArray[np.float64], ratios: NDArray[np.float64],
    residual: NDArray[np.float64], parts: Mapping[str, NDArray[np.float64]], /,
) -> Compiled:  # fmt: skip
    """A field on S located: one walk per moved vertex of the sheet (paper, section 2.2, step 2a)."""
    count = space.vertex_count
    indices = np.repeat(np.arange(count, dtype=np.int32)[:, None], 3, axis=1)
    weights = np.zeros((count, 3), np.float32)
    weights[:, 0] = 1.0
    inside = np.ones(count, np.bool_)
    moved = np.flatnonzero(space.on_sheet & ((dtheta != 0) | (dh != 0))).astype(np.int32)
    landing = space.locate(space.theta[moved] + dtheta[moved], space.h[moved] + dh[moved], moved)
    indices[moved], weights[moved], inside[moved] = (
        space.location_triangles[landing.triangles],
        landing.weights,
        landing.inside,
    )
    return Compiled(indices, weights, ratios.astype(np.float32), residual.astype(np.float32), dict(parts), inside)


def wear(space: ParameterSpace, fitted: Fitted, compiled: Compiled, /, out: Floats | None = None) -> Floats:
    """The compound (V, 3) of a fitted face and a compiled expression: one gather, one rescale, the inner skin behind
    it."""
    out = np.empty_like(fitted.positions) if out is None else out
    inner = space.inner
    axis = np.float32(space.cylinder.x), np.float32(space.cylinder.z)
    gather(
        fitted.positions,
        compiled.indices,
        compiled.weights,
        compiled.ratios,
        fitted.radii,
        *axis,
        space.radius == "origin",
        out,
    )
    follow(fitted.positions, inner.vertices, inner.anchors, inner.weights, compiled.residual, fitted.scale, out)
    return out


@njit(cache=True, fastmath={"contract"}, error_model="numpy")
def gather(
    positions: Floats, indices: Indices, weights: Floats, ratios: Floats, radii: Floats, x: np.float32, z: np.float32,
    origin: bool, out: Floats,
) -> None:  # fmt: skip
    """Kernel of the compound on the sheet (paper, section 2.2, steps 2b, 2c); no trigonometry: theta and h are kept
    by scaling."""
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
def follow(
    positions: Floats, vertices: Indices, anchors: Indices, weights: Floats, residual: Floats, scale: Floats, out:
    Floats
) -> None:  # fmt: skip
    """Moves the inner skin by its anchors' displacement and the expression's own residual; reads and writes out."""
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


def compound(space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0) -> Floats:
    """A face wearing an expression: positions (V, 3) float32, metres (paper, sections 2.2 and 2.4).

    weight scales the field. Raises ValueError where face or expression does not belong to the space.
    """
    return wear(space, fit(space, face), compile_expression(space, expression, weight))


def compound_parts(
    space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0
) -> dict[str, Floats]:
    """The parts of a face wearing an expression: {part: (n, 3)} metres; eyeballs before their turn (see
    `turned_eyes`)."""
    fitted, compiled = fit(space, face), compile_expression(space, expression, weight)
    return moved_parts(space, fitted, wear(space, fitted, compiled), compiled.parts)


def moved_parts(
    space: ParameterSpace, fitted: Fitted, worn: Floats, rest: Mapping[str, NDArray[np.float64]], /
) -> dict[str, Floats]:
    """The parts where the skin has gone to worn (V, 3), with the expression's own rest per part."""
    displacement = worn.astype(np.float64) - fitted.positions
    result = {}
    for name, placed in fitted.parts.items():
        own = fitted.sizes[name] * rest[name] if name in rest else 0.0
        result[name] = (placed + predicted(space, name, displacement) + own).astype(np.float32)
    return result


def turned_eyes(
    space: ParameterSpace,
    parts: Mapping[str, Floats],
    centres: Mapping[str, NDArray[np.float64]],
    eyes: NDArray[np.float64],
    /,
) -> dict[str, Floats]:
    """The parts with both eyeballs turned about centres (3,) by eyes (2, 2): yaw and pitch, left and right."""
    result = dict(parts)
    for name, part in space.parts.items():
        if part.eye:
            rotation = eye_rotation(*eyes[0 if part.eye == "left" else 1])
            result[name] = ((parts[name] - centres[name]) @ rotation.T + centres[name]).astype(np.float32)
    return result
