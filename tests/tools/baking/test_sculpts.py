"""The sculpted faces of the cast: named as their files, unfolded, eyes where everybody has them."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.builtin.binding import EYES
from omote.geometry import mesh
from omote.model.sculpting.sculpt import Sculpt, sculpted, warp
from omote.model.space.eye_socket import ball_heights
from omote.model.space.face import Face
from tools.baking.assemble import fit_mouths
from tools.baking.package import BakeError
from tools.baking.sculpts import read_sculpts

CAST = omote.load_cast()
SCULPTS = read_sculpts()
each_sculpt = pytest.mark.parametrize("sculpt", SCULPTS, ids=lambda sculpt: sculpt.name)


def made(sculpt: Sculpt) -> Face:
    return sculpted(CAST.space, sculpt, CAST.faces)


def test_the_sculpts_of_the_cast() -> None:
    assert [sculpt.name for sculpt in SCULPTS] == ["auntie", "cat", "count", "dog", "noh"]


@each_sculpt
def test_the_cast_has_the_sculpt_with_its_eyes_in_place(sculpt: Sculpt) -> None:
    face = made(sculpt)
    baked = CAST.faces[sculpt.name]
    shift = baked.positions - face.positions
    own = f"face/{sculpt.name}"
    arrays = {own: face.positions + np.median(shift, axis=0)}
    arrays |= {f"{own}/{part}": points for part, points in baked.parts.items()}
    fit_mouths(arrays, CAST.space, [sculpt.name])
    assert np.abs(baked.positions - arrays[own]).max() < 1e-5
    for part, points in baked.parts.items():
        assert np.allclose(points - face.parts[part], np.median(shift, axis=0), atol=1e-6)
    assert CAST.looks[sculpt.name] == sculpt.look


@each_sculpt
def test_the_map_turns_nothing_inside_out(sculpt: Sculpt) -> None:
    points = CAST.space.points
    step = 1e-6
    move = warp(sculpt)
    slopes = [(move(points + step * axis) - move(points - step * axis)) / (2 * step) for axis in np.eye(3)]
    assert np.linalg.det(np.stack(slopes, axis=2)).min() > 0.05


@each_sculpt
def test_eyeballs_are_round_and_lids_lie_on_them(sculpt: Sculpt) -> None:
    face = made(sculpt)
    for eye in EYES:
        ball = face.parts[eye].astype(np.float64)
        assert np.abs(ball_heights(ball, ball) - 1.0).max() < 0.03  # as round as the people's
        rest = ball_heights(CAST.space.points, CAST.space.parts[eye].points)
        lids = (rest > 1.0) & (rest < 1.1)
        over = ball_heights(face.positions, ball)[lids]
        assert 0.98 < over.min() <= over.max() < 1.2


def test_a_dog_has_a_muzzle_and_hanging_ears_and_a_cat_pricked_ones() -> None:
    skin = {name: CAST.faces[name].positions for name in ("generic", "dog", "cat")}
    tip = int(skin["generic"][:, 2].argmax())
    lobe = int(np.abs(skin["generic"] - [0.073, -0.046, 0.058]).sum(axis=1).argmin())
    rim = int(np.abs(skin["generic"] - [0.084, 0.014, 0.030]).sum(axis=1).argmin())
    highest = skin["generic"][skin["cat"][:, 1].argmax()]
    assert skin["dog"][tip, 2] - skin["generic"][tip, 2] > 0.06
    assert skin["dog"][lobe, 1] < skin["dog"][rim, 1] - 0.05
    assert abs(highest[0]) > 0.07
    assert highest[1] < 0.03


def test_a_sculpt_is_named_as_its_file_and_not_as_a_person(tmp_path: Path) -> None:
    text = 'name = "NAME"\n[points]\n' + "\n".join(f"p{i} = {{ at = [{i}, 0, 0] }}" for i in range(4))
    (tmp_path / "mine.toml").write_text(text.replace("NAME", "yours"))
    with pytest.raises(BakeError, match=r"mine\.toml holds a sculpt named 'yours'; expected its file's name"):
        read_sculpts(tmp_path)
    (tmp_path / "mine.toml").write_text("name = 1")
    with pytest.raises(BakeError, match=r"mine\.toml: the sculpt has no control points"):
        read_sculpts(tmp_path)
    (tmp_path / "mine.toml").rename(tmp_path / "old.toml")
    (tmp_path / "old.toml").write_text(text.replace("NAME", "old"))
    with pytest.raises(BakeError, match="and no person's"):
        read_sculpts(tmp_path)


def test_closed_lips_of_dog_and_cat_lie_as_near_beside_the_corners_as_the_generic_faces() -> None:
    lips = next(line for line in CAST.space.lines if line.kind == "lips")
    beside = np.r_[1:6, 26:31]

    def widest(name: str) -> float:
        return float(lips.rungs(CAST.faces[name].positions.astype(np.float64))[beside, 1].max())

    for name in ("dog", "cat"):
        assert widest(name) < widest("generic"), name


def test_a_dogs_chin_lies_under_its_lip() -> None:
    """The lip stood 19 mm before it, a plank over the lower jaw."""
    lip, chin = (
        int(np.abs(CAST.space.points - at).sum(axis=1).argmin()) for at in ([0, -0.076, 0.156], [0, -0.1, 0.148])
    )
    ahead = CAST.faces["dog"].positions[:, 2]
    assert 0.0 < ahead[lip] - ahead[chin] < 0.014


def test_no_edge_of_an_animals_crown_is_a_facet() -> None:
    """The cat's skull had a dent between crown and ear: chords lay 6 mm off what the normals at their ends say."""
    triangles = CAST.space.sheet_triangles
    crown = CAST.space.points[triangles][:, :, 1].min(axis=1) > 0.06
    edges = np.concatenate([triangles[crown][:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    for name in ("dog", "cat"):
        positions = CAST.faces[name].positions.astype(np.float64)
        normals = mesh.normals(positions, CAST.space.skin_triangles)
        start, end = normals[edges[:, 0]], normals[edges[:, 1]]
        turns = np.arccos(np.clip((start * end).sum(axis=1), -1.0, 1.0))
        lengths = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
        assert (lengths * turns / 8.0).max() < 0.0025, name


def test_eyes_of_dog_and_cat_are_larger_and_rounder_than_peoples() -> None:
    lids = next(line for line in CAST.space.lines if line.name == "lid_left")

    def opening(name: str) -> tuple[float, float]:
        points = CAST.faces[name].positions[lids.loop].astype(np.float64)
        return float(np.ptp(points[:, 0])), float(np.ptp(points[:, 1]))

    across, high = opening("generic")
    for name in ("dog", "cat"):
        assert opening(name)[1] > 1.5 * high, name
        assert opening(name)[1] / opening(name)[0] > 1.5 * high / across, name


@pytest.mark.parametrize("animal", ["dog", "cat"])
def test_an_animals_emotions_part_further_than_a_persons(animal: str) -> None:
    """Each pair of them, so that none is taken for another: ears, brows and muzzle answer by the sculpt's gains."""
    sheet = np.unique(CAST.space.sheet_triangles)

    def worn(face: str) -> list[NDArray[np.float64]]:
        return [
            omote.compound(CAST.space, CAST.faces[face], CAST.expressions[name])[sheet].astype(np.float64)
            for name in ("neutral", "joy", "sad", "angry", "fear", "surprise", "disgust")
        ]

    for (a, b), (c, d) in zip(combinations(worn(animal), 2), combinations(worn("generic"), 2), strict=True):
        assert np.sqrt(((a - b) ** 2).sum(axis=1).mean()) > 1.2 * np.sqrt(((c - d) ** 2).sum(axis=1).mean())
