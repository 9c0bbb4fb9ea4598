"""Motion of files as clips: within the stage, feet on the floor, and out and in again as it was."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import omote
from omote.interchange.avatar.humanoid_pose import rest_humanoid
from omote.interchange.clips.body_motion import AnimatedBody, animated_body
from omote.interchange.clips.bvh_humanoid import bvh_motion
from omote.interchange.clips.bvh_writer import humanoid_bvh
from omote.interchange.clips.clip_frames import sample_clip
from omote.interchange.clips.glb_animation import vrm_animation
from omote.interchange.clips.humanoid_motion import HumanoidMotion
from omote.interchange.clips.motion_clip import FAR, clip_of_motion, place_motion
from omote.interchange.clips.vrma_reader import vrma_motion
from omote.perform.clips.clip import Clip
from omote.perform.performer import Performer
from tests.interchange.clips.humanoids import MIXAMO, degrees_apart, moving

CAST = omote.load_cast()
RATE = 30.0
assert CAST.figures is not None
REST = rest_humanoid(CAST.figures, {"generic": 1.0}, {"generic": CAST.faces["generic"].positions})
WALK = moving(tuple(MIXAMO), frames=12, seed=11, most=0.5)


def out(clip: Clip) -> AnimatedBody:
    return animated_body(clip, sample_clip(clip, rate=RATE), REST)


@pytest.mark.parametrize("kind", ["bvh", "vrma"])
def test_a_clip_goes_out_and_comes_in_within_a_degree(kind: str) -> None:
    clip, _ = clip_of_motion(WALK, CAST)
    body = out(clip)
    if kind == "bvh":
        read = bvh_motion(humanoid_bvh(body, RATE).encode())
    else:
        read = vrma_motion(vrm_animation(sample_clip(clip, rate=RATE), {}, name="walk", body=body))
    assert max(degrees_apart(body.motion, read).values()) < 1.0
    again = out(clip_of_motion(read, CAST)[0])
    assert max(degrees_apart(body.motion, again.motion).values()) < 1.0


def test_limbs_of_a_file_point_where_they_did() -> None:
    worlds = WALK.worlds()
    made = out(clip_of_motion(WALK, CAST)[0]).motion.worlds()
    for bone, way in {
        "leftUpperArm": [1, 0, 0],
        "rightLowerArm": [-1, 0, 0],
        "head": [0, 0, 1],
        "hips": [0, 0, 1],
    }.items():
        cosine = (worlds[bone].apply(way) * made[bone].apply(way)).sum(axis=1)
        assert np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))).max() < 0.1, bone


@pytest.mark.parametrize("body", ["child", "heavy", "dog"])
def test_no_foot_is_in_the_floor(body: str) -> None:
    clip, _ = clip_of_motion(WALK, CAST)
    performer = Performer(CAST)
    performer.call_face(body, seconds=0)
    floor = omote.evaluate_figure(CAST, performer.advance(0.0))[:, 1].min()
    for at in np.linspace(0.0, clip.seconds, 5, endpoint=False).tolist():
        performer.play_clip(replace(clip, blend_out=0.0), seconds=0, start=at)
        lowest = omote.evaluate_figure(CAST, performer.advance(0.0))[:, 1].min()
        assert lowest > floor - 0.002, (at, lowest - floor)


def test_a_motion_is_brought_to_the_stage() -> None:
    turned = Rotation.from_rotvec([0.0, 2.0, 0.0])
    turns = WALK.turns.copy()
    turns[:, 0] = (turned * Rotation.from_quat(turns[:, 0])).as_quat()
    away = HumanoidMotion(WALK.times, WALK.names, turns, turned.apply(WALK.hips) + np.array([5.0, 0.0, 3.0]))
    placed, notes = place_motion(away)
    assert len(notes) == 2
    ahead = placed.worlds()["hips"][0].apply([0.0, 0.0, 1.0])
    assert abs(np.arctan2(ahead[0], ahead[2])) < 1e-9
    assert np.abs(placed.hips[0] * [1.0, 0.0, 1.0]).max() < 1e-9
    same, none = place_motion(WALK)
    assert not none
    assert (same.turns == WALK.turns).all()
    steps = moving(tuple(MIXAMO), frames=90)
    walks = HumanoidMotion(
        steps.times, steps.names, WALK.turns[:1].repeat(90, 0), steps.times[:, None] * [0.0, 0.0, 1.5]
    )
    spot, (said,) = place_motion(walks)
    assert "on the spot" in said
    assert np.abs(spot.hips[:, [0, 2]]).max() < FAR


def test_a_face_comes_in_with_the_body_and_alone() -> None:
    count = len(WALK.times)
    ramp = np.linspace(0.0, 1.0, count)
    weights = {"happy": ramp, "blink": ramp, "JawOpen": ramp, "Tail": ramp}
    faced = replace(WALK, weights=weights, gaze=np.column_stack([0.1 * ramp, 0.0 * ramp]))
    clip, notes = clip_of_motion(faced, CAST)
    assert clip.parts == ("brows", "eyes", "mouth", "rest", "gaze", "body")
    assert any("Tail" in note for note in notes)
    frame = sample_clip(clip, rate=RATE)
    for name in ("joy", "eyeBlinkLeft", "jawOpen"):
        assert frame.weights[name] == pytest.approx(ramp, abs=1e-6)
    nods = moving(("hips", "neck", "head"), most=0.3)
    nodding, _ = clip_of_motion(nods, CAST)
    assert nodding.parts == ("head",)


def test_a_cut_is_within_the_motion() -> None:
    clip, _ = clip_of_motion(WALK, CAST, start=0.1, stop=0.3)
    assert clip.seconds == pytest.approx(0.2)
    with pytest.raises(ValueError, match="is no part of the motion"):
        clip_of_motion(WALK, CAST, start=0.1, stop=3.0)
