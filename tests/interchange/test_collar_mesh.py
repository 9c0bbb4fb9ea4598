"""The collar of exported heads: closed below, around the rim of every neck, and left alone by expressions."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry import mesh
from omote.interchange.collar_mesh import COLUMNS, collar_shape, neck_rim
from omote.interchange.formats.glb_writer import MorphTarget

FACES = tuple(load_cast().faces)


@pytest.mark.parametrize("name", FACES)
def test_a_collar_hides_the_rim_of_a_neck_and_is_closed_below(name: str) -> None:
    cast = load_cast()
    positions = cast.faces[name].positions
    moved = MorphTarget(np.ones((3, 3), np.float32), np.ones((3, 3), np.float32))
    shape = collar_shape(cast.space, positions, {"jawOpen": moved})
    assert not shape.targets["jawOpen"].moves.any()
    edges = mesh.boundary_edges(shape.triangles.astype(np.int32))
    assert set(edges.ravel().tolist()) == set(range(COLUMNS)), "it is open at its first ring alone, within the neck"
    rings = shape.points[:-1].reshape(-1, COLUMNS, 3).astype(float)
    rim = positions[neck_rim(cast.space)].astype(float)
    assert rings[..., 1].min() < rim[:, 1].min() < rim[:, 1].max() < rings[..., 1].max()
    middle = rings[0].mean(axis=0)
    angles = np.arctan2(*(rim - middle)[:, [0, 2]].T)
    widest = np.hypot(*(rings - middle)[..., [0, 2]].transpose(2, 0, 1)).max(axis=0)
    around = np.interp(angles, 2 * np.pi * np.arange(COLUMNS + 1) / COLUMNS, [*widest, widest[0]], period=2 * np.pi)
    assert (np.hypot(*(rim - middle)[:, [0, 2]].T) < around).all()


def test_a_collar_faces_outwards() -> None:
    cast = load_cast()
    shape = collar_shape(cast.space, cast.faces["generic"].positions, {})
    points = shape.points.astype(float)
    a, b, c = points[shape.triangles].transpose(1, 0, 2)
    away = np.cross(b - a, c - a)
    assert (a * away).sum() > 0.0, "its volume is counted outwards"
    assert away[-1, 1] < 0.0, "its bottom looks down"
