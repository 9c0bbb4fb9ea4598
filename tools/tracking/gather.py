"""Makes of raw observations what the training reads: features of each frame, few and small, in one file.

python -m tools.tracking.gather FOLDER
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.inputs.camera.face_features import pose_row
from omote.inputs.camera.head_pose import HeadPose, fit_pose, metric_points, normal_face
from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.camera.landmark_map import OUTPUTS, UNITS, Compression
from tools.tracking.face_mirror import find_mirror, mirror_face, mirror_features
from tools.tracking.picture import SIZE, Pose, turn

Values = NDArray[np.float64]
OBSERVATIONS = Path(__file__).with_name("observations.npz")
EVEN = 76
ODD = 52
REST_EVEN = 15
REST_ODD = 7
STEPS = 20.0
"""Of a feature's spread; beyond six spreads it is cut."""
FARTHEST = 0.8
"""A point that moved further, in sizes of the face, was not found."""


@dataclass(frozen=True, eq=False)
class Seen:
    """Frames of one person: faces (n, 478, 3) with the head's turn undone, rest (478, 3), rows of poses (n, 6), and
    what they did (n, OUTPUTS), relative to rest."""

    faces: Values
    rest: Values
    poses: Values
    truth: Values
    rows: NDArray[np.intp]


def see_person(points: NDArray[np.float32], truth: NDArray[np.float32], tilt: float) -> Seen | None:
    """The frames of one person in which a face was found; None where too few at rest are.

    points (n, 478, 3), truth (n, OUTPUTS + 3) as `observe.row_of`; tilt: of the camera, radians.
    """
    rows = np.flatnonzero(points.any(axis=(1, 2)))
    at_rest = [place for place, row in enumerate(rows) if not truth[row, : len(UNITS)].any()]
    if len(at_rest) < 3:
        return None
    metric = [metric_points(LandmarkFrame(points[row], SIZE, SIZE, 0.0)) for row in rows]
    rest = rest_of([metric[place] for place in at_rest])
    poses = [fit_pose(each, rest) for each in metric]
    faces = np.array([pose.undo(each) for pose, each in zip(poses, metric, strict=True)])
    did = truth[rows, :OUTPUTS].astype(np.float64)
    did[:, len(UNITS) : len(UNITS) + 2] -= did[at_rest, len(UNITS) : len(UNITS) + 2].mean(axis=0)
    did[:, -3:] = seen_turns(did[:, -3:], at_rest, tilt)
    sane = np.abs(faces - rest).max(axis=(1, 2)) < FARTHEST
    return Seen(faces[sane], rest, np.array([pose_row(pose) for pose in poses])[sane], did[sane], rows[sane])


def rest_of(faces: list[Values]) -> Values:
    """The face at rest: the mean, each turned as the first."""
    first = normal_face(faces[0])
    return normal_face(np.mean([fit_pose(face, first).undo(face) for face in faces], axis=0))


def seen_turns(heads: Values, at_rest: list[int], tilt: float) -> Values:
    """How far heads (n, 3) are turned from rest about the camera's axes, which is all that it can see.

    at_rest: rows of heads; tilt: of the camera, radians.
    """
    level = turn("x", tilt)
    mean = heads[at_rest].mean(axis=0)
    back = (level @ Pose((mean[0], mean[1], mean[2])).rotation()).T
    turned = [level @ Pose((yaw, pitch, roll)).rotation() @ back for yaw, pitch, roll in heads]
    return np.array([HeadPose(1.0, rotation, np.zeros(3)).angles for rotation in turned])


def people_in(folder: Path) -> Iterator[Seen]:
    """Everybody in the parts of a folder."""
    for path in sorted(folder.glob("*.npz")):
        with np.load(path) as part:
            points, truth, whose, about = (part[name] for name in ("points", "truth", "whose", "about"))
        for place, person in enumerate(np.unique(whose)):
            seen = see_person(points[whose == person], truth[whose == person], float(about[place, -1]))
            if seen is not None:
                yield seen


def compress(people: list[Seen]) -> tuple[Compression, NDArray[np.intp], Values]:
    """Components of these people; which feature is which in the mirror, and its sign."""
    faces = np.concatenate([one.faces for one in people])
    rests = np.concatenate([np.repeat(one.rest[None], len(one.faces), axis=0) for one in people])
    single = np.array([one.rest for one in people])
    pairs = find_mirror(single.mean(axis=0))
    moved_mean, moved = components(faces - rests, pairs, EVEN, ODD)
    rest_mean, rest = components(single, pairs, REST_EVEN, REST_ODD)
    zeros = np.zeros(1, np.float32)
    plain = Compression(moved_mean, moved, rest_mean, rest, zeros, zeros + 1)
    raw = plain.raw(faces, rests, np.concatenate([one.poses for one in people]))
    signs = [np.repeat([1.0, -1.0], counts) for counts in ((EVEN, ODD), (REST_EVEN, REST_ODD))]
    order, sign = mirror_features(*signs)
    both = np.concatenate([raw, raw[:, order] * sign])
    centre = both.mean(axis=0)
    spread = both.std(axis=0) + 1e-6
    found = Compression(moved_mean, moved, rest_mean, rest, centre.astype(np.float32), spread.astype(np.float32))
    return found, order, sign


def components(points: Values, pairs: NDArray[np.intp], even: int, odd: int) -> tuple[NDArray[np.float32], ...]:
    """Mean and principal components (1434, even + odd) of points (n, 478, 3): first those that are the same in the
    mirror, then those that turn round there.

    pairs (478,): the row of each point's other side; even, odd: how many of each kind.
    """
    flat = points.reshape(len(points), -1)
    other = mirror_face(points, pairs).reshape(len(points), -1)
    mean = 0.5 * (flat + other).mean(axis=0)
    halves = [(0.5 * (flat + other) - mean, even), (0.5 * (flat - other), odd)]
    bases = [np.linalg.eigh(half.T @ half)[1][:, : -count - 1 : -1] for half, count in halves]
    return mean.astype(np.float32), np.concatenate(bases, axis=1).astype(np.float32)


def quantize(features: Values) -> NDArray[np.int8]:
    """Features in steps, as they are stored."""
    return np.rint(np.clip(features * STEPS, -127, 127)).astype(np.int8)


def main() -> None:
    """Writes the observations."""
    people = list(people_in(Path(sys.argv[1])))
    compression, order, sign = compress(people)
    features = [
        compression.features(one.faces, np.repeat(one.rest[None], len(one.faces), axis=0), one.poses) for one in people
    ]
    truth = np.concatenate([one.truth for one in people])
    arrays = {name: value.astype(np.float16) for name, value in vars(compression).items()}
    arrays |= {"centre": compression.centre, "spread": compression.spread}
    arrays |= {"order": order.astype(np.int16), "sign": sign.astype(np.int8)}
    arrays |= {"features": quantize(np.concatenate(features)), "people": np.array([len(one.faces) for one in people])}
    arrays |= {"weights": np.rint(255 * truth[:, : len(UNITS)]).astype(np.uint8)}
    arrays |= {"angles": np.rint(1e4 * truth[:, len(UNITS) :]).astype(np.int16)}
    np.savez_compressed(OBSERVATIONS, **arrays)
    digest = hashlib.blake2b(OBSERVATIONS.read_bytes(), digest_size=8).hexdigest()
    size = OBSERVATIONS.stat().st_size / 1e6
    print(f"{OBSERVATIONS}: {len(people)} people, {len(truth)} frames, {size:.2f} MB, {digest}")


if __name__ == "__main__":
    main()
