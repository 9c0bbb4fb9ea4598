"""The body of a clip as bones: a part of it, over the stand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import omote
from omote.interchange.avatar.humanoid_pose import rest_humanoid
from omote.interchange.clips.body_motion import motion_of_clip
from omote.interchange.clips.clip_frames import sample_clip
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.cut_clip import record
from omote.perform.performer import Performer
from tests.interchange.clips.humanoids import degrees_apart

CAST = omote.load_cast()


def test_a_head_that_turns_is_in_the_bones_and_a_weak_lane_bends_less() -> None:
    assert CAST.figures is not None
    rest = rest_humanoid(CAST.figures, {"generic": 1.0}, {"generic": CAST.faces["generic"].positions})
    performer = Performer(CAST)
    performer.call_pose("bow", seconds=0)
    lane = Lane(record(performer, CAST, seconds=0.2))
    whole, half = Clip([lane]), Clip([replace(lane, weight=0.5)])
    bent, less = (motion_of_clip(clip, sample_clip(clip, rate=10.0), rest) for clip in (whole, half))
    stand = motion_of_clip(replace(whole, lanes=[replace(lane, muted=True)]), sample_clip(whole, rate=10.0), rest)
    full, part = (degrees_apart(stand, each)["chest"] for each in (bent, less))
    assert full > 20.0
    assert abs(part - full / 2.0) < 2.0
    frames = sample_clip(whole, rate=10.0)
    turned = motion_of_clip(whole, replace(frames, head=np.tile([0.5, 0.0, 0.0], (len(frames.times), 1))), rest)
    assert degrees_apart(bent, turned)["head"] > 20.0
