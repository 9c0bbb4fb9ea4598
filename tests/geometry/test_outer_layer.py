"""One layer: the outer of two triangles that overlap is kept, and touching is not overlapping."""

from __future__ import annotations

import numpy as np

from omote.geometry.outer_layer import keep_outer_layer

WIDTH = 10.0


def kept(triangles: list[list[tuple[float, float]]], radius: list[float]) -> list[bool]:
    corners = np.array(triangles)
    keep = np.ones(len(corners), np.bool_)
    keep_outer_layer(corners[..., 0].copy(), corners[..., 1].copy(), np.array(radius), WIDTH, 1.0, keep)
    return keep.tolist()


LOW = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
BESIDE = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
OVER = [(0.2, 0.2), (1.2, 0.2), (0.2, 1.2)]


def test_triangles_that_share_an_edge_both_stay() -> None:
    assert kept([LOW, BESIDE], [1.0, 2.0]) == [True, True]


def test_of_two_that_overlap_the_outer_stays() -> None:
    assert kept([LOW, OVER], [1.0, 2.0]) == [False, True]
    assert kept([LOW, OVER], [2.0, 1.0]) == [True, False]


def test_overlap_is_seen_across_the_seam() -> None:
    shifted = [(x + WIDTH, y) for x, y in OVER]
    assert kept([LOW, shifted], [1.0, 2.0]) == [False, True]
