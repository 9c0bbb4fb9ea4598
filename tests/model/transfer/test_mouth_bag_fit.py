"""The mouth bag stays inside the head: pushed behind the skin where it came out, left alone where it did not."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry.proximity import cast_level_rays, nearest_triangles, winding_numbers
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.transfer.mouth_bag_fit import (
    EXACT,
    OUT_AT_RIM,
    OUT_METRES,
    PASSED_AT_RIM,
    fit_mouth_bag,
    limit_depths,
    measure_depths,
    missing_depths,
    push_inside,
    require_depths,
)
from omote.model.transfer.paper_map import compile_expression
from omote.model.transfer.pipeline import LINEAR_INNER_STAGES, transfer_expression


def built() -> omote.Cast:
    return omote.load_cast()


def lacking(space: ParameterSpace, face: omote.Face, positions: NDArray[np.float32]) -> float:
    bag = find_mouth_bag(space)
    assert bag is not None
    return float(
        missing_depths(limit_depths(space, face), measure_depths(space, bag, positions.astype(np.float64))).max()
    )


@pytest.mark.parametrize("name", ["gaunt", "goblin", "old", "kaori"])
def test_an_open_mouth_keeps_its_bag_behind_the_cheeks(name: str) -> None:
    space = built().space
    face = built().faces[name]
    compiled = compile_expression(space, built().expressions["mouth-open"])
    loose = transfer_expression(space, face, compiled, LINEAR_INNER_STAGES)
    inside = fit_mouth_bag(space, face, loose)
    assert lacking(space, face, loose) > 10 * lacking(space, face, inside)
    assert np.array_equal(inside[space.on_sheet], loose[space.on_sheet])


@pytest.mark.parametrize(("name", "unit"), [("dog", "mouthFunnel"), ("dog", "jawLeft"), ("man", "mouthFunnel")])
def test_no_bag_comes_out_where_rays_run_along_the_skin(name: str, unit: str) -> None:
    space = built().space
    face = built().faces[name]
    bag = find_mouth_bag(space)
    assert bag is not None
    compiled = compile_expression(space, built().expressions[unit])
    worn = transfer_expression(space, face, compiled).astype(np.float64)
    corners = worn[space.location_triangles]
    points = worn[bag.vertices]
    away, nearest = nearest_triangles(corners, points)
    deep = (nearest < len(space.sheet_triangles)) & (
        bag.distance > 0.001
    )  # neither seen through the mouth nor of the lips
    assert away[deep & (winding_numbers(corners, points) < 0.5)].max(initial=0.0) < 2 * OUT_METRES


def foremost_out(space: ParameterSpace, positions: NDArray[np.floating], rows: NDArray[np.int32]) -> float:
    """How far vertices are in front of all skin on their ray from the axis, metres along its normal."""
    points = positions.astype(np.float64)
    origins = positions.astype(np.float64)[rows]
    ways = (origins - [space.cylinder.x, 0.0, space.cylinder.z]) * [1.0, 0.0, 1.0]
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    around = space.location_triangles.astype(np.int32)
    far, at = cast_level_rays(points, around, origins + 0.01 * ways, -ways)
    corners = points[around[at]]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    met = (ways * normal).sum(axis=1) / np.linalg.norm(normal, axis=1)
    return float(np.where((far > 0.01) & (far < 0.02) & (met > 0.2), (far - 0.01) * met, 0.0).max())


@pytest.mark.parametrize(("name", "amount"), [("old", 1.32), ("kaori", 1.6)])
def test_the_bag_stays_behind_lips_that_cover_each_other(name: str, amount: float) -> None:
    """A walk from the axis may end at any layer of an overhanging lip; the foremost one counts."""
    space = built().space
    face = omote.caricature(space, built().faces[name], amount)
    bag = find_mouth_bag(space)
    assert bag is not None
    rows = bag.vertices[bag.distance > 0.001]
    assert foremost_out(space, face.positions, rows) < 2e-4
    for unit in ("doubt", "contempt", "mouthSmileRight", "mouth-parling"):
        assert foremost_out(space, compound(space, face, built().expressions[unit]), rows) < 3e-4, unit


@pytest.mark.parametrize(
    ("head", "mouth", "unit"),
    [("child", "baby", "mouthRollUpper"), ("baby", "gaunt", "mouth-depression-retraction"),
     ("kaori", "round", "contempt"), ("man", "old", "sleepy")],
)  # fmt: skip
def test_beside_the_lips_no_bag_stands_out_of_skin_or_membranes(head: str, mouth: str, unit: str) -> None:
    """What lies there was seen by rays that met no skin, or another layer of it."""
    cast = built()
    space = cast.space
    bag = find_mouth_bag(cast.space)
    assert bag is not None
    face = omote.regional(space, "mix", {"mouth": cast.faces[mouth]}, rest=cast.faces[head])
    worn = compound(space, face, cast.expressions[unit]).astype(np.float64)
    corners = worn[np.concatenate([bag.skin, bag.membranes])]
    points = worn[bag.vertices[bag.rim]]
    away, _ = nearest_triangles(corners, points)
    out = (winding_numbers(corners, points) < 0.0) & (away < PASSED_AT_RIM)
    assert away[out].max(initial=0.0) < OUT_AT_RIM + 1e-5


def test_at_rest_nothing_moves() -> None:
    for face in built().faces.values():
        assert np.abs(fit_mouth_bag(built().space, face, face.positions) - face.positions).max() < EXACT, face.name


def test_the_generic_face_is_left_as_it_is_and_deep_enough_at_rest() -> None:
    space = built().space
    generic = built().faces["generic"]
    bag = find_mouth_bag(space)
    assert bag is not None
    assert missing_depths(require_depths(space, bag), measure_depths(space, bag, space.points)).max() == 0
    positions = (generic.positions + 0.01 * ~space.on_sheet[:, None]).astype(np.float32)
    assert fit_mouth_bag(space, generic, positions) is positions


def test_the_bag_follows_the_weight_without_a_jump() -> None:
    space = built().space
    face = built().faces["gaunt"]
    jaw = built().expressions["mouth-open"]
    bag = find_mouth_bag(space)
    assert bag is not None
    worn = [compound(space, face, jaw, weight)[bag.vertices] for weight in (0.799, 0.8, 0.801)]
    assert np.abs(worn[1] - worn[0]).max() < 5e-4
    assert np.abs(worn[2] - worn[1]).max() < 5e-4


def test_no_unit_brings_the_bag_out_of_the_generic_face() -> None:
    cast = built()
    bag = find_mouth_bag(cast.space)
    assert bag is not None
    for name, expression in cast.expressions.items():
        worn = compound(cast.space, cast.faces["generic"], expression).astype(np.float64)
        lack = missing_depths(require_depths(cast.space, bag), measure_depths(cast.space, bag, worn))
        assert lack.max() < 2e-4, name


def test_a_push_takes_along_only_neighbours_that_have_no_depth_to_spare() -> None:
    space = built().space
    bag = find_mouth_bag(space)
    assert bag is not None
    depth = np.minimum(measure_depths(space, bag, space.points).depth, 0.02)
    row = int(np.argmax(np.where(depth < 0.01, depth, 0.0)))
    deeper = np.arange(len(depth)) == row
    for spare, along in ((0.0, True), (0.002, False)):
        wanted = depth - spare + np.where(deeper, spare + 0.001, 0.0)
        moved = np.abs(push_inside(space, bag, wanted, space.points) - space.points[bag.vertices]).max(axis=1) > 1e-9
        assert moved[row]
        assert bool(np.count_nonzero(moved) > 1) is along
