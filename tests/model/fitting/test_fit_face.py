"""Fits of scans: somebody of the cast is found again, in any unit and turned; what is wrong is refused or said."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting import fit_face as module
from omote.model.fitting.fit_face import Fit, fit_face
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.space.face_fit import fit
from omote.model.space.parts import eye_rotation
from omote.model.space.similarity import Similarity

CAST = omote.load_cast()
SPACE = CAST.space
MODES = load_identity_modes()
ZONES = head_zones(CAST.space)
ROWS = find_landmarks(SPACE)
KAORI = CAST.faces["kaori"].positions.astype(np.float64)
RAISED = np.array([0.0, 0.1, 0.0])
HERE = Similarity(1.0, np.eye(3), np.zeros(3))


@pytest.fixture(scope="module")
def kaori() -> Fit:
    """Kaori's skin as a scan in millimetres, turned a little, with two landmarks."""
    turn = eye_rotation(0.1, 0.05)
    told = list[float]()
    points = 1000.0 * (KAORI + RAISED) @ turn.T
    back = Similarity(0.001, turn.T, -RAISED)
    marks = {name: points[ROWS[name]] for name in ("nose_tip", "mouth_left")}
    found = fit_face(SPACE, MODES, Scan(points, SPACE.triangles), back, landmarks=marks, name="Kaori",
                     follow=lambda done, what: told.append(done))  # fmt: skip
    assert told[0] == 0.0
    assert told[-1] == 1.0
    assert told == sorted(told)
    return found


def test_somebody_of_the_cast_is_found_again_without_doubt(kaori: Fit) -> None:
    assert kaori.doubts == ()
    assert np.nanmedian(kaori.residual[ZONES.face]) < 0.05
    assert fit(SPACE, kaori.face).positions.shape == KAORI.shape
    assert kaori.face.name == "Kaori"


def test_a_mirrored_scan_is_asked_about() -> None:
    found = fit_face(SPACE, MODES, Scan(KAORI * [-1.0, 1.0, 1.0], SPACE.triangles), HERE)
    assert [doubt for doubt in found.doubts if "mirrored" in doubt]
    assert np.nanmedian(found.residual[ZONES.face]) < 0.05


def test_the_placement_brings_the_scan_onto_the_face(kaori: Fit) -> None:
    turn = eye_rotation(0.1, 0.05)
    placed = kaori.placement(1000.0 * (KAORI + RAISED) @ turn.T)
    away = np.linalg.norm(placed - kaori.face.positions, axis=1)[ZONES.face]
    assert np.median(away) < 0.002  # along the skin it may lie elsewhere
    assert kaori.placement.scale == pytest.approx(0.001)
    assert np.allclose(kaori.placement.rotation @ kaori.placement.rotation.T, np.eye(3))


def test_eyes_lie_midway_where_the_generic_ones_do(kaori: Fit) -> None:
    for points in (kaori.face.parts, {name: part.points for name, part in SPACE.parts.items()}):
        middle = (points["eye_left"].mean(axis=0) + points["eye_right"].mean(axis=0)) / 2
        assert middle[1] == pytest.approx(0.0, abs=1e-4)


def test_what_was_not_scanned_is_not_seen_and_has_no_residual() -> None:
    front = SPACE.triangles[(KAORI[SPACE.triangles][:, :, 2] > 0.06).all(axis=1)]
    found = fit_face(SPACE, MODES, Scan(KAORI, front), HERE)
    back = SPACE.on_sheet & (found.face.positions[:, 2] < 0.03)
    assert not found.seen[back].any()
    assert np.isnan(found.residual[back]).all()
    assert np.nanmedian(found.residual[ZONES.face]) < 0.05


def test_a_cloud_of_points_does_as_well() -> None:
    draw = np.random.default_rng(1)
    corners = KAORI[SPACE.sheet_triangles[draw.integers(len(SPACE.sheet_triangles), size=40_000)]]
    shares = draw.dirichlet(np.ones(3), size=len(corners))
    found = fit_face(SPACE, MODES, Scan(np.einsum("nk,nkc->nc", shares, corners)), HERE, shut=False)
    assert np.nanmedian(found.residual[ZONES.face]) < 0.2


def test_unknown_landmarks_and_other_heads_are_refused() -> None:
    scan = Scan(KAORI, SPACE.triangles)
    with pytest.raises(ValueError, match="no landmark 'ear'"):
        fit_face(SPACE, MODES, scan, HERE, landmarks={"ear": [0, 0, 0]})
    with pytest.raises(ValueError, match="no surface where the head is"):
        fit_face(SPACE, MODES, scan, Similarity(1.0, np.eye(3), np.full(3, 5.0)))


@pytest.mark.slow
def test_only_who_was_said_to_be_a_head_is_moved_back_to_stand_around_the_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    scan = Scan(KAORI, SPACE.triangles)
    marks = {"nose_tip": KAORI[ROWS["nose_tip"]]}
    plain = fit_face(SPACE, MODES, scan, HERE, landmarks=marks)
    monkeypatch.setattr(module, "find_way_back", lambda *_: 0.01)
    moved = fit_face(SPACE, MODES, scan, HERE, landmarks=marks)
    np.testing.assert_allclose(moved.face.positions, plain.face.positions - [0.0, 0.0, 0.01], atol=2e-4)
    with pytest.raises(ValueError, match="too flat or too crooked"):
        fit_face(SPACE, MODES, scan, HERE)
    monkeypatch.setattr(module, "find_way_back", lambda *_: None)
    with pytest.raises(ValueError, match="points on eyes, nose and mouth help"):
        fit_face(SPACE, MODES, scan, HERE, landmarks=marks)


def test_folds_of_the_head_that_the_modes_give_are_told_where_they_cannot_be_eased(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Folds were sought against that head alone, so what it has itself was found nowhere."""
    person = MODES.shape_skin(1.5 * np.random.default_rng(8).standard_normal(len(MODES.moves)))
    scan = Scan(person, SPACE.triangles)
    eased = fit_face(SPACE, MODES, scan, HERE)
    assert not [doubt for doubt in eased.doubts if "folded" in doubt]
    monkeypatch.setattr(module, "ease_creases", lambda space, plain, head: head)
    told = fit_face(SPACE, MODES, scan, HERE)
    assert [doubt for doubt in told.doubts if "folded" in doubt]
