"""How well a webcam tracks: people left out of the training, pictures of known weights, the camera page's own model.

Each person holds still, does the guided minute, a piece of a real take (a synthetic one where the data is absent) with
a head that turns to 30 degrees, random mixtures, a still, and blinks. Explained: the share of the skin's squared motion
that is gone when what was tracked is taken off. Native landmarks: see tools/tracking/landmark_finder.py.

python -m benchmarks.tracking [--people 8] [--frames 150] [--seed 9000] [--folder FOLDER] [--take CSV]
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from omote.inputs.camera import LandmarkFrame, PerformerCalibration, PerformerTracker, fit_calibration
from omote.inputs.camera.face_features import pose_row
from omote.inputs.camera.guided_steps import STEPS
from omote.inputs.camera.head_pose import fit_pose, metric_points
from omote.inputs.camera.landmark_map import UNITS, load_landmark_map
from omote.model.cast import Look
from tools.tracking.films import RATE, film
from tools.tracking.gather import EVEN, OBSERVATIONS, ODD, seen_turns
from tools.tracking.landmark_finder import Looks, find, open_finder
from tools.tracking.motions import row_of
from tools.tracking.picture import SIZE, Photographer, random_setting
from tools.tracking.random_people import HUMANS, LEFT_OUT, Person, Warp, random_person
from tools.tracking.train_map import read_observations

Values = NDArray[np.float64]
TAKE = Path(__file__).resolve().parents[2] / "shared" / "data" / "livelinkface" / "alex_rom_3.csv"
PLAYED = ("take", "mixtures", "still", "blinks")
MOVES = 0.05
"""Standard deviation of a unit that moves."""
OPEN = 0.4
"""Lids further shut than this hide where eyes look."""
COUNT = len(UNITS)


@dataclass(frozen=True, eq=False)
class Performer:
    """One film: frames, the scene of each, and what was done: weights of UNITS, gaze, head (as the camera sees it,
    relative to rest); metric (u, u): what an error of weights costs on this person's skin."""

    frames: list[LandmarkFrame]
    scenes: NDArray[np.str_]
    truth: Values
    metric: Values

    def of(self, scene: str) -> NDArray[np.intp]:
        """The frames of a scene in which a face was found."""
        return np.array([row for row in np.flatnonzero(self.scenes == scene) if self.frames[row].found], np.intp)


def record(folder: Path, seed: int, number: int, frames: int, finder: Looks, take: Path) -> Path:
    """Takes a person's film and finds its landmarks, into a file; one that is there already stays."""
    path = folder / f"{seed}-{number:03}.npz"
    if path.exists():
        return path
    draw = np.random.default_rng([seed, number])
    person = random_person(draw, LEFT_OUT if number % 2 else HUMANS)
    photographer = Photographer(person, random_setting(draw))
    points = []
    truth = []
    scenes = []
    last = ""
    for scene, moment in film(draw, take if take.exists() else None, take_frames=frames):
        picture = photographer.take(moment.weights, moment.gaze, moment.pose, draw)
        follows = scene == last and scene != "mixtures"
        found = finder.look(picture) if follows else find(finder, picture)
        points.append(np.zeros((478, 3), np.float32) if found is None else found)
        truth.append(row_of(moment))
        scenes.append(scene)
        last = scene
    about = [person.shares.get(name, 0.0) for name in HUMANS] + [photographer.setting.tilt]
    np.savez_compressed(path, points=np.array(points), truth=np.array(truth), scene=np.array(scenes), about=about)
    return path


def load(path: Path) -> Performer:
    """The film in a file."""
    with np.load(path) as stored:
        points, truth, scenes, about = (stored[name] for name in ("points", "truth", "scene", "about"))
    times = np.arange(len(points)) / RATE + np.where(scenes == "mixtures", 1.0, 0.0).cumsum()
    frames = [
        LandmarkFrame(each if each.any() else None, SIZE, SIZE, float(time))
        for each, time in zip(points, times, strict=True)
    ]
    rest = np.flatnonzero(scenes == "neutral").tolist()
    did = truth[:, : COUNT + 5].astype(np.float64)
    did[:, COUNT : COUNT + 2] -= did[rest, COUNT : COUNT + 2].mean(axis=0)
    did[:, -3:] = seen_turns(did[:, -3:], rest, float(about[-1]))
    shares = {name: float(share) for name, share in zip(HUMANS, about, strict=False) if share > 0.0}
    return Performer(frames, scenes, did, metric_of(shares))


def metric_of(shares: dict[str, float]) -> Values:
    """Products of what units move on a mix of the cast (u, u)."""
    person = Person(shares, Warp(np.ones(3), np.zeros((1, 3)), np.zeros((1, 3)), np.ones(1)), Look())
    rest = person.pose({}, (0.0, 0.0))[0].astype(np.float64)
    moved = np.array([(person.pose({unit: 1.0}, (0.0, 0.0))[0] - rest).ravel() for unit in UNITS])
    result: Values = moved @ moved.T
    return result


# ---- the ways


Way = Callable[[Performer], Values]
"""What it tracks in a film: weights of UNITS, gaze, head of every frame; NaN where nothing is known."""


def play(performer: Performer, calibration: PerformerCalibration | None) -> Values:
    """Our tracker, smoothing and all; without a calibration it looks at the rest for two seconds before."""
    tracker = PerformerTracker(calibration)
    if calibration is None:
        rest = [performer.frames[row] for row in performer.of("neutral")]
        for step in range(2 * RATE + 1):
            one = rest[step % len(rest)]
            tracker.step(LandmarkFrame(one.points, one.width, one.height, step / RATE - 10.0))
    found = np.full((len(performer.frames), COUNT + 5), np.nan)
    for row, frame in enumerate(performer.frames):
        seen = tracker.step(frame)
        if seen.found and seen.gaze is not None and seen.head is not None:
            found[row] = [*(seen.weights[unit] for unit in UNITS), *seen.gaze, *seen.head]
    return found


def track(performer: Performer) -> Values:
    """Ours, after two seconds."""
    return play(performer, None)


def track_calibrated(performer: Performer) -> Values:
    """Ours, after the guided minute."""
    steps = {step: [performer.frames[row] for row in performer.of(step)] for step in STEPS}
    return play(performer, fit_calibration(steps))


def seen_features(performer: Performer) -> tuple[NDArray[np.intp], Values]:
    """The frames with a face and their features, as the map reads them."""
    steps = {"neutral": [performer.frames[row] for row in performer.of("neutral")]}
    rest = fit_calibration(steps).rest.face
    compression = load_landmark_map().compression
    rows = np.array([row for row, frame in enumerate(performer.frames) if frame.found])
    points = [metric_points(performer.frames[row]) for row in rows]
    poses = [fit_pose(each, rest) for each in points]
    faces = np.array([pose.undo(each) for pose, each in zip(poses, points, strict=True)])
    return rows, compression.features(faces, np.broadcast_to(rest, faces.shape), np.array([pose_row(p) for p in poses]))


class LinearWays:
    """The prototype's ways, from the same observations: 120 principal components of how points moved and 6 of pose."""

    def __init__(self) -> None:
        arrays, features, targets = read_observations(OBSERVATIONS)
        self._scale = arrays["spread"].astype(np.float64)
        self._centre = arrays["centre"].astype(np.float64)
        spans = self._scale[: EVEN + ODD]
        self._places = np.sort(np.argsort(-spans)[:120])
        turned = np.arange(len(self._scale))[EVEN + ODD + 36 : EVEN + ODD + 42]
        self._columns = np.concatenate([self._places, turned])
        known = self._known(features.astype(np.float64))
        ridge = 0.003 * len(known) * np.eye(known.shape[1]) * np.var(known[:, 0]) * 1e-2
        self._answers = np.linalg.solve(known.T @ known + ridge, known.T @ targets.astype(np.float64))
        moved = known[:, :120]
        worn = np.concatenate([targets[:, :COUNT], np.ones((len(targets), 1))], axis=1)
        rows = np.linalg.solve(worn.T @ worn + 0.1 * np.eye(COUNT + 1), worn.T @ moved)
        self._moves = rows[:COUNT]
        self._rest = rows[COUNT]

    def _known(self, features: Values) -> Values:
        raw = features * self._scale + self._centre
        return np.concatenate([raw[:, self._columns], np.ones((len(raw), 1))], axis=1)

    def ridge(self, performer: Performer) -> Values:
        """The prototype's ridge."""
        rows, features = seen_features(performer)
        found = np.full((len(performer.frames), COUNT + 5), np.nan)
        found[rows] = self._known(features) @ self._answers
        found[:, :COUNT] = np.clip(found[:, :COUNT], 0.0, 1.0)
        return found

    def least_squares(self, performer: Performer) -> Values:
        """Bounded least squares on what units move landmarks by."""
        rows, features = seen_features(performer)
        found = np.full((len(performer.frames), COUNT + 5), np.nan)
        for row, moved in zip(rows, self._known(features)[:, :120], strict=True):
            found[row, :COUNT] = np.minimum(nnls(self._moves.T, moved - self._rest)[0], 1.0)
        return found


# ---- what is measured


def explained(performers: Sequence[Performer], tracked: Sequence[Values], scene: str) -> float:
    """The share of the skin's squared motion in a scene that is gone."""
    left = whole = 0.0
    for one, found in zip(performers, tracked, strict=True):
        rows = one.of(scene)
        did = one.truth[rows, :COUNT]
        error = found[rows, :COUNT] - one.truth[rows, :COUNT]
        left += float(np.einsum("ij,jk,ik->", error, one.metric, error))
        whole += float(np.einsum("ij,jk,ik->", did, one.metric, did))
    return 1.0 - left / whole


def correlation(performers: Sequence[Performer], tracked: Sequence[Values], scene: str) -> float:
    """The mean correlation over the units that move."""
    did = np.concatenate([one.truth[one.of(scene), :COUNT] for one in performers])
    found = np.concatenate([each[one.of(scene), :COUNT] for one, each in zip(performers, tracked, strict=True)])
    return float(np.mean(correlations(did, found)))


def correlations(did: Values, found: Values) -> list[float]:
    """The correlation of each unit (a column) that moves; 0 for one that was not seen to."""
    pairs = [(a, b) for a, b in zip(did.T, found.T, strict=True) if a.std() > MOVES]
    return [float(np.corrcoef(a, b)[0, 1]) if b.std() > 0.0 else 0.0 for a, b in pairs]


def gaze_error(performers: Sequence[Performer], tracked: Sequence[Values]) -> Values:
    """Mean error of the gaze (yaw, pitch), degrees, where the lids are open."""
    errors = []
    for one, found in zip(performers, tracked, strict=True):
        rows = np.concatenate([one.of("take"), one.of("mixtures")])
        lids = one.truth[rows][:, [UNITS.index("eyeBlinkLeft"), UNITS.index("eyeBlinkRight")]].mean(axis=1)
        rows = rows[lids < OPEN]
        errors.append(found[rows, COUNT : COUNT + 2] - one.truth[rows, COUNT : COUNT + 2])
    result: Values = np.degrees(np.abs(np.concatenate(errors)).mean(axis=0))
    return result


def head_error(performers: Sequence[Performer], tracked: Sequence[Values]) -> Values:
    """Mean error of the head (yaw, pitch, roll), degrees."""
    errors = []
    for one, found in zip(performers, tracked, strict=True):
        rows = np.concatenate([one.of(scene) for scene in PLAYED])
        errors.append(found[rows, -3:] - one.truth[rows, -3:])
    result: Values = np.degrees(np.abs(np.concatenate(errors)).mean(axis=0))
    return result


def shaking(performers: Sequence[Performer], tracked: Sequence[Values]) -> float:
    """Of weights on a still: the mean standard deviation, once the filter has come to rest."""
    return float(
        np.mean(
            [found[one.of("still")[8:], :COUNT].std(axis=0) for one, found in zip(performers, tracked, strict=True)]
        )
    )


def blink_counts(performers: Sequence[Performer], tracked: Sequence[Values]) -> tuple[int, int, int, float]:
    """Blinks done, found within two frames, false ones, and minutes."""
    done = hit = false = frames = 0
    columns = [UNITS.index("eyeBlinkLeft"), UNITS.index("eyeBlinkRight")]
    for one, found in zip(performers, tracked, strict=True):
        rows = one.of("blinks")
        real, seen = (closings(values[rows][:, columns].mean(axis=1)) for values in (one.truth, found))
        met = [min((other for other in seen if abs(other - each) <= 2), default=None) for each in real]
        done = done + len(real)
        hit = hit + sum(each is not None for each in met)
        false = false + len(set(seen) - set(met))
        frames = frames + len(rows)
    return done, hit, false, frames / RATE / 60.0


def closings(lids: Values) -> list[int]:
    """The frames in which lids come past half shut, open again in between."""
    found = []
    shut = False
    for row, lid in enumerate(lids):
        if not shut and lid > 0.5:
            found.append(row)
        shut = lid > (0.3 if shut else 0.5)
    return found


def lag(performers: Sequence[Performer], tracked: Sequence[Values]) -> int:
    """The frames by which weights are late: where they correlate best with what was done."""
    scores = []
    for late in range(5):
        pairs: list[float] = []
        for one, found in zip(performers, tracked, strict=True):
            rows = one.of("blinks")
            rows = rows[rows >= rows[0] + late]
            pairs += correlations(one.truth[rows - late, :COUNT], found[rows, :COUNT])
        scores.append(float(np.mean(pairs)))
    return int(np.argmax(scores))


def report(name: str, performers: Sequence[Performer], tracked: Sequence[Values]) -> None:
    """Prints the figures of one way."""
    shares = [explained(performers, tracked, scene) for scene in ("take", "mixtures", "blinks")]
    means = [correlation(performers, tracked, scene) for scene in ("take", "mixtures")]
    print(f"\n{name}")
    print(f"  explained: take {shares[0]:.3f}, mixtures {shares[1]:.3f}, talk with blinks {shares[2]:.3f}")
    print(f"  correlation of the units that move: take {means[0]:.3f}, mixtures {means[1]:.3f}")
    done, hit, false, minutes = blink_counts(performers, tracked)
    print(f"  blinks within two frames: {hit} of {done}; false ones a minute: {false / minutes:.2f}")
    print(f"  shaking on a still {shaking(performers, tracked):.4f}; late by {lag(performers, tracked)} frames")
    if not np.isnan(tracked[0][:, -1]).all():
        print("  gaze: yaw {:.1f}, pitch {:.1f} degrees".format(*gaze_error(performers, tracked)), end="; ")
        print("head: yaw {:.2f}, pitch {:.2f}, roll {:.2f} degrees".format(*head_error(performers, tracked)))


def read_arguments() -> argparse.Namespace:
    """What is asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--people", type=int, default=2)
    parser.add_argument("--frames", type=int, default=90)
    parser.add_argument("--seed", type=int, default=9000)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--take", type=Path, default=TAKE)
    return parser.parse_args()


def main() -> None:
    """Takes the films that are not there, and prints every way's figures."""
    asked = read_arguments()
    folder = asked.folder or Path(tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    paths = [folder / f"{asked.seed}-{number:03}.npz" for number in range(asked.people)]
    if not all(path.exists() for path in paths):
        finder = open_finder()
        paths = [record(folder, asked.seed, number, asked.frames, finder, asked.take) for number in range(asked.people)]
        finder.close()
    performers = [load(path) for path in paths]
    frames = sum(len(one.frames) for one in performers)
    found = sum(frame.found for one in performers for frame in one.frames)
    print(f"{asked.people} people left out of the training, {frames} frames, a face found in {found}")
    print(f"take: {asked.take.name if asked.take.exists() else 'a synthetic one: the data is absent'}")
    linear = LinearWays()
    ways = {
        "bounded least squares on the units' landmarks": linear.least_squares, "the prototype's ridge": linear.ridge,
        "ours, after two seconds at rest": track, "ours, after the guided minute": track_calibrated,
    }  # fmt: skip
    for name, way in ways.items():
        report(name, performers, [way(performer) for performer in performers])


if __name__ == "__main__":
    main()
