"""Scenes as viewers show them at rest: nodes, joints and default weights, whichever reader asks."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_scan import read_gltf
from omote.model.fitting.scan import Scan
from tests.interchange.formats.gltf_files import ball_file
from tests.interchange.scans import scan_samples as samples

POINTS, TRIANGLES = samples.ball()
MOVES = np.random.default_rng(4).normal(0.0, 0.1, (2, *POINTS.shape)).astype("<f4").astype(np.float64)
TARGETS = dict(zip(("Ann", "smile"), MOVES, strict=True))
ATOL = 2e-5

numbers = st.floats(-3.0, 3.0)
triples = st.tuples(numbers, numbers, numbers)
scales = st.tuples(*[st.sampled_from([-2.0, -1.0, 0.5, 1.0, 3.0])] * 3)


def read_both(data: bytes) -> tuple[Scan, Any, list[str]]:
    """The scan and the only piece of a file, and what both readers say."""
    beside = Companions()
    scan = read_gltf(data, beside)
    said: list[str] = []
    (piece,) = read_glb(data, note=said.append)
    return scan, piece, [*beside.notes, *said]


def volume(points: np.ndarray, triangles: np.ndarray) -> float:
    """Positive where triangles wind counter-clockwise seen from outside."""
    a, b, c = (points[triangles[:, at]] for at in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


@given(st.lists(st.tuples(triples, st.tuples(numbers, numbers, numbers, numbers), scales, st.booleans()), max_size=3))
def test_nodes_of_every_sort_place_a_mesh_and_its_moves(chain: list[Any]) -> None:
    """Nested, by a matrix or by parts, turned by any quaternion, scaled unevenly, mirrored: the outside stays out."""
    place = np.eye(4)
    nodes: list[dict[str, Any]] = []
    for shift, quad, scale, by_matrix in chain:
        length = float(np.linalg.norm(quad))
        turn = Rotation.from_quat(quad).as_matrix() if length > 1e-3 else np.eye(3)
        own = np.eye(4)
        own[:3, :3], own[:3, 3] = turn * scale, shift
        place = place @ own
        parts = {"translation": shift, "scale": scale} | ({"rotation": quad} if length > 1e-3 else {})
        nodes.append(({"matrix": own.T.reshape(-1).tolist()} if by_matrix else parts) | {"children": [len(nodes) + 1]})
    nodes.append({"mesh": 0})
    scan, piece, said = read_both(ball_file(targets=TARGETS, nodes=nodes))
    expected = POINTS @ place[:3, :3].T + place[:3, 3]
    np.testing.assert_allclose(scan.positions, expected, atol=ATOL * np.abs(place).max())
    np.testing.assert_array_equal(piece.points, scan.positions)
    for name, moves in TARGETS.items():
        np.testing.assert_allclose(scan.shapes[name], moves @ place[:3, :3].T, atol=ATOL * np.abs(place).max())
        np.testing.assert_array_equal(piece.moves[name], scan.shapes[name])
    assert scan.triangles is not None
    assert volume(scan.positions - expected.mean(axis=0), scan.triangles) > 0.0
    assert said == []


@pytest.mark.parametrize("where", ["mesh", "node", "both"])
def test_default_weights_are_worn_and_those_of_a_node_come_before_its_meshs(where: str) -> None:
    mesh = {"weights": [1.0, 0.25]} if where == "mesh" else {"weights": [0.0, 0.5]} if where == "both" else {}
    node: dict[str, Any] = {"mesh": 0} | ({"weights": [1.0, 0.25]} if where != "mesh" else {})
    scan, piece, said = read_both(ball_file(targets=TARGETS, mesh=mesh, nodes=[node]))
    for points, moves in ((scan.positions, scan.shapes), (piece.points, piece.moves)):
        np.testing.assert_allclose(points, POINTS + MOVES[0] + 0.25 * MOVES[1], atol=ATOL)
        assert list(moves) == ["smile"]
        np.testing.assert_allclose(points + moves["smile"], POINTS + MOVES[0] + MOVES[1], atol=ATOL)
    assert said == ["its shape 'Ann' is worn at rest, so it is part of the face and no expression"] * 2


def rigged(weights: np.ndarray, joints: np.ndarray, **more: np.ndarray) -> bytes:
    """The ball on two joints, below a node that stands elsewhere."""
    attributes = {"JOINTS_0": joints.astype("<u1"), "WEIGHTS_0": weights.astype("<f4"), **more}
    nodes: list[dict[str, Any]] = [
        {"mesh": 0, "skin": 0, "scale": [9, 9, 9]}, {"translation": [0, 0, 3]}, {"translation": [5, 0, 0]},
    ]  # fmt: skip
    return ball_file(targets=TARGETS, attributes=attributes, nodes=nodes, skins=[{"joints": [1, 2]}])


def test_what_no_joint_holds_follows_the_first_and_the_rest_its_own() -> None:
    """A third of the ball has no weights, or weights that are none; the others share two joints."""
    rng = np.random.default_rng(6)
    weights = np.concatenate([rng.random((len(POINTS), 2)), np.zeros((len(POINTS), 2))], axis=1)
    weights[::3] = 0.0
    weights[::6, 1] = np.nan
    joints = np.tile([0, 1, 0, 0], (len(POINTS), 1))
    held = np.where(np.isfinite(weights), weights, 0.0)[:, :2] + [1e-12, 0.0]
    share = (held[:, 0] / held.sum(axis=1))[:, None]
    scan, piece, _ = read_both(rigged(weights, joints))
    np.testing.assert_allclose(scan.positions, POINTS + share * [0, 0, 3] + (1 - share) * [5, 0, 0], atol=ATOL)
    np.testing.assert_array_equal(piece.points, scan.positions)


def test_eight_joints_may_hold_a_vertex_and_those_without_weight_are_any() -> None:
    first = np.tile([0.25, 0, 0, 0], (len(POINTS), 1))
    more = {"JOINTS_1": np.tile([1, 99, 0, 0], (len(POINTS), 1)).astype("<u1")}
    more["WEIGHTS_1"] = np.tile([0.75, 0, 0, 0], (len(POINTS), 1)).astype("<f4")
    scan, _, _ = read_both(rigged(first, np.tile([0, 77, 0, 0], (len(POINTS), 1)), **more))
    np.testing.assert_allclose(scan.positions, POINTS + np.array([3.75, 0, 0.75]), atol=ATOL)


@pytest.mark.parametrize(
    ("extras", "names"),
    [
        ([], ["target_0", "target_1"]),
        (None, ["target_0", "target_1"]),
        ("x", ["target_0", "target_1"]),
        ({"targetNames": 3}, ["target_0", "target_1"]),
        ({"targetNames": [None, "b"]}, ["target_0", "b"]),
        ({"targetNames": [["a"], {}]}, ["target_0", "target_1"]),
        ({"targetNames": {"b": 1, "a": 0, "c": 7, "d": "x"}}, ["a", "b"]),
        ({"targetNames": ["a"]}, ["a", "target_1"]),
    ],
)
def test_extras_may_be_any_json_and_every_target_has_a_name_of_its_own(extras: Any, names: list[str]) -> None:
    scan, piece, said = read_both(ball_file(targets=TARGETS, mesh={"extras": extras}))
    assert list(scan.shapes) == list(piece.moves) == names
    assert said == []


def test_two_shapes_of_one_name_are_told_apart_and_said() -> None:
    scan, piece, said = read_both(ball_file(targets=TARGETS, mesh={"extras": {"targetNames": ["a 1", "a 1"]}}))
    assert list(scan.shapes) == list(piece.moves) == ["a 1", "a 1 1"]
    assert said == ["two of its shapes are named 'a 1': the second is read as 'a 1 1'"] * 2


json_values = st.recursive(
    st.none() | st.booleans() | st.integers(-2, 9) | st.text(max_size=3),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["targetNames", "x"]), inner, max_size=2)
    ),
    max_leaves=6,
)


@given(json_values)
def test_no_extras_cost_a_shape(extras: Any) -> None:
    scan, piece, _ = read_both(ball_file(targets=TARGETS, mesh={"extras": extras}))
    assert [*map(id, scan.shapes)] != []
    np.testing.assert_allclose(np.stack([*scan.shapes.values()]), MOVES, atol=ATOL)
    assert list(piece.moves) == list(scan.shapes)


@given(st.integers(0, len(POINTS) - 1), st.sampled_from([np.nan, np.inf, -np.inf]), st.booleans())
def test_a_point_that_is_no_number_costs_itself_and_is_said(at: int, bad: float, in_target: bool) -> None:
    targets = {name: moves.copy() for name, moves in TARGETS.items()}
    points = POINTS.copy()
    (targets["smile"] if in_target else points)[at, 1] = bad
    data = ball_file(targets=targets, points=points)
    beside = Companions()
    scan = read_gltf(data, beside)
    np.testing.assert_allclose(scan.positions, np.delete(POINTS, at, axis=0), atol=ATOL)
    np.testing.assert_allclose(scan.shapes["smile"], np.delete(MOVES[1], at, axis=0), atol=ATOL)
    assert scan.triangles is not None
    assert len(scan.triangles) == sum(at not in triangle for triangle in TRIANGLES.tolist())
    assert beside.notes == [
        f"1 of its {len(POINTS)} points are no numbers (the first is point {at}): they are left out"
    ]
    if in_target:
        said: list[str] = []
        (piece,) = read_glb(data, note=said.append)
        assert (list(piece.moves), len(said)) == (["Ann"], 1)
        assert "the shape 'smile' of the mesh 'mesh' holds what is no number" in said[0]
    else:
        with pytest.raises(ValueError, match=f"vertex {at} of the mesh 'mesh' is"):
            read_glb(data)


def test_what_the_chosen_scene_does_not_show_is_no_piece() -> None:
    data = ball_file(nodes=[{"mesh": 0, "name": "a"}, {"mesh": 0, "name": "b"}], scenes=[{"nodes": [1]}])
    assert [piece.name for piece in read_glb(data)] == ["b"]


def test_the_text_of_a_document_is_read_with_what_lies_beside_it() -> None:
    document, body = samples.gltf_document(where="beside")
    document["scenes"][0]["nodes"] = [2]
    text = b"\xef\xbb\xbf" + json.dumps(document).encode()
    (piece,) = read_glb(text, find={"ball 1.bin": body}.get)
    np.testing.assert_allclose(piece.points, POINTS[TRIANGLES].reshape(-1, 3), atol=ATOL)
    with pytest.raises(ValueError, match=r"'ball%201.bin', which holds its numbers, .* does not lie beside it"):
        read_glb(text)
