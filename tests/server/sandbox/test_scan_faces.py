"""Fits in a child process: what comes back is the fit, and no face of another head is taken for one."""

import resource

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.builtin.own_face import NoFaceError
from omote.interchange import scan_face
from omote.interchange.scan_face import FIRST_HAIR
from omote.interchange.scans.scan_parts import make_scan
from omote.model.cast import Look
from omote.model.fitting.doubt import EYES, PLACE, Doubt
from omote.model.fitting.find_head import HeadPlacement
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.similarity import Similarity
from omote.server.sandbox.scan_faces import LIMITS, fit_in_child
from tests.interchange.scans import scan_samples as samples

SCAN = make_scan(*samples.ball())
STILL = Similarity(1.0, np.eye(3), np.zeros(3))
SHORT = Look(hair_style=FIRST_HAIR)


def double(*doubts: Doubt, face: str = "kaori", rows: slice = slice(None)) -> tuple[HeadPlacement, Fit]:
    """A fit that found a face of the cast, whatever the scan."""
    cast = load_cast()
    positions = cast.faces[face].positions
    count = cast.space.vertex_count
    residual = np.where(np.arange(count) % 2, 0.25, np.nan)
    place = HeadPlacement(STILL, np.ones(len(SCAN.positions), bool), 0.1, "metres", {}, ())
    fitted = Face("scan", positions[rows], cast.faces[face].parts)
    return place, Fit(fitted, residual, np.ones(count), STILL, doubts)


def test_a_fit_comes_back_with_its_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = load_cast()

    def fit(*_: object, name: str, **__: object) -> tuple[HeadPlacement, Fit]:
        seconds, _hard = resource.getrlimit(resource.RLIMIT_CPU)
        return double(Doubt(f"{name} has {seconds} seconds.", EYES))

    monkeypatch.setattr(scan_face, "fit_scan", fit)
    made = fit_in_child(cast, SCAN, name="Ann", landmarks={"nose_tip": (0.0, 1.0, 2.0)})
    face, _ = made.worn
    np.testing.assert_array_equal(face.positions, cast.faces["kaori"].positions)
    for part, points in cast.faces["kaori"].parts.items():
        np.testing.assert_array_equal(face.parts[part], points)
    assert made.doubts == (f"Ann has {LIMITS.seconds} seconds.",)
    assert [doubt.kind for doubt in made.doubts] == [EYES]
    assert made.describe() == "0.25 mm from the scan (95 of 100 points within 0.25)"


def test_the_colours_of_a_scan_come_back_as_a_look(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = load_cast()
    monkeypatch.setattr(scan_face, "fit_scan", lambda *_, **__: double())
    points = cast.faces["kaori"].positions.astype(np.float64)
    green = Scan(points, cast.space.triangles, np.tile(np.array([20, 160, 60], np.uint8), (len(points), 1)))
    made = fit_in_child(cast, green, name="Ann", landmarks={})
    assert made.worn[1].albedo is not None
    assert made.notes == ()
    assert fit_in_child(cast, Scan(points, cast.space.triangles), name="Ann", landmarks={}).look == SHORT
    far = fit_in_child(cast, Scan(points + 5.0, cast.space.triangles, green.colours), name="Ann", landmarks={})
    assert far.look == SHORT
    assert far.notes[0].startswith("its colours were not taken over: ")


def test_a_failure_comes_back_and_no_other_head_does(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> tuple[HeadPlacement, Fit]:
        raise NoFaceError("there is no head in it", None, (Doubt("There is no head in it.", PLACE),))

    cast = load_cast()
    monkeypatch.setattr(scan_face, "fit_scan", refuse)
    made = fit_in_child(cast, SCAN, name="Ann", landmarks={})
    assert (made.fit, made.failure, made.doubts) == (None, "there is no head in it", ("There is no head in it.",))
    assert made.describe() == "nothing of it was seen"
    with pytest.raises(ValueError, match="no face was made of this scan: there is no head in it"):
        _ = made.worn
    monkeypatch.setattr(scan_face, "fit_scan", lambda *_, **__: double(rows=slice(9)))
    with pytest.raises(ValueError, match="9"):
        fit_in_child(cast, SCAN, name="Ann", landmarks={})
