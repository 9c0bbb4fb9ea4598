"""Compounds: one face wearing one expression (paper, section 2.4), by the paper's map or by the smooth one.

The stages of either are lists: `paper_map.STAGES` and `pipeline.STAGES` (docs/method.md, "The smooth map").
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Floats, Values
from omote.model.space.ears import turn_ears
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import eye_rotation
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import Compiled, apply_paper_map, compile_expression, refuse_foreign
from omote.model.transfer.pipeline import transfer_expression
from omote.model.transfer.teeth_clearance import keep_teeth_inside


def compound(space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0) -> Floats:
    """A face wearing an expression (a blendshape of this face, retargeted from the field on S).

    The face answers in its own strength where it has gains. With transfer="paper" it wears the field by the paper's
    map; with transfer="smooth" the generic face does, and what it does there is carried over: lids and lips meet,
    nothing folds.

    Parameters
    ----------
    space : ParameterSpace
        The space of both.
    face : Face
        Who wears it.
    expression : Expression
        What is worn.
    weight : float
        Scales the field; 1 is as it was made.

    Returns
    -------
    ndarray of float32, (V, 3)
        Positions of skin and inner skin, metres.

    Raises
    ------
    ValueError
        Where face or expression does not belong to the space.

    Examples
    --------
    >>> smiling = omote.compound(cast.space, cast.faces["old"], cast.expressions["smile"], weight=0.7)
    >>> smiling.shape, smiling.dtype
    ((4278, 3), dtype('float32'))
    >>> at_rest = omote.compound(cast.space, cast.faces["old"], cast.expressions["smile"], weight=0.0)
    >>> bool(np.abs(at_rest - cast.faces["old"].positions).max() < 1e-7)
    True

    References
    ----------
    K. Arai (1993), sections 2.2 and 2.4; docs/method.md, "The smooth map".
    """
    return apply_expression(space, face, compile_answer(space, face, expression, weight))


def compile_answer(space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0) -> Compiled:
    """The expression as a face answers it (`answer_expression`), located on S; errors as `compile_expression`.

    space: the space of the generic head; weight: how much of the expression, 1 all.
    """
    refuse_foreign(space, expression)
    fit(space, face)
    return compile_expression(space, answer_expression(space, face.gains, expression), weight)


def apply_expression(space: ParameterSpace, face: Face, compiled: Compiled, /) -> Floats:
    """A face wearing a compiled expression: (V, 3) float32, metres; its gains are not applied, its ears are turned.

    space: the space of the generic head.
    """
    fitted = fit(space, face)
    paper = space.transfer == "paper"
    skin = apply_paper_map(space, fitted, compiled) if paper else transfer_expression(space, face, compiled)
    if not compiled.ears.any():
        return skin
    return turn_ears(space, fitted.positions, skin, compiled.ears, signed=compiled.signed)


def predict_part(space: ParameterSpace, name: str, displacement: Values, /) -> Values:
    """The displacement (n, 3) of a part that follows from that of the skin (V, 3).

    space: the space of the generic head; name: of the part.
    """
    part = space.parts[name]
    return np.einsum("nk,nkc->nc", part.weights, displacement[part.anchors])


def compound_parts(
    space: ParameterSpace, face: Face, expression: Expression, /, weight: float = 1.0
) -> dict[str, Floats]:
    """The parts of a face wearing an expression: {part: (n, 3)} metres; eyeballs before their turn.

    space: the space of the generic head; weight: how much of the expression, 1 all.
    """
    compiled = compile_answer(space, face, expression, weight)
    return move_parts(space, fit(space, face), apply_expression(space, face, compiled), compiled.parts)


def move_parts(
    space: ParameterSpace, fitted: FittedFace, skin: Floats, rest: Mapping[str, Values], /
) -> dict[str, Floats]:
    """The parts of a face whose skin has moved to (V, 3), with the residual rest of each part.

    space: the space of the generic head; fitted: the face, fitted.

    Under the smooth map teeth stay behind the skin.
    """
    displacement = skin.astype(np.float64) - fitted.positions
    result = {}
    for name, placed in fitted.parts.items():
        own = fitted.sizes[name] * rest[name] if name in rest else 0.0
        result[name] = (placed + predict_part(space, name, displacement) + own).astype(np.float32)
    return result if space.transfer == "paper" else keep_teeth_inside(space, fitted, skin, result)


def turn_eyes(
    space: ParameterSpace, parts: Mapping[str, Floats], centres: Mapping[str, Values], eyes: Values, /
) -> dict[str, Floats]:
    """The parts with both eyeballs turned about centres (3,) by eyes (2, 2): yaw and pitch, left and right.

    space: the space of the generic head.
    """
    result = dict(parts)
    for name, part in space.parts.items():
        if part.eye:
            rotation = eye_rotation(*eyes[0 if part.eye == "left" else 1])
            result[name] = ((parts[name] - centres[name]) @ rotation.T + centres[name]).astype(np.float32)
    return result
