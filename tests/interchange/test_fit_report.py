"""Reports of fits: the table is CSV, and the nearest surface is seen in the colour of its distance."""

import csv
import io

import numpy as np

from omote.interchange.fit_report import (
    BAND,
    FARTHEST,
    KEY,
    TALL,
    VIEWS,
    WIDE,
    SheetRow,
    contact_sheet,
    describe_distances,
    draw_view,
    heat_colours,
    table_of,
)

SQUARE = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
SIDES = np.array([[0, 1, 2], [0, 2, 3]])


def test_a_table_comes_back_and_runs_no_formula() -> None:
    rows = [{"scan": "a,b.ply", "what": '=cmd|"x"'}, {"scan": "c.ply", "what": "good"}]
    found = list(csv.DictReader(io.StringIO(table_of(rows).decode(), newline="")))
    assert found == [{"scan": "a,b.ply", "what": '\'=cmd|"x"'}, {"scan": "c.ply", "what": "good"}]


def test_heat_rises_from_blue_to_red_and_what_was_not_seen_is_grey() -> None:
    cold, middle, hot, beyond, unseen = heat_colours(np.array([0.0, FARTHEST / 2, FARTHEST, 99.0, np.nan]))
    assert cold[2] > cold[0]
    assert middle[1] > max(middle[2], 99)
    assert hot[0] > max(hot[1], hot[2])
    np.testing.assert_array_equal(beyond, hot)
    assert unseen[0] == unseen[1] == unseen[2]


def test_what_is_nearer_hides_what_is_behind_it_in_any_order() -> None:
    """A small red square stands before a large blue one: the middle is red, what is around it blue."""
    near = SQUARE * 0.5 + [0, 0, 0.5]
    points = np.concatenate([SQUARE, near])
    sides = np.concatenate([SIDES, SIDES + 4])
    colours = np.repeat([[0.0, 0, 255], [255.0, 0, 0]], 4, axis=0)
    for order in (sides, sides[::-1]):
        picture = draw_view(points, order, colours, 0.0)
        np.testing.assert_array_equal(picture[TALL // 2, WIDE // 2], [255, 0, 0])
        np.testing.assert_array_equal(picture[TALL // 2, WIDE // 2 + int(0.35 * WIDE)], [0, 0, 255])


def test_a_sheet_says_what_its_colours_mean_and_has_three_views_of_each_face() -> None:
    residual = np.array([0.0, 0.5, np.nan, 3.0])
    rows = [SheetRow("Ann", "good", SQUARE, residual), SheetRow("Bo \u2603", "doubtful", SQUARE, np.full(4, np.nan))]
    sheet = contact_sheet(SIDES, rows)
    assert sheet.shape == (len(KEY) * BAND + 2 * (TALL + BAND), len(VIEWS) * WIDE, 3)
    for word in ("blue", "red", "grey", "doubtful", "failed"):
        assert word in " ".join(KEY)
    named = contact_sheet(SIDES, [*rows, SheetRow("Cy", "failed")])
    assert named.shape[0] == sheet.shape[0] + BAND
    assert (named[: len(sheet)] == sheet).all()
    accents, plain = (contact_sheet(SIDES, [SheetRow(name, "failed")]) for name in ("Jürgen Łukasz", "Jurgen Lukasz"))
    assert (accents == plain).all(), "letters that the font lacks are written by those that it has"
    key = sheet[: len(KEY) * BAND]
    assert (key[:, -1] == key[0, 0]).all(), "no line of text is cut"


def test_distances_are_of_what_was_seen() -> None:
    assert describe_distances(np.array([1.0, 1.0, np.nan])) == ("1.00", "1.00")
    assert describe_distances(np.full(3, np.nan)) == ("", "")
