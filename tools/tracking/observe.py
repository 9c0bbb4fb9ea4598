"""Takes pictures of random people and finds their landmarks: the raw observations, in parts.

python -m tools.tracking.observe FOLDER --seed 1 --people 400 --frames 16 [--tests]
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from tools.tracking.landmark_finder import LANDMARKS, find, open_finder
from tools.tracking.motions import Moment, random_moment, random_rest, row_of
from tools.tracking.people import HUMANS, LEFT_OUT, random_person
from tools.tracking.picture import Photographer, Pose, random_setting

RESTS = 4
HOLD = 3
"""Pictures in which the head is held: where it was found before, one look finds it."""


def moments_of(draw: np.random.Generator, frames: int) -> list[Moment]:
    """What a person of the training does: rests first."""
    moments = [random_moment(draw) for _ in range(frames)]
    held = [replace(moment, pose=moments[row - row % HOLD].pose) for row, moment in enumerate(moments)]
    return [random_rest(draw) for _ in range(RESTS)] + held


def describe(photographer: Photographer) -> list[float]:
    """Shares of HUMANS, focal length, distance and tilt of the camera."""
    setting, shares = photographer.setting, photographer.person.shares
    return [*(shares.get(name, 0.0) for name in HUMANS), setting.focal, setting.distance, setting.tilt]


def main() -> None:
    """Makes parts of 20 people each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--people", type=int, default=100)
    parser.add_argument("--frames", type=int, default=16)
    parser.add_argument("--tests", action="store_true")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    finder, missed = open_finder(), 0
    sources = HUMANS if asked.tests else tuple(name for name in HUMANS if name not in LEFT_OUT)
    for first in range(0, asked.people, 20):
        points, truth, whose, about = [], [], [], []
        for number in range(first, min(first + 20, asked.people)):
            draw = np.random.default_rng([asked.seed, number])
            person = random_person(draw, LEFT_OUT if asked.tests and number % 2 else sources)
            photographer = Photographer(person, random_setting(draw))
            still = Pose()
            for moment in moments_of(draw, asked.frames):
                picture = photographer.take(moment.weights, moment.gaze, moment.pose, draw)
                found = finder.look(picture) if moment.pose == still else find(finder, picture)
                still = moment.pose
                missed += found is None
                points.append(np.zeros((LANDMARKS, 3), np.float32) if found is None else found)
                truth.append(row_of(moment))
                whose.append(number)
            about.append(
                [person.shares.get(name, 0.0) for name in HUMANS]
                + [photographer.setting.focal, photographer.setting.distance, photographer.setting.tilt]
            )
        path = asked.folder / f"{asked.seed}-{first:05}.npz"
        np.savez_compressed(
            path, points=np.array(points), truth=np.array(truth), whose=whose, about=np.array(about, np.float32)
        )
        print(path, "missed", missed, flush=True)
    finder.close()


if __name__ == "__main__":
    main()
