"""The lining of the eye sockets is found behind the lids."""

from __future__ import annotations

import numpy as np

import omote
from omote.model.transfer.eyes.socket_skin import find_socket_lining, measure_depth_behind
from tests.synthetic import space

CAST = omote.load_cast()


def test_the_lining_is_inner_skin_behind_the_lids_and_is_found_once() -> None:
    found = find_socket_lining(CAST.space)
    assert found is not None
    assert find_socket_lining(CAST.space) is found
    assert not CAST.space.on_sheet[found.vertices].any()
    middles = [CAST.space.points[line.loop].mean(axis=0) for line in CAST.space.lines if line.kind == "lids"]
    away = np.min([np.linalg.norm(CAST.space.points[found.vertices] - middle, axis=1) for middle in middles], axis=0)
    assert away.max() < 0.05
    assert set(found.vertices) | set(found.skin.ravel()) == set(found.region)


def test_what_lies_deep_is_hidden_and_deep_on_the_generic_head_itself() -> None:
    found = find_socket_lining(CAST.space)
    assert found is not None
    depth, inward = measure_depth_behind(CAST.space, found.skin, found.vertices, CAST.space.points)
    assert (depth[np.isfinite(found.least)] >= found.least[np.isfinite(found.least)]).all()
    assert found.hidden[np.isfinite(found.least)].all()
    assert np.allclose(np.linalg.norm(inward, axis=1), 1.0)


def test_a_head_without_lids_has_none() -> None:
    assert find_socket_lining(space()) is None
