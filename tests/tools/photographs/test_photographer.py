"""Photographs of heads: what a pixel shows is what the camera projects there."""

from __future__ import annotations

import dataclasses

import numpy as np

from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.photographs.photographer import FINE, Model, develop, look_through, photograph
from tools.photographs.sculpted_people import model_of, random_sculpted
from tools.tracking.picture import random_setting

SIDE = 160
CAMERA = PhotographCamera(np.eye(3), np.array([0.0, 0.0, -0.7]), 1.5 * SIDE, SIDE, SIDE)


def somebody(seed: int = 2) -> Model:
    return model_of(random_sculpted(np.random.default_rng(seed)), {}, (0.0, 0.0))


def test_a_pixel_shows_the_place_that_is_projected_to_it() -> None:
    model = somebody()
    hits = look_through(CAMERA, model, 1)
    rows, columns = np.nonzero(hits.triangle >= 0)
    corners = CAMERA.view(model.points)[model.triangles[hits.triangle[rows, columns]]]
    shares = hits.shares[rows, columns].astype(np.float64)
    places = np.einsum("nk,nkc->nc", np.column_stack([1.0 - shares.sum(axis=1), shares]), corners)
    off = CAMERA.project(places) - np.column_stack([columns + 0.5, rows + 0.5])
    assert np.abs(off).max() < 0.6
    assert np.abs(hits.depth[rows, columns] + places[:, 2]).max() < 0.003


def test_the_same_seed_takes_the_same_photograph_and_hair_hides_skin() -> None:
    model = somebody(7)
    assert model.strands is not None

    def take(who: Model) -> tuple[np.ndarray, np.ndarray]:
        draw = np.random.default_rng(4)
        picture, hits = photograph(CAMERA, who, random_setting(draw), draw)
        return picture, hits.triangle

    picture, hit = take(model)
    again, _ = take(model)
    _, bald = take(dataclasses.replace(model, strands=None))
    assert picture.shape == (SIDE, SIDE, 3)
    assert hit.shape == (FINE * SIDE, FINE * SIDE)
    assert np.array_equal(picture, again)
    assert (hit == -2).sum() > 100
    assert not (bald == -2).any()


def test_light_grows_the_picture_and_noise_leaves_its_mean() -> None:
    draw = np.random.default_rng(9)
    calm = dataclasses.replace(random_setting(draw), noise=0.0, exposure=1.0)
    grey = np.full((200, 200, 3), 0.2, np.float32)
    even = develop(grey, calm, draw)
    loud = develop(grey, dataclasses.replace(calm, noise=5.0), draw)
    assert np.ptp(even) == 0
    assert 4.0 < loud.std() < 6.0
    assert abs(loud.mean() - even.mean()) < 0.5
    assert develop(2.0 * grey, calm, draw).mean() > even.mean()
