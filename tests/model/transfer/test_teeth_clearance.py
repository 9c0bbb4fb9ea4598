"""Teeth and gums stay behind the skin of a compound; at rest, and on the generic face, they stay where they are."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import apply_expression, compile_answer, compound_parts, predict_part
from omote.model.transfer.gum_line import GUMS
from omote.model.transfer.teeth_clearance import keep_teeth_inside
from tests.synthetic import space

CAST = omote.load_cast()


def wide(name: str, scale: float) -> Face:
    """A face of the cast with teeth that are larger by a scale, behind its skin at rest."""
    face = CAST.faces[name]
    larger = {}
    for part in GUMS:
        middle = face.parts[part].mean(axis=0)
        larger[part] = (middle + scale * (face.parts[part] - middle)).astype(np.float32)
    return Face(name, face.positions, {**face.parts, **larger})


def outside(skin: NDArray[np.floating], teeth: NDArray[np.floating]) -> float:
    """The greatest distance to the skin of teeth that lie outside of it, other than through the open lips: metres."""
    points = skin.astype(np.float64)
    tested = teeth.astype(np.float64)
    count = len(CAST.space.sheet_triangles)
    corners = points[CAST.space.location_triangles]
    out = tested[winding_numbers(corners, tested) < 0.5]
    away, through = (nearest_triangles(part, out)[0] for part in (corners[:count], corners[count:]))
    return float(away[away < through].max(initial=0.0))


def loose(face: Face, unit: str) -> tuple[NDArray[np.float32], dict[str, NDArray[np.float64]]]:
    """The skin and the teeth of a face wearing a unit, the teeth as their binding alone moves them."""
    compiled = compile_answer(CAST.space, face, CAST.expressions[unit])
    fitted = fit(CAST.space, face)
    skin = apply_expression(CAST.space, face, compiled)
    moves = skin.astype(np.float64) - fitted.positions
    return skin, {
        name: fitted.parts[name]
        + predict_part(CAST.space, name, moves)
        + fitted.sizes[name] * compiled.parts.get(name, 0.0)
        for name in GUMS
    }


@pytest.mark.parametrize(("name", "scale"), [("gaunt", 1.3), ("auntie", 1.2), ("man", 1.2)])
@pytest.mark.parametrize("unit", ["jawOpen", "laugh", "mouth-upward-retraction"])
def test_teeth_that_would_come_out_stay_inside(name: str, scale: float, unit: str) -> None:
    face = wide(name, scale)
    skin, before = loose(face, unit)
    after = compound_parts(CAST.space, face, CAST.expressions[unit])
    assert outside(skin, np.concatenate([after[part] for part in GUMS])) < 1e-4
    if unit == "jawOpen":
        assert outside(skin, np.concatenate([before[part] for part in GUMS])) > 3e-4


def test_teeth_stay_inside_where_rays_only_graze_the_skin() -> None:
    face = wide("old", 1.1)
    unit = CAST.expressions["mouth-upward-retraction"]
    skin = apply_expression(CAST.space, face, compile_answer(CAST.space, face, unit))
    parts = compound_parts(CAST.space, face, unit)
    assert outside(skin, np.concatenate([parts[part] for part in GUMS])) < 1e-4


@pytest.mark.parametrize("name", CAST.faces)
def test_at_rest_no_tooth_moves(name: str) -> None:
    fitted = fit(CAST.space, CAST.faces[name])
    nudged = fitted.positions + np.float32(2e-5) * (np.arange(3) == 2)  # beyond what counts as still
    kept = keep_teeth_inside(CAST.space, fitted, nudged, fitted.parts)
    assert all(np.abs(kept[part] - fitted.parts[part]).max() < 1e-4 for part in kept)
    again = keep_teeth_inside(CAST.space, fitted, fitted.positions, fitted.parts)
    assert all(again[part] is fitted.parts[part] for part in again)


def test_teeth_of_the_generic_face_are_the_source_and_stay() -> None:
    generic = CAST.faces["generic"]
    fitted = fit(CAST.space, generic)
    far = {part: points + np.array([0.0, 0.0, 0.02], np.float32) for part, points in fitted.parts.items()}
    kept = keep_teeth_inside(CAST.space, fitted, fitted.positions + np.float32(0.001), far)
    assert all(kept[part] is far[part] for part in far)


def test_all_else_stays_and_what_was_kept_inside_stays_too() -> None:
    face = wide("gaunt", 1.3)
    skin, teeth = loose(face, "jawOpen")
    fitted = fit(CAST.space, face)
    parts = {**fitted.parts, **{name: points.astype(np.float32) for name, points in teeth.items()}}
    once = keep_teeth_inside(CAST.space, fitted, skin, parts)
    assert all(once[part] is parts[part] for part in parts if part not in GUMS)
    twice = keep_teeth_inside(CAST.space, fitted, skin, once)
    assert max(np.abs(twice[part] - once[part]).max() for part in GUMS) < 5e-5
    assert max(np.abs(once[part] - parts[part]).max() for part in GUMS) > 3e-4


def test_teeth_follow_the_weight_without_a_jump() -> None:
    face = wide("gaunt", 1.3)
    jaw = CAST.expressions["jawOpen"]
    worn = [compound_parts(CAST.space, face, jaw, weight)["teeth_lower"] for weight in (0.799, 0.8, 0.801)]
    assert np.abs(worn[1] - worn[0]).max() < 5e-4
    assert np.abs(worn[2] - worn[1]).max() < 5e-4


def test_a_head_without_teeth_comes_back_as_it_is() -> None:
    built = space()
    face = Face("egg", (built.points * 1.1).astype(np.float32))
    fitted = fit(built, face)
    kept = keep_teeth_inside(built, fitted, fitted.positions + np.float32(0.01), fitted.parts)
    assert all(kept[part] is fitted.parts[part] for part in fitted.parts)


@pytest.mark.parametrize("unit", ["joy", "neutral"])
def test_teeth_that_are_out_at_rest_are_inside_in_every_expression_and_at_rest(unit: str) -> None:
    out = wide("gaunt", 1.8)
    assert outside(out.positions, np.concatenate([out.parts[part] for part in GUMS])) > 1e-3
    compiled = compile_answer(CAST.space, out, CAST.expressions["joy"])
    fitted = fit(CAST.space, out)
    skin = apply_expression(CAST.space, out, compiled) if unit == "joy" else fitted.positions
    parts = {part: np.asarray(fitted.parts[part], np.float32) for part in GUMS}
    after = keep_teeth_inside(CAST.space, fitted, skin, parts)
    assert outside(skin, np.concatenate([after[part] for part in GUMS])) < 3e-4
