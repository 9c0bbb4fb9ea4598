"""Corrects what the layers of a recipe fold together and none of them alone, as sums on air are corrected.

An expression made of layers is one compound wherever it is worn: what it folds on the generic head every face would
wear, and no corrective of a frame may touch it (`omote.perform.blending.correctives`). A blink and a squint laid one
lid 4 mm over the other.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping
from typing import TypeVar

import msgspec
import numpy as np

from omote.arrays import Floats, Values
from omote.model.controls.net_field import NetField
from omote.model.extraction.sheet_field import measure_field
from omote.model.recipes.compose_expression import add_field, compose_expression
from omote.model.recipes.recipe import Layer, Recipe
from omote.model.space.complexion import PALE
from omote.model.space.expression import Expression
from omote.model.space.face_fit import fit, generic_face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.corrective_regions import CorrectiveRegions, find_corrective_regions
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.perform.blending.correctives import Eyeballs, correct_combination, measure_allowance

SourceExpressions = Mapping[str, Expression]

_CACHED = 64
"""Layers whose allowance stays cached, and recipes whose correction does."""

Found = TypeVar("Found")


class LayerCorrection:
    """Composes recipes on one space, their layers corrected; caches what dragged points and weights leave as it was."""

    def __init__(self, space: ParameterSpace) -> None:
        self._space = space
        self._regions = find_corrective_regions(space)
        self._allowances: OrderedDict[Recipe, Floats] = OrderedDict()
        self._corrections: OrderedDict[Recipe, Values | None] = OrderedDict()

    def compose(self, recipe: Recipe, sources: SourceExpressions, net_field: NetField, /) -> Expression:
        """The expression of a recipe, as `compose_expression`; ground, layers and muscles may cross lids and lips,
        press lids into eyeballs and turn triangles over as far as each does alone, added up.

        Control points are left out of this: a dragged point stays where it was let go.

        recipe: what is composed; sources: the expressions that it names; net_field: its control net.
        """
        whole = compose_expression(self._space, recipe, sources, net_field)
        members = list(_members(recipe))
        regions = self._regions
        if regions is None or len(members) < 2:
            return whole

        def correct() -> Values | None:
            alone = [abs(weight) * self._allow(regions, member, sources, net_field) for member, weight in members]
            allowed = np.sum(alone, axis=0)
            still = compose_expression(self._space, _still(recipe), sources, net_field)
            return correct_field(self._space, regions, still, allowed.astype(np.float32))

        correction = _find_once(self._corrections, _still(recipe), correct)
        return whole if correction is None else add_field(self._space, whole, correction)

    def _allow(
        self, regions: CorrectiveRegions, member: Recipe, sources: SourceExpressions, net_field: NetField
    ) -> Floats:
        def measure() -> Floats:
            alone = compose_expression(self._space, member, sources, net_field)
            generic = fit(self._space, generic_face(self._space))
            return measure_allowance(regions, generic, alone, _wear(self._space, alone))

        return _find_once(self._allowances, member, measure)


def correct_field(
    space: ParameterSpace, regions: CorrectiveRegions, expression: Expression, allowed: Floats, /
) -> Values | None:
    """The field (V, 3) of dtheta, dh and R - 1 that corrects an expression on the generic head; None: nothing to do.

    allowed (regions.size,): as for `correct_combination`.

    space, regions: where folds are looked for; expression: what is worn.
    """
    worn = _wear(space, expression)
    rest = space.points.astype(np.float64)
    balls = Eyeballs.of(fit(space, generic_face(space)), regions.eyes, expression.eyes)
    corrected = correct_combination(regions, rest.astype(np.float32), worn, allowed, balls)
    change = (corrected.astype(np.float64) - worn)[space.welded]
    moved = space.on_sheet & change.any(axis=1)
    if not moved.any():
        return None
    field = _stack(measure_field(space, rest, worn + change - rest)) - _stack(expression)
    result: Values = np.where(moved[:, None], field, 0.0)
    return result


def _still(recipe: Recipe) -> Recipe:
    """The recipe with its control points and eyes at rest."""
    still = ((0.0, 0.0, 1.0),) * len(recipe.net)
    return msgspec.structs.replace(recipe, vectors=still, eyes=(0.0, 0.0, 0.0, 0.0), pupil=0.0, complexion=PALE)


def _members(recipe: Recipe) -> Iterator[tuple[Recipe, float]]:
    """Recipes of what is added up, each alone at a weight of 1, with its weight."""
    bare = msgspec.structs.replace(_still(recipe), ground=None, layers=(), pulls=())
    layers = () if recipe.ground is None else (Layer(recipe.ground, ""),)
    for layer in (*layers, *(layer for layer in recipe.layers if not layer.muted)):
        yield msgspec.structs.replace(bare, layers=(msgspec.structs.replace(layer, weight=1.0),)), layer.weight
    for pull in recipe.pulls:
        yield msgspec.structs.replace(bare, pulls=(msgspec.structs.replace(pull, contraction=1.0),)), pull.contraction


def _wear(space: ParameterSpace, expression: Expression) -> Floats:
    """The generic head (V, 3) wearing it."""
    return (space.points + displace_generic(space, compile_expression(space, expression))).astype(np.float32)


def _stack(expression: Expression) -> Values:
    return np.stack([expression.dtheta, expression.dh, expression.ratio - 1.0], axis=1)


def _find_once(cache: OrderedDict[Recipe, Found], recipe: Recipe, find: Callable[[], Found]) -> Found:
    """Finds through a cache (least recently used)."""
    if recipe not in cache:
        cache[recipe] = find()
        if len(cache) > _CACHED:
            cache.popitem(last=False)
    cache.move_to_end(recipe)
    return cache[recipe]
