"""The mix of expressions as the faces on air answer it: the field of each face, by the weight of both."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from omote.arrays import Floats, Values
from omote.model.cast import Cast
from omote.model.known_names import PlayRegion
from omote.model.space.expression import Expression
from omote.model.space.face_fit import fit, generic_face
from omote.model.space.gain import changes_field, gain_of
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import Compiled, apply_paper_map, compile_expression
from omote.model.weak_cache import weakly_cached
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.expression_tables import RegionalField, TableRow, tables_of
from omote.perform.blending.region_masks import PlayMask

CAPACITY = 256
"""Answers kept per cast, a quarter of a megabyte of numbers for 4,278 vertices; the least recently used go first."""


@dataclass(frozen=True, eq=False)
class Answer:
    """An expression of the cast as a face answers it: the expression; its row in tables; source (V, 3) metres, the
    generic face wearing it by the paper's map."""

    expression: Expression
    row: TableRow
    source: Floats


@weakly_cached
def answers_of(cast: Cast) -> Callable[[str, str], Answer]:
    """What the faces of a cast make of its expressions, by the names of both, kept as long as the cast lives."""
    space = cast.space  # not the cast itself, which could never go
    faces = cast.faces
    expressions = cast.expressions

    @lru_cache(maxsize=CAPACITY)
    def answer(face: str, name: str) -> Answer:
        own = answer_expression(space, faces[face].gains, expressions[name])
        source = apply_paper_map(space, fit(space, generic_face(space)), compile_expression(space, own))
        return Answer(own, TableRow.of(space, own), source)

    return answer


@dataclass(frozen=True, eq=False)
class AnsweredMix:
    """Expressions of the cast by weight, whose fields are worn as they are, own answers (of faces with gains) with
    theirs, how far the ears turn, (2, 3) radians, and what regions wear beyond that."""

    cast: Cast
    plain: Mapping[str, float]
    own: tuple[tuple[Answer, float], ...] = ()
    ears: Values = field(default_factory=lambda: np.zeros((2, 3)))
    regions: tuple[RegionalMix, ...] = ()

    def with_regions(self, regions: Sequence[RegionalMix]) -> AnsweredMix:
        """The mix with what regions wear beyond it; ears belong to the region `rest` whole."""
        ears = sum((mix.more.ears for mix in regions if mix.region == "rest"), self.ears)
        return replace(self, regions=tuple(regions), ears=ears)

    def part_residual(self, part: str) -> Values:
        """What a part does beyond following the skin, (n, 3), by weight, in the generic face's size."""
        worn = [
            (expression.parts[part], weight) for expression, weight in self.expressions() if part in expression.parts
        ]
        total = sum((weight * residual for residual, weight in worn), np.zeros(3))
        for region in self.regions:
            total = total + region.mask.parts[part] * region.more.part_residual(part)
        return np.asarray(total)

    def expressions(self) -> list[tuple[Expression, float]]:
        """All that the whole face wears, with their weights."""
        plain = [(self.cast.expressions[name], weight) for name, weight in self.plain.items()]
        return plain + [(answer.expression, weight) for answer, weight in self.own]

    def compile(self) -> Compiled:
        """The sum of all fields by weight, located on S; no parts."""
        regions = [RegionalField(mix.mask.skin[:, 0], mix.more.plain, mix.more.rows()) for mix in self.regions]
        return tables_of(self.cast).mix(self.plain, self.rows(), regions)

    def rows(self) -> list[tuple[TableRow, float]]:
        """The own answers as rows of tables."""
        return [(answer.row, weight) for answer, weight in self.own]

    def compounds(self) -> list[tuple[Floats, float]]:
        """What the generic face does under each of the fields alone, by the paper's map, (V, 3) metres, and its weight;
        of a region's fields only what belongs to it."""
        compounds = compound_cache(self.cast)
        plain = [(compounds.source(name), weight) for name, weight in self.plain.items()]
        worn = plain + [(answer.source, weight) for answer, weight in self.own]
        return worn + [
            (mix.mask.skin * source, weight) for mix in self.regions for source, weight in mix.more.compounds()
        ]


@dataclass(frozen=True, eq=False)
class RegionalMix:
    """What a region wears beyond the mix of the whole face: weights that sum to nothing, where its mask says."""

    region: PlayRegion
    mask: PlayMask
    more: AnsweredMix


def answered_mix(cast: Cast, faces: Mapping[str, float], weights: Mapping[str, float], /) -> AnsweredMix:
    """What faces of a cast by weight make of expressions by weight, both by name.

    cast: of both; faces, weights: by name, of faces and of expressions.
    """
    if not any(cast.faces[face].gains for face in faces):
        return AnsweredMix(cast, weights)
    plain = dict[str, float]()
    own = list[tuple[Answer, float]]()
    ears = np.zeros((2, 3))
    for face, share in faces.items():
        gains = cast.faces[face].gains
        for name, weight in weights.items():
            ears += share * weight * gain_of(gains, "ears", name) * cast.expressions[name].ears
            if changes_field(gains, name):
                own.append((answers_of(cast)(face, name), share * weight))
            else:  # as the cast has it, in tables and caches
                plain[name] = plain.get(name, 0.0) + share * weight
    return AnsweredMix(cast, plain, tuple(own), ears)
