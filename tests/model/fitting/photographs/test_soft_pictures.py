"""What a photograph shows of points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry import mesh
from omote.model.albedo import encode_light
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.soft_pictures import COARSE, cut_face, look_at, unhidden

SPACE = load_cast().space
SIDE = 400
CAMERA = PhotographCamera(np.eye(3), np.array([0.0, 0.0, -0.8]), 900.0, SIDE, SIDE)
AHEAD = np.tile([0.0, 0.0, 1.0], (5, 1))
PLACES = np.column_stack([np.linspace(-0.04, 0.04, 5), np.linspace(0.03, -0.03, 5), np.zeros(5)])


def taken(scale: int = 1) -> tuple[Photograph, PhotographCamera]:
    """A picture that is e times as bright for each 200 pixels of 400 further to the right."""
    side = scale * SIDE
    light = np.tile(0.3 * np.exp(np.linspace(-1.0, 1.0, side))[None, :, None], (side, 1, 3))
    camera = replace(CAMERA, focal=scale * CAMERA.focal, width=side, height=side)
    return Photograph(np.full((478, 2), side / 2.0), side, side, picture=encode_light(light)), camera


@pytest.mark.parametrize("scale", [1, 4])
def test_brightness_and_its_slope_are_the_pictures_whatever_its_size(scale: int) -> None:
    photograph, camera = taken(scale)
    picture = cut_face(photograph, camera, PLACES)
    assert picture is not None
    assert picture.step == max(int(COARSE * camera.focal / 0.8), 1)
    shown = look_at(picture, camera, PLACES, AHEAD, 0.006)
    pixels = 900.0 * PLACES[:, 0] / 0.8
    assert shown.bright == pytest.approx(np.log(0.3 * np.exp(pixels / 200.0) + 0.004), abs=0.02)
    assert shown.slopes[:, 0] == pytest.approx(900.0 / 0.8 / 200.0, rel=0.15)
    assert shown.slopes[:, 1] == pytest.approx(0.0, abs=0.1)
    assert shown.seen == pytest.approx(1.0)


def test_what_turns_away_or_lies_outside_is_not_seen() -> None:
    photograph, camera = taken()
    picture = cut_face(photograph, camera, PLACES)
    assert picture is not None
    assert not look_at(picture, camera, PLACES, -AHEAD, 0.002).seen.any()
    assert not look_at(picture, camera, np.add(PLACES, [0.5, 0.0, 0.0]), AHEAD, 0.002).seen.any()


def test_without_a_picture_or_a_face_in_it_nothing_is_cut() -> None:
    photograph, camera = taken()
    assert cut_face(replace(photograph, picture=None), camera, PLACES) is None
    assert cut_face(photograph, camera, np.add(PLACES, [5.0, 0.0, 0.0])) is None


def test_a_head_hides_its_own_back() -> None:
    normals = mesh.normals(SPACE.points, SPACE.triangles)
    clear = unhidden(CAMERA, SPACE.points, SPACE.triangles, SPACE.points)
    assert clear[normals[:, 2] < -0.5].mean() < 0.25  # the rim's
    tip = SPACE.points[:, 2].argmax()
    assert clear[tip]
