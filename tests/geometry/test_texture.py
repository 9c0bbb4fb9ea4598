"""Values of vertices on a texture: linear where triangles lie, with a margin around them."""

import numpy as np

from omote.geometry.texture import MARGIN, paint

SQUARE = np.array([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]])
HALVES = np.array([[0, 1, 2], [0, 2, 3]])


def test_what_is_linear_on_the_texture_is_painted_as_it_is() -> None:
    size = 64
    picture = paint(3.0 * SQUARE[:, 0] - SQUARE[:, 1] + 0.5, SQUARE, HALVES, size)
    across, down = np.meshgrid((np.arange(size) + 0.5) / size, (np.arange(size) + 0.5) / size)
    inside = slice(size // 4, 3 * size // 4)
    np.testing.assert_allclose(picture[inside, inside], (3.0 * across - down + 0.5)[inside, inside], atol=1e-9)


def test_a_margin_lies_around_the_islands_and_nothing_beyond() -> None:
    picture = paint(np.full(4, 7.0), SQUARE, HALVES, 64)
    middle = picture[32]
    first = 16 - MARGIN
    assert (middle[first : 64 - first] == 7.0).all()
    assert (middle[:first] == 0.0).all()
    assert (middle[64 - first :] == 0.0).all()


def test_which_way_a_triangle_winds_makes_no_difference() -> None:
    values = np.array([0.0, 1.0, 2.0, 3.0])
    np.testing.assert_allclose(
        paint(values, SQUARE, HALVES[:, ::-1], 32), paint(values, SQUARE, HALVES, 32), atol=1e-12
    )


def test_a_triangle_without_area_paints_nothing() -> None:
    assert not paint(np.ones(4), SQUARE[[0, 0, 0, 0]], HALVES, 16).any()


def test_a_picture_turned_over_is_the_picture_of_what_is_turned_over() -> None:
    values = np.array([0.0, 1.0, 5.0, 3.0])
    picture = paint(values, SQUARE, HALVES, 64)
    np.testing.assert_allclose(paint(values, SQUARE[:, ::-1], HALVES, 64), picture.T, atol=1e-12)
    np.testing.assert_allclose(paint(values, 1.0 - SQUARE, HALVES, 64), picture[::-1, ::-1], atol=1e-12)
