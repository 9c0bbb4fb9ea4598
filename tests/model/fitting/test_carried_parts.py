"""Parts go as rigid bodies of the scan go; what bends is left alone."""

import numpy as np

import omote
from omote.model.fitting.carried_parts import ScanParts, carry_parts
from omote.model.space.face_fit import fit

CAST = omote.load_cast()
FITTED = fit(CAST.space, CAST.faces["kaori"])
TEETH = FITTED.parts["teeth_lower"].astype(np.float64)
FOUND = ScanParts({"teeth_lower": np.arange(len(TEETH))}, {})


def test_what_is_rigid_is_carried_and_what_bends_is_not() -> None:
    down = np.tile([0.0, -0.02, -0.01], (len(TEETH), 1))
    np.testing.assert_allclose(carry_parts(FOUND, FITTED, TEETH, down)["teeth_lower"], down, atol=1e-9)
    assert carry_parts(FOUND, FITTED, TEETH, 0.01 * np.random.default_rng(0).normal(size=TEETH.shape)) == {}
