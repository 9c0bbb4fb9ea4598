"""Extraction: from a displacement of a face to an expression, the inverse of a compound (paper, section 2.2, step 1).

In order: the smooth map inverted, so that the displacement is the generic face's; each vertex's new place projected
onto that face at rest, which gives the field on S; residuals: what inner skin and parts do over what the field
predicts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import ask
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.parts import eye_angles, eye_rotation
from omote.model.transfer.compound import apply_expression, predict_part
from omote.model.transfer.paper_map import compile_expression, project_to_surface
from omote.model.transfer.pipeline import (
    CONTINUOUS_STAGES,
    LINEAR_INNER_STAGES,
    apply_smooth_map,
    transfer_expression,
)
from omote.model.transfer.smooth_map import prepare_smooth_map

Values = NDArray[np.float64]

# Displacements below a nanometre are rest: fields stay empty where nothing moves.
_REST = 1e-9
# Steps of the inverse through the continuous stages at most, the error in metres at which it ends, and how many earlier
# steps it remembers; then steps through all stages of the sheet, and the error that asks for them.
_STEPS, _EXACT, _MEMORY = 120, 1e-8, 30
_POLISHING_STEPS, _CLOSE = 60, 2e-6


def extract(
    space: ParameterSpace, face: Face, displacement: ArrayLike, /, *, parts: Mapping[str, ArrayLike] | None = None
) -> Expression:
    """The expression that moves a face by a displacement; the way back of `compound`.

    In a space with transfer="smooth" the displacement is first brought to the generic face and measured there.

    Parameters
    ----------
    space : ParameterSpace
        The space of the face.
    face : Face
        The face at rest.
    displacement : array_like, (V, 3)
        Where each vertex goes from there, metres.
    parts : mapping of array_like (n, 3), by the name of a part, optional
        Displacements of eyeballs, teeth, tongue and lashes, metres; an eyeball's is read as a turn about its centre and
        a rest.

    Returns
    -------
    Expression
        A field on S: any face of the space wears it.

    Raises
    ------
    ValueError
        On other shapes and on values that are not finite.
    TypeError
        Where the space is none, or parts is no mapping.

    Examples
    --------
    >>> kaori, old = cast.faces["kaori"], cast.faces["old"]
    >>> smiling = omote.compound(cast.space, kaori, cast.expressions["smile"])
    >>> smile = omote.extract(cast.space, kaori, smiling - kaori.positions)
    >>> bool(np.abs(omote.compound(cast.space, kaori, smile) - smiling).max() < 1e-5)  # metres
    True

    References
    ----------
    K. Arai (1993), section 2.2, steps 1a to 1d; docs/method.md, "The smooth map".
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
        ready = prepare_smooth_map(space, face)
        goal = ready.positions + moved * space.on_sheet[:, None]
        bare = _field(space, ready.generic, invert_smooth_map(space, face, goal))
    else:
        bare = _field(space, face.positions.astype(np.float64), moved)
    return ask(space, face.gains, _with_rest(space, face, bare, moved, parts or {}))


def invert_smooth_map(space: ParameterSpace, face: Face, goal: Values, /) -> Values:
    """The displacement (V, 3) of the generic face with which `apply_smooth_map` brings a face's sheet to goal (V, 3).

    Exact where no stage after `CONTINUOUS_STAGES` changes the sheet; elsewhere all stages of the sheet are inverted as
    far as they go. Anderson acceleration (1965), since plain fixed-point steps diverge where a face's triangles are
    much larger than the generic one's.
    """
    through_continuous = partial(apply_smooth_map, space, face, stages=CONTINUOUS_STAGES)
    through_all = partial(apply_smooth_map, space, face)
    first = goal - prepare_smooth_map(space, face).positions
    smooth = _solve_fixed_point(through_continuous, goal, first, _STEPS)
    if np.abs(through_all(smooth) - goal).max() < _CLOSE:
        return smooth
    return _solve_fixed_point(through_all, goal, smooth, _POLISHING_STEPS)


def _solve_fixed_point(map_: Callable[[Values], Values], goal: Values, start: Values, most: int) -> Values:
    """Where a map gives the goal (V, 3), or the nearest it came to it in so many steps of Anderson acceleration."""
    displacement, best, least = start, start, np.inf
    steps, changes = list[Values](), list[Values]()
    before: tuple[Values, Values] | None = None
    for _ in range(most):
        residual = goal - map_(displacement)
        error = float(np.abs(residual).max())
        if error < least:
            best, least = displacement, error
        if error < _EXACT:
            break
        if before is not None:
            steps, changes = [*steps, before[0]][-_MEMORY:], [*changes, residual - before[1]][-_MEMORY:]
        step = _accelerated_step(residual, steps, changes)
        before = (step, residual)
        displacement = displacement + step
    return best


def _accelerated_step(residual: Values, steps: list[Values], changes: list[Values]) -> Values:
    """Half the residual, after the combination of earlier steps whose changes of the residual explain it best."""
    if not steps:
        return 0.5 * residual
    known = np.stack(changes)
    share, *_ = np.linalg.lstsq(known.reshape(len(known), -1).T, residual.ravel(), rcond=1e-10)
    result: Values = 0.5 * (residual - np.tensordot(share, known, 1)) - np.tensordot(share, np.stack(steps), 1)
    return result


def _field(space: ParameterSpace, before: Values, moved: Values) -> Expression:
    """The field on S of a displacement (V, 3) of the sheet of a face with positions (V, 3)."""
    after = before + moved
    vertices = np.flatnonzero(space.on_sheet & (np.abs(moved) > _REST).any(axis=1)).astype(np.int32)
    landing = project_to_surface(space, before, after[vertices], vertices)
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
    sheet = _wear(space, face, bare)
    inner = space.inner.vertices
    residual = (moved[inner] - _before_mouth_bag(space, face, bare)[inner]) / fitted.scale[:, None]
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
        rest[name] = (after - before - predict_part(space, name, sheet)) / fitted.sizes[name]
    return Expression(bare.dtheta, bare.dh, bare.ratio, residual, rest, eyes, space.radius, space.transfer)


def _wear(space: ParameterSpace, face: Face, bare: Expression) -> Values:
    """What the skin (V, 3) does under a field as it is, whatever gains the face has."""
    return apply_expression(space, face, compile_expression(space, bare)).astype(np.float64) - face.positions


def _before_mouth_bag(space: ParameterSpace, face: Face, bare: Expression) -> Values:
    """What the skin (V, 3) is predicted to do before the mouth bag is fitted, which needs the residual."""
    if space.transfer == "paper":
        return _wear(space, face, bare)
    compiled = compile_expression(space, bare)
    return transfer_expression(space, face, compiled, LINEAR_INNER_STAGES).astype(np.float64) - face.positions
