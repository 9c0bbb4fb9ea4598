"""Takes pictures of random people and finds their landmarks: the raw observations, in parts.

python -m tools.tracking.observe FOLDER --seed 1 --people 400 --frames 16 [--tests]
"""

from __future__ import annotations

import argparse
import os
import subprocess
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tools.tracking.motions import UNITS, Moment, random_moment, random_rest
from tools.tracking.people import HUMANS, LEFT_OUT, random_person
from tools.tracking.picture import SIZE, Photographer, random_setting

RESTS = 4
LANDMARKS = 478


class Finder:
    """The landmark model, in a process of its own environment (OMOTE_MEDIAPIPE: its Python)."""

    def __init__(self) -> None:
        python = os.environ.get("OMOTE_MEDIAPIPE", "/tmp/map/mpenv/bin/python")
        script = Path(__file__).with_name("find_landmarks.py")
        self._process = subprocess.Popen(
            [python, str(script), str(SIZE), "film"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )

    def find(self, picture: NDArray[np.uint8], passes: int = 2) -> NDArray[np.float32] | None:
        """The points (478, 3) in a picture; None where no face is found."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        points = None
        for _ in range(passes):
            self._process.stdin.write(picture.tobytes())
            self._process.stdin.flush()
            data = self._process.stdout.read(1 + 12 * LANDMARKS)
            points = np.frombuffer(data, np.float32, offset=1).reshape(LANDMARKS, 3) if data[0] else None
        return points

    def close(self) -> None:
        """Ends the process."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


def moments_of(draw: np.random.Generator, frames: int) -> list[Moment]:
    """What a person of the training does: rests first."""
    return [random_rest(draw) for _ in range(RESTS)] + [random_moment(draw) for _ in range(frames)]


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
            for moment in moments_of(draw, asked.frames):
                found = finder.find(photographer.take(moment.weights, moment.gaze, moment.pose, draw))
                missed += found is None
                points.append(np.zeros((LANDMARKS, 3), np.float32) if found is None else found)
                truth.append(row_of(moment))
                whose.append(number)
            about.append([person.shares.get(name, 0.0) for name in HUMANS] + [photographer.setting.focal, photographer.setting.distance])
        path = asked.folder / f"{asked.seed}-{first:05}.npz"
        np.savez_compressed(path, points=np.array(points), truth=np.array(truth), whose=whose, about=np.array(about, np.float32))
        print(path, "missed", missed, flush=True)
    finder.close()


if __name__ == "__main__":
    main()
