"""Clouds as text, whichever way their columns are parted and named; all others are refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.scans.cloud_reader import read_cloud
from omote.interchange.scans.companions import Companions
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


HEADS = {
    "xyz": ["x", "y", "z"], "XYZ": ["X", "Y", "Z"], "with units": ["X [m]", "Y [m]", "Z [m]"],
    "in metres": ["x_m", "y_m", "z_m"], "spelled": ["Pos X", "pos-y", "PosZ"],
}  # fmt: skip
TONES = {"letters": ["R", "G", "B"], "words": ["Red", "GREEN", "blue"], "CloudCompare": ["Rf", "Gf", "Bf"]}
SEPARATED = st.sampled_from(
    [(";", "."), (";", ","), ("; ", ","), (",", "."), (", ", "."), (", ", ","), ("\t", "."), ("\t", ",")]
)


def table(
    columns: list[str], rows: list[list[str]], separator: str, decimal: str, *, quoted: bool = False, end: str = "\n"
) -> bytes:
    """A table as programs write it."""
    cells = [columns, *([cell.replace(".", decimal) for cell in row] for row in rows)]
    mark = '"' if quoted and (decimal == "." or separator.strip() == ";") else ""
    return end.join(separator.join(f"{mark}{cell}{mark}" for cell in row) for row in cells).encode()


@given(
    SEPARATED, st.sampled_from(sorted(HEADS)), st.sampled_from([None, *sorted(TONES)]), st.permutations(range(7)),
    st.booleans(), st.sampled_from(["\n", "\r\n", "\r"]), st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]),
)  # fmt: skip
def test_a_table_is_the_same_however_it_is_written(
    separated: tuple[str, str], head: str, tones: str | None, order: list[int], quoted: bool, end: str, encoding: str
) -> None:
    """Every separator, decimals either way, names in any order and capitals with units, quotes, marks, ends of lines;
    a column beside that means nothing."""
    names = [*HEADS[head], *(TONES[tones] if tones else ["n1", "n2", "n3"]), "Nr"]
    values = np.concatenate([POINTS, samples.colours(), np.arange(len(POINTS))[:, None]], axis=1)
    chosen = [[f"{row[at]:.17g}" for at in order] for row in values.tolist()]
    data = table([names[at] for at in order], chosen, *separated, quoted=quoted, end=end).decode().encode(encoding)
    beside = Companions()
    scan = read_cloud(data, beside)
    np.testing.assert_array_equal(scan.positions, POINTS)
    if tones:
        np.testing.assert_array_equal(scan.colours, samples.colours())
    else:
        assert scan.colours is None
    assert beside.notes == []


@given(
    SEPARATED, st.integers(0, len(POINTS) - 1), st.integers(0, 2),
    st.sampled_from(["", "nan", "NaN", "N/A", "null", "inf"]),
)  # fmt: skip
def test_a_cell_that_is_empty_or_no_number_costs_its_point(
    separated: tuple[str, str], at: int, column: int, cell: str
) -> None:
    rows = [[f"{value:.17g}" for value in row] for row in np.concatenate([POINTS, samples.colours()], axis=1).tolist()]
    rows[at][column] = cell
    beside = Companions()
    scan = read_cloud(table(["x", "y", "z", "r", "g", "b"], rows, *separated), beside)
    np.testing.assert_array_equal(scan.positions, np.delete(POINTS, at, axis=0))
    np.testing.assert_array_equal(scan.colours, np.delete(samples.colours(), at, axis=0))
    assert beside.notes == [f"1 of its 128 points are no numbers (the first is point {at}): they are left out"]


@given(st.sampled_from(["#", "//", "# "]), st.permutations("xyz"), st.sampled_from(["", " # the nose", "\t# 9 9 9"]))
def test_names_in_a_comment_name_columns_and_comments_behind_rows_are_none(
    sign: str, order: list[str], comment: str
) -> None:
    rows = POINTS[:, ["xyz".index(name) for name in order]]
    lines = [sign + " ".join(order).upper(), *(" ".join(map(repr, row)) + comment for row in rows.tolist())]
    np.testing.assert_array_equal(read_cloud("\n".join(lines).encode()).positions, POINTS)


def test_names_that_name_no_place_are_said() -> None:
    beside = Companions()
    scan = read_cloud(b"East,North,Height\n" + samples.write_cloud(","), beside)
    np.testing.assert_array_equal(scan.positions, POINTS)
    assert beside.notes == ["its columns are named 'East, North, Height': the first three are taken for x, y and z"]


def test_rows_of_another_length_cost_no_other_row_its_colour() -> None:
    lines = samples.write_cloud(" ", coloured=True).split(b"\n")
    lines[3] = b" ".join(lines[3].split()[:3])
    lines[9] += b" 7 7 7 7"
    scan = read_cloud(b"\n".join(lines))
    np.testing.assert_array_equal(scan.positions, POINTS)
    expected = samples.colours()
    expected[3] = 255
    np.testing.assert_array_equal(scan.colours, expected)


def test_long_rows_are_rows() -> None:
    """The first rows end, within the letters that a message shows, in the middle of a number."""
    lines = [" ".join(f"{value:.30e}" for value in row) for row in POINTS.tolist()]
    np.testing.assert_array_equal(read_cloud("\n".join(lines).encode()).positions, POINTS)
