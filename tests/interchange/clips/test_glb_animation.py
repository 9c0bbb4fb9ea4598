"""Clips as animations of glTF and as VRM Animations, read by three.js and three-vrm."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from omote.interchange.clips.clip_names import quaternions_of
from omote.interchange.clips.glb_animation import animated_head, used_names, vrm_animation
from omote.interchange.export_face import named_compound_meshes
from omote.perform.channels import GAZE_UNITS
from tests import synthetic
from tests.interchange.clips.motion import angles_between, frames_of, read_with_three
from tests.stage_data.heads import context, synthetic_cast


def test_a_head_moves_as_the_clip_does(tmp_path: Path) -> None:
    cast = synthetic_cast()
    frames = frames_of(cast)
    face = synthetic.FACES[0]
    worn = [*used_names(frames, cast.expressions), *(unit for unit in GAZE_UNITS if unit in cast.expressions)]
    poses = [(name, named_compound_meshes(cast, face, name)) for name in worn]
    path = tmp_path / "line1.glb"
    path.write_bytes(animated_head(context(), face, poses, frames, name="line1"))
    read = read_with_three(path)
    wanted = frames.turning_eyes(cast.expressions)
    moved = [name for name in read["curves"] if name.endswith(".morphTargetInfluences")]
    assert {name.partition(".")[0] for name in moved} == read["targets"].keys()
    assert len(moved) > 1
    for name in moved:
        curve = read["curves"][name]
        places = read["targets"][name.partition(".")[0]]
        table = np.reshape(curve["values"], (len(frames.times), len(places)))
        assert curve["times"] == pytest.approx(frames.times, abs=1e-6)
        for target, place in places.items():
            assert table[:, place] == pytest.approx(wanted.get(target, np.zeros(len(table))), abs=1e-4)
    (root,) = [curve for name, curve in read["curves"].items() if name.endswith(".quaternion")]
    assert angles_between(root["values"], quaternions_of(frames.head)) < 0.01


def test_an_avatar_moves_as_the_clip_does(tmp_path: Path) -> None:
    cast = synthetic_cast()
    frames = frames_of(cast)
    path = tmp_path / "line1.vrma"
    path.write_bytes(vrm_animation(frames, {"jawOpen": "JawOpen"}, name="line1"))
    vrm = read_with_three(path)["vrm"]
    assert vrm["duration"] == pytest.approx(frames.times[-1], abs=1e-6)
    assert vrm["preset"]["relaxed"] == pytest.approx(frames.weights["smile"], abs=1e-4)
    assert vrm["custom"]["JawOpen"] == pytest.approx(frames.weights["jawOpen"], abs=1e-4)
    assert not any("eyeLook" in name for name in vrm["custom"])
    assert angles_between(vrm["rotations"]["head"], quaternions_of(frames.head)) < 0.01
    assert angles_between(vrm["lookAt"], quaternions_of(frames.gaze)) < 0.01
