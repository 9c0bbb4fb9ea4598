"""Extraction: from a displacement of a face to an expression, the inverse of a compound (paper, section 2.2, step 1).

In order: the smooth map inverted, so that the displacement is the generic face's; each vertex's new place projected
onto that face at rest, which gives the field on S; residuals: what inner skin and parts do over what the field
predicts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Floats, Values
from omote.geometry import mesh
from omote.model.extraction.ear_turns import fit_ear_turns, undo_ears
from omote.model.extraction.extracted_expression import ExtractedExpression, measure_uncertainty
from omote.model.extraction.inner_skin_residual import solve_inner_residual
from omote.model.extraction.known_span import KnownSum
from omote.model.extraction.sheet_field import REST, measure_field
from omote.model.extraction.smooth_map_inverse import InverseResult, invert_smooth_map
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import ask, gain_of
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.parts import eye_angles, eye_rotation
from omote.model.transfer.compound import apply_expression, predict_part
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import compile_expression, refuse_foreign
from omote.model.transfer.smooth_map import prepare_smooth_map

# What differs from the positions at rest by less than this share of them is positions and no displacement.
_ALIKE = 0.5


def extract(
    space: ParameterSpace,
    face: Face,
    displacement: ArrayLike,
    /,
    *,
    parts: Mapping[str, ArrayLike] | None = None,
    known: Sequence[Expression] = (),
) -> ExtractedExpression:
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
    known : sequence of Expression, optional
        Expressions that it may be a sum of, such as the cast's. Where the face's map gives the same displacement for
        several fields (folds turned back, lids pushed off an eyeball), they say which is meant; where it is such a sum,
        its turns of head and ears are theirs too.

    Returns
    -------
    ExtractedExpression
        A field on S: any face of the space wears it. Its `uncertainty` says, vertex by vertex, how far others may be
        off, where several fields give the same displacement of this face.

    Raises
    ------
    ValueError
        On other shapes, on values that are not finite, and on what is no displacement in metres: positions,
        millimetres.
    TypeError
        Where the space is none, parts is no mapping, or one of known is no expression.

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
    for expression in known:
        refuse_foreign(space, expression)
    moved = _validate_displacement(space, face, displacement)
    answered = [answer_expression(space, face.gains, expression) for expression in known]
    bare, inverse, still = _measure_without_ears(space, face, moved, answered)
    near = inverse.known.expression if inverse.known else None
    worn = _with_parts(space, face, _with_inner_skin(space, face, bare, still, near), parts or {})
    asked = ask(space, face.gains, worn)
    if inverse.exact and inverse.known:
        return _with_uncertainty(_with_unseen(face, asked, inverse.known, known), np.zeros(space.vertex_count))
    return _with_uncertainty(asked, measure_uncertainty(space, face, worn))


def _validate_displacement(space: ParameterSpace, face: Face, displacement: ArrayLike) -> Values:
    """The displacement (V, 3) of a face; ValueError on another shape, on positions and on what is not metres."""
    moved = mesh.validate_points(displacement, name="displacement")
    rest = face.positions
    if len(moved) != space.vertex_count:
        raise ValueError(
            f"displacement has {len(moved)} rows; expected {space.vertex_count}, one per vertex of the skin"
        )
    for unit, scale in (("", 1.0), (" in millimetres", 1000.0)):
        if np.linalg.norm(moved - scale * rest) < _ALIKE * np.linalg.norm(scale * rest):
            raise ValueError(
                f"displacement[0] is {moved[0]}: these are positions{unit}; expected how far each vertex goes from "
                "rest, metres: subtract face.positions"
            )
    _refuse_far(moved, rest, "displacement")
    return moved


def _refuse_far(moved: Values, rest: Floats, name: str) -> None:
    """ValueError where something goes farther than the head (V, 3) is long."""
    far = np.linalg.norm(moved, axis=1)
    longest = float(np.ptp(rest, axis=0).max())
    worst = int(far.argmax())
    if far[worst] > longest:
        raise ValueError(
            f"row {worst} of the {name} is {moved[worst]}, {far[worst]:.3g} m; expected at most "
            f"{longest:.2g} m, as the head is long: give it in metres (divide millimetres by 1000)"
        )


def _with_uncertainty(taken: Expression, uncertainty: Values) -> ExtractedExpression:
    """The expression with its uncertainty (V,), metres."""
    values = {entry.name: getattr(taken, entry.name) for entry in fields(Expression)}
    return ExtractedExpression(**values, uncertainty=uncertainty)


def _measure_without_ears(
    space: ParameterSpace, face: Face, moved: Values, known: Sequence[Expression]
) -> tuple[Expression, InverseResult, Values]:
    """The field of a displacement (V, 3) whose ears are turned back, with their turns: those of the known sum where it
    is one, else the least that turn them so; what the inverse found, and the displacement that is left (V, 3)."""
    turns = fit_ear_turns(space, face, moved)
    still = undo_ears(space, face, moved, turns) if turns.any() else moved
    bare, inverse = _measure_sheet(space, face, still, known)
    if turns.any() and inverse.known is not None:
        again = undo_ears(space, face, moved, inverse.known.expression.ears)
        exactly = _measure_sheet(space, face, again, known)
        if exactly[1].exact:
            turns = inverse.known.expression.ears
            still = again
            (bare, inverse) = exactly
    return replace(bare, ears=turns), inverse, still


def _with_unseen(face: Face, taken: Expression, known_sum: KnownSum, known: Sequence[Expression]) -> Expression:
    """The expression, which is a sum of known ones, with their turns of the head, and of the ears where a face that
    does not turn its own cannot show them."""
    shares = [(weight, known[place]) for weight, place in zip(known_sum.share, known_sum.places, strict=True)]
    turned = replace(taken, head=sum((weight * expression.head for weight, expression in shares), np.zeros(3)))
    if gain_of(face.gains, "ears"):
        return turned
    return replace(turned, ears=sum((weight * expression.ears for weight, expression in shares), np.zeros((2, 3))))


def _measure_sheet(
    space: ParameterSpace, face: Face, moved: Values, known: Sequence[Expression]
) -> tuple[Expression, InverseResult]:
    """The field of a face's displacement (V, 3), and what the inverse found."""
    if space.transfer == "paper":
        return measure_field(space, face.positions.astype(np.float64), moved), InverseResult(moved, None)
    ready = prepare_smooth_map(space, face)
    goal = ready.positions + moved * space.on_sheet[:, None]
    inverse = invert_smooth_map(space, face, goal, known)
    return measure_field(space, ready.generic, inverse.displacement), inverse


def _with_inner_skin(
    space: ParameterSpace, face: Face, bare: Expression, moved: Values, near: Expression | None
) -> Expression:
    """The expression with the inner skin's residual."""
    inner = space.inner.vertices
    residual = solve_inner_residual(space, face, bare, face.positions[inner].astype(np.float64) + moved[inner], near)
    moving = np.abs(residual).max(axis=1, keepdims=True) >= REST
    return replace(bare, residual=np.where(moving, residual, 0.0))


def _with_parts(space: ParameterSpace, face: Face, skin: Expression, parts: Mapping[str, ArrayLike]) -> Expression:
    """The expression with what parts do over what the skin's motion predicts."""
    fitted = fit(space, face)
    sheet = apply_expression(space, face, compile_expression(space, skin)).astype(np.float64) - face.positions
    eyes = np.zeros((2, 2))
    rest: dict[str, Values] = {}
    for name, given in parts.items():
        if name not in space.parts:
            raise ValueError(f"parts has a displacement of {name!r}; expected one of {sorted(space.parts)}")
        part = space.parts[name]
        before = fitted.parts[name].astype(np.float64)
        shift = mesh.validate_points(given, name=f"displacement of part {name!r}")
        if len(shift) != len(before):
            raise ValueError(f"displacement of part {name!r} has {len(shift)} rows; expected {len(before)}")
        _refuse_far(shift, face.positions, f"displacement of part {name!r}")
        after = before + shift
        if part.eye:
            angles = eye_angles(before, after)
            eyes[0 if part.eye == "left" else 1] = angles
            # Turned back about the centre, so that what remains is turned with the ball.
            after = (after - fitted.centres[name]) @ eye_rotation(*angles) + fitted.centres[name]
        rest[name] = (after - before - predict_part(space, name, sheet)) / fitted.sizes[name]
    return replace(skin, parts=rest, eyes=eyes)
