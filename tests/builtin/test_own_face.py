"""omote.fit: a scan with landmarks becomes a face; without enough of them it is refused."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.fitting.landmarks import find_landmarks

CAST = omote.load_cast()
OLD, ROWS = CAST.faces["old"].positions.astype(np.float64), find_landmarks(CAST.space)


def test_a_scan_in_inches_about_other_axes_becomes_a_face() -> None:
    points = OLD[:, [2, 0, 1]] / 0.0254
    clicks = {name: points[row] for name, row in ROWS.items()}
    found = omote.fit(CAST.space, points, CAST.space.triangles, landmarks=clicks, name="old again", shut=False)
    assert isinstance(found, omote.Fit)
    assert np.nanmedian(found.residual) < 0.1
    assert found.face.name == "old again"


def test_too_few_landmarks_are_refused() -> None:
    with pytest.raises(ValueError, match="landmarks"):
        omote.fit(CAST.space, OLD, CAST.space.triangles, landmarks={"nose_tip": OLD[0]})
