"""omote.fit: a scan with landmarks becomes a face; without enough of them it is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.builtin import load_identity_modes, own_face
from omote.model.fitting.doubt import Doubt
from omote.model.fitting.find_head import find_head
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan

CAST = omote.load_cast()
OLD = CAST.faces["old"].positions.astype(np.float64)
ROWS = find_landmarks(CAST.space)


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


def test_what_was_no_head_where_it_was_sought_is_said_in_those_words(monkeypatch: pytest.MonkeyPatch) -> None:
    clicks = {name: OLD[row] for name, row in ROWS.items()}
    doubtful = find_head(CAST.space, load_identity_modes(), Scan(OLD), landmarks=clicks)
    monkeypatch.setattr(
        own_face, "find_head", lambda *_, **__: replace(doubtful, doubts=(Doubt("This may be no face."),))
    )

    def refuse(*_: object, **__: object) -> None:
        raise ValueError("the axis is outside the head")

    monkeypatch.setattr(own_face, "fit_kinds", refuse)
    with pytest.raises(ValueError, match=r"^This may be no face\.$"):
        omote.fit(CAST.space, OLD, CAST.space.triangles)
    monkeypatch.setattr(own_face, "find_head", lambda *_, **__: replace(doubtful, doubts=()))
    with pytest.raises(ValueError, match="the axis is outside"):
        omote.fit(CAST.space, OLD, CAST.space.triangles)
