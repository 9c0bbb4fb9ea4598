"""Fitting a face to a space: remembered, placed parts, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_cast
from omote.model.space.face import Face
from omote.model.space.face_fit import ALIKE, fit, generic_face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import apply_expression, predict_part
from omote.model.transfer.paper_map import compile_expression
from tests.synthetic import space


def test_a_face_is_fitted_once() -> None:
    face = Face("a", space().points)
    assert fit(space(), face) is fit(space(), face)


def test_parts_go_where_a_similarity_of_the_face_carries_them() -> None:
    fitted = fit(space(), Face("large", space().points * 1.5))
    for name, part in space().parts.items():
        assert np.allclose(fitted.parts[name], part.points * 1.5, atol=1e-6)
        assert np.isclose(fitted.sizes[name], 1.0 if part.follows_jaw and space().lines else 1.5, atol=1e-5)
        assert np.allclose(fitted.centres[name], part.points.mean(axis=0) * 1.5, atol=1e-6)


@given(st.floats(-0.7, 0.7))
def test_inner_skin_moves_by_itself_as_far_as_on_the_generic_face_but_on_sizes_of_no_person(far: float) -> None:
    """People's amplitudes do not grow with their heads; beyond what people differ by, and under the paper's map, which
    scales the sheet too, they do."""
    bare = ParameterSpace.build(space().points, space().triangles)
    face = Face("sized", bare.points * np.exp(far))
    beyond = np.sign(far) * max(abs(far) - ALIKE, 0.0)
    assert np.allclose(fit(bare, face).scale, np.exp(beyond), atol=1e-5)
    assert np.allclose(fit(bare.under("paper"), face).scale, np.exp(far), atol=1e-5)


def test_what_follows_the_jaw_turns_as_far_as_the_chin_moves_whatever_its_size() -> None:
    """Teeth that turned in their own size went through the lips of heads with large teeth."""
    cast = load_cast()
    source = fit(cast.space, generic_face(cast.space)).positions
    compiled = compile_expression(cast.space, cast.expressions["jawOpen"])
    teeth = cast.space.parts["teeth_lower"]
    for face in (cast.faces["auntie"], cast.faces["child"], cast.faces["doll"]):
        fitted = fit(cast.space, face)
        here, there = (
            predict_part(cast.space, teeth.name, after.astype(np.float64) - before)[0]
            for after, before in (
                (apply_expression(cast.space, face, compiled), fitted.positions),
                (apply_expression(cast.space, generic_face(cast.space), compiled), source),
            )
        )
        assert fitted.sizes[teeth.name] == pytest.approx(here @ there / (there @ there), abs=0.03)


def test_a_face_that_knows_its_parts_keeps_them() -> None:
    own = space().parts["eye_left"].points + 0.001
    assert np.allclose(fit(space(), Face("a", space().points, {"eye_left": own})).parts["eye_left"], own, atol=1e-7)


def test_faces_that_do_not_fit_are_refused() -> None:
    points = space().points
    with pytest.raises(ValueError, match=f"has 5 vertices; expected the {len(points)} of the generic face"):
        fit(space(), Face("a", np.zeros((5, 3))))
    collapsed = points.copy()
    collapsed[space().triangles[9, 0]] = collapsed[space().triangles[9, 1]]
    with pytest.raises(ValueError, match="has no area"):
        fit(space(), Face("a", collapsed))
    with pytest.raises(ValueError, match="outside the head"):
        fit(space(), Face("a", points + np.array([0.0, 0.0, 0.7])))
    with pytest.raises(ValueError, match="part 'beak' of 1 vertices"):
        fit(space(), Face("a", points, {"beak": np.zeros((1, 3))}))
