"""The mix of expressions as the faces on air answer it: each face's own field, by the weight of both."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.known_names import PlayRegion
from omote.model.space.expression import Expression
from omote.model.space.gain import changes_field, gain_of
from omote.model.transfer.paper_map import Compiled
from omote.perform.blending.answer_cache import Answer, answers_of
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.expression_tables import RegionalField, TableRow, tables_of
from omote.perform.blending.region_masks import PlayMask

Floats = NDArray[np.float32]
Values = NDArray[np.float64]


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
        ears = sum((each.more.ears for each in regions if each.region == "rest"), self.ears)
        return replace(self, regions=tuple(regions), ears=ears)

    def part_residual(self, part: str) -> Values:
        """What a part does beyond following the skin, (n, 3), by weight, in the generic face's size."""
        moving = [(each.parts[part], weight) for each, weight in self.expressions() if part in each.parts]
        total = sum((weight * residual for residual, weight in moving), np.zeros(3))
        for each in self.regions:
            total = total + each.mask.parts[part] * each.more.part_residual(part)
        return np.asarray(total)

    def expressions(self) -> list[tuple[Expression, float]]:
        """All that the whole face wears, with their weights."""
        plain = [(self.cast.expressions[name], weight) for name, weight in self.plain.items()]
        return plain + [(answer.expression, weight) for answer, weight in self.own]

    def compile(self) -> Compiled:
        """The sum of all fields by weight, located on S; no parts."""
        regions = [RegionalField(each.mask.skin[:, 0], each.more.plain, each.more.rows()) for each in self.regions]
        return tables_of(self.cast).mix(self.plain, self.rows(), regions)

    def rows(self) -> list[tuple[TableRow, float]]:
        """The own answers as rows of tables."""
        return [(answer.row, weight) for answer, weight in self.own]

    def compounds(self) -> list[tuple[Floats, float]]:
        """What the generic face does under each of the fields alone, by the paper's map, (V, 3) metres, and its weight;
        of a region's fields only what belongs to it."""
        known = compound_cache(self.cast)
        plain = [(known.source(name), weight) for name, weight in self.plain.items()]
        worn = plain + [(answer.source, weight) for answer, weight in self.own]
        return worn + [
            (each.mask.skin * source, weight) for each in self.regions for source, weight in each.more.compounds()
        ]


@dataclass(frozen=True, eq=False)
class RegionalMix:
    """What a region wears beyond the mix of the whole face: weights that sum to nothing, where its mask says."""

    region: PlayRegion
    mask: PlayMask
    more: AnsweredMix


def answered_mix(cast: Cast, faces: Mapping[str, float], weights: Mapping[str, float], /) -> AnsweredMix:
    """What faces by weight make of expressions by weight."""
    if not any(cast.faces[face].gains for face in faces):
        return AnsweredMix(cast, weights)
    plain, own, ears = dict[str, float](), list[tuple[Answer, float]](), np.zeros((2, 3))
    for face, share in faces.items():
        gains = cast.faces[face].gains
        for name, weight in weights.items():
            ears += share * weight * gain_of(gains, "ears", name) * cast.expressions[name].ears
            if changes_field(gains, name):
                own.append((answers_of(cast)(face, name), share * weight))
            else:  # as the cast has it, in tables and caches
                plain[name] = plain.get(name, 0.0) + share * weight
    return AnsweredMix(cast, plain, tuple(own), ears)
