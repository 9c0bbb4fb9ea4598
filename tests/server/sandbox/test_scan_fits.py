"""Fits in a child process: what comes back is the fit, and no face of another head is taken for one."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.scan_look import FIRST_HAIR
from omote.interchange.scans.scan_parts import make_scan
from omote.model.cast import Look
from omote.model.fitting.doubt import EYES, Doubt
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.similarity import Similarity
from omote.server.sandbox import scan_fits
from omote.server.sandbox.scan_fits import ScanFit, fit_in_child
from tests.interchange.scans import scan_samples as samples

SCAN = make_scan(*samples.ball())


def double(*doubts: Doubt, face: str = "kaori", rows: slice = slice(None)) -> Fit:
    """A fit that found a face of the cast, whatever the scan."""
    cast = load_cast()
    found = cast.faces[face]
    count = cast.space.vertex_count
    residual = np.where(np.arange(count) % 2, 0.25, np.nan)
    placement = Similarity(1.0, np.eye(3), np.zeros(3))
    return Fit(Face("scan", found.positions[rows], found.parts), residual, np.ones(count), placement, doubts)


def test_a_fit_comes_back(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = load_cast()
    monkeypatch.setattr(scan_fits, "fit", lambda *_, **options: double(Doubt(f"It is {options['name']}.", EYES)))
    found = fit_in_child(cast, SCAN, name="Ann", landmarks={"nose_tip": (0.0, 1.0, 2.0)})
    np.testing.assert_array_equal(found.face.positions, cast.faces["kaori"].positions)
    for part, points in cast.faces["kaori"].parts.items():
        np.testing.assert_array_equal(found.face.parts[part], points)
    assert (found.face.name, found.doubts) == ("Ann", ("It is Ann.",))
    assert [doubt.kind for doubt in found.doubts] == [EYES]
    assert found.describe() == "0.25 mm from the scan (95 of 100 points within 0.25)"


def test_the_colours_of_a_scan_come_back_as_a_look(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = load_cast()
    monkeypatch.setattr(scan_fits, "fit", lambda *_, **__: double())
    points = cast.faces["kaori"].positions.astype(np.float64)
    green = Scan(points, cast.space.triangles, np.tile(np.array([20, 160, 60], np.uint8), (len(points), 1)))
    found = fit_in_child(cast, green, name="Ann")
    assert found.look.albedo is not None
    assert found.notes == ()
    assert fit_in_child(cast, Scan(points, cast.space.triangles), name="Ann").look == Look(hair_style=FIRST_HAIR)
    far = fit_in_child(cast, Scan(points + 5.0, cast.space.triangles, green.colours), name="Ann")
    assert far.look == Look(hair_style=FIRST_HAIR)
    assert far.notes[0].startswith("its colours were not taken over: ")


def test_a_refusal_comes_back_and_no_other_head_does(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> Fit:
        raise ValueError("there is no head in it")

    cast = load_cast()
    monkeypatch.setattr(scan_fits, "fit", refuse)
    with pytest.raises(ValueError, match="there is no head in it"):
        fit_in_child(cast, SCAN, name="Ann")
    monkeypatch.setattr(scan_fits, "fit", lambda *_, **__: double(rows=slice(9)))
    with pytest.raises(ValueError, match="9"):
        fit_in_child(cast, SCAN, name="Ann")


def test_what_was_not_seen_is_said() -> None:
    cast = load_cast()
    nothing = np.full(cast.space.vertex_count, np.nan)
    assert ScanFit(cast.faces["kaori"], Look(), nothing, nothing, ()).describe() == "nothing of it was seen"
