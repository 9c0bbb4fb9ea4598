"""Limb fields on figures: worn by every body and mix, called or driven."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.arrays import Points, Triangles, Values
from omote.perform.figures.figure import RestingFigure, resting_figure
from omote.perform.figures.limb_mix import limb_weights, wear_limb_fields

CAST = omote.load_cast()
FIGURES = CAST.figures
assert FIGURES is not None
FIELDS = FIGURES.limb_fields
HEAD = CAST.faces["generic"].positions.astype(np.float64)
STRAIGHT = np.zeros(4)


def resting(bodies: dict[str, float], head: Points = HEAD) -> RestingFigure:
    assert FIGURES is not None
    return resting_figure(FIGURES, bodies, head)


def moves(figure: RestingFigure, name: str, weight: float = 1.0) -> Points:
    """How far a field moves each row, metres."""
    assert FIGURES is not None
    return np.asarray(wear_limb_fields(FIGURES, figure, {name: weight}).rows - figure.rows)


def normals(rows: Points, triangles: Triangles) -> Values:
    a, b, c = (rows[triangles[:, corner]] for corner in range(3))
    return np.asarray(np.cross(b - a, c - a))


@pytest.mark.parametrize("name", FIELDS)
def test_no_body_of_the_cast_folds_under_a_field(name: str) -> None:
    assert FIGURES is not None
    triangles = np.concatenate([FIGURES.space.triangles, FIGURES.space.skirt])
    for body in FIGURES.bodies:
        figure = resting({body: 1.0}, CAST.faces[body].positions.astype(np.float64))
        before = normals(figure.rows, triangles)
        after = normals(figure.rows + moves(figure, name), triangles)
        assert ((before * after).sum(axis=1) > 0.0).all(), body
        assert np.linalg.norm(after, axis=1).max() > 0.0


@pytest.mark.parametrize("name", FIELDS)
def test_half_a_mix_wears_half_of_what_each_body_wears(name: str) -> None:
    """Linear in weight and body: nothing has to be found anew while bodies change."""
    one, other, mixed = (resting(bodies) for bodies in ({"heavy": 1.0}, {"child": 1.0}, {"heavy": 0.5, "child": 0.5}))
    expected = 0.5 * (moves(one, name) + moves(other, name))
    np.testing.assert_allclose(moves(mixed, name), expected, atol=1e-9)
    np.testing.assert_allclose(moves(mixed, name, 0.3), 0.3 * expected, atol=1e-9)


def test_a_larger_body_is_moved_farther_and_the_head_never() -> None:
    assert FIGURES is not None
    figure = resting({"kaori": 1.0})
    larger = RestingFigure(
        1.5 * figure.rows, 1.5 * figure.joints, figure.stand, figure.ankles, figure.leg, figure.correctives
    )
    for name in FIELDS:
        np.testing.assert_allclose(moves(larger, name), 1.5 * moves(figure, name), atol=1e-9)
        assert not moves(figure, name)[: FIGURES.space.head_rows].any()


def test_a_bent_elbow_tenses_its_own_biceps_and_a_breath_the_chest() -> None:
    bends = np.array([130.0, 10.0, 130.0, 130.0])
    assert limb_weights(FIELDS, {}, bends, 0.0) == {"bicepsLeft": 1.0}
    assert limb_weights(FIELDS, {}, STRAIGHT, 0.4) == {"breath": 0.4}
    halfway = limb_weights(FIELDS, {}, np.array([0.0, 80.0, 0.0, 0.0]), 0.0)
    assert halfway == {"bicepsRight": pytest.approx(0.5)}
    assert limb_weights(FIELDS, {}, STRAIGHT, 0.0) == {}


def test_of_what_is_called_and_what_drives_the_larger_shows() -> None:
    bends = np.array([80.0, 0.0, 0.0, 0.0])
    assert limb_weights(FIELDS, {"bicepsLeft": 0.2}, bends, 0.0) == {"bicepsLeft": pytest.approx(0.5)}
    assert limb_weights(FIELDS, {"bicepsLeft": 0.9}, bends, 0.0) == {"bicepsLeft": 0.9}
    assert limb_weights(FIELDS, {"belly": -0.3, "smile": 1.0}, STRAIGHT, 0.0) == {"belly": -0.3}
