"""What people do before a camera: random mixtures of units, and poses of talk and feeling with sums as takes have."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.inputs.camera.landmark_map import UNITS
from tools.tracking.picture import Pose

LEFTS = [name for name in UNITS if name.endswith("Left") and name.replace("Left", "Right") in UNITS]
PAIRS = tuple(name.removesuffix("Left") for name in LEFTS)
"""Groups of units that faces have on both sides; SINGLES: all others."""
SINGLES = tuple(name for name in UNITS if name.removesuffix("Left").removesuffix("Right") not in PAIRS)
OPPOSED = {"jaw", "mouth"}
"""Pairs of which a face does one side at a time."""
TALK = (
    {"jawOpen": 0.55, "mouthLowerDown": 0.3},
    {"jawOpen": 0.2, "mouthStretch": 0.4, "mouthSmile": 0.2},
    {"jawOpen": 0.35, "mouthFunnel": 0.7},
    {"jawOpen": 0.15, "mouthPucker": 0.8},
    {"mouthPress": 0.4, "mouthRollUpper": 0.3},
    {"mouthRollLower": 0.5, "mouthUpperUp": 0.15, "jawOpen": 0.08},
    {"jawOpen": 0.12, "mouthLowerDown": 0.4, "mouthShrugUpper": 0.15},
    {"jawOpen": 0.25, "mouthClose": 0.15, "mouthFunnel": 0.2},
    {"jawOpen": 0.3, "mouthUpperUp": 0.3, "mouthLowerDown": 0.4, "tongueOut": 0.15},
    {"jawOpen": 0.15, "mouthClose": 0.14, "mouthPress": 0.2},
)
"""Mouths of speech."""
FEELINGS: tuple[dict[str, float], ...] = (
    {"mouthSmile": 0.8, "cheekSquint": 0.5, "eyeSquint": 0.3, "mouthDimple": 0.15},
    {"mouthFrown": 0.6, "browInnerUp": 0.6, "mouthShrugLower": 0.4},
    {"browDown": 0.8, "noseSneer": 0.4, "eyeSquint": 0.4, "mouthPress": 0.3},
    {"browInnerUp": 0.7, "browOuterUp": 0.7, "eyeWide": 0.6, "jawOpen": 0.3},
    {"noseSneer": 0.7, "mouthUpperUp": 0.5, "browDown": 0.3},
    {"mouthPucker": 0.7, "mouthFunnel": 0.1},
    {"cheekPuff": 0.8, "mouthPucker": 0.2, "mouthClose": 0.03},
    {"browOuterUp": 0.8, "browInnerUp": 0.3},
    {"mouthSmile": 0.5, "jawOpen": 0.4, "mouthUpperUp": 0.3, "cheekSquint": 0.4},
    {"mouthShrugLower": 0.6, "mouthShrugUpper": 0.4, "mouthFrown": 0.3},
    {"mouthRollLower": 0.5, "mouthRollUpper": 0.5},
    {"jawForward": 0.7},
    {"eyeSquint": 0.7, "browDown": 0.4},
    {"jawOpen": 0.8},
    {"mouthStretch": 0.7, "eyeWide": 0.4},
    {"tongueOut": 0.8, "jawOpen": 0.4},
    {},
)
"""What faces do for longer."""


@dataclass(frozen=True)
class Moment:
    """What somebody does in one picture: weights of units, the eyes (yaw, pitch, radians), the head."""

    weights: dict[str, float] = field(default_factory=dict)
    gaze: tuple[float, float] = (0.0, 0.0)
    pose: Pose = field(default_factory=Pose)


def spread(groups: dict[str, float], draw: np.random.Generator, uneven: float = 0.12) -> dict[str, float]:
    """Weights of units from weights of groups: a pair's sides differ a little.

    groups: weights by group; draw: of the difference; uneven: its spread, of a weight.
    """
    found: dict[str, float] = {}
    for group, weight in groups.items():
        if group in PAIRS:
            for side in ("Left", "Right"):
                found[group + side] = float(np.clip(weight * (1 + draw.normal(0, uneven)), 0, 1))
        else:
            found[group] = float(np.clip(weight, 0, 1))
    return found


def random_mixture(draw: np.random.Generator) -> dict[str, float]:
    """Some units, each in a strength of its own, without sense."""
    groups = [*PAIRS, *SINGLES]
    chosen = draw.choice(len(groups), int(draw.integers(2, 11)), replace=False)
    weights: dict[str, float] = {}
    for group in (groups[row] for row in chosen):
        weight = float(draw.beta(1.2, 1.4))
        if group not in PAIRS:
            weights[group] = weight
        elif group in OPPOSED or draw.random() < 0.3:
            weights[group + str(draw.choice(["Left", "Right"]))] = weight
        else:
            weights |= spread({group: weight}, draw)
    return bound(weights, draw)


def bound(weights: dict[str, float], draw: np.random.Generator) -> dict[str, float]:
    """Weights that a face can wear together: lips close what the jaw has opened, eyes are wide or shut.

    weights: by unit, 0 to 1; draw: of what gives way.
    """
    if "mouthClose" in weights and draw.random() < 0.85:
        weights["mouthClose"] = min(weights["mouthClose"], weights.get("jawOpen", 0.0))
    for side in ("Left", "Right"):
        if weights.get(f"eyeBlink{side}", 0.0) > 0.3:
            weights.pop(f"eyeWide{side}", None)
    return weights


def random_talk(draw: np.random.Generator) -> dict[str, float]:
    """A moment of speech with a feeling, brows and lids: sums as takes have."""
    groups: dict[str, float] = {}
    parts = [(FEELINGS[draw.integers(len(FEELINGS))], draw.uniform(0, 1.1)) for _ in range(int(draw.integers(1, 3)))]
    if draw.random() < 0.7:
        near = draw.integers(len(TALK), size=2)
        share = draw.uniform()
        parts += [(TALK[near[0]], 1.2 * share), (TALK[near[1]], 1.2 * (1 - share))]
    for recipe, share in parts:
        for group, weight in recipe.items():
            groups[group] = groups.get(group, 0.0) + share * weight
    for group in (*PAIRS, *SINGLES):
        if group not in OPPOSED and draw.random() < 0.5:
            groups[group] = groups.get(group, 0.0) + float(draw.exponential(0.04))
    weights = spread(groups, draw)
    lids = draw.random()
    shut = 1.0 if lids < 0.12 else float(draw.uniform(0, 1)) if lids < 0.3 else float(draw.exponential(0.06))
    weights["eyeBlinkLeft"] = min(1.0, shut)
    weights["eyeBlinkRight"] = min(1.0, max(0.0, shut + draw.normal(0, 0.03))) if draw.random() < 0.95 else 0.0
    return bound(weights, draw)


def random_single(draw: np.random.Generator) -> dict[str, float]:
    """One unit, or a pair."""
    groups = [*PAIRS, *SINGLES]
    group = groups[draw.integers(len(groups))]
    weight = float(draw.uniform(0.15, 1.0))
    if group not in PAIRS:
        return bound({group: weight} | ({"jawOpen": 0.5} if group == "mouthClose" else {}), draw)
    if group in OPPOSED or draw.random() < 0.3:
        return {group + str(draw.choice(["Left", "Right"])): weight}
    return spread({group: weight}, draw)


def random_moment(draw: np.random.Generator) -> Moment:
    """Anything that somebody may do."""
    kind = draw.random()
    weights = random_mixture(draw) if kind < 0.45 else random_talk(draw) if kind < 0.85 else random_single(draw)
    return Moment(weights, random_gaze(draw), random_pose(draw))


def random_rest(draw: np.random.Generator) -> Moment:
    """A face at rest, about straight ahead."""
    yaw, pitch, roll = draw.normal(0.0, 0.05, 3)
    gaze = tuple(draw.normal(0.0, 0.03, 2).tolist())
    return Moment({}, (gaze[0], gaze[1]), Pose((yaw, pitch, roll), tuple(draw.normal(0.0, 0.006, 3).tolist())))


def random_gaze(draw: np.random.Generator) -> tuple[float, float]:
    """Yaw and pitch of the eyes, radians."""
    wide = 0.3 if draw.random() < 0.35 else 1.0
    yaw, pitch = draw.normal(0.0, wide * np.radians([14.0, 9.0]))
    return float(np.clip(yaw, -0.55, 0.55)), float(np.clip(pitch, -0.4, 0.4))


def random_pose(draw: np.random.Generator) -> Pose:
    """A head turned to 30 degrees and moved by centimetres."""
    wide = 0.3 if draw.random() < 0.35 else 1.0
    most = np.radians([32.0, 24.0, 20.0])
    yaw, pitch, roll = np.clip(draw.normal(0.0, wide * np.radians([15.0, 10.0, 8.0])), -most, most).tolist()
    x, y, z = draw.normal(0.0, [0.015, 0.012, 0.025]).tolist()
    return Pose((yaw, pitch, roll), (x, y, z))


def row_of(moment: Moment) -> NDArray[np.float32]:
    """Weights of UNITS, gaze, head, move."""
    weights = [moment.weights.get(name, 0.0) for name in UNITS]
    return np.array([*weights, *moment.gaze, *moment.pose.head, *moment.pose.move], np.float32)
