"""The look of a face from photographs: their colours, and hair where the scalp is another colour than the skin."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.png import read_png
from omote.interchange.scan_face import FIRST_HAIR, suggest_photograph_look
from omote.interchange.skin_texture import Canvas, build_canvas, decode_srgb
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera

CAST = load_cast()
MAN = CAST.faces["man"]
SIDE = 400
CAMERA = PhotographCamera(np.eye(3), np.array([0.0, 0.0, -0.8]), 800.0, SIDE, SIDE)
HAIRLINE = 0.08
"""Metres over the eyes, about where hair begins."""


def photograph(skin: tuple[int, int, int], hair: tuple[int, int, int]) -> Photograph:
    """Hair above a line, skin below it."""
    row = round(CAMERA.project(CAMERA.view(np.array([[0.0, HAIRLINE, 0.08]])))[0, 1])
    picture = np.full((SIDE, SIDE, 3), skin, np.uint8)
    picture[:row] = hair
    return Photograph(np.zeros((478, 2)), SIDE, SIDE, picture=picture)


@pytest.fixture(scope="module")
def canvas() -> Canvas:
    """The built-in skin's."""
    return build_canvas(read_png(load_mask()), load_meshes()[0], CAST.space.points)


@pytest.mark.parametrize("skin", [(220, 180, 160), (88, 60, 46)])
def test_skin_of_any_shade_keeps_its_colour_and_black_hair_is_seen_on_all(
    canvas: Canvas, skin: tuple[int, int, int]
) -> None:
    look, seen, _ = suggest_photograph_look(CAST, canvas, MAN, [photograph(skin, (14, 12, 12))], [CAMERA])
    assert look.hair_style == FIRST_HAIR
    assert decode_srgb(look.hair).max() < 0.5 * decode_srgb(look.skin).max()
    bald, *_ = suggest_photograph_look(CAST, canvas, MAN, [photograph(skin, skin)], [CAMERA])
    assert bald.hair_style == ""
    assert look.albedo is not None
    assert seen.shape == look.albedo.pixels.shape[:2]
    assert 0 < (seen > 0).sum() < seen.size


def test_a_cast_without_a_texture_and_photographs_of_nothing_are_refused(canvas: Canvas) -> None:
    one = photograph((9, 9, 9), (9, 9, 9))
    with pytest.raises(ValueError, match="no texture"):
        suggest_photograph_look(replace(CAST, atlas=None), canvas, MAN, [one], [CAMERA])
    away = replace(CAMERA, shift=np.array([5.0, 0.0, -0.8]))
    with pytest.raises(ValueError, match="no photograph shows the face"):
        suggest_photograph_look(CAST, canvas, MAN, [one], [away])
