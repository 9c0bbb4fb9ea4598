"""Expressions imported from meshes: they reproduce the source shape, and are retargeted to all faces."""

import numpy as np
import pytest

from omote.interchange.export_face import (
    build_scene,
    choose_expressions,
    compound_meshes,
    meshes_of,
    named_compound_meshes,
)
from omote.interchange.formats.glb_reader import Piece, read_glb
from omote.interchange.formats.glb_writer import glb_bytes
from omote.interchange.import_meshes import import_expressions, import_face
from omote.model.space.face_fit import fit
from tests import synthetic
from tests.stage_data.heads import context, meshes, synthetic_cast

CAST = synthetic_cast()
NEAR = 5e-5
"""Metres that may be lost there and back."""


def exported_pieces(face: str, names: list[str]) -> tuple[Piece, ...]:
    """A face of the cast as it comes out of its GLB."""
    return read_glb(
        glb_bytes(build_scene(context(), face, ((name, named_compound_meshes(CAST, face, name)) for name in names)))
    )


def shape(face: str, expression: str, *, scale: float = 1.0) -> list[Piece]:
    """A face wearing an expression, as one shape of the skin."""
    rest = meshes_of(fit(CAST.space, CAST.faces[face]))["skin"]
    worn = named_compound_meshes(CAST, face, expression)["skin"]
    return [Piece("skin", scale * (rest + (worn - rest)))]


@pytest.mark.parametrize("face", synthetic.FACES)
def test_what_went_out_comes_back_as_it_was(face: str) -> None:
    names = choose_expressions(CAST, "all")
    for each in import_expressions(CAST, meshes(), {face: exported_pieces(face, names)}):
        assert each.expression is CAST.expressions[each.label]
        assert each.face == face
        assert each.error < NEAR


@pytest.mark.parametrize("some", [12, len(CAST.space.welded)])
def test_shapes_beside_their_head_at_rest_may_be_in_any_one_order(some: int) -> None:
    """Some vertices of both files, or all, change places alike: the shape is that of the file in our order."""
    rows = np.arange(len(CAST.space.welded))
    rows[:some] = np.random.default_rng(11).permutation(some)
    names = {"neutral": CAST.faces["broad"].positions.astype(np.float64), "odd": shape("broad", "smile")[0].points}
    ours, mixed = (
        list(
            import_expressions(CAST, meshes(), {name: [Piece("head", points[order])] for name, points in names.items()})
        )
        for order in (np.arange(len(rows)), rows)
    )
    assert [each.label for each in mixed] == [each.label for each in ours] == ["odd"]
    assert mixed[0].error < NEAR
    for name, worn in compound_meshes(CAST.space, CAST.faces["long"], ours[0].expression).items():
        again = compound_meshes(CAST.space, CAST.faces["long"], mixed[0].expression)[name]
        np.testing.assert_allclose(again, worn, atol=NEAR)


@pytest.mark.parametrize("face", synthetic.FACES)
def test_an_unknown_head_is_measured_and_does_the_same(face: str) -> None:
    (piece, *others) = exported_pieces(face, ["smile", "eyeLookUpLeft"])
    moves = {f"odd {name}": moved for name, moved in piece.moves.items()}
    renamed = [
        Piece(each.name, each.points, each.rows, {f"odd {n}": m for n, m in each.moves.items()}) for each in others
    ]
    found = list(
        import_expressions(CAST, meshes(), {"x": [Piece(piece.name, piece.points, piece.rows, moves), *renamed]})
    )
    assert [each.label for each in found] == ["odd smile", "odd eyeLookUpLeft"]
    for each in found:
        assert each.error < NEAR
        aim = named_compound_meshes(CAST, face, each.label.removeprefix("odd "))
        for name, points in compound_meshes(CAST.space, CAST.faces[face], each.expression).items():
            np.testing.assert_allclose(points, aim[name], atol=NEAR)


def test_a_shape_alone_whose_moved_vertices_change_places_is_refused() -> None:
    """No face has a vertex where they are, so that places say nothing of their order: it was 17 mm wrong, and taken."""
    points = shape("broad", "smile")[0].points
    moved = np.argsort(-np.linalg.norm(points - CAST.faces["broad"].positions, axis=1))[:24]
    points[moved] = points[np.random.default_rng(5).permutation(moved)]
    with pytest.raises(ValueError, match=r"'odd': vertex \d+.* went another way than all vertices around"):
        list(import_expressions(CAST, meshes(), {"odd": [Piece("skin", points)]}))


def test_a_keyed_model_is_an_expression() -> None:
    for face in ("long", ""):
        (found,) = import_expressions(CAST, meshes(), {"Grin": shape("long", "smile")}, face=face)
        assert (found.label, found.face) == ("Grin", "long")
        assert found.error < NEAR


def test_shapes_start_from_the_one_at_rest() -> None:
    shapes = {"Grin": shape("long", "smile", scale=1.02), "Neutral": shape("long", "neutral", scale=1.02)}
    (found,) = import_expressions(CAST, meshes(), shapes)
    assert (found.label, found.face) == ("Grin", "imported")
    assert found.error < NEAR
    known = list(
        import_expressions(CAST, meshes(), {"a": shape("broad", "smile"), "whatever": shape("broad", "neutral")})
    )
    assert [(each.label, each.face) for each in known] == [("a", "broad")]


def test_a_wrong_face_is_recognised() -> None:
    wrong = {"Grin": shape("long", "smile")}
    with pytest.raises(ValueError, match=r"'Grin' starts from 'long' and not from 'broad': 95 % .* say --face long"):
        list(import_expressions(CAST, meshes(), wrong, face="broad"))
    with pytest.raises(ValueError, match=r"'head' starts from 'long' and not from 'broad'"):
        list(import_expressions(CAST, meshes(), {"head": exported_pieces("long", ["smile"])}, face="broad"))
    with pytest.raises(ValueError, match=r"'Grin' starts from 'long' and .* take it in alone"):
        list(import_expressions(CAST, meshes(), {**wrong, "rest": shape("broad", "neutral")}))
    moved = [Piece("skin", meshes_of(fit(CAST.space, CAST.faces["long"]))["skin"] + [0.0, 0.002, 0.0])]
    with pytest.raises(ValueError, match=r"'Up' does not start from 'long': .* 2\.0 mm .* a shape named 'neutral'"):
        list(import_expressions(CAST, meshes(), {"Up": moved}, face="long"))
    (up,) = import_expressions(CAST, meshes(), {"Up": moved, "neutral": shape("long", "neutral")})
    assert up.label == "Up"


def test_what_cannot_be_an_expression_is_refused() -> None:
    with pytest.raises(ValueError, match=r"nothing says from which face 'Grin' starts; add a shape named 'neutral'"):
        list(import_expressions(CAST, meshes(), {"Grin": shape("long", "smile", scale=1.02)}))
    with pytest.raises(ValueError, match="show a face at rest and no expression"):
        list(import_expressions(CAST, meshes(), {"long": shape("long", "neutral")}))
    with pytest.raises(ValueError, match="there is no face 'nobody' in this cast"):
        list(import_expressions(CAST, meshes(), {"long": shape("long", "smile")}, face="nobody"))
    with pytest.raises(ValueError, match="ball: no head of this topology"):
        list(import_expressions(CAST, meshes(), {"ball": [Piece("ball", np.zeros((4, 3)))]}))


def test_a_head_at_rest_is_a_face_and_wears_the_look_that_it_is_known_by() -> None:
    face, look = import_face(CAST, meshes(), "Aunt", exported_pieces("broad", []))
    assert face.name == "Aunt"
    np.testing.assert_array_equal(face.positions, CAST.faces["broad"].positions)
    assert look == CAST.looks["broad"]


@pytest.mark.parametrize("scale", [0.0, 1e-6, 100.0])
def test_a_head_that_is_not_in_metres_is_refused(scale: float) -> None:
    away = [Piece("skin", scale * meshes_of(fit(CAST.space, CAST.faces["long"]))["skin"])]
    with pytest.raises(ValueError, match=r"Grin: the head is .* m long; expected .* export it in metres"):
        list(import_expressions(CAST, meshes(), {"Grin": away}, face="long"))
    with pytest.raises(ValueError, match="export it in metres"):
        import_face(CAST, meshes(), "Grin", away)
