"""The control net: a periodic partition of S, eq. 1 and eq. 2, drags on any face."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.controls.control_net import ControlNet
from omote.model.transfer.compound import compound
from tests.synthetic import cast, space


def scattered(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    low, high = np.quantile(space().h[space().on_sheet], [0.05, 0.95])
    return rng.uniform(-np.pi, np.pi, count), rng.uniform(low, high, count)


def net(count: int = 100, seed: int = 0) -> ControlNet:
    return ControlNet.build(space(), *scattered(count, seed))


@given(st.integers(24, 60), st.integers(0, 50))
def test_the_net_is_an_annulus_and_covers_every_vertex_with_weights_of_one(count: int, seed: int) -> None:
    made = net(count, seed)
    assert len(made.triangles) == 2 * len(made.theta) - 32  # Euler: an annulus with 16 points on either rim
    assert (np.sort(mesh.boundary_edges(made.triangles).ravel()).reshape(-1, 2)[:, 0] >= made.own).all()
    assert np.allclose(made.basis.sum(axis=1)[space().on_sheet], 1.0)
    assert made.basis.data.min() >= -1e-9
    assert (made.basis.sum(axis=1)[~space().on_sheet] == 0).all()


def test_eq_2_is_linear_and_a_constant_is_reproduced() -> None:
    made = net()
    constant = made.expression(np.tile([0.01, -0.002, 1.1], (len(made.theta), 1)))
    sheet = space().on_sheet
    assert np.allclose(constant.dtheta[sheet], 0.01)
    assert np.allclose(constant.dh[sheet], -0.002)
    assert np.allclose(constant.ratio[sheet], 1.1)
    rng = np.random.default_rng(4)
    a, b = rng.normal([0, 0, 1], 0.01, (2, made.own, 3))
    both = made.expression((a + b) / 2)
    assert np.allclose(both.dh, (made.expression(a).dh + made.expression(b).dh) / 2)


def test_turning_all_points_once_around_changes_nothing() -> None:
    theta, h = scattered(40, 2)
    values = np.random.default_rng(1).normal([0, 0, 1], 0.01, (40, 3))
    a = ControlNet.build(space(), theta, h).expression(values)
    b = ControlNet.build(space(), theta + 2 * np.pi, h).expression(values)
    assert np.allclose(a.dtheta, b.dtheta)


def test_a_drag_on_any_face_is_undone_by_the_point_it_leads_to() -> None:
    """Dragging point i of a face to where point j lies gives exactly the way from i to j on S."""
    made = net(30, 3)
    for face in cast().faces.values():
        places = made.points_on(face)
        for i, j in ((0, 1), (5, 9), (20, 3)):
            dtheta, dh = made.drag(face, i, places[j])
            assert np.isclose(wrap(np.array(dtheta - made.theta[j] + made.theta[i])), 0.0, atol=1e-4)
            assert np.isclose(dh, made.h[j] - made.h[i], atol=1e-5)


def test_what_the_artist_writes_moves_every_face() -> None:
    made = net()
    values = np.tile([0.0, 0.004, 1.0], (made.own, 1))
    for face in cast().faces.values():
        lifted = compound(space(), face, made.expression(values)) - face.positions
        assert np.median(lifted[space().on_sheet, 1]) > 0.002


def test_nets_are_refused() -> None:
    theta, h = scattered(5, 1)
    with pytest.raises(ValueError, match=r"expected two arrays \(n,\) with n >= 3"):
        ControlNet.build(space(), theta[:2], h[:2])
    with pytest.raises(ValueError, match="control point 0 is at theta = nan"):
        ControlNet.build(space(), np.r_[np.nan, theta[1:]], h)
    with pytest.raises(ValueError, match=r"control point 4 .* with h between"):
        ControlNet.build(space(), theta, np.r_[h[:4], 9.0])
    with pytest.raises(ValueError, match="join each other around both sides"):
        ControlNet.build(space(), *scattered(3, 2))
    with pytest.raises(ValueError, match="at the same place"):
        ControlNet.build(space(), np.r_[theta, theta[0]], np.r_[h, h[0]])
    made = net()
    with pytest.raises(ValueError, match=r"values has shape \(2, 3\)"):
        made.expression(np.ones((2, 3)))
    with pytest.raises(ValueError, match=r"values\[0\].*positive R"):
        made.expression(np.zeros((made.own, 3)))
    with pytest.raises(ValueError, match="control point 100 does not exist; expected 0 to 99"):
        made.drag(cast().faces["generic"], 100, [0, 0, 0])
    with pytest.raises(ValueError, match=r"target\[0\]"):
        made.drag(cast().faces["generic"], 0, [0, np.nan, 0])
