"""Extraction: from a displacement of a face to an expression, the field on S (paper, section 2.2, step 1)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.parts import eye_angles, eye_rotation
from omote.model.transfer.compound import carrier, compound, followed, generic_face, on_generic, predicted
from omote.model.transfer.paper_map import compile_expression, slide
from omote.model.transfer.smooth_map import uncarried

Values = NDArray[np.float64]

# Displacements below a nanometre are rest: fields stay empty where nothing moves.
_REST = 1e-9


def extract(
    space: ParameterSpace, face: Face, displacement: ArrayLike, /, *, parts: Mapping[str, ArrayLike] | None = None
) -> Expression:
    """The expression that moves a face by a displacement (paper, section 2.2, steps 1a-1d).

    In a space with transfer="smooth" the displacement is first brought to the generic face and measured there.

    displacement (V, 3) metres on the face; parts: displacements (n, 3) of parts by name (an eyeball's is read as a turn
    about its centre and a rest). Raises ValueError on other shapes and on values that are not finite.
    """
    refuse_no_space(space)
    fit(space, face)
    if not isinstance(parts, Mapping | None):
        raise TypeError(f"parts is a {type(parts).__name__}; expected a mapping from part names to (n, 3) metres")
    moved = mesh.validate_points(displacement, name="displacement")
    if len(moved) != space.vertex_count:
        raise ValueError(
            f"displacement has {len(moved)} rows; expected {space.vertex_count}, one per vertex of the skin"
        )
    if space.transfer == "smooth":
        source = generic_face(space)
        ready = carrier(space, face)
        goal = ready.positions + moved * space.on_sheet[:, None]
        bare = _field(space, source.positions.astype(np.float64), uncarried(ready, goal))
    else:
        bare = _field(space, face.positions.astype(np.float64), moved)
    return _with_rest(space, face, bare, moved, parts or {})


def _field(space: ParameterSpace, before: Values, moved: Values) -> Expression:
    """The field on S of a displacement (V, 3) of the sheet of a face with positions (V, 3)."""
    after = before + moved
    vertices = np.flatnonzero(space.on_sheet & (np.abs(moved) > _REST).any(axis=1)).astype(np.int32)
    landing = slide(space, before, after[vertices], vertices)
    dtheta, dh, ratio = np.zeros(len(before)), np.zeros(len(before)), np.ones(len(before))
    corners = space.location_triangles[landing.triangles]
    from_first = wrap(space.theta[corners] - space.theta[corners[:, :1]])
    theta = space.theta[corners[:, 0]] + (landing.weights * from_first).sum(axis=1)
    dtheta[vertices] = wrap(theta - space.theta[vertices])
    dh[vertices] = (landing.weights * space.h[corners]).sum(axis=1) - space.h[vertices]
    surface = (landing.weights[..., None] * before[corners]).sum(axis=1)
    reference = before[vertices] if space.radius == "origin" else surface
    ratio[vertices] = _radius(space, after[vertices]) / np.maximum(_radius(space, reference), 1e-9)
    still = np.zeros((len(space.inner.vertices), 3))
    return Expression(dtheta, dh, ratio, still, radius=space.radius, transfer=space.transfer)


def _radius(space: ParameterSpace, points: Values) -> Values:
    return space.cylinder.unroll(points)[2]


def _with_rest(
    space: ParameterSpace, face: Face, bare: Expression, moved: Values, parts: Mapping[str, ArrayLike]
) -> Expression:  # fmt: skip
    """The expression with its residuals: what inner skin and parts do over what the sheet's motion predicts."""
    fitted = fit(space, face)
    sheet = compound(space, face, bare).astype(np.float64) - face.positions
    inner = space.inner.vertices
    residual = (moved[inner] - _unkept(space, face, bare)[inner]) / fitted.scale[:, None]
    residual[np.abs(residual).max(axis=1) < _REST] = 0.0
    eyes = np.zeros((2, 2))
    rest: dict[str, Values] = {}
    for name, given in parts.items():
        if name not in space.parts:
            raise ValueError(f"parts has a displacement of {name!r}; expected one of {sorted(space.parts)}")
        part, before = space.parts[name], fitted.parts[name].astype(np.float64)
        shift = mesh.validate_points(given, name=f"displacement of part {name!r}")
        if len(shift) != len(before):
            raise ValueError(f"displacement of part {name!r} has {len(shift)} rows; expected {len(before)}")
        after = before + shift
        if part.eye:
            angles = eye_angles(before, after)
            eyes[0 if part.eye == "left" else 1] = angles
            # Turned back about the centre, so that what remains is turned with the ball.
            after = (after - fitted.centres[name]) @ eye_rotation(*angles) + fitted.centres[name]
        rest[name] = (after - before - predicted(space, name, sheet)) / fitted.sizes[name]
    return Expression(bare.dtheta, bare.dh, bare.ratio, residual, rest, eyes, space.radius, space.transfer)


def _unkept(space: ParameterSpace, face: Face, bare: Expression) -> Values:
    """What the skin (V, 3) is predicted to do before the mouth bag is kept inside the head, which needs the rest."""
    compiled = compile_expression(space, bare)
    if space.transfer == "paper":
        return compound(space, face, bare).astype(np.float64) - face.positions
    return followed(space, face, on_generic(space, compiled), compiled.residual).astype(np.float64) - face.positions
