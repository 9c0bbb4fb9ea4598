"""Whom or what the characters of a scene look at."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Frame
from omote.perform.limits import GAZE_LIMITS
from omote.perform.motion.automatic_motion import EYE_RANGE
from omote.perform.scene.gaze_targets import MOST_CAMERAS, MOST_POINTS, SHORTEST_BREAK, contacts
from omote.perform.scene.scene import Scene


def pair(cast: Cast, turn: float = 0.0) -> Scene:
    """Two on one stage; the first is turned."""
    scene = Scene.begun(cast)
    scene.add("two")
    scene.enter("two", seconds=0.0)
    scene.place("one", x=-0.6, turn=turn, seconds=0.0)
    scene.place("two", x=0.6, seconds=0.0)
    return scene


def later(scene: Scene, seconds: float = 4.0) -> dict[str, Frame]:
    """What each shows some time later."""
    for _ in range(round(60 * seconds)):
        frame = scene.advance(1 / 60)
    return {name: each.frame for name, each in frame.characters.items()}


@pytest.mark.parametrize("turn", [0.0, 0.7, -0.9, 3.0])
def test_a_character_looks_at_another_whatever_way_it_stands(cast: Cast, turn: float) -> None:
    """Head and eyes together, or as far as they can."""
    scene = pair(cast, turn)
    scene["one"].look_at("character", "two")
    shown = later(scene)["one"]
    eyes = 0.108 * math.sin(turn + shown.head.yaw), 0.108 * math.cos(turn + shown.head.yaw)
    wanted = math.remainder(math.atan2(1.2 - eyes[0], 0.108 - eyes[1]) - turn, math.tau)
    if abs(wanted) < 1.7:
        assert shown.head.yaw + shown.gaze.yaw == pytest.approx(wanted, abs=0.02)
    else:
        assert abs(shown.gaze.yaw) == pytest.approx(EYE_RANGE.yaw, abs=0.01)
        assert shown.gaze.yaw * wanted > 0.0
    assert abs(shown.gaze.yaw) <= EYE_RANGE.yaw < GAZE_LIMITS["yaw"]


def test_a_named_point_a_camera_and_a_direction(cast: Cast) -> None:
    scene = pair(cast)
    scene.set_gaze_point(" front row ", x=0.6, y=-0.5, z=2.0)
    scene["one"].look_at("gaze_point", "front row")
    below = later(scene)["one"]
    assert below.gaze.pitch + below.head.pitch < -0.1
    scene.note_camera("left", (-3.0, 0.0, 1.0))
    scene["one"].look_at("stage", "left")
    aside = later(scene)["one"]
    assert aside.gaze.yaw + aside.head.yaw < -0.8
    scene["one"].look_at("direction", yaw=0.25)
    assert later(scene)["one"].gaze.yaw == pytest.approx(0.25, abs=0.01)


def test_a_stage_that_there_is_not_is_named_with_those_that_there_are(cast: Cast) -> None:
    scene = pair(cast)
    with pytest.raises(ValueError, match=r"no stage 'nosuch' in .* has none with a name; open /stage\?name=nosuch"):
        scene["one"].look_at("stage", "nosuch")
    for stage in ("left", "right", ""):
        scene.note_camera(stage, (-3.0, 0.0, 1.0))
    with pytest.raises(ValueError, match="which has 'left', 'right'; open"):
        scene["one"].look_at("stage", "lef")
    scene["one"].look_at("stage", "right")
    scene["one"].look_at("stage")


def test_who_has_left_is_looked_at_no_more_and_again_when_back(cast: Cast) -> None:
    scene = pair(cast)
    scene["one"].look_at("character", "two")
    looks = later(scene)["one"].head.yaw
    scene.leave("two", seconds=0.0)
    assert abs(later(scene)["one"].head.yaw) < 0.05 < looks
    scene.enter("two", seconds=0.0)
    assert later(scene)["one"].head.yaw == pytest.approx(looks, abs=0.02)
    scene.remove("two", seconds=0.0)
    assert abs(later(scene)["one"].head.yaw) < 0.05


def test_a_deleted_point_is_looked_at_no_more(cast: Cast) -> None:
    scene = pair(cast)
    scene.set_gaze_point("box", x=3.0, y=0.5, z=1.0)
    scene["two"].look_at("gaze_point", "box")
    scene.delete_gaze_point("box")
    frame = scene.advance(0.0)
    assert frame.gaze_points == {}
    motion = frame.characters["two"].frame.motion
    assert motion is not None
    assert motion.target.kind == "ahead"


def test_a_scene_that_looks_goes_on_from_a_snapshot_bit_for_bit(cast: Cast) -> None:
    scene = pair(cast)
    scene.set_gaze_point("box", x=3.0, y=0.5, z=1.0)
    scene.note_camera("", (0.1, 0.2, 1.3))
    scene["one"].look_at("character", "two")
    scene["two"].look_at("character", "one")
    for name in scene:
        scene[name].set_motion(0.5, seed=len(name))
    later(scene, 1.0)
    other = Scene.restored(cast, scene.snapshot())
    for _ in range(200):
        assert scene.advance(1 / 60) == other.advance(1 / 60)


def test_nobody_is_looked_at_who_is_not_there(cast: Cast) -> None:
    scene = pair(cast)
    with pytest.raises(ValueError, match="there is no character 'three'"):
        scene["one"].look_at("character", "three")
    with pytest.raises(ValueError, match="cannot look at itself"):
        scene["one"].look_at("character", "one")
    with pytest.raises(ValueError, match="gaze point"):
        scene["one"].look_at("gaze_point", "box")
    with pytest.raises(ValueError, match="gaze point"):
        scene.delete_gaze_point("box")


def test_points_have_a_name_and_are_not_without_end(cast: Cast) -> None:
    scene = pair(cast)
    for number in range(MOST_POINTS):
        scene.set_gaze_point(f"seat {number}", x=0.0, y=0.0, z=2.0)
    scene.set_gaze_point("seat 1", x=1.0, y=0.0, z=2.0)
    with pytest.raises(ValueError, match="as many as a show keeps"):
        scene.set_gaze_point("one more", x=0.0, y=0.0, z=2.0)
    for wrong in ("", "x" * 41):
        with pytest.raises(ValueError, match="name of a gaze point"):
            scene.set_gaze_point(wrong, x=0.0, y=0.0, z=2.0)
    with pytest.raises(ValueError, match="y of the gaze point seat 1"):
        scene.set_gaze_point("seat 1", x=0.0, y=99.0, z=2.0)


def test_no_more_cameras_are_kept_than_stages_can_be(cast: Cast) -> None:
    scene = pair(cast)
    for number in range(MOST_CAMERAS + 5):
        scene.note_camera(str(number), (0.0, 0.0, 1.0))
    assert len(scene.snapshot().cameras) == MOST_CAMERAS
    with pytest.raises(ValueError, match="camera of the stage '1'"):
        scene.note_camera("1", (0.0, math.nan, 1.0))


SEEDS = st.tuples(st.integers(0, 2**31 - 1), st.integers(0, 2**31 - 1))
STEP = 1 / 30


def spells(met: list[bool]) -> list[tuple[bool, float]]:
    """The spells of a sequence but the first and the last, with their seconds."""
    ends = np.flatnonzero(np.diff(met)) + 1
    return [(met[begin], (end - begin) * STEP) for begin, end in itertools.pairwise(ends)]


@given(SEEDS)
def test_they_meet_each_others_eyes_in_spells_of_one_to_five_seconds(seeds: tuple[int, int]) -> None:
    seen = [contacts(seeds, step * STEP) for step in range(9000)]
    found = spells([one and other for one, other in seen])
    meeting = [seconds for met, seconds in found if met]
    breaks = [seconds for met, seconds in found if not met]
    assert min(meeting) >= 1.0 - 2 * STEP
    assert max(meeting) <= 5.0 + 2 * STEP
    assert min(breaks) >= SHORTEST_BREAK - 2 * STEP
    assert 0.3 < sum(meeting) / (sum(meeting) + sum(breaks)) < 0.6


@given(SEEDS)
def test_now_one_and_now_the_other_looks_away_first(seeds: tuple[int, int]) -> None:
    seen = [contacts(seeds, step / 10) for step in range(6000)]
    first = [after for before, after in itertools.pairwise(seen) if before == (True, True) != after]
    assert (False, True) in first
    assert (True, False) in first
    assert all(any(each) for each in first), "both never look away at once"
