"""The default control points: about a hundred, symmetric, where the face moves."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.controls.default_net import COUNT, default_net
from omote.model.controls.mirror import mirror_rows
from omote.model.controls.net_field import build_net_field
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import Recipe
from omote.model.space.head_regions import region_weights
from omote.model.space.lid_lip_lines import chains
from omote.model.transfer.compound import compound
from tests import synthetic


def test_about_a_hundred_points_each_with_its_mirror_image() -> None:
    space = omote.load_cast().space
    rows = default_net(space)
    assert COUNT <= len(rows) <= COUNT + 1
    assert len(set(rows)) == len(rows)
    assert space.on_sheet[list(rows)].all()
    assert set(mirror_rows(space)[list(rows)]) == set(rows)
    assert all(place >= 0 for place in build_net_field(space, rows).mirror)


def test_every_lid_and_lip_has_its_corners_and_points_on_both_edges() -> None:
    space = omote.load_cast().space
    rows = set(default_net(space))
    for line in space.lines:
        upper, lower = chains(space.points, line.loop)
        assert {upper[0], upper[-1]} <= rows
        for chain in (upper, lower):
            assert len(rows & set(chain[1:-1].tolist())) >= (3 if line.kind == "lids" else 5)


@pytest.mark.parametrize("name", ["generic", "kaori", "old", "child", "baby", "noh"])
@pytest.mark.parametrize("way", [(0.0, 0.01, 0.0), (0.1, 0.007, 0.05), (0.1, 0.0, 0.0), (0.0, -0.01, 0.0)])
def test_lips_whose_points_go_as_their_place_on_the_edge_says_stay_closed(
    name: str, way: tuple[float, float, float]
) -> None:
    cast = omote.load_cast()
    space = cast.space
    net = default_net(cast.space)
    line = next(line for line in space.lines if line.kind == "lips")
    vectors = np.tile([0.0, 0.0, 1.0], (len(net), 1))
    place = {row: at for at, row in enumerate(net)}
    for chain in chains(space.points, line.loop):
        steps = np.linalg.norm(np.diff(space.points[chain], axis=0), axis=1)
        shares = np.append(0.0, np.cumsum(steps)) / steps.sum()
        for row, share in zip(chain, shares, strict=True):
            if int(row) in place:
                vectors[place[int(row)]] = np.add([0.0, 0.0, 1.0], np.multiply(way, max(0.0, 2.0 * share - 1.0) ** 2))
    worn = compose_expression(space, Recipe(net, tuple((a, b, c) for a, b, c in vectors.tolist())), {})
    face = cast.faces[name]
    opening = line.rungs(compound(space, face, worn).astype(np.float64)) - line.rungs(face.positions.astype(np.float64))
    assert opening[:, 1].max() < 5e-4


def test_most_points_stand_where_expressions_move() -> None:
    space = omote.load_cast().space
    rows = list(default_net(space))
    weights = region_weights(space)
    face = sum(weights[region][rows].sum() for region in ("brows", "eyes", "nose", "cheeks", "mouth", "jaw"))
    assert face > 0.7 * len(rows)


def test_one_head_has_one_net_and_another_head_one_too() -> None:
    assert default_net(omote.load_cast().space) == default_net(omote.load_cast().space)
    egg = synthetic.space()
    made = build_net_field(egg, default_net(egg))
    assert np.allclose(made.net.basis.sum(axis=1)[egg.on_sheet], 1.0)
