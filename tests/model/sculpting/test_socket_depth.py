"""The lining of the eye sockets lies behind the skin, on every face and in every squint."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.sculpting.caricature import caricature
from omote.model.sculpting.regions import regional
from omote.model.sculpting.socket_depth import SHALLOW_METRES, fit_lining_at_rest, measure_lining, mend_lining
from omote.model.space.face import Face
from omote.model.transfer.compound import compound
from omote.model.transfer.mouth_bag import measure_distance
from omote.model.transfer.socket_skin import RIM_METRES, SocketLining, find_socket_lining
from tests.synthetic import space

CAST = omote.load_cast()


def lining() -> SocketLining:
    found = find_socket_lining(CAST.space)
    assert found is not None
    return found


def out(positions: NDArray[np.floating]) -> float:
    """How far a vertex of the lining is from the skin that it has come out of, metres; lids' rims do not count."""
    points = positions.astype(np.float64)
    vertices = lining().vertices
    corners = CAST.space.welded[CAST.space.triangles]
    near = corners[np.isin(corners, vertices).any(axis=1)].astype(np.int32)
    tested = points[vertices[measure_distance(CAST.space, near, vertices) > RIM_METRES]]
    closed = points[CAST.space.location_triangles]
    count = len(CAST.space.sheet_triangles)
    outside = tested[winding_numbers(closed, tested) < 0.5]
    away, through = (nearest_triangles(part, outside)[0] for part in (closed[:count], closed[count:]))
    return float(away[away < through].max(initial=0.0))


@pytest.mark.parametrize("name", CAST.faces)
def test_the_lining_of_every_face_is_in_order(name: str) -> None:
    face = CAST.faces[name]
    assert measure_lining(CAST.space, lining(), face.positions).max() < SHALLOW_METRES
    assert mend_lining(CAST.space, face) is face


@pytest.mark.parametrize("name", ["man", "gaunt", "heavy", "goblin"])
@pytest.mark.parametrize("unit", ["pain", "eyeSquintLeft", "laugh"])
def test_no_lining_comes_through_the_cheek_of_who_squints(name: str, unit: str) -> None:
    assert out(compound(CAST.space, CAST.faces[name], CAST.expressions[unit])) < 3e-4


def test_a_lining_in_front_of_the_skin_goes_behind_it_and_nothing_else_moves() -> None:
    face = CAST.faces["man"]
    found = lining()
    asked = found.vertices[np.isfinite(found.least)]
    raised = face.positions.astype(np.float64)
    raised[np.isin(CAST.space.welded, asked), 2] += 0.003
    assert measure_lining(CAST.space, found, raised).max() > 0.001
    placed = fit_lining_at_rest(CAST.space, raised.astype(np.float32))
    assert measure_lining(CAST.space, found, placed).max() < SHALLOW_METRES
    others = ~np.isin(CAST.space.welded, found.vertices)
    assert np.array_equal(placed[others], raised.astype(np.float32)[others])


def test_the_generic_face_is_the_measure_and_stays() -> None:
    positions = CAST.space.points.astype(np.float32)
    assert fit_lining_at_rest(CAST.space, positions) is positions


@pytest.mark.parametrize("kind", ["caricature", "mix"])
def test_faces_made_at_run_time_have_their_lining_in_order(kind: str) -> None:
    faces = CAST.faces
    face = (
        caricature(CAST.space, faces["man"], 1.8)
        if kind == "caricature"
        else regional(CAST.space, "hers", {"cheeks": faces["heavy"]}, rest=faces["kaori"])
    )
    assert measure_lining(CAST.space, lining(), face.positions).max() < SHALLOW_METRES


def test_a_head_without_lids_stays() -> None:
    built = space()
    face = Face("egg", built.points)
    assert find_socket_lining(built) is None
    assert mend_lining(built, face) is face
    assert fit_lining_at_rest(built, face.positions) is face.positions


def test_no_rim_of_a_lid_comes_through_the_lid_of_the_strongest_caricature() -> None:
    """The dog's upper lids showed 1.7 mm of it."""
    points = caricature(CAST.space, CAST.faces["dog"], 3.0).positions.astype(np.float64)
    tested = points[lining().vertices]
    closed = points[CAST.space.location_triangles]
    away, nearest = nearest_triangles(closed, tested)
    skin = nearest < len(CAST.space.sheet_triangles)  # through the eye's opening a rim may be out
    outside = skin & (winding_numbers(closed, tested) < 0.5)
    assert away[outside].max(initial=0.0) < 3e-4
