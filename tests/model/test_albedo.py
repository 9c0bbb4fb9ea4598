"""Pictures of skin: what they are, and their mixes in linear light."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.model.albedo import Albedo, decode_light, encode_light, mix_albedos, regional_albedo
from omote.model.cast import Look
from omote.model.space.head_regions import region_weights

SIDE = 1024


def plain(*texel: int, side: int = SIDE) -> Albedo:
    return Albedo(np.broadcast_to(np.array(texel, np.uint8), (side, side, 4)))


def light(albedo: Albedo) -> NDArray[np.float32]:
    """Linear light times coverage, and coverage, (k, k, 4)."""
    cover = albedo.pixels[..., 3:] / np.float32(255.0)
    return np.concatenate([decode_light(albedo.pixels[..., :3]) * cover, cover], axis=2)


def noise(seed: int) -> Albedo:
    return Albedo(np.random.default_rng(seed).integers(0, 256, (SIDE, SIDE, 4), np.uint8))


@pytest.mark.parametrize(
    "pixels",
    [np.zeros((1024, 1024, 3), np.uint8), np.zeros((512, 512, 4), np.uint8), np.zeros((1024, 1024, 4), np.float32)],
)
def test_other_pictures_are_refused(pixels: NDArray[np.uint8]) -> None:
    with pytest.raises(ValueError, match=r"a picture of skin has shape .* expected \(1024, 1024, 4\)"):
        Albedo(pixels)


def test_a_picture_is_frozen_and_equal_to_one_with_the_same_texels() -> None:
    texels = np.zeros((SIDE, SIDE, 4), np.uint8)
    first = Albedo(texels)
    same = Albedo(texels.copy())
    texels[0, 0, 0] = 1
    other = Albedo(texels)
    assert first == same != other
    assert (hash(first), repr(first)) == (hash(same), repr(same)) != (hash(other), repr(other))
    assert not first.pixels.flags.writeable


def test_a_look_takes_a_picture_and_nothing_else() -> None:
    picture = plain(1, 2, 3, 255)
    assert Look(albedo=picture) == replace(Look(), albedo=plain(1, 2, 3, 255)) != Look()
    with pytest.raises(ValueError, match="albedo of a look is a str; expected an Albedo"):
        Look(albedo="skin.png")  # type: ignore[arg-type]


def test_every_colour_comes_back_from_linear_light() -> None:
    codes = np.arange(256, dtype=np.uint8)
    np.testing.assert_array_equal(encode_light(decode_light(codes)), codes)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_light_is_encoded_as_the_standard_says(kind: type) -> None:
    """IEC 61966-2-1: a fifth of white is byte 124, and what is beyond white is white."""
    coded = round(255 * (1.055 * 0.2 ** (1 / 2.4) - 0.055))
    np.testing.assert_array_equal(encode_light(np.array([-1.0, 0.0, 0.2, 1.0, 2.0], kind)), [0, 0, coded, 255, 255])


def test_a_mix_is_linear_in_light_and_coverage() -> None:
    one = noise(1)
    other = noise(2)
    mixed = mix_albedos(((one, 0.3), (other, 0.7)))
    assert mixed is not None
    wanted = 0.3 * light(one) + 0.7 * light(other)
    covered = wanted[..., 3] > 0.2  # a colour times a small coverage says little of it
    assert np.abs(light(mixed) - wanted)[covered].max() < 0.012  # two roundings to 8 bits


def test_a_face_without_a_picture_takes_its_share_of_the_coverage() -> None:
    mixed = mix_albedos(((plain(200, 100, 50, 255), 0.5), (None, 0.5)))
    assert mixed == plain(200, 100, 50, 128)
    assert mixed.cover == pytest.approx(0.5, abs=0.5 / 255)


def test_one_picture_alone_stays_itself_and_none_stays_none() -> None:
    one = noise(3)
    assert mix_albedos(((one, 1.0), (None, 0.0))) is one
    assert mix_albedos(((None, 0.4), (None, 0.6))) is None


def test_pictures_of_two_sizes_mix_at_the_larger() -> None:
    mixed = mix_albedos(((plain(0, 0, 0, 255), 0.5), (plain(255, 255, 255, 255, side=2048), 0.5)))
    assert mixed is not None
    assert mixed.side == 2048
    half = int(encode_light(np.array([0.5], np.float32))[0])
    np.testing.assert_array_equal(mixed.pixels[0, 0], [half, half, half, 255])


def test_regions_come_from_their_own_pictures() -> None:
    cast = load_cast()
    assert cast.atlas is not None
    red = plain(255, 0, 0, 255)
    green = plain(0, 255, 0, 255)
    found = regional_albedo(cast.space, cast.atlas, red, (("mouth", green),))
    assert found is not None
    share = cast.atlas.spread(region_weights(cast.space)["mouth"], SIDE)
    seen = cast.atlas.spread(np.ones(cast.space.vertex_count), SIDE) == 1.0
    assert np.abs(light(found)[..., 1] - share)[seen].max() < 0.05
    assert np.abs(light(found)[..., 0] - (1.0 - share))[seen].max() < 0.05
    assert (found.pixels[..., 3] == 255).all()


def test_a_region_without_a_picture_uncovers_what_is_painted() -> None:
    cast = load_cast()
    assert cast.atlas is not None
    found = regional_albedo(cast.space, cast.atlas, plain(255, 0, 0, 255), (("skull", None),))
    assert found is not None
    share = cast.atlas.spread(region_weights(cast.space)["skull"], SIDE)
    seen = cast.atlas.spread(np.ones(cast.space.vertex_count), SIDE) == 1.0
    assert np.abs(found.pixels[..., 3] / 255.0 - (1.0 - share))[seen].max() < 0.05


def test_the_same_picture_everywhere_stays_itself() -> None:
    cast = load_cast()
    one = noise(4)
    assert cast.atlas is not None
    assert regional_albedo(cast.space, cast.atlas, one, (("nose", one), ("jaw", one))) is one
    assert regional_albedo(cast.space, cast.atlas, None, (("nose", None),)) is None
