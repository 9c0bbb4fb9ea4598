"""Skin of a scan: what lies between lids and lips is not; shut eyes are told from open ones."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.geometry import mesh
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.scan_skin import keep_skin, may_be_shut, squares_around_eyes
from omote.model.fitting.scan_surface import ScanSurface, sample_cloud, sample_mesh
from omote.perform.frame import Frame

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


def people() -> dict[str, dict[str, float]]:
    """Every face of the cast, and mixes of three by a seed."""
    draw = np.random.default_rng(33)
    names = sorted(CAST.faces)
    mixes = {
        f"mix {at}": dict(zip(draw.choice(names, 3, False), draw.dirichlet(np.ones(3)), strict=True)) for at in range(6)
    }
    return {name: {name: 1.0} for name in names} | mixes


@pytest.mark.parametrize("faces", people().values(), ids=people().keys())
def test_lids_that_meet_are_told_from_open_ones_on_every_head(faces: dict[str, float]) -> None:
    blink = {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}
    head = omote.evaluate(CAST, Frame(faces, {"neutral": 1.0})).astype(np.float64)
    for channels in ({}, blink, {"eyeBlinkLeft": 1.0}):
        worn = omote.evaluate(CAST, Frame(faces, {"neutral": 1.0}, channels=channels)).astype(np.float64)
        assert may_be_shut(SPACE, (worn, SPACE.triangles), head) is (channels == blink)
        for off in (-0.003, 0.003):  # as far a fit may lie beside the lids, which are no part of it
            assert may_be_shut(SPACE, (worn, SPACE.triangles), head + np.array([0.0, off, 0.0])) is (channels == blink)


@pytest.mark.parametrize("face", ["generic", "man", "kaori"])
def test_a_cloud_tells_the_same(face: str) -> None:
    head = CAST.faces[face].positions.astype(np.float64)
    outside = (head, mesh.normals(head, SPACE.triangles))
    for blink in (0.0, 1.0):
        channels = {"eyeBlinkLeft": blink, "eyeBlinkRight": blink}
        worn = omote.evaluate(CAST, Frame({face: 1.0}, {"neutral": 1.0}, channels=channels)).astype(np.float64)
        points = sample_mesh(worn, SPACE.triangles, BOX, 0.03).points[::5]
        skin = keep_skin(sample_cloud(points, outside, BOX, 0.03), ZONES, head)
        assert may_be_shut(SPACE, squares_around_eyes(SPACE, skin, head), head) is (blink == 1.0)
