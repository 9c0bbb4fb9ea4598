"""Validates the recipes and numbers of editors: they pass unchanged or are rejected with an error message."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Look
from omote.model.recipes.compose_face import choose_look
from omote.model.recipes.recipe import AnyRecipe, FaceRecipe, GainRow, Recipe, Vector
from omote.model.sculpting.caricature import MOST_AMOUNT
from omote.model.space.complexion import MOST
from omote.model.space.gain import Gain, check_gain_region, validate_gains
from omote.model.space.head_regions import REGIONS
from omote.show.validation import Quantity, Refusal, validate_number

DTHETA = Quantity("dtheta of a control point (radians)", -math.pi, math.pi)
DH = Quantity("dh of a control point (metres)", -0.5, 0.5)
RATIO = Quantity("R of a control point", 0.2, 5.0)
TARGET = Quantity("where a point is put (metres)", -1.0, 1.0)
WEIGHT = Quantity("a weight", -2.0, 2.0)
CONTRACTION = Quantity("a muscle's contraction", -1.0, 2.0)
EYE = Quantity("an angle of an eyeball (radians)", -math.pi / 2, math.pi / 2)
PUPIL = Quantity("a pupil", -2.0, 2.0)
BLOOD = Quantity("a number of the complexion", -MOST, MOST)
AMOUNT = Quantity("the amount of caricature", 0.0, MOST_AMOUNT)
MOVE = Quantity("a handle's move (metres)", -0.5, 0.5)
PLACE = Quantity("a place in the list", -1e9, 1e9)

FEWEST_POINTS = 3
MOST_POINTS = 400
MOST_LAYERS = 200
MOST_PULLS = 40
MOST_FACES = 40
MOST_GAINS = 400
LONGEST_LABEL = 200
_UNITY = 1e-3
"""How far the weights of a mix of faces may sum from one."""


@dataclass(frozen=True)
class Bounds:
    """What recipes may refer to: on_sheet (V,) bool, which vertices of the skin lie on the sheet; the muscles; the
    hair styles."""

    on_sheet: NDArray[np.bool_]
    muscles: frozenset[str]
    hair: frozenset[str] = frozenset()


def check_recipe(recipe: AnyRecipe, bounds: Bounds) -> None:
    """Validates a recipe; Refusal where a number is out of range, or something that it names does not exist.

    recipe: of an editor; bounds: what it may name.
    """
    if isinstance(recipe, FaceRecipe):
        _check_face(recipe, bounds)
    elif isinstance(recipe, Recipe):
        _check_expression(recipe, bounds)


def check_targets(targets: Iterable[Vector]) -> None:
    """Validates the targets of dragged points; Refusal where one is out of reach."""
    for target in targets:
        for coordinate in target:
            validate_number(coordinate, TARGET)


def check_vectors(vectors: Sequence[Vector], net: Sequence[int]) -> None:
    """Rejects, by Refusal, other than one vector for each control point, and one that is out of range.

    vectors: dtheta, dh and R; net: rows of the skin.
    """
    if len(vectors) != len(net):
        raise Refusal(f"there are {len(vectors)} vectors for {len(net)} control points: send one for each.")
    for dtheta, dh, ratio in vectors:
        validate_number(dtheta, DTHETA)
        validate_number(dh, DH)
        validate_number(ratio, RATIO)


def check_net(net: Sequence[int], bounds: Bounds) -> None:
    """Rejects, by Refusal, control points that are too few or many, stand on one vertex, or off the sheet.

    net: rows of the skin; bounds: what it may name.
    """
    if not FEWEST_POINTS <= len(net) <= MOST_POINTS:
        raise Refusal(f"there are {len(net)} control points: a net has {FEWEST_POINTS} to {MOST_POINTS}.")
    _check_rows(net, len(bounds.on_sheet), "control point")
    for row in net:
        if not bounds.on_sheet[row]:
            raise Refusal(f"a control point stands on vertex {row}, off the sheet: choose one on the outer skin.")


def _check_expression(recipe: Recipe, bounds: Bounds) -> None:
    check_net(recipe.net, bounds)
    check_vectors(recipe.vectors, recipe.net)
    _check_count(len(recipe.layers), MOST_LAYERS, "layers")
    for layer in recipe.layers:
        validate_number(layer.weight, WEIGHT)
        if len(layer.label) > LONGEST_LABEL or not layer.label.isprintable():
            raise Refusal(
                f"a layer is labelled {layer.label[:80]!r}: give at most {LONGEST_LABEL} printable characters."
            )
        if layer.region is not None:
            _check_region(layer.region)
    _check_count(len(recipe.pulls), MOST_PULLS, "muscles")
    pulled = [pull.muscle for pull in recipe.pulls]
    for pull in recipe.pulls:
        validate_number(pull.contraction, CONTRACTION)
        if pull.muscle not in bounds.muscles:
            raise Refusal(f"there is no muscle {pull.muscle[:80]!r}: choose from {', '.join(sorted(bounds.muscles))}.")
        if pulled.count(pull.muscle) > 1:
            raise Refusal(f"muscle {pull.muscle!r} is there twice: give each once.")
    _check_added(recipe)


def _check_added(recipe: Recipe) -> None:
    """What a recipe adds to eyes, blood, tears and sweat."""
    for angle in recipe.eyes:
        validate_number(angle, EYE)
    validate_number(recipe.pupil, PUPIL)
    for value in recipe.complexion:
        validate_number(value, BLOOD)


def _check_face(recipe: FaceRecipe, bounds: Bounds) -> None:
    _check_count(len(recipe.base), MOST_FACES, "faces")
    whole = math.fsum(validate_number(weight, WEIGHT) for weight in recipe.base.values())
    if abs(whole - 1.0) > _UNITY:
        raise Refusal(f"the weights of the faces sum to {whole:.4g}: a mix of faces sums to 1.")
    for region in recipe.regions:
        _check_region(region)
    _check_gains(recipe.gains)
    _check_look(recipe.look, bounds)
    validate_number(recipe.amount, AMOUNT)
    if len(recipe.moves) != len(recipe.points):
        raise Refusal(f"there are {len(recipe.moves)} moves for {len(recipe.points)} handles: send one for each.")
    _check_count(len(recipe.points), MOST_POINTS, "handles")
    _check_rows(recipe.points, len(bounds.on_sheet), "handle")
    for move in recipe.moves:
        for coordinate in move:
            validate_number(coordinate, MOVE)


def _check_gains(rows: Sequence[GainRow]) -> None:
    _check_count(len(rows), MOST_GAINS, "gains")
    try:
        gains = [Gain(check_gain_region(row.region[:80]), row.value, row.expression) for row in rows]
        validate_gains(gains, "this face")
    except ValueError as error:
        raise Refusal(f"{error}.") from error


def _check_look(chosen: Mapping[str, str | float], bounds: Bounds) -> None:
    try:
        style = choose_look(Look(), chosen).hair_style
    except ValueError as error:
        raise Refusal(f"{error}.") from error
    if style not in ("", *bounds.hair):
        raise Refusal(f"there is no hair style {style[:80]!r}: choose from {', '.join(sorted(bounds.hair))}, or none.")


def _check_rows(rows: Sequence[int], count: int, what: str) -> None:
    for row in rows:
        if not 0 <= row < count:
            raise Refusal(f"a {what} stands on vertex {row}: the skin has vertices 0 to {count - 1}.")
    if len(set(rows)) != len(rows):
        twice = next(row for row in rows if list(rows).count(row) > 1)
        raise Refusal(f"two {what}s stand on vertex {twice}: keep one of them.")


def _check_region(region: str) -> None:
    if region not in REGIONS:
        raise Refusal(f"there is no region {region[:80]!r}: choose from {', '.join(REGIONS)}.")


def _check_count(count: int, most: int, what: str) -> None:
    if count > most:
        raise Refusal(f"there are {count} {what}: at most {most} can be kept.")
