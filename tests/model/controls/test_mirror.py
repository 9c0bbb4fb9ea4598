"""The mirror: an involution on rows, fields, parts and eyes."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.controls.mirror import mirror_expression, mirror_of, mirror_rows
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from tests import synthetic


def same(one: Expression, other: Expression) -> bool:
    fields = all(
        np.array_equal(getattr(one, name), getattr(other, name))
        for name in ("dtheta", "dh", "ratio", "residual", "eyes", "pupil")
    )
    return fields and all(np.array_equal(one.parts[name], other.parts[name]) for name in one.parts)


@pytest.mark.parametrize("space", [omote.load_cast().space, synthetic.space()], ids=["built-in", "egg"])
def test_the_image_of_the_image_is_the_vertex(space: ParameterSpace) -> None:
    rows = mirror_rows(space)
    assert np.array_equal(rows[rows], np.arange(space.vertex_count))
    assert np.allclose(space.points[rows], space.points * [-1, 1, 1], atol=1e-9)
    assert mirror_of(space).parts["eye_left"][0] == "eye_right"


def test_an_expression_mirrored_twice_is_itself() -> None:
    cast = omote.load_cast()
    for name in ("wink", "smile", "tongueOut", "eyeLookUpLeft"):
        expression = cast.expressions[name]
        assert same(mirror_expression(cast.space, mirror_expression(cast.space, expression)), expression)


def test_the_left_unit_mirrored_is_the_right_one() -> None:
    cast = omote.load_cast()
    for unit in ("eyeBlink", "eyeLookOut", "mouthSmile", "browDown"):
        left = cast.expressions[unit + "Left"]
        right = cast.expressions[unit + "Right"]
        image = mirror_expression(cast.space, left)
        here, there = (np.stack([0.1 * one.dtheta, one.dh]) for one in (image, right))
        assert np.linalg.norm(here - there) < 0.05 * np.linalg.norm(there)
        assert np.allclose(image.eyes, right.eyes, atol=0.02)


def test_a_crooked_head_is_refused() -> None:
    points, triangles = synthetic.head()
    points = points + np.where(points[:, :1] > 0.02, [[0.0, 0.002, 0.0]], 0.0)
    with pytest.raises(ValueError, match="not symmetric about x = 0"):
        mirror_rows(ParameterSpace.build(points, triangles))
