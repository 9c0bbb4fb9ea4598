"""Folds of avatars: nothing shows at rest, with blinks and on lacquer; what is pressed shows, on its own side."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.avatar.fold_overlays import OVER, PARTS, Overlays, build_overlays
from omote.interchange.export_face import SKIN, ExportContext, Meshes, build_scene, named_compound_meshes

CONTEXT = ExportContext(load_cast(), load_meshes(), load_mask())
WORN = ("angry", "mouthSmileLeft", "browDownRight", "eyeBlinkLeft", "eyeLookDownLeft", "neutral")


@cache
def overlays(face: str) -> Overlays:
    cast = CONTEXT.cast
    poses: dict[str, Meshes] = {name: named_compound_meshes(cast, face, name) for name in WORN}
    skin = build_scene(CONTEXT, face, poses.items(), hair=False).shapes[0]
    rest = cast.faces[face].positions.astype(np.float64)
    return build_overlays(CONTEXT, cast.looks[face], skin, rest, {name: worn[SKIN] for name, worn in poses.items()})


@pytest.mark.parametrize("face", ["old", "kaori"])
def test_what_is_pressed_shows_and_rest_blinks_and_looks_do_not(face: str) -> None:
    shown = overlays(face).shown
    assert shown({}) == shown({"neutral": 1.0}) == shown({"eyeBlinkLeft": 1.0, "eyeLookDownLeft": 1.0}) == {}
    angry = shown({"angry": 1.0})
    assert max(angry, key=angry.__getitem__) == "folds_frown"
    assert angry["folds_frown"] > 0.5
    half = shown({"angry": 0.5})
    assert 0.0 < half["folds_frown"] < angry["folds_frown"] <= 1.0
    assert all(0.0 < part <= 1.0 for part in angry.values())


def test_one_side_folds_alone() -> None:
    shown = overlays("old").shown
    assert shown({"mouthSmileLeft": 1.0})["folds_mouth_left"] > 0.2
    assert not {name for name in shown({"mouthSmileLeft": 1.0}) if name.endswith("right")}
    assert not {name for name in shown({"browDownRight": 1.0}) if name.endswith("left")}


def test_surfaces_lie_over_the_skin_and_move_with_it() -> None:
    found = overlays("old")
    skin = named_compound_meshes(CONTEXT.cast, "old", "neutral")[SKIN]
    smiling = named_compound_meshes(CONTEXT.cast, "old", "mouthSmileLeft")[SKIN]
    assert [shape.name for shape in found.shapes] == [f"folds_{part}" for part in PARTS]
    for shape in found.shapes:
        over = np.linalg.norm(shape.points[:, None] - skin[None], axis=2)
        assert over.min(axis=1) == pytest.approx(OVER, rel=0.02)
        rows = over.argmin(axis=1)
        moves = shape.targets["mouthSmileLeft"].moves if "mouthSmileLeft" in shape.targets else 0.0
        np.testing.assert_allclose((smiling - skin)[rows], moves + np.zeros_like(shape.points), atol=1e-6)
        assert (shape.material.shown, shape.material.cut) == (0.0, 0.0)
        assert shape.material.picture is found.shapes[0].material.picture


def test_lacquer_has_none() -> None:
    assert overlays("noh").shapes == ()
    assert overlays("noh").shown({"angry": 1.0}) == {}
