"""What a performer of a test does, in scenes: a rest, the guided minute, a take, mixtures, a still, blinks, a move."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from omote.builtin import load_cast
from omote.inputs.camera.guided_steps import GUIDED, LOOKS, NEUTRAL, STEPS
from omote.inputs.camera.landmark_map import UNITS
from omote.inputs.takes.live_link_take import read_live_link_take
from omote.inputs.trackers.arkit_names import plain_spelling
from tools.tracking.motions import Moment, bound, random_mixture, random_pose, random_talk, spread
from tools.tracking.picture import Pose

RATE = 30
"""Frames a second."""


def film(
    draw: np.random.Generator, take: Path | None, *, take_frames: int = 150, mixtures: int = 40
) -> list[tuple[str, Moment]]:
    """Frames of one performer: the name of the scene, and what they do.

    draw: of all that is random; take: a recording of Live Link Face, None for a synthetic one; take_frames, mixtures:
    how many frames of each.
    """
    scenes = [("neutral", still(draw, Pose(tuple(draw.normal(0, 0.03, 3)), (0.0, 0.0, 0.0)))) for _ in range(20)]
    scenes += guided(draw)
    scenes += [("take", moment) for moment in (real_take(draw, take, take_frames) if take else talk(draw, take_frames))]
    scenes += [
        ("mixtures", Moment(random_mixture(draw), random_look(draw), random_pose(draw))) for _ in range(mixtures)
    ]
    held = Moment(
        bound(random_talk(draw) | {"eyeBlinkLeft": 0.0, "eyeBlinkRight": 0.0}, draw),
        random_look(draw),
        small_pose(draw),
    )
    scenes += [("still", held)] * 30
    scenes += [("blinks", moment) for moment in blinks(draw, take_frames)]
    return scenes


def still(draw: np.random.Generator, pose: Pose) -> Moment:
    """A face at rest that holds almost still.

    draw: of what trembles; pose: of the head.
    """
    turned = np.array(pose.head) + draw.normal(0, 0.004, 3)
    return Moment({}, tuple(draw.normal(0, 0.02, 2)), Pose(tuple(turned), tuple(draw.normal(0, 0.0006, 3))))


def small_pose(draw: np.random.Generator) -> Pose:
    """A head turned a little."""
    return Pose(tuple(draw.normal(0, 0.12, 3)), tuple(draw.normal(0, 0.008, 3)))


def random_look(draw: np.random.Generator) -> tuple[float, float]:
    """Eyes anywhere within 25 and 15 degrees."""
    return float(np.radians(draw.uniform(-25, 25))), float(np.radians(draw.uniform(-15, 15)))


def guided(draw: np.random.Generator) -> list[tuple[str, Moment]]:
    """The steps of the guided minute: nobody does them quite as asked."""
    frames = []
    for step in (name for name in STEPS if name != NEUTRAL):
        groups = GUIDED.get(step, {})
        strength = float(draw.uniform(0.85, 1.1))
        weights = spread({name: strength * weight for name, weight in groups.items()}, draw, 0.06)
        weights = {name: min(1.0, weight + float(draw.exponential(0.02))) for name, weight in weights.items()}
        yaw, pitch = np.array(LOOKS.get(step, (0.0, 0.0))) * draw.uniform(0.92, 1.08) + draw.normal(0, 0.015, 2)
        look = (float(yaw), float(pitch))
        poses = [still(draw, small_pose_of(draw)) for _ in range(6)]
        frames += [(step, replace(pose, weights=weights, gaze=look)) for pose in poses]
    return frames


def small_pose_of(draw: np.random.Generator) -> Pose:
    """A head that is asked to hold still."""
    return Pose(tuple(draw.normal(0, 0.03, 3)), tuple(draw.normal(0, 0.004, 3)))


def head_path(draw: np.random.Generator, frames: int) -> list[Pose]:
    """Poses (radians, metres) that wander to 30 degrees, smoothly.

    draw: of the way; frames: how many.
    """
    at = np.arange(frames) / RATE
    most = np.radians([30.0, 15.0, 10.0])
    turns = np.zeros((frames, 3))
    for axis in range(3):
        for rate in (0.11, 0.23, 0.41):
            turns[:, axis] += draw.uniform(0.1, 0.55) * np.sin(
                2 * np.pi * (rate * at * draw.uniform(0.7, 1.3) + draw.uniform())
            )
    moves = np.stack([0.012 * np.sin(2 * np.pi * (0.13 * at + draw.uniform())) for _ in range(3)], 1)
    turns = np.clip(turns, -1, 1) * most
    return [
        Pose((turn[0], turn[1], turn[2]), (move[0], move[1], move[2]))
        for turn, move in zip(turns.tolist(), moves.tolist(), strict=True)
    ]


def talk(draw: np.random.Generator, frames: int) -> list[Moment]:
    """A synthetic take: from one moment of talk to the next, each a tenth to half a second away.

    draw: of the moments; frames: how many.
    """
    found: list[dict[str, float]] = []
    last = random_talk(draw)
    while len(found) < frames:
        aim = random_talk(draw)
        steps = int(draw.integers(3, 14))
        for step in range(steps):
            share = 0.5 - 0.5 * np.cos(np.pi * step / steps)
            found.append({n: float((1 - share) * last.get(n, 0.0) + share * aim.get(n, 0.0)) for n in {*last, *aim}})
        last = aim
    looks = gaze_path(draw, frames)
    return [Moment(w, g, p) for w, g, p in zip(found, looks, head_path(draw, frames), strict=False)]


def gaze_path(draw: np.random.Generator, frames: int) -> list[tuple[float, float]]:
    """Fixations of a quarter of a second to one and a half.

    draw: of the fixations; frames: how many.
    """
    looks: list[tuple[float, float]] = []
    while len(looks) < frames:
        looks += [random_look(draw)] * int(draw.integers(8, 45))
    return looks[:frames]


def blinks(draw: np.random.Generator, frames: int) -> list[Moment]:
    """A face that talks a little and blinks each second or two: shut within 3-4 frames, open within 5-7.

    draw: of the times; frames: how many.
    """
    moments = talk(draw, frames)
    lids = np.zeros(frames)
    at = int(draw.integers(8, 25))
    while at < frames - 12:
        down = int(draw.integers(2, 5))
        up = int(draw.integers(4, 8))
        shape = np.concatenate(
            [np.linspace(0, 1, down + 1)[1:], np.ones(int(draw.integers(1, 3))), np.linspace(1, 0, up + 1)[1:]]
        )
        lids[at : at + len(shape)] = shape[: frames - at]
        at += int(draw.integers(28, 60))
    found = []
    for moment, lid in zip(moments, lids, strict=True):
        rest = {name: 0.6 * weight for name, weight in moment.weights.items() if not name.startswith("eyeBlink")}
        shut = {f"eyeBlink{side}": float(max(lid, 0.03)) for side in ("Left", "Right")}
        for side in ("Left", "Right"):
            rest[f"eyeWide{side}"] = rest.get(f"eyeWide{side}", 0.0) * float(1 - lid)
        found.append(Moment(rest | shut, moment.gaze, moment.pose))
    return found


def real_take(draw: np.random.Generator, path: Path, frames: int) -> list[Moment]:
    """A piece of a take of Live Link Face at 30 Hz, with a head of ours, that turns further.

    draw: of where it begins; path: the recording; frames: how many.
    """
    rows = _take_rows(path)
    first = int(draw.integers(0, len(rows) - 2 * frames))
    poses = head_path(draw, frames)
    return [replace(rows[first + 2 * k], pose=poses[k]) for k in range(frames)]


@cache
def _take_rows(path: Path) -> list[Moment]:
    take = read_live_link_take(path.read_text())
    looks = {
        name: load_cast().expressions[f"eyeLook{name}"].eyes for name in ("UpLeft", "DownLeft", "InLeft", "OutLeft")
    }
    names = [plain_spelling(name) for name in take.names]
    rows = []
    for values in take.values:
        said = dict(zip(names, values, strict=True))
        weights = {name: float(np.clip(said.get(plain_spelling(name), 0.0), 0.0, 1.0)) for name in UNITS}
        gaze = sum(said.get(plain_spelling(f"eyeLook{name}"), 0.0) * eyes[0] for name, eyes in looks.items())
        rows.append(Moment(weights, (float(gaze[0]), float(gaze[1]))))
    return rows
