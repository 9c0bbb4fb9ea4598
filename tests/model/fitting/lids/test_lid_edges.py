"""Lids are pulled to where a scan's are seen to end, however far beside them they lie."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.fitting.lids.lid_edges import LidEdges, see_lid_edges
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import ScanSurface, sample_mesh
from omote.model.space.similarity import Similarity

CAST = omote.load_cast()
SPACE = CAST.space
KAORI = CAST.faces["kaori"]
REST = KAORI.positions.astype(np.float64)
HERE = Similarity(1.0, np.eye(3), np.zeros(3))


def narrowed(weight: float) -> NDArray[np.float64]:
    """Kaori with narrow eyes."""
    moves = [omote.compound(SPACE, KAORI, CAST.expressions[f"eyeBlink{side}"]) - REST for side in ("Left", "Right")]
    return np.asarray(REST + weight * sum(moves), np.float64)


def surface_of(skin: NDArray[np.float64]) -> ScanSurface:
    """Samples of a skin."""
    return sample_mesh(skin, SPACE.triangles, np.stack([skin.min(axis=0), skin.max(axis=0)]), 0.03)


def edges_of(skin: NDArray[np.float64]) -> LidEdges:
    """Where the lids of a skin end."""
    edges = see_lid_edges(SPACE, Scan(skin, SPACE.triangles), HERE, surface_of(skin))
    assert edges is not None
    return edges


@pytest.mark.parametrize("weight", [0.0, 0.3, 0.45])
def test_lids_are_pulled_to_narrow_ones_from_four_millimetres_above(weight: float) -> None:
    skin = narrowed(weight)
    pulls = edges_of(skin).find_pulls(REST)
    assert len(pulls) == 4
    for pull in pulls:
        assert np.linalg.norm(pull.places - pull.matrix @ skin, axis=1).mean() < 0.0012


def test_shut_eyes_and_clouds_pull_nothing() -> None:
    assert edges_of(narrowed(1.0)).find_pulls(REST) == []
    assert see_lid_edges(SPACE, Scan(REST), HERE, surface_of(REST)) is None
