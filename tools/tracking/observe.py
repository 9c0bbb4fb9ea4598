"""Takes pictures of random people and finds their landmarks: the raw observations, in parts.

python -m tools.tracking.observe FOLDER --seed 1 --people 400 --frames 16 [--tests]
"""

from __future__ import annotations

import argparse
import os
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tools.tracking.motions import UNITS, Moment, random_moment, random_rest
from tools.tracking.people import HUMANS, LEFT_OUT, random_person
from tools.tracking.picture import SIZE, Photographer, Pose, random_setting

RESTS = 4
LANDMARKS = 478
HOLD = 3
"""Pictures in which the head is held: where it was found before, one look finds it."""
MOST_LOOKS = 6
SETTLED = 0.35
"""Pixels."""


class Finder:
    """The landmark model, in a process of its own environment (OMOTE_MEDIAPIPE: its Python)."""

    def __init__(self) -> None:
        python = os.environ.get("OMOTE_MEDIAPIPE", "/tmp/map/mpenv/bin/python")
        script = Path(__file__).with_name("find_landmarks.py")
        self._process = subprocess.Popen(
            [python, str(script), str(SIZE), "film"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )

    def find(self, picture: NDArray[np.uint8]) -> NDArray[np.float32] | None:
        """The points (478, 3) in a picture; None where no face is found.

        The model looks where the face was in the picture before: it is shown the same one until it has settled there,
        as it has in a film.
        """
        points = self.look(picture)
        for _ in range(MOST_LOOKS - 1):
            before, points = points, self.look(picture)
            if points is None or (before is not None and _moved(before, points) < SETTLED):
                break
        return points

    def look(self, picture: NDArray[np.uint8]) -> NDArray[np.float32] | None:
        """The points in the next picture of a film."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(picture.tobytes())
        self._process.stdin.flush()
        data = self._process.stdout.read(1 + 12 * LANDMARKS)
        return np.frombuffer(data, np.float32, offset=1).reshape(LANDMARKS, 3) if data[0] else None

    def close(self) -> None:
        """Ends the process."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


def _moved(before: NDArray[np.float32], after: NDArray[np.float32]) -> float:
    """How far points have moved, in pixels (root mean square)."""
    return SIZE * float(np.sqrt(((after - before)[:, :2] ** 2).sum(axis=1).mean()))


def moments_of(draw: np.random.Generator, frames: int) -> list[Moment]:
    """What a person of the training does: rests first."""
    moments = [random_moment(draw) for _ in range(frames)]
    held = [replace(moment, pose=moments[row - row % HOLD].pose) for row, moment in enumerate(moments)]
    return [random_rest(draw) for _ in range(RESTS)] + held


def row_of(moment: Moment) -> NDArray[np.float32]:
    """Weights of UNITS, gaze, head, move."""
    weights = [moment.weights.get(name, 0.0) for name in UNITS]
    return np.array([*weights, *moment.gaze, *moment.pose.head, *moment.pose.move], np.float32)


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
    finder, missed = Finder(), 0
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
                found = finder.look(picture) if moment.pose == still else finder.find(picture)
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
