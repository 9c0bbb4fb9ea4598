"""Sides of a slit are told along the skin: of lips that touch, too."""

import numpy as np

import omote
from omote.model.fitting.scan_correspondence import SIDE_CLEAR, our_sides
from omote.model.space.lid_lip_lines import chains

SPACE = omote.load_cast().space


def test_middles_of_both_halves_of_every_line_lie_on_their_sides() -> None:
    for line in SPACE.lines:
        sides, away = our_sides(SPACE, line, SPACE.points)
        upper, lower = (chain[len(chain) // 2] for chain in chains(SPACE.points, line.loop))
        assert sides[upper] > SIDE_CLEAR
        assert sides[lower] < -SIDE_CLEAR
        np.testing.assert_array_equal(away[[upper, lower]], 0.0)
