"""Tangents: exact on the generic head in the limit, near on every face."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.controls.default_net import default_net
from omote.model.controls.net_field import build_net_field
from omote.model.controls.tangents import generic_tangents, tangents
from omote.model.recipes.compose_expression import add_field
from omote.model.transfer.compound import compound

CAST = omote.load_cast()


def test_the_generic_head_keeps_cylinder_coordinates() -> None:
    """A turn of all vertices is a rotation, a lift a translation, R a widening: the tangents are their derivatives."""
    space = CAST.space
    turn, lift, swell = generic_tangents(space)[:, space.on_sheet]
    points = space.points[space.on_sheet]
    away = points - [space.cylinder.x, 0.0, space.cylinder.z]
    assert np.allclose((turn * away * [1, 0, 1]).sum(axis=1), 0.0)
    assert np.allclose(np.hypot(turn[:, 0], turn[:, 2]), np.hypot(away[:, 0], away[:, 2]))
    assert np.allclose(lift, [0, 1, 0])
    assert np.allclose(swell, away * [1, 0, 1])
    assert not generic_tangents(space)[:, ~space.on_sheet].any()


@pytest.mark.parametrize("name", ["kaori", "baby", "dog"])
def test_a_drag_of_five_millimetres_is_nearly_its_tangent(name: str) -> None:
    space = CAST.space
    face = CAST.faces[name]
    made = build_net_field(space, default_net(space))
    slope = tangents(space, face)
    found = []
    for point in range(2, len(made.rows), 9):
        vectors = np.tile([0.0, 0.0, 1.0], (len(made.rows), 1))
        vectors[point] += [0.02, 0.003, 0.02]
        field = made.field(vectors)
        way = compound(space, face, add_field(space, None, field)).astype(np.float64) - face.positions
        moved = space.on_sheet & (np.linalg.norm(way, axis=1) > 2e-4)
        apart = np.linalg.norm(np.einsum("vk,kvc->vc", field, slope) - way, axis=1)
        found.append(np.median(apart[moved] / np.linalg.norm(way[moved], axis=1)))
    assert np.median(found) < 0.1
