"""Where a scan is nearest to places of a face, and its colours there."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.albedo import decode_light
from omote.model.appearance.scan_colours import choose_nearest, nearest_faces, place_colours
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity

STILL = Similarity(1.0, np.eye(3), np.zeros(3))


def sheet(z: float = 0.0, side: int = 20) -> tuple[np.ndarray, np.ndarray]:
    """A square of 0.1 m at a height, facing up."""
    rows, columns = np.indices((side, side)).reshape(2, -1)
    points = np.stack([columns, rows, np.zeros(len(rows))], axis=1) * [0.1 / (side - 1), 0.1 / (side - 1), 0.0]
    points[:, 2] = z
    first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    lower = np.stack([first, first + 1, first + side + 1], axis=1)
    upper = np.stack([first, first + side + 1, first + side], axis=1)
    return points, np.concatenate([lower, upper])


def test_the_nearest_place_is_the_foot_of_the_perpendicular() -> None:
    points, triangles = sheet()
    colours = place_colours(Scan(points, triangles, np.zeros((len(points), 3), np.uint8)), STILL, points)
    random = np.random.default_rng(1)
    over = random.uniform(0.01, 0.09, (200, 3)) * [1.0, 1.0, 0.02]
    up = np.tile([0.0, 0.0, 1.0], (200, 1))
    everything = np.tile(np.arange(len(triangles)), (200, 1))
    faces, shares, away = choose_nearest(colours, over, up, everything)
    np.testing.assert_allclose(away, over[:, 2], atol=1e-12)
    feet = np.einsum("nc,nck->nk", shares, colours.corners[faces])
    np.testing.assert_allclose(feet[:, :2], over[:, :2], atol=1e-12)
    nearest = nearest_faces(colours, over, up)
    within, _, near = choose_nearest(colours, over, up, nearest[:, None])
    assert np.median(near - away) < 1e-4
    np.testing.assert_array_equal(within, nearest)


def test_of_two_sheets_the_one_that_faces_the_same_way_is_taken() -> None:
    low, triangles = sheet(0.0)
    high, _ = sheet(0.002)
    both = Scan(
        np.concatenate([low, high]),
        np.concatenate([triangles, triangles[:, ::-1] + len(low)]),
        np.zeros((2 * len(low), 3), np.uint8),
    )
    colours = place_colours(both, STILL, low)
    place = np.array([[0.05, 0.05, 0.0015]])
    up = np.array([[0.0, 0.0, 1.0]])
    assert nearest_faces(colours, place, up)[0] < len(triangles) <= nearest_faces(colours, place, -up)[0]


def test_a_cloud_gives_the_colour_of_its_nearest_point() -> None:
    points, _ = sheet()
    codes = np.random.default_rng(2).integers(0, 256, (len(points), 3), np.uint8)
    colours = place_colours(Scan(points, None, codes), STILL, points)
    faces = nearest_faces(colours, points + 1e-4, np.zeros(points.shape))
    first, shares, away = choose_nearest(colours, points + 1e-4, np.zeros(points.shape), faces[:, None])
    np.testing.assert_array_equal(colours.light(first, shares), decode_light(codes))
    np.testing.assert_allclose(away, np.sqrt(3) * 1e-4)


def test_a_scan_without_colours_is_refused() -> None:
    points, triangles = sheet()
    with pytest.raises(ValueError, match="this scan has no colours"):
        place_colours(Scan(points, triangles), STILL, points)


def test_what_lies_too_far_away_has_no_neighbour() -> None:
    points, triangles = sheet()
    for kept in (triangles, None):
        colours = place_colours(Scan(points, kept, np.zeros((len(points), 3), np.uint8)), STILL, points)
        over = np.array([[0.05, 0.05, 0.001], [0.05, 0.05, 0.02]])
        up = np.tile([0.0, 0.0, 1.0], (2, 1))
        faces = nearest_faces(colours, over, up, within=0.008)
        assert faces[0] >= 0 > faces[1]
        away = choose_nearest(colours, over, up, faces[:, None])[2]
        assert away[0] < 0.008
        assert away[1] == np.inf
