"""Caches what faces with gains make of the cast's expressions, once per cast, face and name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.face_fit import fit, generic_face
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import apply_paper_map, compile_expression
from omote.perform.blending.expression_tables import TableRow

Floats = NDArray[np.float32]

CAPACITY = 256
"""Answers kept per cast, a quarter of a megabyte each on the built-in head; the least recently used go first."""


@dataclass(frozen=True, eq=False)
class Answer:
    """An expression of the cast as a face answers it: the expression; its row in tables; source (V, 3) metres, the
    generic face wearing it by the paper's map."""

    expression: Expression
    row: TableRow
    source: Floats


Answers = Callable[[str, str], Answer]

_of_cast: WeakKeyDictionary[Cast, Answers] = WeakKeyDictionary()


def answers_of(cast: Cast) -> Answers:
    """The answers of a cast by face and expression, cached as long as the cast lives."""
    if cast not in _of_cast:
        _of_cast[cast] = build_answers(cast)
    return _of_cast[cast]


def build_answers(cast: Cast, capacity: int = CAPACITY) -> Answers:
    """The answers of a cast, so many of them kept."""
    space, faces, expressions = cast.space, cast.faces, cast.expressions  # not the cast itself, which could never go

    @lru_cache(maxsize=capacity)
    def answer(face: str, name: str) -> Answer:
        own = answer_expression(space, faces[face].gains, expressions[name])
        source = apply_paper_map(space, fit(space, generic_face(space)), compile_expression(space, own))
        return Answer(own, TableRow.of(space, own), source)

    return answer
