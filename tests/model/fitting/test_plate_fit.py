"""The plate: stays where it fits, meets a surface, follows pulls, and is no finer than a rough surface allows."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.fitting.head_zones import head_zones, row_matrix
from omote.model.fitting.plate_fit import LENGTHS, NOISY, Hold, bend, find_lengths, match
from omote.model.fitting.scan_surface import ScanSurface, sample_mesh

CAST = omote.load_cast()
SPACE = CAST.space
ZONES = head_zones(CAST.space)
BOX = np.stack([SPACE.points.min(axis=0), SPACE.points.max(axis=0)])


def surface_of(name: str) -> ScanSurface:
    """The skin of somebody of the cast."""
    return sample_mesh(CAST.faces[name].positions.astype(np.float64), SPACE.triangles, BOX, 0.05)


def test_a_head_on_its_own_surface_stays() -> None:
    surface = surface_of("generic")
    bent = bend(SPACE, SPACE.points, surface, ZONES.weights, [])
    assert np.median(surface.measure_distance(bent)[ZONES.face]) < 2e-5
    assert np.quantile(np.linalg.norm(bent - SPACE.points, axis=1)[ZONES.face], 0.95) < 0.0005  # along the skin too


def test_a_head_bent_onto_another_lies_on_it() -> None:
    surface = surface_of("kaori")
    bent = bend(SPACE, SPACE.points, surface, ZONES.weights, [])
    before, after = (np.median(surface.measure_distance(skin)[ZONES.face]) for skin in (SPACE.points, bent))
    assert after < 0.02 * before


def test_without_matches_pulls_alone_say_where_the_plate_goes() -> None:
    rows = np.array([10, 900, 2000, 3000])
    shift = np.array([0.001, 0.002, -0.001])
    pull = Hold(row_matrix(rows, SPACE.vertex_count), SPACE.points[rows] + shift, np.ones(4))
    nothing = np.zeros(SPACE.vertex_count)
    bent = bend(SPACE, SPACE.points, surface_of("generic"), nothing, [(pull, np.ones(2))], LENGTHS[:2])
    assert np.abs(bent - SPACE.points - shift).max() < 1e-4


def test_far_points_and_those_that_look_away_have_no_match() -> None:
    surface = surface_of("generic")
    assert not match(surface, SPACE, SPACE.points + 0.2, 0.003).weights.any()
    inside_out = ScanSurface(surface.points, -surface.normals, surface.border, surface.component, surface.triangle)
    weights = match(inside_out, SPACE, SPACE.points, 0.003).weights
    assert weights[ZONES.closed].mean() < 0.02 < match(surface, SPACE, SPACE.points, 0.003).weights[ZONES.closed].mean()


def test_a_rough_surface_is_not_followed_finely() -> None:
    rough = sample_mesh(SPACE.points, SPACE.triangles, BOX, 0.05)
    spoiled = rough.normals + np.random.default_rng(0).normal(scale=0.4, size=rough.normals.shape)
    spoiled /= np.linalg.norm(spoiled, axis=1, keepdims=True)
    assert find_lengths(rough) == LENGTHS
    lengths = find_lengths(ScanSurface(rough.points, spoiled, rough.border, rough.component, rough.triangle))
    assert min(lengths) >= NOISY > LENGTHS[-1]
