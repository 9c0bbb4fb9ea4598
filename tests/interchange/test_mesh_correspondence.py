"""Mesh correspondence: vertices matched by attribute, by order, by position; and heads of another topology."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.export_face import meshes_of
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.mesh_correspondence import NEAR, build_face, match_head, nearest_face
from omote.model.space.face_fit import fit
from tests import synthetic
from tests.stage_data.heads import meshes, synthetic_cast

CAST = synthetic_cast()
SKIN = meshes_of(fit(CAST.space, CAST.faces["broad"]))["skin"]
MOVES = np.random.default_rng(2).normal(0.0, 0.01, SKIN.shape)
MOVES = MOVES[CAST.space.welded]
ORDER = np.random.default_rng(3).permutation(len(SKIN))


def pieces(rows: np.ndarray, *, told: bool, name: str = "skin") -> list[Piece]:
    """The broad face with vertices in some order."""
    return [Piece(name, SKIN[rows], rows if told else None, {"odd": MOVES[rows]})]


@pytest.mark.parametrize(
    ("rows", "told", "name"),
    [
        (ORDER, True, "skin"),
        (ORDER, True, "Mesh.003"),
        (np.append(ORDER, ORDER[:40]), True, "skin.001"),
        (np.arange(len(SKIN)), False, "anything"),
        (meshes()[0].source.astype(np.int64), False, "head"),
    ],
)
def test_a_head_is_known_however_it_is_written(rows: np.ndarray, told: bool, name: str) -> None:
    found = match_head(CAST, meshes(), pieces(rows, told=told, name=name))
    assert found.face == "broad"
    np.testing.assert_array_equal(found.rest["skin"], SKIN)
    np.testing.assert_array_equal(found.moves["odd"]["skin"], MOVES)


def test_a_head_in_another_order_is_known_by_where_its_vertices_lie() -> None:
    rows = np.append(ORDER, ORDER[:7])  # neither count of ours
    found = match_head(CAST, meshes(), pieces(rows, told=False))
    assert found.face == "broad"
    np.testing.assert_allclose(found.moves["odd"]["skin"], MOVES)


@given(st.sets(st.integers(0, len(SKIN) - 1), min_size=12, max_size=60), st.booleans(), st.integers(0, 99))
def test_our_number_of_vertices_in_another_order_is_matched_by_place(some: set[int], torn: bool, seed: int) -> None:
    """Some vertices change places, as programs do that pack meshes; split at seams or not."""
    order = meshes()[0].source.astype(np.int64) if torn else np.arange(len(SKIN))
    mixed = np.random.default_rng(seed).permutation(sorted(some))
    rows = order.copy()
    rows[sorted(some)] = order[mixed]
    found = match_head(CAST, meshes(), pieces(rows, told=False))
    np.testing.assert_allclose(found.rest["skin"], SKIN, atol=1e-12)
    np.testing.assert_allclose(found.moves["odd"]["skin"], MOVES, atol=1e-12)


def test_a_shape_in_another_order_that_no_place_tells_is_refused() -> None:
    """Sixty vertices of a still half change places, and the other half moves: the rows of those are not known."""
    moved = SKIN + np.where(SKIN[:, :1] > 0.0, 0.01, 0.0)
    still = np.flatnonzero(SKIN[:, 0] <= 0.0)[:60]
    rows = np.arange(len(SKIN))
    rows[still] = np.roll(still, 7)
    assert match_head(CAST, meshes(), [Piece("skin", moved)]).face == ""
    with pytest.raises(ValueError, match=r"of its vertices are in another order than ours: vertex .* of 'broad'"):
        match_head(CAST, meshes(), [Piece("skin", moved[rows])])


def test_parts_are_known_by_their_names_and_others_are_passed_over() -> None:
    ball = meshes_of(fit(CAST.space, CAST.faces["broad"]))["eye_left"]
    others = [Piece("eye_left", ball), Piece("collar", np.zeros((5, 3))), Piece("teeth_lower", np.zeros((3, 3)))]
    found = match_head(CAST, meshes(), [*pieces(ORDER, told=True), *others])
    assert found.rest.keys() == {"skin", "eye_left"}
    assert found.moves["odd"].keys() == {"skin"}


def test_what_is_no_head_of_ours_is_refused() -> None:
    for strange in ([], [Piece("head", np.zeros((99, 3)))], pieces(ORDER[:-1], told=True)):
        with pytest.raises(ValueError, match="no head of this topology is in this file: expected a mesh with the"):
            match_head(CAST, meshes(), strange)


def test_rows_that_the_cast_does_not_have_belong_to_no_mesh() -> None:
    with pytest.raises(ValueError, match="no head of this topology"):
        match_head(CAST, meshes(), [Piece("skin", SKIN, np.arange(len(SKIN)) + 5)])


def test_a_face_is_found_where_it_is_near_enough() -> None:
    assert nearest_face(CAST, SKIN + 0.5 * NEAR) == "broad"
    assert nearest_face(CAST, SKIN + 2.0 * NEAR) == ""


def test_a_face_that_is_in_no_cast_is_the_files_own() -> None:
    found = match_head(CAST, meshes(), [Piece("skin", SKIN * 1.01, np.arange(len(SKIN)))])
    assert found.face == ""
    own = build_face(CAST, found)
    np.testing.assert_allclose(own.positions, SKIN * 1.01, rtol=1e-6)
    assert build_face(CAST, found, "long") is CAST.faces["long"]
    assert synthetic.FACES
