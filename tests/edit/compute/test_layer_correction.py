"""Layers that fold together and none alone: corrected on the generic head, and so on every face; nothing else is."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import omote
from omote.edit.compute.layer_correction import LayerCorrection
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import build_net_field
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import Layer, Pull, Recipe, Vector
from omote.model.space.expression import Expression
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
NET = default_net(CAST.space)
NET_FIELD = build_net_field(CAST.space, NET)
REST: tuple[Vector, ...] = ((0.0, 0.0, 1.0),) * len(NET)
LAYERS = LayerCorrection(CAST.space)
STACKED = ("eyeBlinkLeft", "eyeSquintLeft", "cheekSquintLeft")


def layered(*names: str, weight: float = 1.0, mirrored: bool = False) -> Recipe:
    return Recipe(NET, REST, layers=tuple(Layer(name, name, weight, mirrored=mirrored) for name in names))


def compose(recipe: Recipe) -> Expression:
    return LAYERS.compose(recipe, CAST.expressions, NET_FIELD)


def count_folds(face: str, expression: Expression) -> int:
    """Triangles of the sheet that a face wearing it turns over against its rest."""
    rest = CAST.faces[face].positions.astype(np.float64)
    triangles = CAST.space.sheet_triangles
    worn = compound(CAST.space, CAST.faces[face], expression).astype(np.float64)
    return int((area_shares(worn, *rest_normals(rest, triangles), triangles) <= 0.0).sum())


def same(one: Expression, other: Expression) -> bool:
    names = ("dtheta", "dh", "ratio", "residual", "eyes", "ears", "head")
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in names)


@pytest.mark.parametrize("face", ["generic", "kaori", "dog"])
@pytest.mark.parametrize("mirrored", [False, True])
def test_layers_that_fold_together_are_corrected(face: str, mirrored: bool) -> None:
    recipe = layered(*STACKED, mirrored=mirrored)
    alone = sum(count_folds(face, compose(layered(name, mirrored=mirrored))) for name in STACKED)
    assert alone == 0
    assert count_folds(face, compose_expression(CAST.space, recipe, CAST.expressions, NET_FIELD)) > 20
    assert count_folds(face, compose(recipe)) == 0


def test_what_folds_nothing_is_the_sum_itself() -> None:
    for recipe in (layered("smile"), layered("jawOpen", "mouthClose"), layered("eyeBlinkLeft", weight=0.5)):
        assert same(compose(recipe), compose_expression(CAST.space, recipe, CAST.expressions, NET_FIELD))
    muted = msgspec.structs.replace(
        layered("eyeBlinkLeft"), layers=(Layer("eyeBlinkLeft", ""), Layer("pain", "", muted=True))
    )
    assert same(compose(muted), compose(layered("eyeBlinkLeft")))


def test_control_points_add_the_same_to_corrected_layers() -> None:
    vectors = np.random.default_rng(7).normal([0, 0, 1], 0.002, (len(NET), 3))
    recipe = layered(*STACKED)
    moved = compose(
        msgspec.structs.replace(recipe, vectors=tuple((float(a), float(b), float(c)) for a, b, c in vectors))
    )
    still = compose(recipe)
    added = np.stack([moved.dtheta - still.dtheta, moved.dh - still.dh, moved.ratio - still.ratio], axis=1)
    wanted = np.where(CAST.space.on_sheet[:, None], NET_FIELD.field(vectors), 0.0)
    assert np.allclose(added, wanted, atol=1e-12)


def test_muscles_count_as_layers() -> None:
    recipe = msgspec.structs.replace(layered("eyeBlinkLeft"), pulls=(Pull("orbicularis_oculi_left", 1.5),))
    plain = compose_expression(CAST.space, recipe, CAST.expressions, NET_FIELD)
    assert count_folds("generic", compose(recipe)) < count_folds("generic", plain)


def test_only_so_many_corrections_stay_known() -> None:
    corrections = LayerCorrection(CAST.space)
    for step in range(70):
        corrections.compose(layered("smile", "sad", weight=step / 100), CAST.expressions, NET_FIELD)
    assert len(corrections._corrections) == 64
