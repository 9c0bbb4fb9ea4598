"""Zones of the generic head: on the sheet, the same on both sides, each where its opening is."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.controls.mirror import mirror_rows
from omote.model.fitting.head_zones import head_zones, row_matrix, rung_matrix

SPACE = omote.load_cast().space
ZONES = head_zones(SPACE)


def test_zones_are_the_same_on_both_sides_and_on_the_sheet() -> None:
    across = mirror_rows(SPACE)
    for mask in (ZONES.face, ZONES.lids, ZONES.lips, ZONES.nostrils):
        assert mask.any()
        assert SPACE.on_sheet[mask].all()
        assert (mask != mask[across]).mean() < 0.002
    assert not ZONES.weights[~SPACE.on_sheet].any()


def test_lines_lie_in_their_zones_and_closed_skin_has_none() -> None:
    for line in SPACE.lines:
        zone = ZONES.lids if line.kind == "lids" else ZONES.lips
        assert zone[line.loop[SPACE.on_sheet[line.loop]]].all()
        assert not ZONES.closed[line.loop].any()


def test_matrices_give_rows_and_rungs() -> None:
    rows = np.array([3, 1, 3])
    assert np.array_equal(row_matrix(rows, SPACE.vertex_count) @ SPACE.points, SPACE.points[rows])
    for line in SPACE.lines:
        assert np.allclose(rung_matrix(line, SPACE.vertex_count) @ SPACE.points, line.rungs(SPACE.points), atol=1e-12)
