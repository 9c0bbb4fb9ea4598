"""Colours of photographs on a face."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.model.appearance.photograph_albedo import take_photograph_albedo
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from tools.tracking.picture import turn

CAST = load_cast()
SIDE = 600
TEXELS = 1024
PAINTED = np.full((TEXELS, TEXELS, 3), 128, np.uint8)
POINTS = np.zeros((478, 2))


def camera_at(yaw: float) -> PhotographCamera:
    return PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.8]), 1200.0, SIDE, SIDE)


def photograph(colour: tuple[int, int, int]) -> Photograph:
    return Photograph(POINTS, SIDE, SIDE, picture=np.full((SIDE, SIDE, 3), colour, np.uint8))


def seen_share(values: np.ndarray, sign: float) -> float:
    """How much of the face's left (+1) or right (-1) side the values (k, k) mark."""
    assert CAST.atlas is not None
    front = CAST.space.on_sheet & (CAST.space.points[:, 0] * sign > 0.02) & (CAST.space.points[:, 2] > 0.06)
    zone = CAST.atlas.spread(front.astype(float), TEXELS) > 0.9
    return float(values[zone].mean())


def test_one_colour_comes_back_and_only_what_faces_the_camera_is_seen() -> None:
    assert CAST.atlas is not None
    face = CAST.faces["kaori"]
    colour = (180, 120, 90)
    taken = take_photograph_albedo(
        CAST.space, CAST.atlas, face, [photograph(colour)], [camera_at(0.9)], PAINTED, even=False
    )
    whole = taken.seen == 255
    assert (taken.albedo.pixels[whole, :3] == colour).all()
    assert seen_share(whole, -1.0) > 0.5  # its left side is turned away
    assert seen_share(whole, 1.0) < 0.2


def test_two_photographs_show_both_sides_and_pass_over_smoothly() -> None:
    assert CAST.atlas is not None
    views = [photograph((180, 120, 90)), photograph((150, 100, 75))]
    cameras = [camera_at(0.6), camera_at(-0.6)]
    taken = take_photograph_albedo(CAST.space, CAST.atlas, CAST.faces["kaori"], views, cameras, PAINTED, even=False)
    whole = taken.seen == 255
    assert min(seen_share(whole, 1.0), seen_share(whole, -1.0)) > 0.5
    both = whole[:, 1:] & whole[:, :-1]
    steps = np.abs(np.diff(taken.albedo.pixels[..., 0].astype(int), axis=1))[both]
    # A seam would be all of 30; texels beside each other across a gap of the texture are no neighbours on the skin.
    assert np.quantile(steps, 0.999) <= (180 - 150) / 6


def test_photographs_without_a_picture_and_of_nothing_are_refused() -> None:
    assert CAST.atlas is not None
    face = CAST.faces["kaori"]
    plain = Photograph(POINTS, SIDE, SIDE)
    with pytest.raises(ValueError, match="no photograph comes with its picture"):
        take_photograph_albedo(CAST.space, CAST.atlas, face, [plain], [camera_at(0.0)], PAINTED)
    away = PhotographCamera(np.eye(3), np.array([5.0, 0.0, -0.8]), 1200.0, SIDE, SIDE)
    with pytest.raises(ValueError, match="no photograph shows the face"):
        take_photograph_albedo(CAST.space, CAST.atlas, face, [photograph((9, 9, 9))], [away], PAINTED)
