"""Outlines of heads in photographs."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry.depth_map import draw_depth
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.outlines import find_outline
from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.tracking.picture import turn

SPACE = load_cast().space
FACE = head_zones(SPACE).face
SIDE = 500


def camera_at(yaw: float) -> PhotographCamera:
    return PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.8]), 900.0, SIDE, SIDE)


def silhouette(camera: PhotographCamera) -> np.ndarray:
    """A bright head before the dark."""
    seen = camera.view(SPACE.points)
    screen = np.column_stack([camera.project(seen), -seen[:, 2]])
    return np.where(np.isfinite(draw_depth(screen, SPACE.triangles.astype(np.int32), SIDE, SIDE)), 200.0, 20.0)


@pytest.mark.parametrize("yaw", [0.7, -0.7])
def test_the_outline_of_a_head_lies_where_it_ends(yaw: float) -> None:
    found = find_outline(SPACE, camera_at(yaw), SPACE.points, silhouette(camera_at(yaw)), FACE)
    clear = found.clear > 0.3
    assert clear.sum() > 10
    assert np.median(np.abs(found.away[clear])) < 0.001  # a pixel of this picture is .9 mm


@pytest.mark.parametrize("growth", [0.97, 1.03])
def test_a_head_that_is_drawn_too_large_or_small_is_pulled_back(growth: float) -> None:
    camera = camera_at(0.7)
    found = find_outline(SPACE, camera, SPACE.points * growth, silhouette(camera), FACE)
    clear = found.clear > 0.3
    assert np.sign(np.median(found.away[clear])) == np.sign(1.0 - growth)


def test_an_even_picture_has_no_outline() -> None:
    found = find_outline(SPACE, camera_at(0.7), SPACE.points, np.full((SIDE, SIDE), 90.0), FACE)
    assert not found.clear.any()
