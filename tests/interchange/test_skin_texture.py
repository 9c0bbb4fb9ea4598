"""The skin's colour: the traits' layers in their own colours, and nothing where none is painted."""

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.png import read_png
from omote.interchange.skin_texture import (
    Canvas,
    build_canvas,
    decode_srgb,
    enlarge,
    hairline,
    paint_skin,
    zones_of,
)  # fmt: skip
from omote.model.albedo import Albedo, encode_light
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
        code = encode_light(decode_srgb(colour))
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


def test_a_picture_stands_in_place_of_what_is_painted_where_it_covers(built_in: Canvas) -> None:
    side = len(built_in.hair)
    texels = np.random.default_rng(4).integers(0, 256, (side, side, 4), np.uint8)
    texels[: side // 2, :, 3], texels[side // 2 :, :, 3] = 255, 0
    look = replace(BARE, albedo=Albedo(texels))
    seen = paint_skin(built_in, look)
    painted = paint_skin(built_in, BARE)
    np.testing.assert_array_equal(seen[side // 2 :], painted[side // 2 :])
    open_ = built_in.layers["mask"][..., 3] == 1.0  # nothing takes light away, so there is no lining either
    open_[side // 2 :] = False
    assert open_.sum() > 0.2 * side * side
    assert np.abs(seen[open_].astype(int) - texels[open_][:, :3]).max() <= 1


def test_make_up_lies_on_a_picture_too(built_in: Canvas) -> None:
    side = len(built_in.hair)
    look = replace(BARE, albedo=Albedo(np.full((side, side, 4), 255, np.uint8)))
    made_up = paint_skin(built_in, replace(look, makeup=1.0)).astype(int) - paint_skin(built_in, look)
    drawn = built_in.layers["patches"][..., 2] > 0.5
    assert (made_up[drawn] < -60).any(axis=1).mean() > 0.9
    assert not made_up[built_in.layers["patches"][..., 2] == 0.0].any()


def test_a_larger_picture_keeps_its_texels(built_in: Canvas) -> None:
    side = len(built_in.hair)
    texels = np.random.default_rng(5).integers(0, 256, (2 * side, 2 * side, 4), np.uint8)
    texels[..., 3] = 255
    seen = paint_skin(built_in, replace(BARE, albedo=Albedo(texels)))
    open_ = enlarge(built_in, 2).layers["mask"][..., 3] == 1.0
    assert seen.shape == (2 * side, 2 * side, 3)
    assert np.abs(seen[open_].astype(int) - texels[open_][:, :3]).max() <= 1


def test_zones_lie_where_their_colours_are_painted(built_in: Canvas) -> None:
    """Another colour of a look changes its zone."""
    zones = zones_of(built_in)
    look = replace(BARE, brows=1.0, scalp=1.0)
    painted = paint_skin(built_in, look).astype(int)
    for name in ("lip", "brow", "skin"):
        changed = paint_skin(built_in, Look(**{**vars(look), name: "#0000ff"})).astype(int) - painted
        zone = zones[name] > 0.6
        assert zone.sum() > 1000
        assert (np.abs(changed).max(axis=2)[zone] > 20).mean() > 0.9
