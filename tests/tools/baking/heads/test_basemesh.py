"""Reading the base mesh and its targets."""

import numpy as np
import pytest

from tools.baking.heads.basemesh import read_base_mesh, read_target
from tools.baking.package import BakeError

MESH = """# two quads in two groups
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
v 2 1 0
vt 0 0
vt 0.5 1
g body
f 1/1 2/1 3/2 4/2
g helper-tongue
f 2/2 5/2 6/1 3/1
"""


def test_quads_are_read_by_group_from_zero() -> None:
    base = read_base_mesh(MESH)
    assert base.points.shape == (6, 3)
    np.testing.assert_array_equal(base.uvs, [[0, 0], [0.5, 1]])
    assert set(base.groups) == {"body", "helper-tongue"}
    np.testing.assert_array_equal(base.groups["body"].corners, [[0, 1, 2, 3]])
    np.testing.assert_array_equal(base.groups["helper-tongue"].uv_corners, [[1, 1, 0, 0]])


@pytest.mark.parametrize("face", ["f 1/1 2/1 3/2", "f 1 2 3 4", "f 1/ 2/1 3/2 4/2"])
def test_faces_that_are_no_textured_quads_are_refused(face: str) -> None:
    with pytest.raises(BakeError, match=r"line 14 of the base mesh .*expected four corners with texture coordinates"):
        read_base_mesh(MESH + face)


def test_targets_move_the_vertices_they_name() -> None:
    moved = read_target("# comment\n1 .5 -.25 0\n\n4 0 0 1e-3\n", 6)
    expected = np.zeros((6, 3))
    expected[1], expected[4] = [0.5, -0.25, 0], [0, 0, 0.001]
    np.testing.assert_array_equal(moved, expected)


def test_an_empty_target_moves_nothing() -> None:
    assert not read_target("# nothing\n", 3).any()


@pytest.mark.parametrize("line", ["6 0 0 1", "-1 0 0 1", "1 0 0"])
def test_targets_of_another_mesh_are_refused(line: str) -> None:
    with pytest.raises(BakeError, match=r"a target names vertex .*expected 4 and under 6"):
        read_target(line, 6)
