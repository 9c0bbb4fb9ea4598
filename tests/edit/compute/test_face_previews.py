"""A thinned scan lies on the surface of the whole one, in the face's frame, with its colours."""

import numpy as np
import pytest

from omote.edit.compute.face_previews import MOST_POINTS, MOST_TRIANGLES, thin_scan
from omote.geometry import mesh
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity

RADIUS = 90.0
TURN = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
PLACE = Similarity(0.001, TURN, np.array([0.1, 0.2, 0.3]))


def ball(rings: int) -> Scan:
    """A ball of the radius of a head in millimetres, red on its upper half."""
    polar, around = np.meshgrid(np.linspace(0.01, np.pi - 0.01, rings), np.linspace(0, 2 * np.pi, 2 * rings, False))
    points = np.stack([np.sin(polar) * np.cos(around), np.cos(polar), np.sin(polar) * np.sin(around)], axis=-1).reshape(
        -1, 3
    )
    at = np.arange(len(points)).reshape(2 * rings, rings)
    right = np.roll(at, -1, axis=0)
    quads = np.stack([at[:, :-1], at[:, 1:], right[:, 1:], right[:, :-1]], axis=-1).reshape(-1, 4)
    colours = np.where(points[:, 1:2] > 0, [200, 10, 10], [10, 10, 200]).astype(np.uint8)
    return Scan(RADIUS * points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]), colours)


def test_a_small_scan_comes_whole_where_it_was_placed() -> None:
    scan = ball(20)
    thin = thin_scan(scan, PLACE)
    assert np.allclose(thin.positions, PLACE(scan.positions), atol=1e-7)
    assert scan.triangles is not None
    assert np.array_equal(thin.triangles, scan.triangles)
    assert thin.colours is not None
    assert scan.colours is not None
    assert np.array_equal(thin.colours, scan.colours)


def test_a_large_scan_is_thinned_to_the_limit_on_its_own_surface() -> None:
    scan = ball(280)
    assert scan.triangles is not None
    assert len(scan.triangles) > 4 * MOST_TRIANGLES
    thin = thin_scan(scan, PLACE)
    assert MOST_TRIANGLES / 3 < len(thin.triangles) <= MOST_TRIANGLES
    away = np.linalg.norm(thin.positions.astype(np.float64) - PLACE(np.zeros((1, 3))), axis=1)
    assert np.abs(away - 0.001 * RADIUS).max() < 1e-3 * 0.001 * RADIUS, (
        "points of a cell of the grid have their middle in it"
    )
    triangles = thin.triangles.astype(np.int32)
    middles = thin.positions[triangles].mean(axis=1)
    directions = mesh.normals(thin.positions.astype(np.float64), triangles)
    outward = ((middles - PLACE(np.zeros((1, 3)))) * directions[triangles].mean(axis=1)).sum(axis=1)
    assert max((outward > 0).mean(), (outward < 0).mean()) > 0.999, "no side is turned"
    assert thin.colours is not None
    up = PLACE.rotation @ [0.0, 1.0, 0.0]
    height = (thin.positions - PLACE(np.zeros((1, 3)))) @ up
    assert (thin.colours[height > 0.003, 0] == 200).all()
    assert (thin.colours[height < -0.003, 2] == 200).all()


def test_a_cloud_is_thinned_without_triangles() -> None:
    points = np.random.default_rng(3).normal(size=(3 * MOST_POINTS, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    thin = thin_scan(Scan(points), Similarity(0.1, np.eye(3), np.zeros(3)))
    assert MOST_POINTS / 4 < len(thin.positions) <= MOST_POINTS
    assert (len(thin.triangles), thin.colours) == (0, None)


def test_only_what_lies_around_the_head_is_kept_where_anything_does() -> None:
    scan = ball(60)
    low = PLACE(np.zeros((1, 3)))[0] - [1.0, 1.0, 0.0]
    half = thin_scan(scan, PLACE, np.stack([low, low + 2.0]))
    assert 0.45 < len(half.positions) / len(scan.positions) < 0.55
    assert half.positions[:, 2].min() >= low[2] - 1e-6
    nowhere = thin_scan(scan, PLACE, np.stack([low + 50.0, low + 51.0]))
    assert len(nowhere.positions) == len(scan.positions)


def test_the_colours_of_a_texture_come_to_the_points_that_it_covers() -> None:
    points = np.random.default_rng(4).normal(size=(120, 3))
    triangles = np.arange(120).reshape(40, 3)
    texture = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [9, 9, 9]]], np.uint8)
    places = np.random.default_rng(5).uniform(size=(40, 3, 2))
    thin = thin_scan(
        Scan(points, triangles, texture=texture, texcoords=places), Similarity(1.0, np.eye(3), np.zeros(3))
    )
    wanted = texture[(places[..., 1] >= 0.5).astype(int), (places[..., 0] >= 0.5).astype(int)]
    assert thin.colours is not None
    assert np.array_equal(thin.colours, wanted.reshape(-1, 3))


@pytest.mark.parametrize("size", [1e-3, 1e3])
def test_its_unit_does_not_matter(size: float) -> None:
    scan = ball(280)
    grown = Scan(scan.positions * size, scan.triangles)
    thin = thin_scan(grown, Similarity(0.001 / size, np.eye(3), np.zeros(3)))
    assert MOST_TRIANGLES / 3 < len(thin.triangles) <= MOST_TRIANGLES
