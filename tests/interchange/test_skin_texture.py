"""The skin's colour: the traits' layers in their own colours, and nothing where none is painted."""

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.png import read_png
from omote.interchange.skin_texture import Canvas, build_canvas, decode_srgb, encode_srgb, hairline, paint_skin
from omote.model.cast import Look
from tests import synthetic
from tests.stage_data.heads import SIZE, layers, meshes

BARE = Look(skin="#808080", pores=0.0, age=0.0, brows=0.0, scalp=0.0, makeup=0.0, stubble=0.0)


@pytest.fixture(scope="module")
def built_in() -> Canvas:
    """The canvas of the built-in cast."""
    return build_canvas(read_png(load_mask()), load_meshes()[0], load_cast().space.points)


def test_colours_come_back_from_linear_light() -> None:
    for colour in ("#000000", "#ffffff", "#0a0b0c", "#c08a70"):
        code = encode_srgb(decode_srgb(colour))
        assert "#" + "".join(f"{value:02x}" for value in code) == colour


def test_where_nothing_is_painted_skin_has_its_own_colour() -> None:
    made = build_canvas(read_png(layers()), meshes()[0], synthetic.space().points)
    assert (paint_skin(made, BARE) == 0x80).all()
    assert made.hair.shape == (SIZE, SIZE)


def test_a_trait_that_is_off_changes_nothing(built_in: Canvas) -> None:
    plain = paint_skin(built_in, BARE)
    for change in ({"brow": "#ff0000"}, {"hair": "#00ff00"}, {"coat": "#0000ff"}, {"gloss": 1.0}):
        np.testing.assert_array_equal(paint_skin(built_in, replace(BARE, **change)), plain)


def test_each_trait_paints_where_its_layer_lies(built_in: Canvas) -> None:
    plain = paint_skin(built_in, BARE).astype(int)
    looks = ((replace(BARE, freckles=1.0), "marks", 1), (replace(BARE, stubble=1.0), "marks", 2))
    for look, layer, channel in (*looks, (replace(BARE, brows=0.5), "mask", 1)):
        painted = paint_skin(built_in, look).astype(int)
        where = built_in.layers[layer][..., channel]
        changed = np.abs(painted - plain).max(axis=2) > 12
        assert changed.any()
        assert where[changed].min() > 0.0


def test_hair_grows_behind_the_hairline_of_a_head() -> None:
    crown, forehead, nape = np.array([[0.0, 0.12, 0.0], [0.0, 0.04, 0.14], [0.0, 0.0, -0.08]])
    np.testing.assert_allclose(hairline(np.array([crown, forehead, nape])), [1.0, 0.0, 1.0])
