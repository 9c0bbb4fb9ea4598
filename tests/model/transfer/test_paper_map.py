"""Extract, compile, compound: the paper's map there and back, its invariances, and what it refuses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound, compound_parts, turn_eyes
from omote.model.transfer.paper_map import compile_expression, project_to_surface
from tests.synthetic import cast, head, space

MICROMETRE = 1e-6


def landed(used: ParameterSpace, face: Face, displacement: np.ndarray, expression: Expression) -> np.ndarray:
    """The sheet's vertices whose walks, out and back, ended inside a triangle (or that rest)."""
    before = face.positions.astype(float)
    moved = np.flatnonzero(used.on_sheet & (np.abs(displacement) > 1e-9).any(axis=1)).astype(np.int32)
    inside = used.on_sheet.copy()
    inside[moved] = project_to_surface(used, before, before[moved] + displacement[moved], moved).inside
    return inside & compile_expression(used, expression).inside


@pytest.mark.parametrize("radius", ["origin", "surface"])
@pytest.mark.parametrize("face", ["generic", "broad", "long"])
@pytest.mark.parametrize("name", ["jawOpen", "browInnerUp", "smile"])
def test_extract_then_apply_gives_the_displacement_back(face: str, name: str, radius: str) -> None:
    used = ParameterSpace.build(*head(), radius=radius, transfer="paper")  # type: ignore[arg-type]
    wearer = Face(face, cast().faces[face].positions)
    source = compound(space(), cast().faces["generic"], cast().expressions[name]).astype(float) - space().points
    displacement = source + 1e-4 * np.sin(np.arange(source.size)).reshape(source.shape)
    expression = extract(used, wearer, displacement)
    error = np.linalg.norm(compound(used, wearer, expression) - wearer.positions - displacement, axis=1)
    inside = landed(used, wearer, displacement, expression)
    assert inside.sum() >= 0.9 * used.on_sheet.sum()
    assert error[inside].max() < MICROMETRE
    assert error[used.inner.vertices].max() < 1e-4


def test_parts_come_back_and_an_eyeballs_turn_is_read_as_a_turn() -> None:
    wearer = cast().faces["broad"]
    fitted = fit(space(), wearer)
    worn = compound_parts(space(), wearer, cast().expressions["eyeLookOutLeft"])
    eyes = cast().expressions["eyeLookOutLeft"].eyes
    turned = turn_eyes(space(), worn, fitted.centres, eyes)
    displacement = {name: turned[name] - fitted.parts[name] for name in turned}
    skin = compound(space(), wearer, cast().expressions["eyeLookOutLeft"]) - wearer.positions
    again = extract(space(), wearer, skin, parts=displacement)
    assert np.allclose(again.eyes, eyes, atol=1e-4)
    back = turn_eyes(space(), compound_parts(space(), wearer, again), fitted.centres, again.eyes)
    for name, points in turned.items():
        assert np.abs(back[name] - points).max() < 1e-6, name


def test_no_displacement_is_the_field_at_rest_and_moves_no_face() -> None:
    rest = extract(space(), cast().faces["generic"], np.zeros((space().vertex_count, 3)))
    assert not rest.dtheta.any()
    assert not rest.dh.any()
    assert (rest.ratio == 1).all()
    for face in cast().faces.values():
        assert np.abs(compound(space(), face, rest) - face.positions).max() < 1e-7


@given(st.floats(-1.0, 1.0))
def test_weight_scales_the_field(weight: float) -> None:
    expression = cast().expressions["jawOpen"]
    scaled = Expression(
        weight * expression.dtheta,
        weight * expression.dh,
        1 + weight * (expression.ratio - 1),
        weight * expression.residual,
    )
    face = cast().faces["long"]
    assert np.array_equal(compound(space(), face, expression, weight=weight), compound(space(), face, scaled))


def test_a_face_twice_as_large_wears_a_compound_twice_as_large() -> None:
    used = ParameterSpace.build(*head(), axis=(0.0, 0.0), transfer="paper")
    generic = Face("generic", used.points)
    expression = extract(
        used, generic, compound(space(), cast().faces["generic"], cast().expressions["smile"]) - used.points
    )
    small = compound(used, generic, expression)
    large = compound(used, Face("large", 2 * used.points), expression)
    assert np.allclose(large, 2 * small, atol=1e-6)


def test_a_head_turned_about_the_axis_wears_its_compound_turned() -> None:
    """The map knows no front: turning face and displacement about the axis turns what is extracted and applied."""
    points, triangles = head()
    used = ParameterSpace.build(points, triangles, axis=(0.0, 0.0), transfer="paper")
    turn = np.array([[np.cos(0.3), 0, np.sin(0.3)], [0, 1, 0], [-np.sin(0.3), 0, np.cos(0.3)]])
    face = Face("generic", points)
    displacement = compound(space(), cast().faces["generic"], cast().expressions["smile"]) - points
    expression = extract(used, face, displacement)
    turned = extract(used, Face("turned", points @ turn.T), displacement @ turn.T)
    assert np.allclose(turned.dtheta, expression.dtheta, atol=1e-6)
    assert np.allclose(turned.dh, expression.dh, atol=1e-7)
    assert np.allclose(turned.ratio, expression.ratio, atol=1e-6)


def test_the_inner_skin_follows_the_sheet_where_an_expression_says_nothing_of_it() -> None:
    expression = cast().expressions["smile"]
    bare = Expression(expression.dtheta, expression.dh, expression.ratio, np.zeros_like(expression.residual))
    moved = compound(space(), cast().faces["generic"], bare) - space().points
    inner = space().inner
    expected = (inner.weights[..., None] * moved[inner.anchors]).sum(axis=1)
    assert np.allclose(moved[inner.vertices], expected, atol=1e-6)


def test_fields_of_another_rule_or_another_space_are_refused() -> None:
    other = ParameterSpace.build(*head(), radius="surface")
    with pytest.raises(ValueError, match=r"radius='origin' and the space has radius='surface'.*extract it again"):
        compound(other, cast().faces["generic"], cast().expressions["smile"])
    small = Expression(np.zeros(3), np.zeros(3), np.ones(3), np.zeros((0, 3)))
    with pytest.raises(ValueError, match=r"has 3 vertices.*made on another space"):
        compound(space(), cast().faces["generic"], small)


@pytest.mark.parametrize(
    ("weight", "sentence"),
    [
        (float("nan"), "weight is nan"),
        (1e4, "keeps it positive"),
        (-1e300, r"weight is -1e\+300; expected a number from -1e\+06 to 1e\+06"),
        (10**400, "weight is far too large"),
        (True, "weight must be a number, not True"),
        (None, "weight must be a number, not None"),
        (1j, "weight must be a number, not 1j"),
        (np.zeros(2), "weight must be a number, not array"),
    ],
)
def test_weights_are_refused(weight: Any, sentence: str) -> None:
    with pytest.raises((ValueError, TypeError), match=sentence):
        compound(space(), cast().faces["generic"], cast().expressions["jawOpen"], weight=weight)


def test_a_part_that_the_space_does_not_have_is_refused() -> None:
    smile = cast().expressions["smile"]
    beaked = Expression(smile.dtheta, smile.dh, smile.ratio, smile.residual, {"beak": np.zeros((4, 3))})
    with pytest.raises(ValueError, match="moves a part 'beak'"):
        compound(space(), cast().faces["generic"], beaked)


def test_what_is_no_space_face_or_expression_is_refused() -> None:
    nothing: Any = None
    array: Any = space().points
    face = cast().faces["generic"]
    smile = cast().expressions["smile"]
    for wrong, kind in ((nothing, "NoneType"), (array, "ndarray")):
        with pytest.raises(TypeError, match=f"the face is a {kind}; expected an omote.Face"):
            compound(space(), wrong, smile)
        with pytest.raises(TypeError, match=f"the expression is a {kind}; expected an omote.Expression"):
            compound(space(), face, wrong)
        with pytest.raises(TypeError, match=f"the space is a {kind}; expected an omote.ParameterSpace"):
            compound(wrong, face, smile)
