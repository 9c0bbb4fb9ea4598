"""Random heads and what they differ by: modes fall in size, do not overlap, and hold no turn, shift or size."""

from __future__ import annotations

import numpy as np

import omote
from omote.builtin import load_identity_modes
from omote.model.space.similarity import fit_similarity

SPACE = omote.load_cast().space
MODES = load_identity_modes()


def test_modes_fall_in_size_and_do_not_overlap() -> None:
    both = [MODES.moves, *MODES.part_moves.values()]
    flat = np.concatenate([each.reshape(len(each), -1) for each in both], axis=1)
    sizes = np.linalg.norm(flat, axis=1)
    assert (np.diff(sizes) < 1e-6).all()
    cosines = (flat @ flat.T) / np.outer(sizes, sizes)
    assert np.abs(cosines - np.eye(len(flat))).max() < 1e-3  # half precision


def test_a_mode_neither_turns_nor_shifts_nor_grows_the_head() -> None:
    even = np.ones(SPACE.vertex_count)
    for mode in MODES.moves[:20]:
        by_similarity = fit_similarity(SPACE.points, SPACE.points + mode, even)(SPACE.points) - SPACE.points
        assert np.linalg.norm(by_similarity) < 0.1 * np.linalg.norm(mode)
