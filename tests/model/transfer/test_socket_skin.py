"""The lining of the eye sockets is found behind the lids."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.geometry.mesh import unit_normals
from omote.model.space.face import Face
from omote.model.transfer.compound import compound
from omote.model.transfer.socket_skin import (
    EXACT,
    SocketLining,
    find_socket_lining,
    fit_socket_lining,
    measure_depth_behind,
    measure_out,
)
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


def lining() -> SocketLining:
    found = find_socket_lining(CAST.space)
    assert found is not None
    return found


def push_out(face: Face, way: float) -> np.ndarray:
    """A face at rest whose hidden lining came forward, metres."""
    found = lining()
    raised = face.positions.astype(np.float64)
    raised[np.isin(CAST.space.welded, found.vertices[found.hidden]), 2] += way
    return raised.astype(np.float32)


@pytest.mark.parametrize("name", ["man", "kaori", "dog"])
def test_a_lining_that_comes_out_goes_back_and_nothing_else_moves(name: str) -> None:
    face = CAST.faces[name]
    raised = push_out(face, 0.006)
    at_rest = np.maximum(measure_out(CAST.space, lining(), face.positions.astype(np.float64))[0], 0.0)
    assert (measure_out(CAST.space, lining(), raised.astype(np.float64))[0] - at_rest).max() > 0.001
    placed = fit_socket_lining(CAST.space, face, raised)
    assert (measure_out(CAST.space, lining(), placed.astype(np.float64))[0] - at_rest).max() < 2 * EXACT
    others = ~np.isin(CAST.space.welded, lining().vertices)
    assert np.array_equal(placed[others], raised[others])


@pytest.mark.parametrize("unit", ["asleep", "pain", "laugh", "eyeSquintLeft"])
def test_no_expression_brings_a_lining_out_further_than_at_rest(unit: str) -> None:
    for face in CAST.faces.values():
        if face.name == "generic":
            continue
        at_rest = np.maximum(measure_out(CAST.space, lining(), face.positions.astype(np.float64))[0], 0.0)
        worn = compound(CAST.space, face, CAST.expressions[unit]).astype(np.float64)
        assert (measure_out(CAST.space, lining(), worn)[0] - at_rest).max() < 1e-4


def test_before_skin_that_looks_away_as_a_lids_edge_does_a_lining_is_out() -> None:
    found = lining()
    points = CAST.faces["kaori"].positions.astype(np.float64)
    corners = points[found.skin]
    middles = corners.mean(axis=1)
    ahead = CAST.space.cylinder.outward(middles)
    squarely = np.flatnonzero((unit_normals(corners) * ahead).sum(axis=1) > 0.3)[::20]
    hidden = found.vertices[found.hidden][0]
    assert len(squarely)
    for triangle in squarely:
        turned = found.skin[[triangle], ::-1]
        alone = replace(found, skin=turned)
        raised = points.copy()
        raised[hidden] = middles[triangle] + 0.0004 * ahead[triangle]
        out, inward = measure_out(CAST.space, alone, raised)
        assert out[0] > 1e-4
        raised[hidden] += (out[0] + 1e-4) * inward[0]
        assert measure_out(CAST.space, alone, raised)[0][0] < 0.0


def test_a_face_at_rest_and_the_generic_face_stay() -> None:
    man = CAST.faces["man"]
    generic = CAST.faces["generic"]
    assert fit_socket_lining(CAST.space, man, man.positions) is man.positions
    raised = push_out(generic, 0.004)
    assert fit_socket_lining(CAST.space, generic, raised) is raised


def test_a_head_without_lids_stays() -> None:
    built = space()
    face = Face("egg", built.points)
    assert fit_socket_lining(built, face, face.positions) is face.positions
