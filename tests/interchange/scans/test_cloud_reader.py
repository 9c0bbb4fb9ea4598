"""Clouds as text, whichever way their columns are parted and named; all others are refused."""

import numpy as np
import pytest

from omote.interchange.scans.cloud_reader import read_cloud
from tests.interchange.scans import scan_samples as samples

POINTS, _ = samples.ball()


@pytest.mark.parametrize("separator", [" ", "\t", ",", ", ", ";"])
@pytest.mark.parametrize("coloured", [False, True])
def test_points_come_back_whatever_parts_them(separator: str, coloured: bool) -> None:
    scan = read_cloud(samples.write_cloud(separator, coloured=coloured))
    np.testing.assert_array_equal(scan.positions, POINTS)
    if coloured:
        np.testing.assert_array_equal(scan.colours, samples.colours())
    else:
        assert scan.colours is None


@pytest.mark.parametrize("separator", [" ", ";"])
def test_a_decimal_comma_is_no_separator(separator: str) -> None:
    np.testing.assert_array_equal(read_cloud(samples.write_cloud(separator).replace(b".", b",")).positions, POINTS)


def test_named_columns_are_found_in_any_order() -> None:
    rows = np.concatenate([samples.colours().astype(float), POINTS[:, ::-1]], axis=1)
    text = "Red;Green;Blue;Z;Y;X\n" + "\n".join(";".join(map(repr, row)) for row in rows.tolist())
    scan = read_cloud(text.encode())
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.colours, samples.colours())


def test_the_count_of_a_pts_file_is_no_point_and_intensity_no_colour() -> None:
    rows = np.concatenate([POINTS, np.full((len(POINTS), 1), -700.0), samples.colours()], axis=1)
    text = f"{len(rows)}\n" + "\n".join(" ".join(map(repr, row)) for row in rows.tolist())
    scan = read_cloud(text.encode())
    np.testing.assert_array_equal(scan.positions, POINTS)
    np.testing.assert_array_equal(scan.colours, samples.colours())


def test_a_normal_is_no_colour() -> None:
    rows = np.abs(np.concatenate([POINTS, POINTS], axis=1))
    text = "# a comment\n" + "\n".join(" ".join(map(repr, row)) for row in rows.tolist())
    assert read_cloud(text.encode()).colours is None


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"\0\1\2", "no cloud of points, but binary data"),
        (b"hello\nhow are you\n", "no cloud, but text"),
        (samples.write_cloud() + b"\n1 2", "'1 2' is no point"),
        (samples.write_cloud() + b"\n1 2 three", "'three', which is no number"),
        (b"1 2 3\n" * 20, "20 usable points"),
    ],
)
def test_what_is_wrong_is_refused_with_a_sentence(data: bytes, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read_cloud(data)
