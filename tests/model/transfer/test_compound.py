"""Compounds under both rules: the generic face's are the same, the others' carry what the generic face does."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.model.space.expression import Expression
from omote.model.space.face_fit import generic_face
from omote.model.transfer.compound import compound, compound_parts
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.smooth_map import prepare_smooth_map
from tests.synthetic import cast, head, space

pytestmark = pytest.mark.long

UNITS = ("jawOpen", "eyeBlinkLeft", "mouthSmileRight", "mouthFunnel")


def under_paper(expression: Expression) -> Expression:
    """The same field, tagged as taken under the paper's rule: on the generic face both rules take the same one."""
    return Expression(
        expression.dtheta, expression.dh, expression.ratio, expression.residual, expression.parts, expression.eyes,
        expression.radius, "paper",
    )  # fmt: skip


@pytest.mark.parametrize("unit", UNITS)
def test_the_generic_face_wears_the_same_under_both_rules(unit: str) -> None:
    built = omote.load_cast()
    smooth = compound(built.space, built.faces["generic"], built.expressions[unit])
    paper = compound(built.space.under("paper"), built.faces["generic"], under_paper(built.expressions[unit]))
    assert np.abs(smooth - paper).max() < 1e-6


@pytest.mark.parametrize("unit", UNITS)
def test_on_every_face_nothing_folds_and_the_inner_skin_follows(unit: str) -> None:
    built = omote.load_cast()
    source = compound(built.space, generic_face(built.space), built.expressions[unit]).astype(np.float64)
    for face in built.faces.values():
        worn = compound(built.space, face, built.expressions[unit])
        assert np.isfinite(worn).all()
        assert find_folds(prepare_smooth_map(built.space, face).geometry, worn.astype(np.float64), source).sum() == 0, (
            face.name
        )
        moved = np.abs(worn - face.positions).max(axis=1)
        assert moved[built.space.inner.vertices].max() < 2 * np.abs(source - built.space.points).max()


@given(st.floats(0.0, 1.0))
def test_weight_runs_continuously_from_rest(weight: float) -> None:
    face = cast().faces["broad"]
    jaw = cast().expressions["jawOpen"]
    near = compound(space(), face, jaw, weight=weight * (1 - 1e-4)), compound(space(), face, jaw, weight=weight)
    assert np.abs(near[0] - near[1]).max() < 1e-5
    assert np.abs(compound(space(), face, jaw, weight=0.0) - face.positions).max() < 1e-6


def test_parts_follow_the_skin_that_is_worn() -> None:
    face = cast().faces["long"]
    jaw = cast().expressions["jawOpen"]
    parts = compound_parts(space(), face, jaw)
    rest = compound_parts(space(), face, cast().expressions["neutral"])
    assert (parts["teeth_lower"] - rest["teeth_lower"])[:, 1].max() < 0
    assert np.abs(parts["eye_left"] - rest["eye_left"]).max() < 1e-7


def test_fields_of_the_other_rule_are_refused() -> None:
    with pytest.raises(ValueError, match=r"transfer='paper' and the space has transfer='smooth'.*extract it again"):
        compound(space(), cast().faces["generic"], under_paper(cast().expressions["smile"]))
    with pytest.raises(ValueError, match="transfer is 'rough'; expected one of 'smooth', 'paper'"):
        type(space()).build(*head(), transfer="rough")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="transfer is 'rough'"):
        space().under("rough")  # type: ignore[arg-type]
