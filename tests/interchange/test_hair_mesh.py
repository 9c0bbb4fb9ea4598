"""Hair as a mesh: ribbons as wide as the style says, that go where their anchors go."""

import numpy as np

from omote.geometry import mesh
from omote.interchange.export_face import hair_shape
from omote.interchange.formats.glb_writer import MorphTarget
from omote.model.cast import Look
from omote.model.hair import place_strands
from tests.model.tufts import tuft
from tests.synthetic import space

POINTS = space().points


def test_ribbons_lie_along_the_strands_and_follow_their_anchors() -> None:
    style = tuft()
    moves = np.random.default_rng(1).normal(size=POINTS.shape).astype(np.float32)
    shape = hair_shape(style, POINTS, 1.5 * POINTS, {"x": MorphTarget(moves, moves)}, Look())
    count, places = style.points.shape[:2]
    edges = shape.points.reshape(count, places, 2, 3)
    np.testing.assert_allclose(edges.mean(axis=2), place_strands(style, POINTS, 1.5 * POINTS), atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(edges[:, :, 1] - edges[:, :, 0], axis=2), style.width, rtol=1e-4)
    moved = shape.targets["x"].moves.reshape(count, -1, 3)
    np.testing.assert_array_equal(moved, np.broadcast_to(moves[style.anchors][:, None], moved.shape))
    assert not shape.targets["x"].turns.any()


def test_ribbons_face_as_their_normals_say() -> None:
    shape = hair_shape(tuft(), POINTS, POINTS, {}, Look())
    corners = shape.points[shape.triangles].astype(np.float64)
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("tc,tc->t", faces, shape.normals[shape.triangles].mean(axis=1)) >= 0.0).all()
    assert mesh.areas(shape.points.astype(np.float64), shape.triangles.astype(np.int32)).min() > 0.0
