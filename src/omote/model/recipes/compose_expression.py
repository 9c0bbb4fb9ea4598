"""Composes the expression of a recipe: adds its ground, weighted layers, muscles and control points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from omote.arrays import Values
from omote.geometry import mesh
from omote.model.controls.face_muscles import muscle_fields
from omote.model.controls.mirror import mirror_expression
from omote.model.controls.net_field import NetField, build_net_field
from omote.model.recipes.recipe import KEY, Layer, Recipe
from omote.model.space.complexion import MOST, OF_REGION, PARTS, Complexion, check_complexion
from omote.model.space.expression import Expression
from omote.model.space.head_regions import RegionMask, check_region, region_mask
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression
from omote.model.weak_cache import weakly_cached

HEAVIEST = 4.0
"""A layer's weight, and a muscle's contraction, at most, either way."""


@dataclass
class _Sum:
    """What is added up: field (V, 3) of dtheta, dh and R - 1, residual (inner, 3), parts, eyes (2, 2), pupil,
    ears (2, 3), head (3,), complexion (7,)."""

    field: Values
    residual: Values
    parts: dict[str, Values]
    eyes: Values
    ears: Values
    head: Values
    complexion: Values
    pupil: float = 0.0


def compose_expression(
    space: ParameterSpace, recipe: Recipe, sources: Mapping[str, Expression], /, net_field: NetField | None = None
) -> Expression:
    """Composes the expression of a recipe: fields add as dtheta, dh and R - 1, and so do residuals, parts, eyes,
    pupils, ears, head and complexion; muted layers add nothing.

    space: the space of the generic head.

    sources: the expressions that it names; net_field: of its net, where it is known. Raises ValueError on what it names
    and nobody knows, numbers that are not finite, weights beyond HEAVIEST and radii that are not positive.
    """
    total = _zero_sum(space)
    if recipe.ground is not None:
        _add(space, total, _find_source(space, sources, recipe.ground), Layer(recipe.ground, ""))
    for layer in recipe.layers:
        expression = _find_source(space, sources, layer.source)
        if layer.muted:
            continue
        _add(space, total, mirror_expression(space, expression) if layer.mirrored else expression, layer)
    for pull in recipe.pulls:
        total.field += _amount(pull.contraction, f"contraction of muscle {pull.muscle!r}") * find_muscle_field(
            space, pull.muscle
        )
    total.field += (net_field or build_net_field(space, recipe.net)).field(recipe.vectors)
    eyes = mesh.validate_numbers(recipe.eyes, name="eyes of a recipe")
    total.eyes += eyes.reshape(2, 2)
    total.pupil += recipe.pupil
    total.complexion += check_complexion(recipe.complexion)
    return _expression(space, total)


def find_muscle_field(space: ParameterSpace, name: str, /) -> Values:
    """The field (V, 3) of a muscle at full contraction; ValueError for an unknown name.

    space: the space of the generic head.
    """
    fields = muscle_fields(space)
    if name not in fields:
        raise ValueError(f"there is no muscle {name!r}; expected one of {', '.join(fields) or 'none on this head'}")
    return fields[name]


def add_field(space: ParameterSpace, ground: Expression | None, field: Values, /) -> Expression:
    """Adds a field to a ground (None: at rest): a field (V, 3) of dtheta, dh and R - 1; ValueError on radii that are
    not positive.

    space: the space of the generic head.
    """
    total = _zero_sum(space)
    if ground is not None:
        _add(space, total, ground, Layer("", ""))
    total.field += field
    return _expression(space, total)


def _zero_sum(space: ParameterSpace) -> _Sum:
    still = np.zeros((len(space.inner.vertices), 3))
    return _Sum(
        np.zeros((space.vertex_count, 3)),
        still,
        {},
        np.zeros((2, 2)),
        np.zeros((2, 3)),
        np.zeros(3),
        np.zeros(len(PARTS)),
    )


def _find_source(space: ParameterSpace, sources: Mapping[str, Expression], name: str) -> Expression:
    if name not in sources:
        what = "own content" if name.startswith(KEY) else "expression of the cast"
        raise ValueError(f"a recipe names {name!r}; there is no such {what}: choose another layer")
    compile_expression(space, sources[name], 0.0)
    return sources[name]


def _amount(number: float, what: str) -> float:
    if isinstance(number, bool) or not isinstance(number, int | float) or not abs(number) <= HEAVIEST:
        raise ValueError(f"{what} is {number!r}; expected a number from {-HEAVIEST:g} to {HEAVIEST:g}")
    return float(number)


def _add(space: ParameterSpace, total: _Sum, expression: Expression, layer: Layer) -> None:
    weight = _amount(layer.weight, f"weight of layer {layer.label or layer.source!r}")
    mask = _whole(space) if layer.region is None else region_mask(space, check_region(layer.region))
    field = np.stack([expression.dtheta, expression.dh, expression.ratio - 1.0], axis=1)
    total.field += weight * mask.skin[:, None] * field
    total.residual += weight * mask.skin[space.inner.vertices, None] * expression.residual
    for name, rest in expression.parts.items():
        total.parts[name] = total.parts.get(name, 0.0) + weight * mask.parts[name][:, None] * rest
    total.eyes += weight * mask.eyes[:, None] * expression.eyes
    total.pupil += weight * float(mask.eyes.mean()) * expression.pupil
    total.ears += weight * (layer.region in (None, "ears")) * expression.ears
    total.head += weight * (layer.region is None) * expression.head
    total.complexion += weight * _blood_in(layer.region) * expression.complexion


def _blood_in(region: str | None) -> Values:
    """How much of each part of a complexion a layer brings (7,): all of it, or that of its region."""
    return np.array([float(region is None or part in OF_REGION.get(region, ())) for part in PARTS])


@weakly_cached
def _whole(space: ParameterSpace) -> RegionMask:
    """The mask of everything."""
    parts = {name: np.ones(len(part.points)) for name, part in space.parts.items()}
    return RegionMask(np.ones(space.vertex_count), parts, np.ones(2))


def _expression(space: ParameterSpace, total: _Sum) -> Expression:
    sheet = space.on_sheet[:, None]
    dtheta, dh, over = np.where(sheet, total.field, 0.0).T
    low = int(over.argmin())
    if not over[low] > -1.0:
        raise ValueError(
            f"this sum brings the radius at vertex {low} to {1.0 + over[low]:.3g} of itself; expected a positive one: "
            "give layers and muscles less weight, or pull the points there less deep"
        )
    return Expression(
        dtheta, dh, 1.0 + over, total.residual, total.parts, total.eyes, space.radius, space.transfer, total.pupil,
        ears=total.ears, head=total.head, complexion=Complexion(*np.clip(total.complexion, -MOST, MOST).tolist()),
    )  # fmt: skip


def change_net(
    space: ParameterSpace, recipe: Recipe, ground: Expression | None, net: Sequence[int], /
) -> tuple[Recipe, NetField, Expression | None]:
    """Refits an expression to another net: the recipe, whose ground the caller names, its net field, and that ground.

    space: the space of the generic head.

    The new points carry the old control field where they stand; what the new net cannot say of it goes into the ground
    (None: there is still none), so that nothing moves. ValueError as `build_net_field`.
    """
    before = build_net_field(space, recipe.net).field(recipe.vectors)
    net_field = build_net_field(space, net)
    vectors = before[list(net_field.rows)] + [0.0, 0.0, 1.0]
    left = before - net_field.field(vectors)
    rows = tuple((float(a), float(b), float(c)) for a, b, c in vectors)
    refitted = _replace_net(recipe, net_field.rows, rows)
    if not np.abs(left).max(initial=0.0) > 1e-12:
        return refitted, net_field, ground
    return refitted, net_field, add_field(space, ground, left)


def _replace_net(recipe: Recipe, net: tuple[int, ...], vectors: tuple[tuple[float, float, float], ...]) -> Recipe:
    return msgspec.structs.replace(recipe, net=net, vectors=vectors)
