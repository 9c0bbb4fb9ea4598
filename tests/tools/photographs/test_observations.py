"""Weights of modes that are found in a known head."""

from __future__ import annotations

import numpy as np

from omote.builtin import load_cast, load_identity_modes
from omote.model.space.similarity import fit_similarity
from tools.photographs.observations import find_weights


def off(weights: np.ndarray, skin: np.ndarray) -> float:
    """Metres between the head of some weights and a skin (V, 3), after a similarity: the mean."""
    sheet = load_cast().space.on_sheet
    made = load_identity_modes().shape_skin(weights)[sheet]
    back = fit_similarity(skin[sheet], made, np.ones(int(sheet.sum())))(skin[sheet])
    return float(np.linalg.norm(back - made, axis=1).mean())


def test_a_head_of_the_modes_is_found_again_whatever_its_place_and_size() -> None:
    modes = load_identity_modes()
    weights = np.zeros(len(modes.moves))
    weights[:8] = [1.0, -0.5, 0.7, 0.0, 1.2, -1.0, 0.3, 0.5]
    skin = modes.shape_skin(weights)
    found = find_weights(1.03 * skin + [0.01, -0.02, 0.03])
    assert off(found, skin) < 0.05 * off(np.zeros_like(weights), skin)
    assert np.linalg.norm(found) < 1.2 * np.linalg.norm(weights)  # no more than people differ by
