"""Photographs against soft light on a face."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.builtin.own_skin import load_skin_samples
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.bundle import adjust
from omote.model.fitting.photographs.bundle_problem import Bundle, Problem
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.skin_evidence import SkinEvidence, compare, open_evidence, start_lights, unknowns
from omote.model.space.similarity import fit_similarity
from tools.photographs.photographer import photograph
from tools.photographs.sculpted_people import Sculpted, model_of, random_sculpted
from tools.tracking.picture import random_setting, turn

SPACE = load_cast().space
MODES = load_identity_modes()
TABLE = load_landmark_table()
SIDE = 320
BLUR = 0.004


def weights_of(person: Sculpted) -> np.ndarray:
    """The modes that are nearest to a person."""
    flat = MODES.moves.reshape(len(MODES.moves), -1)
    off = (person.face.positions - MODES.skin).ravel()
    return np.asarray(np.linalg.solve(flat @ flat.T + 1e-6 * np.eye(len(flat)), flat @ off))


@cache
def taken(*yaws: float) -> tuple[Sculpted, tuple[Photograph, ...]]:
    """Somebody without hair photographed, with landmarks that err as the landmark model's do."""
    draw = np.random.default_rng(5)
    person = random_sculpted(draw, 1.0)
    setting = random_setting(draw)
    views = []
    person = replace(person, look=replace(person.look, hair_style=""))
    alike = draw.normal(size=TABLE.person.shape[2])
    for yaw in yaws:
        camera = PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.8]), 1.3 * SIDE, SIDE, SIDE)
        picture, _ = photograph(camera, model_of(person, {}, (0.0, 0.0)), setting, draw)
        law = TABLE.error_at(yaw)
        points = np.full((478, 2), SIDE / 2.0)
        seen = camera.view(TABLE.places(person.face.positions))
        own = law.basis @ (np.linalg.cholesky(law.shared) @ draw.normal(size=len(law.shared)))
        off = law.mean + law.slopes @ weights_of(person) + law.person @ alike + own
        seen[:, :2] += (off + np.sqrt(law.alone) * draw.normal(size=len(off))).reshape(-1, 2)
        points[: len(seen)] = camera.project(seen)
        views.append(Photograph(points, SIDE, SIDE, camera="one", picture=picture))
    return person, tuple(views)


@cache
def opened() -> tuple[Problem, SkinEvidence, Bundle]:
    _, views = taken(0.0, 0.6)
    problem = Problem(
        SPACE, MODES, TABLE, views, TABLE.places(MODES.skin), TABLE.places(MODES.moves),
        np.stack(list(TABLE.units.values())), [0, 0], [None, None],
    )  # fmt: skip
    found = adjust(SPACE, MODES, TABLE, views)
    evidence = open_evidence(problem, load_skin_samples(), found)
    return problem, evidence, replace(found, lights=start_lights(problem, evidence, found, BLUR))


def moved(last: Bundle, name: str, step: float) -> Bundle:
    """The bundle with one unknown of the second photograph's changed."""
    if name == "mode":
        return replace(last, weights=last.weights + step * (np.arange(len(last.weights)) == 3))
    if name == "light":
        return replace(last, lights=last.lights + step * np.eye(9)[4])
    if name == "paint":
        return replace(last, paint=last.paint + step * np.eye(3)[0])
    growth = step if name == "lens" else 0.0
    turned, shifted = (step * np.eye(3)[1] * (name == each) for each in ("turn", "shift"))
    return replace(last, cameras=(last.cameras[0], last.cameras[1].move(turned, shifted, growth)))


@pytest.mark.parametrize(
    ("name", "column", "step"),
    [("mode", 3, 0.02), ("turn", 111, 2e-3), ("shift", 114, 2e-4), ("lens", 116, 2e-3), ("light", -8, 1e-3),
     ("paint", -3, 1e-3)],
)  # fmt: skip
def test_slopes_are_those_of_differences(name: str, column: int, step: float) -> None:
    problem, evidence, last = opened()
    now = compare(problem, evidence, last, 1, BLUR)
    after, before = (compare(problem, evidence, moved(last, name, way * step), 1, BLUR) for way in (1.0, -1.0))
    rows = np.intersect1d(np.intersect1d(after.rows, before.rows), now.rows)
    ends = [each.left[np.isin(each.rows, rows)] for each in (after, before)]
    slope = now.slopes[np.isin(now.rows, rows), column]
    assert slope.shape == ends[0].shape
    difference = (ends[0] - ends[1]) / (2.0 * step)
    assert np.corrcoef(slope, difference)[0, 1] > 0.97
    assert np.abs(slope - difference).mean() < 0.2 * np.abs(difference).mean() + 1e-6
    assert unknowns(problem, 1).shape == now.slopes.shape[1:]


def error(skin: np.ndarray, person: Sculpted) -> float:
    """Metres between the faces, the mean after a similarity."""
    face = head_zones(SPACE).face
    truth = person.face.positions[face].astype(np.float64)
    placed = fit_similarity(skin[face], truth, np.ones(len(truth)))(skin[face])
    return float(np.linalg.norm(placed - truth, axis=1).mean())


@pytest.mark.slow
def test_pictures_bring_a_face_nearer_to_the_person_and_lights_start_bright() -> None:
    person, views = taken(0.0, 0.6, -0.6)
    blind, seeing = (adjust(SPACE, MODES, TABLE, views, each) for each in (None, load_skin_samples()))
    before, after = (error(MODES.shape_skin(each.weights), person) for each in (blind, seeing))
    assert after < 0.85 * before
    assert np.isfinite(seeing.lights).all()


def test_without_pictures_skin_says_nothing() -> None:
    _, views = taken(0.0, 0.6)
    plain = [replace(each, picture=None) for each in views]
    blind, told = (adjust(SPACE, MODES, TABLE, plain, each) for each in (None, load_skin_samples()))
    assert np.array_equal(blind.weights, told.weights)
