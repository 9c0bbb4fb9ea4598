"""Frames of clips: each at its second, in any order, as the clip has them."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.stage_data.clip_poses import ClipPoses, count_frames
from omote.stage_data.picture_grid import lay_out
from omote.stage_data.picture_request import RenderRequest

RAMP = Clip([Lane(make_curve([0.0, 1.0, 2.0], {"jawOpen": [0.0, 0.5, 1.0]}, {}))], start=0.5, loop=True, speed=2.0)
"""It opens the jaw by half a second, at the speed 1; 1.5 s of it are played."""


def test_a_frame_is_that_of_its_second_whatever_was_asked_before(cast: Cast) -> None:
    poses = ClipPoses(cast, {"ramp": RAMP})
    for at in (1.25, 0.0, 1.0, 0.25):
        assert poses.frame("ramp", at).channels["jawOpen"] == pytest.approx(0.5 * (0.5 + at), abs=1e-12)
    assert poses.frame("ramp", 1.0) == ClipPoses(cast, {"ramp": RAMP}).frame("ramp", 1.0)
    with pytest.raises(ValueError, match=r"the clip ramp has no second 1\.5; give one from 0 on, before 1\.5"):
        poses.frame("ramp", 1.5)
    with pytest.raises(ValueError, match=r"there is no clip 'rams'.*ramp"):
        poses.frame("rams", 0.0)


def test_a_picture_of_a_clip_has_its_own_face_and_light_and_nothing_else(cast: Cast) -> None:
    face = list(cast.faces)[1]
    poses = ClipPoses(cast, {"ramp": RAMP})
    ((pose,),) = lay_out(RenderRequest(clip="ramp", at=0.5, face=(face,), light="flat"), cast, poses).poses
    assert (pose["faces"], pose["light"], pose["channels"]) == ({face: 1.0}, {"flat": 1.0}, {"jawOpen": 0.5})
    with pytest.raises(ValueError, match="the clip ramp has expression and turn of its own"):
        lay_out(RenderRequest(clip="ramp", expression=("smile",), turn="5"), cast, poses)
    with pytest.raises(ValueError, match=r"the second 0\.5 is of no clip"):
        lay_out(RenderRequest(at=0.5), cast, poses)
    with pytest.raises(ValueError, match="name a show file that has clips with --show"):
        lay_out(RenderRequest(clip="ramp"), cast)


def test_frames_end_before_the_clip_does() -> None:
    assert count_frames(RAMP, 40.0) == 30
    with pytest.raises(ValueError, match="at most 20000"):
        count_frames(RAMP, 1e6)
