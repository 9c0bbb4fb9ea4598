"""Turns back what units and performed expressions fold on the generic head itself.

Retargeting repairs on a face what the generic face does not fold (`omote.model.transfer.fold_repair`); what that does
fold everybody would wear. A wink adds a blink to two squints: their sum laid one lid over the other and turned 41
triangles over. It is corrected as such a sum is on air (`omote.perform.blending.correctives`), once.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression
from omote.model.space.face_fit import FittedFace, fit, generic_face
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import eye_angles
from omote.model.transfer.compound import predict_part
from omote.model.transfer.corrective_regions import CorrectiveRegions, find_corrective_regions
from omote.perform.blending.correctives import Eyeballs, correct_combination, measure_allowance
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.basemesh import Floats
from tools.baking.heads.moves import Move

Allowance = NDArray[np.float32]

# Lids that close lie over each other by so much, metres: the published blink laid one 4.2 mm over the other, and eyes
# twice as large made that a flap of 12 mm.
OVERLAP = 0.0003
# Blocks of rounds, fewer than on air: no unit folds so much that they do not end it, and the built-in cast stays as
# published.
ROUNDS = (8, 8, 8)
# Closes the lips of an open jaw; without the jaw lips lie over each other by intent, and so does what they fold.
WITH_OPEN_JAW = ("mouthClose",)


def repair_folds(space: ParameterSpace, moves: Mapping[str, Move], /) -> dict[str, Move]:
    """The moves without a triangle of the sheet turned over around eyes and mouth.

    A unit may cross lids and lips and press lids into eyeballs as it does, a performed expression as far as its units
    do together. Parts that hang on the skin, such as lashes, go with it.

    space: of the generic face; moves: by expression.
    """
    regions = find_corrective_regions(space)
    if regions is None:
        return dict(moves)
    alone = {name: move for name, move in moves.items() if name not in PERFORMED}
    own = {name: _allowance(space, regions, move) for name, move in alone.items()}
    for name, recipe in PERFORMED.items():
        if name in moves:
            own[name] = sum((abs(weight) * own[unit] for unit, weight in unit_weights(recipe).items()), _none(regions))
            _limit_lids(regions, own[name])
    return {
        name: move if name in WITH_OPEN_JAW else _correct(space, regions, move, own[name])
        for name, move in moves.items()
    }


def _none(regions: CorrectiveRegions) -> Allowance:
    return np.zeros(regions.size, np.float32)


def _allowance(space: ParameterSpace, regions: CorrectiveRegions, move: Move) -> Allowance:
    """What a unit uses up of lips and eyeballs; of triangles nothing, for none may fold, of lids the overlap."""
    count = space.vertex_count
    still = np.zeros((len(space.inner.vertices), 3))
    turned = Expression(np.zeros(count), np.zeros(count), np.ones(count), still, eyes=_eyes(space, regions, move))
    skin = (space.points + move.skin).astype(np.float32)
    result = measure_allowance(regions, _generic(space), turned, skin)
    result[: len(regions.triangles)] = 0.0
    _limit_lids(regions, result)
    return result


def _limit_lids(regions: CorrectiveRegions, allowed: Allowance) -> None:
    """Lets lids cross by no more than OVERLAP, in place."""
    for number, crossing in enumerate(regions.crossings):
        if crossing.kind == "lids":
            rungs = slice(len(regions.triangles) + number * RUNGS, len(regions.triangles) + (number + 1) * RUNGS)
            np.minimum(allowed[rungs], OVERLAP, out=allowed[rungs])


def _correct(space: ParameterSpace, regions: CorrectiveRegions, move: Move, allowed: Allowance) -> Move:
    rest = space.points.astype(np.float32)
    worn = (space.points + move.skin).astype(np.float32)
    balls = Eyeballs.of(_generic(space), regions.eyes, _eyes(space, regions, move))
    corrected = correct_combination(regions, rest, worn, allowed, balls, rounds=ROUNDS, damped=False)
    repaired = (corrected.astype(np.float64) - worn)[space.welded]
    if not repaired.any():
        return move
    hung = {name: move.parts[name] + predict_part(space, name, repaired) for name in regions.attached_parts}
    return Move(move.skin + repaired, {**move.parts, **hung})


def _generic(space: ParameterSpace) -> FittedFace:
    return fit(space, generic_face(space))


def _eyes(space: ParameterSpace, regions: CorrectiveRegions, move: Move) -> Floats:
    """How far a move turns both eyeballs, (2, 2) radians."""
    balls = [(space.parts[name].points, move.parts[name]) for name in regions.eyes]
    return np.array([eye_angles(ball, ball + moved) for ball, moved in balls])
