"""The mouth bag meets the gums on every face at rest, and no crown lies in its walls."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import move_parts
from omote.model.transfer.gum_line import bind_to_gums, find_gum_line, meet_gums, share_jaws
from omote.model.transfer.paper_map import compile_expression
from omote.model.transfer.pipeline import LINEAR_INNER_STAGES, transfer_expression
from tests.synthetic import space

CAST = omote.load_cast()
Values = NDArray[np.float64]


def walls(positions: NDArray[np.floating]) -> Values:
    line = find_gum_line(CAST.space)
    assert line is not None
    return np.ascontiguousarray(positions[line.bag.triangles].astype(np.float64))


def gum_edges(parts: dict[str, Values]) -> Values:
    line = find_gum_line(CAST.space)
    assert line is not None
    return np.asarray(line.gather(parts)[line.edge])


def placed(name: str) -> dict[str, Values]:
    return {part: points.astype(np.float64) for part, points in fit(CAST.space, CAST.faces[name]).parts.items()}


@pytest.mark.parametrize("name", CAST.faces)
def test_every_gum_ends_at_the_lining_of_the_mouth(name: str) -> None:
    distance, _ = nearest_triangles(walls(CAST.faces[name].positions), gum_edges(placed(name)))
    assert distance.mean() < 0.001
    assert distance.max() < 0.003


def test_each_vertex_of_the_teeth_has_its_place_on_the_bag() -> None:
    line = find_gum_line(CAST.space)
    assert line is not None
    assert np.allclose(line.weights.sum(axis=1), 1.0)
    assert np.allclose(np.linalg.norm(line.outward, axis=1), 1.0)
    inside = np.isin(line.corners, line.bag.vertices)
    assert np.allclose(line.places.sum(axis=1), np.where(inside, line.weights, 0.0).sum(axis=1))
    assert find_gum_line(CAST.space) is line


def test_a_bag_in_the_teeth_is_drawn_out_of_them() -> None:
    line = find_gum_line(CAST.space)
    face = CAST.faces["man"].positions.astype(np.float64)
    parts = placed("man")
    assert line is not None
    bag = line.bag.vertices
    shrunk = face.copy()
    shrunk[bag] += np.minimum(line.bag.distance / 0.02, 1.0)[:, None] * 0.2 * (face[bag].mean(axis=0) - face[bag])
    mended = face.copy()
    mended[bag] = meet_gums(line, shrunk, parts)
    edges = gum_edges(parts)
    assert nearest_triangles(walls(shrunk), edges)[0].mean() > 4.0 * nearest_triangles(walls(mended), edges)[0].mean()
    crowns = line.gather(parts)[~line.edge & (line.upward > 0)]
    inside = [(winding_numbers(walls(bag), crowns) < -0.5).mean() for bag in (shrunk, mended)]
    assert inside[0] < inside[1]


def test_a_space_without_teeth_has_no_gum_line() -> None:
    assert find_gum_line(space()) is None


LINE = find_gum_line(CAST.space)
JAWS = ("jawOpen", "mouth-open", "laugh", "shout", "jawLeft", "mouthSmileLeft", "mouthPucker")


def test_shares_are_none_at_the_lips_and_whole_behind_the_gums() -> None:
    assert LINE is not None
    shares = np.stack(share_jaws(CAST.space, LINE))
    assert (shares >= 0).all()
    assert (shares.sum(axis=0) <= 1 + 1e-9).all()
    assert np.allclose(shares.sum(axis=0)[LINE.bag.distance > 0.028], 1.0)
    assert shares[:, LINE.bag.distance.argmin()].sum() < 0.1


@pytest.mark.parametrize("name", CAST.faces)
def test_lining_and_gum_stay_together_in_every_expression(name: str) -> None:
    """What holds the edge of a gum moves as that gum does, before the skin in front of it may push it back."""
    assert LINE is not None
    face = CAST.faces[name]
    fitted = fit(CAST.space, face)
    edge = np.flatnonzero(LINE.edge)
    for unit in JAWS:
        expression = CAST.expressions[unit]
        compiled = compile_expression(CAST.space, expression)
        skin = transfer_expression(CAST.space, face, compiled, LINEAR_INNER_STAGES).astype(np.float64)
        parts = move_parts(CAST.space, fitted, skin.astype(np.float32), expression.parts)
        teeth = LINE.gather(parts) - LINE.gather(fitted.parts)
        lining = (LINE.weights[..., None] * (skin - face.positions)[LINE.corners]).sum(axis=1)
        off = np.linalg.norm(lining - teeth, axis=1)[edge]
        assert np.quantile(off, 0.9) < 0.001, unit


def test_weights_of_the_inner_skin_sum_to_what_does_not_stay() -> None:
    inner = CAST.space.inner
    sums = inner.weights.sum(axis=1)
    assert (sums <= 1 + 1e-5).all()
    outside = ~np.isin(CAST.space.welded[inner.vertices], LINE.bag.vertices if LINE else [])
    assert np.allclose(sums[outside], 1.0, atol=1e-5)


def test_a_space_without_gums_comes_back_as_it_is() -> None:
    assert bind_to_gums(space()) is space()
