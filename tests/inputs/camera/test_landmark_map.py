"""The built-in map is there, gives nothing at rest, and says what is wrong with a file that is none."""

from pathlib import Path

import numpy as np
import pytest

from omote.inputs.camera.face_features import pose_row
from omote.inputs.camera.head_pose import HeadPose
from omote.inputs.camera.landmark_groups import LIDS, LIPS_APART
from omote.inputs.camera.landmark_map import MAP, OUTPUTS, UNITS, load_landmark_map, read_landmark_map, swish
from tests.inputs.camera.heads import mean_face

STRAIGHT = pose_row(HeadPose(0.12, np.eye(3), np.zeros(3)))


def outputs_of(face: np.ndarray) -> dict[str, float]:
    general = load_landmark_map()
    found = general.estimate(general.compression.features(face, mean_face(), STRAIGHT))
    return dict(zip(UNITS, found[: len(UNITS)].tolist(), strict=True))


def test_a_face_at_rest_does_next_to_nothing() -> None:
    assert max(map(abs, outputs_of(mean_face()).values())) < 0.15


def test_lids_that_shut_are_a_blink_of_that_eye() -> None:
    face = mean_face()
    upper, lower = LIDS["Left"]
    face[upper] = face[lower] + [0.0, 0.01, 0.0]
    found = outputs_of(face)
    assert found["eyeBlinkLeft"] > 0.35
    assert found["eyeBlinkLeft"] > found["eyeBlinkRight"] + 0.25


def test_lips_that_part_move_jaw_or_lips() -> None:
    face = mean_face()
    for _, lower in LIPS_APART:
        face[lower, 1] -= 0.15
    rest = outputs_of(mean_face())
    found = outputs_of(face)
    parts = ("jawOpen", "mouthLowerDownLeft", "mouthLowerDownRight", "mouthFunnel")
    assert sum(found[name] - rest[name] for name in parts) > 0.2


def test_many_faces_give_what_each_gives() -> None:
    general = load_landmark_map()
    faces = np.stack([mean_face(), 1.05 * mean_face()])
    both = general.estimate(general.compression.features(faces, np.stack([mean_face()] * 2), np.stack([STRAIGHT] * 2)))
    each = [general.estimate(general.compression.features(face, mean_face(), STRAIGHT)) for face in faces]
    assert both.shape == (2, OUTPUTS)
    assert both == pytest.approx(np.array(each), abs=1e-5)


def test_swish_is_nothing_far_below_and_itself_far_above() -> None:
    assert swish(np.array([-40.0, 0.0, 40.0])) == pytest.approx([0.0, 0.0, 40.0], abs=1e-9)


def test_what_is_no_map_is_rejected(tmp_path: Path) -> None:
    path = tmp_path / "landmark_map.npz"
    with pytest.raises(ValueError, match=r"No such file.*put back the one that came with Omote"):
        read_landmark_map(path)
    path.write_bytes(b"no map")
    with pytest.raises(ValueError, match="no map of this version"):
        read_landmark_map(path)


@pytest.mark.parametrize(("name", "value", "reason"), [
    ("format", np.array(99), "format 99"), ("linear", np.zeros((3, OUTPUTS)), "linear part"),
    ("centre", None, "centre"),
])  # fmt: skip
def test_a_map_of_another_version_is_rejected(tmp_path: Path, name: str, value: np.ndarray | None, reason: str) -> None:
    with np.load(MAP) as file:
        arrays = dict(file)
    arrays.pop(name)
    path = tmp_path / "landmark_map.npz"
    np.savez(path, **(arrays if value is None else {**arrays, name: value}))
    with pytest.raises(ValueError, match=reason):
        read_landmark_map(path)
