"""Skin of a scan: what lies between lids and lips is not; shut eyes are told from open ones."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.scan_skin import keep_skin, may_be_shut
from omote.model.fitting.scan_surface import ScanSurface, sample_mesh
from omote.model.space.face_fit import generic_face

CAST = omote.load_cast()
SPACE = CAST.space
ZONES = head_zones(CAST.space)
BOX = np.stack([SPACE.points.min(axis=0), SPACE.points.max(axis=0)])


def scan_of(skin: np.ndarray) -> tuple[ScanSurface, int]:
    """A skin with the generic eyes and teeth, and how many sheets the skin alone is."""
    every = [skin]
    corners = [SPACE.triangles]
    start = len(skin)
    for name, part in SPACE.parts.items():
        if name != "lashes":
            every.append(part.points)
            corners.append(part.triangles + start)
            start += len(part.points)
    alone = sample_mesh(skin, SPACE.triangles, BOX, 0.03)
    return sample_mesh(np.vstack(every), np.vstack(corners), BOX, 0.03), np.unique(alone.component).size


def test_eyes_and_teeth_are_left_out_and_skin_stays() -> None:
    scan, _ = scan_of(SPACE.points)
    kept = keep_skin(scan, ZONES, SPACE.points)
    away, _ = kept.tree.query(np.vstack([SPACE.parts[name].points for name in ("teeth_upper", "tongue")]))
    assert len(kept.points) < len(scan.points)
    assert kept.measure_distance(SPACE.points[ZONES.closed]).max() < 0.001
    assert np.quantile(away, 0.5) > 0.001


def test_eyes_are_shut_where_the_lids_meet_before_the_ball() -> None:
    shut = omote.compound(SPACE, generic_face(SPACE), CAST.expressions["eyeBlinkLeft"])
    both = omote.compound(SPACE, generic_face(SPACE), CAST.expressions["eyeBlinkRight"]).astype(np.float64)
    closed = shut.astype(np.float64) + both - SPACE.points
    for skin, answer in ((SPACE.points, False), (closed, True)):
        surface = keep_skin(sample_mesh(skin, SPACE.triangles, BOX, 0.03), ZONES, SPACE.points)
        assert may_be_shut(SPACE, surface, SPACE.points) is answer
