"""Colours of photographs on a face."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_landmark_table
from omote.model.appearance.photograph_albedo import take_photograph_albedo
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame
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


SKIN_COLOUR, TOOTH_COLOUR = (180, 120, 90), (250, 250, 250)


def laughing(camera: PhotographCamera) -> tuple[Photograph, np.ndarray]:
    """Kaori laughs: her picture, skin in one colour and teeth in another, with her landmarks; and her skin (V, 3)."""
    weights = {"jawOpen": 0.4, "mouthSmileLeft": 0.9, "mouthSmileRight": 0.9, "mouthUpperUpLeft": 0.6}
    frame = Frame({"kaori": 1.0}, {"neutral": 1.0}, channels=weights)
    skin = evaluate(CAST, frame).astype(np.float64)
    parts = evaluate_parts(CAST, frame)
    near = camera.draw(skin, CAST.space.triangles)
    teeth = np.minimum(
        *(camera.draw(parts[name], CAST.space.parts[name].triangles) for name in ("teeth_upper", "teeth_lower"))
    )
    picture = np.full((SIDE, SIDE, 3), SKIN_COLOUR, np.uint8)
    picture[teeth < near] = TOOTH_COLOUR
    landmarks = np.concatenate([load_landmark_table().places(skin), np.zeros((10, 3))])
    return Photograph(camera.project(camera.view(landmarks)), SIDE, SIDE, picture=picture), skin


def test_teeth_of_a_laugh_never_land_on_lips() -> None:
    """Where the fit knows how far the mouth is open none do; where it does not know, few: landmarks say what is between
    lips. Before, 1,818 texels were white in this picture."""
    assert CAST.atlas is not None
    camera = camera_at(0.0)
    view, skin = laughing(camera)
    assert (np.asarray(view.picture) == TOOTH_COLOUR).all(axis=2).sum() > 200, "teeth are seen"
    lips = head_zones(CAST.space).lips & CAST.space.on_sheet
    zone = CAST.atlas.spread(lips.astype(float), TEXELS) > 0.9

    atlas = CAST.atlas

    def take(worn: list[np.ndarray], view: Photograph) -> tuple[int, float]:
        """How many texels are lighter than skin, and how much of the lips is seen."""
        taken = take_photograph_albedo(
            CAST.space, atlas, CAST.faces["kaori"], [view], [camera], PAINTED, worn=worn, even=False
        )
        over = (taken.albedo.pixels[..., :3].astype(int) - SKIN_COLOUR).max(axis=2)
        return int(((over > 20) & (taken.seen > 0)).sum()), float((taken.seen > 0)[zone].mean())

    white, seen = take([skin], view)
    assert white == 0
    assert seen > 0.6
    unknown, _ = take([], view)
    blind, _ = take([], replace(view, landmarks=POINTS))
    assert unknown < 0.15 * blind
