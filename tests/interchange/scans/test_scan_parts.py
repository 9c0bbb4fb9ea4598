"""What all formats share: polygons, colours, doubled points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.scans import scan_parts
from omote.interchange.scans.scan_parts import bytes_of_colours, fan_polygons, find_doubles, make_scan, weld_scan
from omote.model.fitting.scan import Scan
from tests.interchange.scans import scan_samples as samples


@given(st.lists(st.integers(0, 7), max_size=9))
def test_a_fan_names_all_corners_of_each_polygon(counts: list[int]) -> None:
    places = fan_polygons(np.array(counts, np.int64))
    begin = 0
    expected = []
    for count in counts:
        expected += [[begin, begin + step, begin + step + 1] for step in range(1, count - 1)]
        begin += count
    np.testing.assert_array_equal(places, np.array(expected).reshape(-1, 3))


def test_colours_in_any_numbers_are_bytes() -> None:
    tones = samples.colours()
    for scale in (1.0, 1 / 255.0, 257.0):
        np.testing.assert_array_equal(bytes_of_colours(tones * scale), tones)
    assert bytes_of_colours(np.array([[0.5, -1.0, 0.0]])) is None
    assert bytes_of_colours(np.array([[0.5, np.nan, 0.0]])) is None
    np.testing.assert_array_equal(
        bytes_of_colours(np.array([[1.02, -0.001, 0.0], [np.nan, 0, 0]])), [[255, 0, 0], [255] * 3]
    )


@given(st.lists(st.tuples(st.sampled_from([0.0, -0.0, 1.5]), st.sampled_from([0.0, 2.0])), min_size=1, max_size=12))
def test_doubles_are_those_of_a_table(rows: list[tuple[float, float]]) -> None:
    first, of = find_doubles(np.array(rows))
    table = dict.fromkeys((a + 0.0, b) for a, b in rows)
    np.testing.assert_array_equal(np.array(rows)[first], [*table])
    np.testing.assert_array_equal(of, [[*table].index((a + 0.0, b)) for a, b in rows])


def test_doubles_are_told_apart_even_where_their_keys_are_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scan_parts, "_MULTIPLIERS", np.zeros(3, np.uint64))
    values = np.random.default_rng(3).integers(0, 3, (40, 2)).astype(float)
    first, of = find_doubles(values)
    np.testing.assert_array_equal(values[first][of], values)
    assert len(first) == len(np.unique(values, axis=0))


def test_points_that_move_apart_stay_apart() -> None:
    points, triangles = samples.ball()
    corners = points[triangles].reshape(-1, 3)
    rows = np.arange(len(corners)).reshape(-1, 3)
    apart = np.zeros_like(corners)
    apart[0] = 1.0
    assert len(weld_scan(make_scan(corners, rows)).positions) == len(points)
    assert len(weld_scan(make_scan(corners, rows, shapes={"open": apart})).positions) == len(points) + 1


def test_texture_coordinates_beyond_the_picture_come_back_by_whole_repetitions() -> None:
    points, triangles = samples.ball()
    uv = samples.texcoords()
    moved = uv + np.random.default_rng(5).integers(-3, 4, (len(uv), 1, 2))
    made = [make_scan(points, triangles, texture=samples.picture(), texcoords=each) for each in (uv, moved)]
    np.testing.assert_allclose(made[1].texcoords, made[0].texcoords, atol=1e-12)  # type: ignore[arg-type]


def test_a_cloud_of_triangles_without_area_is_a_cloud() -> None:
    points, _ = samples.ball()
    scan = make_scan(points, np.array([[1, 1, 2]]))
    assert isinstance(scan, Scan)
    assert scan.triangles is None
