"""Regions: weights sum to one, nothing jumps, one face everywhere is itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.geometry.laplacian import smoothing_matrix
from omote.model.sculpting.regions import regional
from omote.model.space.eye_socket import NEAR, ball_heights
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.head_regions import REGIONS, Region, region_weights
from omote.model.space.similarity import fit_similarity
from tests.synthetic import FACES, cast, space

CAST = omote.load_cast()


def everywhere(face: Face) -> dict[Region, Face]:
    return dict.fromkeys(REGIONS, face)


@pytest.mark.parametrize("name", FACES)
def test_one_face_everywhere_is_that_face(name: str) -> None:
    face = cast().faces[name]
    for made in (regional(space(), "same", everywhere(face)), regional(space(), "same", {}, rest=face)):
        assert np.allclose(made.positions, face.positions, atol=1e-7)
        for part, points in fit(space(), face).parts.items():
            assert np.allclose(made.parts[part], points, atol=1e-7)


def test_no_region_at_all_is_the_generic_face() -> None:
    assert np.allclose(regional(space(), "none", {}).positions, space().points, atol=1e-7)


def test_each_region_has_the_form_of_its_face_and_no_border_is_rougher_than_both() -> None:
    old = CAST.faces["old"]
    child = CAST.faces["child"]
    made = regional(CAST.space, "mixed", {"jaw": old, "mouth": old}, rest=child)
    weights = region_weights(CAST.space)
    lower = weights["jaw"] + weights["mouth"]
    assert np.allclose(made.positions[lower < 1e-4], child.positions[lower < 1e-4], atol=1e-3)
    laid = fit_similarity(old.positions, made.positions, lower**8)
    assert np.linalg.norm(laid(old.positions) - made.positions, axis=1)[lower > 0.95].max() < 0.004
    mean = smoothing_matrix(CAST.space.skin_triangles, CAST.space.vertex_count)
    border = (lower > 0.2) & (lower < 0.8)
    rough = [np.linalg.norm(mean @ p - p, axis=1)[border].mean() for p in (f.positions for f in (old, child, made))]
    assert rough[2] < 1.1 * max(rough[:2])


def test_a_face_of_another_size_and_place_gives_the_same_mix() -> None:
    doll = CAST.faces["doll"]
    man = CAST.faces["man"]
    larger = Face("larger", 1.3 * doll.positions, {name: 1.3 * points for name, points in doll.parts.items()})
    mixes = [regional(CAST.space, "staring", {"eyes": face}, rest=man) for face in (doll, larger)]
    assert np.allclose(mixes[0].positions, mixes[1].positions, atol=1e-5)
    for name, points in mixes[0].parts.items():
        assert np.allclose(points, mixes[1].parts[name], atol=1e-5)


def test_eyes_of_another_face_sit_where_the_rest_has_its_own() -> None:
    doll = CAST.faces["doll"]
    man = CAST.faces["man"]
    made = regional(CAST.space, "staring", {"eyes": doll}, rest=man)
    for name in ("eye_left", "eye_right"):
        assert np.linalg.norm(made.parts[name].mean(axis=0) - man.parts[name].mean(axis=0)) < 0.004


def test_eyeballs_of_a_mix_stay_round_and_outside_of_the_lids() -> None:
    used = ("doll", "heavy")
    made = regional(CAST.space, "staring", {"eyes": CAST.faces[used[0]]}, rest=CAST.faces[used[1]])
    for name in ("eye_left", "eye_right"):
        ball = made.parts[name].astype(np.float64)
        generic = CAST.space.parts[name].points
        rough = [np.ptp(ball_heights(points, points)) for points in (*(CAST.faces[n].parts[name] for n in used), ball)]
        assert rough[2] <= max(rough[:2])
        lids = ball_heights(CAST.space.points, generic) > 1.0
        sources = [ball_heights(CAST.faces[n].positions, CAST.faces[n].parts[name]) for n in used]
        over = ball_heights(made.positions.astype(np.float64), ball)
        assert (over >= np.minimum(*sources) - 1e-4)[lids & (np.maximum(*sources) < NEAR)].all()


def test_a_region_that_is_none_is_refused() -> None:
    with pytest.raises(ValueError, match="there is no region 'hair'; expected some of brows, eyes"):
        regional(space(), "a", {"hair": cast().faces["long"]})  # type: ignore[dict-item]


def test_a_space_without_eyes_is_refused() -> None:
    with pytest.raises(ValueError, match="has 0 eyeballs; expected two"):
        region_weights(replace(space(), parts={}))
