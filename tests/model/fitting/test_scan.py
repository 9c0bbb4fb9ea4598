"""Scans: what comes in stays as it was; what is no scan is rejected in words."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.model.fitting.scan import FEWEST_POINTS, Scan

POINTS = np.random.default_rng(1).normal(size=(FEWEST_POINTS, 3))
TRIANGLES = np.random.default_rng(2).integers(0, FEWEST_POINTS, (40, 3))
TEXTURE = np.zeros((4, 8, 3), np.uint8)
CORNERS = np.zeros((40, 3, 2))


def test_a_scan_keeps_what_it_was_given_and_none_can_write_into_it() -> None:
    colours = np.full((FEWEST_POINTS, 3), 7, np.uint8)
    shapes = {"jawOpen": 0.1 * POINTS}
    scan = Scan(POINTS, TRIANGLES, colours, TEXTURE, CORNERS, shapes)
    assert scan.triangles is not None
    assert scan.colours is not None
    assert np.array_equal(scan.positions, POINTS)
    assert np.array_equal(scan.triangles, TRIANGLES)
    assert np.array_equal(scan.shapes["jawOpen"], shapes["jawOpen"])
    assert np.array_equal(scan.colours, colours)
    for each in (scan.positions, scan.triangles, scan.colours, scan.shapes["jawOpen"]):
        assert not each.flags.writeable
    assert POINTS.flags.writeable


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"positions": POINTS[:9]}, "a scan has 9 points; expected at least 100"),
        ({"positions": POINTS[:, :2]}, "positions of a scan"),
        ({"positions": np.where(POINTS > 2.0, np.nan, POINTS)}, "positions of a scan"),
        ({"triangles": TRIANGLES + 100}, r"name rows \d+ to \d+; expected 0 to 99"),
        ({"triangles": TRIANGLES - 100}, r"name rows -\d+ to -?\d+; expected 0 to 99"),
        ({"triangles": TRIANGLES.astype(float)}, r"expected \(t, 3\) of integers"),
        ({"colours": np.zeros((3, 3), np.uint8)}, r"expected \(100, 3\) of uint8"),
        ({"colours": np.zeros((100, 3))}, r"expected \(100, 3\) of uint8"),
        ({"texture": TEXTURE}, "expected both or neither"),
        ({"texture": TEXTURE[0], "triangles": TRIANGLES, "texcoords": CORNERS}, "of uint8"),
        ({"texture": TEXTURE, "triangles": TRIANGLES, "texcoords": CORNERS[1:]}, r"expected \(40, 3, 2\)"),
        ({"texture": TEXTURE, "triangles": TRIANGLES, "texcoords": CORNERS + np.inf}, "finite"),
        ({"shapes": {"smile": POINTS[1:]}}, "shape 'smile' of a scan has 99 points; expected 100"),
    ],
)
def test_what_is_no_scan_is_rejected_in_words(given: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Scan(**{"positions": POINTS, **given})
