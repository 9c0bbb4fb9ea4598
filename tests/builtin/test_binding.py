"""What hangs on what: still parts, parts of the jaw, lashes."""

import numpy as np
import pytest

from omote import load_cast
from omote.builtin.binding import AXIS, JAW, LASHES, PARTS, STILL, PartMesh, head_space
from omote.model.transfer.compound import predicted

SPACE = load_cast().space
MOTION = np.random.default_rng(2).normal(scale=0.01, size=(SPACE.vertex_count, 3))


def test_every_part_is_bound_and_the_axis_is_the_designs() -> None:
    assert tuple(SPACE.parts) == PARTS
    assert (SPACE.cylinder.x, SPACE.cylinder.z) == AXIS


@pytest.mark.parametrize("name", STILL)
def test_eyeballs_and_upper_teeth_stay_in_the_head(name: str) -> None:
    assert not predicted(SPACE, name, MOTION).any()


@pytest.mark.parametrize("name", JAW)
def test_lower_teeth_and_tongue_go_with_the_jaw_as_one_piece(name: str) -> None:
    moved = predicted(SPACE, name, MOTION)
    assert np.ptp(moved, axis=0).max() < 1e-12
    jaw = np.unique(SPACE.parts[name].anchors)
    np.testing.assert_allclose(moved[0], MOTION[jaw].mean(axis=0))


def test_lashes_go_with_the_lids() -> None:
    shift = np.array([0.001, -0.002, 0.003])
    everywhere = np.broadcast_to(shift, MOTION.shape)
    np.testing.assert_allclose(predicted(SPACE, LASHES, everywhere), np.broadcast_to(shift, (250, 3)))
    lids = SPACE.points[np.unique(SPACE.parts[LASHES].anchors)]
    assert (np.abs(lids[:, 1]) < 0.012).all()


def test_a_missing_part_is_refused() -> None:
    parts = {name: PartMesh(part.points, part.triangles) for name, part in SPACE.parts.items() if name != "tongue"}
    with pytest.raises(KeyError, match="tongue"):
        head_space(SPACE.points, SPACE.triangles, parts, np.arange(50, dtype=np.int32))
