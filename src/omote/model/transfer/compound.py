"""Compounds: one face wearing one expression (paper, section 2.4), by the paper's map or by the smooth one."""

from __future__ import annotations

from collections.abc import Mapping
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import eye_rotation
from omote.model.transfer.eyeball_clearance import Ball
from omote.model.transfer.mouth_bag_fit import kept_inside
from omote.model.transfer.paper_map import Compiled, compile_expression, follow, wear
from omote.model.transfer.smooth_map import Carrier, carried, carrier_of

Floats = NDArray[np.float32]
Values = NDArray[np.float64]

_generics: WeakKeyDictionary[ParameterSpace, Face] = WeakKeyDictionary()
_carriers: WeakKeyDictionary[Face, tuple[ParameterSpace, Carrier]] = WeakKeyDictionary()


def compound(space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0) -> Floats:
    """A face wearing an expression: positions (V, 3) float32, metres (paper, sections 2.2 and 2.4).

    weight scales the field. With transfer="paper" by the paper's map; with transfer="smooth" the generic face wears it
    by the paper's map, and what it does there is carried over: lids and lips meet, nothing folds (method.md,
    section 3).
    Raises ValueError where face or expression does not belong to the space.
    """
    return worn(space, face, compile_expression(space, expression, weight))


def worn(space: ParameterSpace, face: Face, compiled: Compiled, /) -> Floats:
    """A face wearing a compiled expression: (V, 3) float32, metres."""
    fitted = fit(space, face)
    if space.transfer == "paper":
        return wear(space, fitted, compiled)
    return carried_over(space, face, on_generic(space, compiled), compiled.residual)


def generic_face(space: ParameterSpace, /) -> Face:
    """The face M0 of a space."""
    if space not in _generics:
        parts = {name: part.points.astype(np.float32) for name, part in space.parts.items()}
        _generics[space] = Face("generic", space.points, parts)
    return _generics[space]


def on_generic(space: ParameterSpace, compiled: Compiled, /) -> Values:
    """What a compiled expression does to the generic face by the paper's map: displacement (V, 3), metres."""
    fitted = fit(space, generic_face(space))
    return wear(space, fitted, compiled).astype(np.float64) - fitted.positions


def carried_over(space: ParameterSpace, face: Face, displacement: Values, residual: Floats, /) -> Floats:
    """A face moved as the generic face is by (V, 3): the sheet carried smoothly, the inner skin behind it with its
    residual (inner, 3), the mouth bag inside the head."""
    return kept_inside(space, face, followed(space, face, displacement, residual))


def followed(space: ParameterSpace, face: Face, displacement: Values, residual: Floats, /) -> Floats:
    """What `carried_over` gives before the mouth bag is kept inside the head: linear in the residual."""
    fitted = fit(space, face)
    moved = carried(carrier(space, face), displacement)
    out = np.where(space.on_sheet[:, None], moved[space.welded], fitted.positions).astype(np.float32)
    inner = space.inner
    follow(fitted.positions, inner.vertices, inner.anchors, inner.weights, residual, fitted.scale, out)
    return out


def carrier(space: ParameterSpace, face: Face, /) -> Carrier:
    """What is solved once to carry expressions to a face, remembered as long as the face lives."""
    known = _carriers.get(face)
    if known is None or known[0] is not space:
        fitted, generic = fit(space, face), fit(space, generic_face(space))
        here, there = fitted.positions.astype(np.float64), generic.positions.astype(np.float64)
        balls = tuple(zip(_balls(space, generic), _balls(space, fitted), strict=True))
        known = (space, carrier_of(there, here, space.sheet_triangles, space.lines, balls))
        _carriers[face] = known
    return known[1]


def _balls(space: ParameterSpace, fitted: FittedFace) -> tuple[Ball, ...]:
    """The eyeballs of a face."""
    return tuple(Ball(fitted.centres[name], fitted.ball_radius(name)) for name, part in space.parts.items() if part.eye)


def predicted(space: ParameterSpace, name: str, displacement: NDArray[np.float64], /) -> NDArray[np.float64]:
    """The displacement (n, 3) of a part that follows from that of the skin (V, 3)."""
    part = space.parts[name]
    result: NDArray[np.float64] = np.einsum("nk,nkc->nc", part.weights, displacement[part.anchors])
    return result


def compound_parts(
    space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0
) -> dict[str, Floats]:
    """The parts of a face wearing an expression: {part: (n, 3)} metres; eyeballs before their turn."""
    compiled = compile_expression(space, expression, weight)
    return moved_parts(space, fit(space, face), worn(space, face, compiled), compiled.parts)


def moved_parts(
    space: ParameterSpace, fitted: FittedFace, worn: Floats, rest: Mapping[str, NDArray[np.float64]], /
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
