"""BVH of head and eyes, read by the loader of three.js."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from omote.interchange.clips.bvh_writer import bvh_text
from omote.interchange.clips.clip_names import quaternions_of
from omote.model.cast import Cast
from tests.interchange.clips.motion import angles_between, frames_of, read_with_three


def test_head_and_eyes_come_back_within_a_hundredth_of_a_degree(cast: Cast, tmp_path: Path) -> None:
    frames = frames_of(cast)
    path = tmp_path / "line1.bvh"
    path.write_text(bvh_text(frames))
    read = read_with_three(path)
    assert read["bones"][:2] == ["Head", "LeftEye"]
    curves = read["curves"]
    assert curves["Head.quaternion"]["times"] == pytest.approx(frames.times, abs=1e-6)
    assert np.ptp(frames.head[:, 0]) > 0.05
    for bone, turns in (("Head", frames.head), ("LeftEye", frames.gaze), ("RightEye", frames.gaze)):
        assert angles_between(curves[f"{bone}.quaternion"]["values"], quaternions_of(turns)) < 0.01
