"""Takes pictures of random people and finds their landmarks: the raw observations, in parts.

python -m tools.tracking.observe FOLDER --seed 1 --people 400 --frames 16
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tools.tracking.landmark_finder import LANDMARKS, Looks, find, open_finder
from tools.tracking.motions import Moment, random_moment, random_rest, row_of
from tools.tracking.picture import Photographer, Pose, random_setting
from tools.tracking.random_people import HUMANS, LEFT_OUT, random_person

RESTS = 4
PART = 20
HOLD = 3
"""Pictures in which the head is held: where it was found before, one look finds it."""


def moments_of(draw: np.random.Generator, frames: int) -> list[Moment]:
    """What a person of the training does: rests first.

    draw: of what they do; frames: how many.
    """
    moments = [random_moment(draw) for _ in range(frames)]
    held = [replace(moment, pose=moments[row - row % HOLD].pose) for row, moment in enumerate(moments)]
    return [random_rest(draw) for _ in range(RESTS)] + held


def describe(photographer: Photographer) -> list[float]:
    """Shares of HUMANS, focal length, distance and tilt of the camera."""
    setting = photographer.setting
    shares = photographer.person.shares
    return [*(shares.get(name, 0.0) for name in HUMANS), setting.focal, setting.distance, setting.tilt]


def observe_person(
    photographer: Photographer, frames: int, finder: Looks, draw: np.random.Generator
) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """The points of a person's frames (zeros where no face was found), and what they did.

    photographer: of the person; frames: how many; finder: the model; draw: of what they do and of noise.
    """
    points = []
    truth = []
    still = Pose()
    for moment in moments_of(draw, frames):
        picture = photographer.take(moment.weights, moment.gaze, moment.pose, draw)
        found = finder.look(picture) if moment.pose == still else find(finder, picture)
        still = moment.pose
        points.append(np.zeros((LANDMARKS, 3), np.float32) if found is None else found)
        truth.append(row_of(moment))
    return points, truth


def main() -> None:
    """Makes parts of 20 people each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--people", type=int, default=100)
    parser.add_argument("--frames", type=int, default=21)
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    finder = open_finder()
    for first in range(0, asked.people, PART):
        write_part(asked.folder, asked.seed, range(first, min(first + PART, asked.people)), asked.frames, finder)
    finder.close()


def write_part(folder: Path, seed: int, numbers: range, frames: int, finder: Looks) -> None:
    """Writes the observations of some people into one file.

    folder: for the file; seed: of all people; numbers: of those that are written; frames: of each; finder: the model.
    """
    sources = tuple(name for name in HUMANS if name not in LEFT_OUT)
    points: list[NDArray[np.float32]] = []
    truth: list[NDArray[np.float32]] = []
    whose: list[int] = []
    about: list[list[float]] = []
    for number in numbers:
        draw = np.random.default_rng([seed, number])
        photographer = Photographer(random_person(draw, sources), random_setting(draw))
        found, did = observe_person(photographer, frames, finder, draw)
        points = points + found
        truth = truth + did
        whose = whose + [number] * len(did)
        about.append(describe(photographer))
    path = folder / f"{seed}-{numbers.start:05}.npz"
    np.savez_compressed(
        path, points=np.array(points), truth=np.array(truth), whose=whose, about=np.array(about, np.float32)
    )
    print(path, flush=True)


if __name__ == "__main__":
    main()
