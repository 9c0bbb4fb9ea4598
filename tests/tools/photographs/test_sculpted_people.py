"""People of the identity modes who can be photographed."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from tools.photographs.sculpted_people import dress, fit_ball, model_of, painted_colours, random_sculpted

CAST = load_cast()


def test_the_same_seed_is_the_same_person_and_another_is_another() -> None:
    one, again, other = (random_sculpted(np.random.default_rng(seed)) for seed in (3, 3, 4))
    assert np.array_equal(one.face.positions, again.face.positions)
    assert one.look == again.look
    assert np.abs(one.face.positions - other.face.positions).max() > 0.002


def test_what_is_worn_moves_the_mouth_and_looking_aside_turns_the_eyes() -> None:
    person = random_sculpted(np.random.default_rng(3))
    rest, eyes = person.wear({}, (0.0, 0.0))
    opened, _ = person.wear({"jawOpen": 1.0}, (0.0, 0.0))
    _, aside = person.wear({}, (0.4, 0.0))
    assert np.abs(rest - person.face.positions).max() < 1e-5
    assert np.linalg.norm(opened - rest, axis=1).max() > 0.01
    assert np.abs(aside["eye_left"] - eyes["eye_left"]).max() > 0.002


def test_the_ball_through_points_of_a_sphere_is_theirs() -> None:
    draw = np.random.default_rng(1)
    ways = draw.standard_normal((50, 3))
    points = [0.3, -0.1, 2.0] + 0.012 * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    assert fit_ball(points) == pytest.approx([0.3, -0.1, 2.0], abs=1e-9)


def test_what_is_drawn_fits_together() -> None:
    person = dress(CAST.faces["kaori"], np.random.default_rng(8))
    model = model_of(person, {}, (0.0, 0.0))
    count = len(model.points)
    assert model.triangles.max() < count
    assert {len(each) for each in (model.normals, model.uv, model.openness, model.local)} == {count}
    assert len(model.material) == len(model.triangles)
    assert (model.strands is None) == (person.look.hair_style == "")


def test_painted_skin_has_the_looks_colours_and_brows_unless_plain() -> None:
    look = CAST.looks["kaori"]
    painted = painted_colours(look)
    plain = painted_colours(look, plain=True)
    skin = np.array(list(bytes.fromhex(look.skin[1:])))
    assert np.abs(np.median(plain.reshape(-1, 3), axis=0) - skin).max() <= 2
    changed = np.abs(painted.astype(int) - plain).sum(axis=2) > 30
    assert 0.0 < changed.mean() < 0.1
    assert painted[changed].mean() < plain[changed].mean()  # her brows are dark
