"""The field around a ball is the distance to it."""

import numpy as np
import pytest

from tools.baking.hair.growth_field import STEP, field_of, surface_samples


def ball(radius: float = 0.05, columns: int = 48, rows: int = 24) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a ball around the origin."""
    theta = 2 * np.pi * np.arange(columns) / columns
    phi = np.pi * np.arange(rows + 1) / rows
    rings = np.stack(
        [
            np.outer(np.sin(phi), np.sin(theta)),
            np.outer(-np.cos(phi), np.ones(columns)),
            np.outer(np.sin(phi), np.cos(theta)),
        ],
        axis=-1,
    )
    row, column = (each.ravel() for each in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    after = (column + 1) % columns
    a, b = row * columns + column, row * columns + after
    triangles = np.concatenate([np.stack([a, b, b + columns], axis=1), np.stack([a, b + columns, a + columns], axis=1)])
    return radius * rings.reshape(-1, 3), triangles.astype(np.int32)


def test_heights_are_distances_and_out_is_away_from_the_middle() -> None:
    points, triangles = ball()
    field = field_of(points, triangles, closing=0.0, blur=0.002)
    ways = np.random.default_rng(2).normal(size=(200, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    for height in (-0.01, 0.0, 0.02):
        places = ways * (0.05 + height)
        assert np.abs(field.height(places) - height).max() < STEP
        assert (field.outward(places) * ways).sum(axis=1).min() > 0.9  # blurred over less than a cell


def test_a_gap_narrower_than_the_closing_counts_as_filled() -> None:
    points, triangles = ball(0.03)
    aside = np.array([0.033, 0.0, 0.0])
    pair = np.concatenate([points - aside, points + aside])
    both = np.concatenate([triangles, triangles + len(points)])
    middle = np.zeros((1, 3))
    assert field_of(pair, both, closing=0.0, blur=0.001).height(middle)[0] > 0.0
    assert field_of(pair, both, closing=0.015, blur=0.001).height(middle)[0] < 0.0


def test_samples_lie_on_the_surface_and_face_outwards() -> None:
    points, triangles = ball()
    spots, facing = surface_samples(points, triangles)
    assert np.linalg.norm(spots, axis=1) == pytest.approx(0.05, rel=0.02)
    assert (spots * facing).sum(axis=1).min() > 0.0
