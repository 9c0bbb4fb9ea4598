"""Pictures of eyeballs, teeth, tongue and hairs, and the places that they are painted for."""

import numpy as np
import pytest

from omote.interchange import part_textures
from omote.interchange.skin_texture import decode_srgb
from omote.model.cast import Look


def test_an_eyeball_is_painted_around_its_line_of_sight() -> None:
    ahead = np.array([[0.0, 0.0, 2.0]])
    aside = np.array([[3.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    np.testing.assert_allclose(part_textures.eye_uv(ahead), [[0.5, 0.5]])
    np.testing.assert_allclose(
        part_textures.eye_uv(aside), [[0.5 + np.sqrt(0.125), 0.5], [0.5, 0.5 - np.sqrt(0.125)]], rtol=1e-6
    )


def test_equal_areas_of_the_ball_are_equal_on_its_picture() -> None:
    angle = np.linspace(0.0, np.pi, 50)[:-1]
    rings = np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], axis=1)
    reach = part_textures.eye_uv(rings)[:, 0] - 0.5
    np.testing.assert_allclose(reach**2 * 4, (1.0 - np.cos(angle)) / 2.0, atol=1e-6)


def test_the_pupil_is_dark_the_iris_has_its_colour_and_the_white_is_light() -> None:
    size = 256
    look = Look(iris="#2060ff")
    eye = part_textures.paint_eye(look, size).astype(int)
    middle = size // 2
    edge = round(size / 2 * np.sin(np.arcsin(part_textures.LIMBUS) / 2))
    assert eye[middle, middle].max() < 20
    iris = eye[middle, middle + round(0.7 * edge)]
    assert iris[2] > 1.5 * iris[0]
    assert eye[middle, middle + 3 * edge].min() > 150


def test_a_slit_is_higher_than_it_is_wide() -> None:
    eye = part_textures.paint_eye(Look(iris="#a0a040", slit=1.0), 256).max(axis=2)
    dark = eye < 20
    assert dark.any(axis=1).sum() > 2 * dark[100:156, 100:156].any(axis=0).sum() > 0


@pytest.mark.parametrize("upper", [True, False])
def test_teeth_reach_from_the_gum_to_the_edge(upper: bool) -> None:
    angle = np.linspace(-1.0, 1.0, 21)
    arch = np.stack([0.03 * np.sin(angle), np.zeros_like(angle), 0.03 * np.cos(angle)], axis=1)
    up = np.array([0.0, 0.01, 0.0])
    low = arch - up
    high = arch + up
    uv = part_textures.arch_uv(np.concatenate([low, high]), upper=upper)
    np.testing.assert_allclose(uv[:21, 1], 1.0 if upper else 0.0)
    np.testing.assert_allclose(uv[21:, 1], 0.0 if upper else 1.0)
    assert (np.diff(uv[:21, 0]) > 0.0).all()


def test_gums_are_red_and_teeth_are_not() -> None:
    teeth = part_textures.paint_teeth(Look(), upper=True, size=128).astype(int)
    gum = teeth[2, 64]
    enamel = teeth[40, 70]
    assert gum[0] - gum[1] > 50 > enamel[0] - enamel[1]
    assert (teeth[0, :, 3] == 255).all()


def test_a_tongue_has_a_furrow() -> None:
    tongue = part_textures.paint_tongue(64).astype(int)
    assert tongue[10, 31].sum() < tongue[10, 10].sum()
    points = np.array([[-0.01, 0, 0.05], [0.0, 0, 0.05], [0.01, 0, 0.0]])
    np.testing.assert_allclose(part_textures.tongue_uv(points), [[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]], atol=1e-6)


def test_lashes_grow_away_from_the_eyeball() -> None:
    points = np.array([[0.0, 0.015, 0.001], [0.0, 0.018, 0.001], [0.0, -0.015, 0.001], [0.0, -0.018, 0.001]])
    across, along = part_textures.lash_uv(points, np.zeros(3)).T
    np.testing.assert_allclose(across, 0.5)
    assert along[0] == along[2] == 0.0
    assert along[3] > along[1] > 0.9


def test_hairs_are_denser_at_their_roots_and_wear_their_colour() -> None:
    picture = part_textures.paint_strands(decode_srgb("#ff0000"), 20, columns=400, rows=50, cover=0.5)
    cover = picture[..., 3].mean(axis=1) / 255.0
    np.testing.assert_allclose(cover[0], 0.5, atol=0.1)
    assert cover[-1] < 0.1 < cover[20] < cover[0]
    assert (picture[..., 1:3] == 0).all()
    assert picture[..., 0].max() > 200


def test_an_eye_is_the_same_whatever_was_painted_before_it() -> None:
    """What all eyes share is kept, and no eye changes it."""
    one = Look(iris="#2060ff", slit=0.5)
    other = Look(iris="#a0a040")
    first = part_textures.paint_eye(one, 64)
    assert (part_textures.paint_eye(other, 64) != first).any()
    assert (part_textures.paint_eye(one, 32).shape, part_textures.paint_eye(one, 64).tobytes()) == (
        (32, 32, 3), first.tobytes(),
    )  # fmt: skip
