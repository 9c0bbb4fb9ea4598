"""Samples of surfaces: on it, even, with its normals, borders and sheets; clouds find their planes."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.model.fitting.scan_surface import face_outward, is_inside_out, sample_cloud, sample_mesh

BOX = np.array([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def ball(size: float = 0.1, rows: int = 60) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A sphere about the origin that is open at both poles."""
    h, a = np.meshgrid(np.linspace(0.1, np.pi - 0.1, rows), np.linspace(0, 2 * np.pi, rows, endpoint=False))
    points = size * np.stack([np.sin(h) * np.sin(a), np.cos(h), np.sin(h) * np.cos(a)], axis=-1)
    at = np.arange(rows * rows).reshape(rows, rows)
    one = at[:, :-1]
    right = np.roll(at, -1, 0)[:, :-1]
    below = at[:, 1:]
    across = np.roll(at, -1, 0)[:, 1:]
    quads = [np.stack(each, axis=-1).reshape(-1, 3) for each in ((one, below, across), (one, across, right))]
    return points.reshape(-1, 3), np.concatenate(quads)


def test_samples_lie_on_the_surface_and_look_out() -> None:
    surface = sample_mesh(*ball(), BOX, 0.0)
    assert np.abs(np.linalg.norm(surface.points, axis=1) - 0.1).max() < 2e-4
    assert ((surface.points * surface.normals).sum(axis=1) > 0.099).all()
    assert np.unique(surface.component).size == 1


def test_samples_at_the_border_are_those_near_the_open_poles() -> None:
    surface = sample_mesh(*ball(), BOX, 0.0)
    high = np.abs(surface.points[:, 1])
    assert high[surface.border].min() > high[~surface.border].max() - 1e-3


def test_distance_is_that_to_the_surface_and_of_farther_points_that_to_the_samples() -> None:
    surface = sample_mesh(*ball(), BOX, 0.0)
    ways = np.array([[1.0, 0, 0], [0, 0, 1.0], [0.6, 0, -0.8]])
    assert surface.measure_distance(0.103 * ways) == pytest.approx(0.003, abs=1e-4)
    assert surface.measure_distance(0.1 * ways).max() < 1e-4


def test_the_nearest_that_looks_the_same_way_is_found_through_a_thin_wall() -> None:
    outside, triangles = ball(0.1)
    inside, _ = ball(0.099)
    both = sample_mesh(
        np.vstack([outside, inside]), np.vstack([triangles, triangles[:, ::-1] + len(outside)]), BOX, 0.0
    )
    asked = np.array([[0.0995, 0.0, 0.0]])
    (out,) = both.find_nearest(asked, asked / 0.0995)
    (inward,) = both.find_nearest(asked, -asked / 0.0995)
    assert np.linalg.norm(both.points[out]) > np.linalg.norm(both.points[inward])


def test_what_hangs_on_an_edge_of_three_triangles_is_a_sheet_of_its_own() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1.0]])
    surface = sample_mesh(points, np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]]), BOX, 1.0)
    assert np.unique(surface.component).size == 3


def test_a_cloud_finds_normals_that_look_as_the_head_does() -> None:
    points, _ = ball()
    cloud = sample_cloud(points, (points, points / 0.1), BOX, 0.0)
    assert ((cloud.points * cloud.normals).sum(axis=1) / 0.1 > 0.98).all()


def test_nothing_near_the_head_is_refused() -> None:
    points, triangles = ball()
    with pytest.raises(ValueError, match="no surface where the head is"):
        sample_mesh(points + 9.0, triangles, BOX, 0.1)
    with pytest.raises(ValueError, match="expected at least"):
        sample_cloud(points + 9.0, (points, points), BOX, 0.1)


def test_a_surface_that_is_wound_the_other_way_is_turned() -> None:
    points, triangles = ball()
    for wound in (triangles, triangles[:, ::-1]):
        surface = face_outward(sample_mesh(points, wound, BOX, 0.0), (points, points / 0.1))
        assert ((surface.points * surface.normals).sum(axis=1) > 0.0).all()


def test_a_mirrored_or_turned_surface_is_inside_out_and_one_of_both_sides_is_not() -> None:
    points, triangles = ball()
    outside = (points, points / np.linalg.norm(points, axis=1, keepdims=True))

    def told(places: NDArray[np.float64], corners: NDArray[np.int64]) -> bool:
        return is_inside_out(sample_mesh(places, corners, BOX, 0.0), outside)

    both = np.concatenate([triangles, triangles[:, ::-1]])
    mirrored = points * [-1.0, 1.0, 1.0]
    assert [told(points, triangles), told(points, triangles[:, ::-1]), told(mirrored, triangles)] == [False, True, True]
    assert not told(points, both)
    assert not told(mirrored, triangles[:, ::-1]), "who mirrors with care leaves no trace"
