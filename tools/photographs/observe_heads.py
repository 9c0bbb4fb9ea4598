"""Photographs random people and finds their landmarks: what the table of landmarks is learned from.

python -m tools.photographs.observe_heads FOLDER --seed 1 --people 400 --views 10
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.inputs.camera.landmark_map import UNITS
from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.photographs.photographer import Hits, Model, look_through, photograph
from tools.photographs.sculpted_people import Sculpted, model_of, random_sculpted
from tools.photographs.views import camera_at, random_focal
from tools.tracking.landmark_finder import Looks, find, open_finder
from tools.tracking.motions import random_talk
from tools.tracking.picture import _meshes, random_setting
from tools.tracking.rasterizer import SKIN

PART = 20
SIDE = 384
WIDEST = np.radians(80.0)
NOBODY = np.float32(np.nan)


def random_views(draw: np.random.Generator, count: int) -> list[tuple[float, float, float]]:
    """Yaw, pitch and roll of a head in some photographs, radians: from the front, and from everywhere to profiles."""
    yaws = np.where(draw.random(count) < 0.3, draw.normal(0.0, 0.1, count), draw.uniform(-WIDEST, WIDEST, count))
    others = draw.normal(0.0, np.radians([7.0, 5.0]), (count, 2))
    return [(float(yaw), float(pitch), float(roll)) for yaw, (pitch, roll) in zip(yaws, others, strict=True)]


def random_expression(draw: np.random.Generator) -> dict[str, float]:
    """Weights of units in a photograph: often none, else what people do."""
    if draw.random() < 0.4:
        return {}
    share = draw.uniform(0.2, 1.0)
    return {name: share * weight for name, weight in random_talk(draw).items() if name in UNITS}


def random_gaze(draw: np.random.Generator, yaw: float) -> tuple[float, float]:
    """The eyes of a head that is turned by yaw: into the camera as far as they go, or straight ahead."""
    share = float(draw.random() < 0.5)
    return float(np.clip(draw.normal(-share * yaw, 0.08), -0.5, 0.5)), float(np.clip(draw.normal(0, 0.05), -0.3, 0.3))


def observe_person(
    person: Sculpted, count: int, finder: Looks, draw: np.random.Generator
) -> Sequence[tuple[NDArray[np.float32], ...]]:
    """Of each photograph in which a face was found: points (478, 3), weights of UNITS, camera (15,), and where
    the points lie on the generic skin (478, 3)."""
    found = []
    focal = random_focal(draw)
    setting = random_setting(draw)
    for yaw, pitch, roll in random_views(draw, count):
        weights = random_expression(draw)
        model = model_of(person, weights, random_gaze(draw, yaw))
        camera = camera_at(draw, yaw, pitch, roll, focal, SIDE)
        picture, _ = photograph(camera, model, setting, draw)
        points = find(finder, picture)
        if points is None or not _plausible(points, camera):
            continue
        row = np.array([weights.get(name, 0.0) for name in UNITS], np.float32)
        flat = np.concatenate([camera.rotation.ravel(), camera.shift, [camera.focal, SIDE, yaw]]).astype(np.float32)
        found.append((points, row, flat, lift(points, look_through(camera, model, 1), model)))
    return found


def _plausible(points: NDArray[np.float32], camera: PhotographCamera) -> bool:
    """Whether the model found the face itself and nothing beside it."""
    nose = camera.project(camera.view(np.array([[0.0, -0.01, 0.1]])))[0] / SIDE
    size = camera.focal / SIDE * 0.12 / float(-camera.shift[2])
    return bool(np.linalg.norm(points[:468, :2].mean(axis=0) - nose) < 0.5 * size)


def lift(points: NDArray[np.float32], hits: Hits, model: Model) -> NDArray[np.float32]:
    """Where landmarks (478, 3) lie on the generic head's skin, (478, 3) metres, by the pixel they name; else nan."""
    mesh = _meshes()
    generic = np.concatenate([load_cast().space.points, np.full((int(mesh.source.max()) + 1, 3), np.nan)])
    pixels = np.floor(points[:, :2] * SIDE).astype(int)
    inside = ((pixels >= 0) & (pixels < SIDE)).all(axis=1)
    at = np.clip(pixels, 0, SIDE - 1)
    triangle = hits.triangle[at[:, 1], at[:, 0]]
    share = hits.shares[at[:, 1], at[:, 0]]
    good = inside & (triangle >= 0)
    good &= model.material[np.maximum(triangle, 0)] == SKIN
    corners = generic[mesh.source[model.triangles[np.maximum(triangle, 0)]]]
    shares = np.column_stack([1.0 - share.sum(axis=1), share])
    places = np.einsum("nk,nkc->nc", shares, corners).astype(np.float32)
    places[~good] = NOBODY
    lifted: NDArray[np.float32] = places
    return lifted


def write_part(folder: Path, seed: int, numbers: range, views: int, finder: Looks) -> None:
    """Writes the observations of some people into one file."""
    rows: list[tuple[NDArray[np.float32], ...]] = []
    whose: list[int] = []
    for number in numbers:
        draw = np.random.default_rng([seed, number])
        person = random_sculpted(draw)
        found = observe_person(person, views, finder, draw)
        rows = rows + list(found)
        whose = whose + [number] * len(found)
    points, weights, cameras, lifted = (np.array(each) for each in zip(*rows, strict=True))
    path = folder / f"{seed}-{numbers.start:05}.npz"
    np.savez(path, points=points, weights=weights, cameras=cameras, lifted=lifted, whose=whose, seed=seed)
    print(path, len(whose), flush=True)


def main() -> None:
    """Makes parts of 20 people each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--people", type=int, default=100)
    parser.add_argument("--views", type=int, default=10)
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    finder = open_finder()
    end = asked.first + asked.people
    for first in range(asked.first, end, PART):
        write_part(asked.folder, asked.seed, range(first, min(first + PART, end)), asked.views, finder)
    finder.close()


if __name__ == "__main__":
    main()
