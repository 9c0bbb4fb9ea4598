"""The nearest place in a triangle: inside, on edges, at corners; and the rims of lids on a scan."""

import numpy as np
import pytest

import omote
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.scan_correspondence import correspond, nearest_in
from omote.model.fitting.scan_skin import keep_skin
from omote.model.fitting.scan_surface import sample_mesh

CAST = omote.load_cast()


def test_the_nearest_place_is_no_farther_than_any_other() -> None:
    draw = np.random.default_rng(0)
    corners = draw.normal(size=(50, 3, 3))
    asked = draw.normal(size=(50, 3))
    shares = draw.dirichlet(np.ones(3), 400)
    weights, off = nearest_in(corners, asked)
    np.testing.assert_allclose(weights.sum(axis=1), 1.0)
    assert weights.min() >= -1e-12
    np.testing.assert_allclose(np.einsum("mk,mkc->mc", weights, corners) + off, asked)
    others = np.linalg.norm(np.einsum("sk,mkc->msc", shares, corners) - asked[:, None], axis=2).min(axis=1)
    assert (np.linalg.norm(off, axis=1) <= others + 1e-12).all()


@pytest.mark.parametrize("name", ["old", "man"])
def test_rims_of_lids_are_matched_on_a_scan_that_lies_beside_them(name: str) -> None:
    """A rim whose normal was over 60 degrees off counted nothing, though its place was known: blinks were 9 % off."""
    space = CAST.space
    skin = CAST.faces[name].positions.astype(np.float64)
    beside = skin + np.array([0.0003, -0.0005, 0.0])
    box = np.stack([skin.min(axis=0), skin.max(axis=0)])
    surface = keep_skin(sample_mesh(beside, space.sheet_triangles, box, 0.03), head_zones(space), skin)
    found = correspond(space, skin, beside, space.sheet_triangles, surface)
    rims = np.unique(np.concatenate([line.loop for line in space.lines if line.kind == "lids"]))
    assert (found.sure[rims] > 0.5).mean() > 0.97
