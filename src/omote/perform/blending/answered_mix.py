"""The mix of expressions as the faces on air answer it: each face's own field, by the weight of both."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.face_fit import fit, generic_face
from omote.model.space.gain import answer, field_gain, gain_of
from omote.model.transfer.paper_map import Compiled, apply_paper_map, compile_expression
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.expression_tables import ExpressionTables, tables_of

Floats = NDArray[np.float32]
Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class AnsweredMix:
    """Expressions of the cast by weight, whose fields are worn as they are, own answers (of faces with gains) with
    theirs, and how far the ears turn, (2, 3) radians."""

    cast: Cast
    plain: Mapping[str, float]
    own: tuple[tuple[Expression, float], ...] = ()
    ears: Values = field(default_factory=lambda: np.zeros((2, 3)))

    def expressions(self) -> list[tuple[Expression, float]]:
        """All of them with their weights."""
        return [*((self.cast.expressions[name], weight) for name, weight in self.plain.items()), *self.own]

    def compile(self) -> Compiled:
        """The sum of all fields by weight, located on S; no parts."""
        if not self.own:
            return tables_of(self.cast).mix(self.plain)
        expressions = {name: self.cast.expressions[name] for name in self.plain}
        answers = {f"\n{place}": expression for place, (expression, _) in enumerate(self.own)}
        weights = {f"\n{place}": weight for place, (_, weight) in enumerate(self.own)}
        return ExpressionTables(self.cast.space, expressions | answers).mix({**self.plain, **weights})

    def compounds(self) -> list[tuple[Floats, float]]:
        """What the generic face does under each of the fields alone, by the paper's map, (V, 3) metres, and its
        weight."""
        space, known = self.cast.space, compound_cache(self.cast)
        source = fit(space, generic_face(space))
        found = [(known.source(name), weight) for name, weight in self.plain.items()]
        return found + [
            (apply_paper_map(space, source, compile_expression(space, expression)), weight)
            for expression, weight in self.own
        ]


def answered_mix(cast: Cast, faces: Mapping[str, float], weights: Mapping[str, float], /) -> AnsweredMix:
    """What faces by weight make of expressions by weight."""
    if not any(cast.faces[face].gains for face in faces):
        return AnsweredMix(cast, weights)
    plain, own, ears = dict[str, float](), list[tuple[Expression, float]](), np.zeros((2, 3))
    for face, share in faces.items():
        gains = cast.faces[face].gains
        for name, weight in weights.items():
            expression = cast.expressions[name]
            ears += share * weight * gain_of(gains, "ears", name) * expression.ears
            if field_gain(cast.space, gains, name) is None:  # as the cast has it, in tables and caches
                plain[name] = plain.get(name, 0.0) + share * weight
            else:
                own.append((answer(cast.space, gains, expression), share * weight))
    return AnsweredMix(cast, plain, tuple(own), ears)
