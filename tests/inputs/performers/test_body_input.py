"""Bodies before cameras at a session: worn by the figure that their performer's face plays, or by another; lost."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.inputs.camera.body_points import BodyPoints, write_body_points
from omote.inputs.camera.solve_body import ELBOW, WRIST
from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.body_input import BodyInput
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.model.body.pose_regions import POSE_REGIONS, region_bones
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.packed_pose import unpack_pose
from omote.perform.figures.pose_mix import mix_poses
from omote.perform.figures.tracked_body import with_tracked
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello
from omote.show.objects.sources import RouteSource
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession
from tests.inputs.camera.bodies import FIGURES, RESTING, SKELETON, filmed_body, joints_of

TICK = 1.0 / 30.0
FADED = 1e-4
WHOLE = {"head": 0.0, "stance": 0.0, "trunk": 1.0, "arm_left": 1.0, "arm_right": 1.0}
STAND, PRESENT = (joints_of(FIGURES.poses[name]) for name in ("stand", "present"))


class Stage:
    """A session with a body, and its performer's face beside it."""

    def __init__(self) -> None:
        self.session = ShowSession(load_cast())
        self.session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
        self.faces = TrackerInput(TRACKER_PROTOCOLS["vmc"], lambda: self.session)
        self.bodies = BodyInput(lambda: self.session, self.faces)
        self.now = 0.0

    def play(self, seconds: float, joints: object, hidden: tuple[int, ...] = ()) -> dict[str, CharacterState]:
        """Plays one who does a pose. joints: of `joints_of`, None for nobody."""
        for _ in range(round(seconds / TICK)):
            if joints is None:
                seen = BodyPoints(None, 640, 480, self.now)
            else:
                seen = filmed_body(np.asarray(joints), self.now, hidden)
            assert self.bodies.receive("Ada", write_body_points(seen), self.now) == ""
            self.bodies.play(self.now)
            self.now += TICK
            state = self.session.tick(self.now)
        return dict(state.characters)


@pytest.fixture
def stage() -> Stage:
    return Stage()


def shares(character: CharacterState) -> dict[str, float]:
    """How much of each region is tracked."""
    tracked = None if character.figure is None else character.figure.tracked
    return {} if tracked is None else dict(zip(POSE_REGIONS, tracked.shares, strict=True))


def worn(character: CharacterState) -> np.ndarray:
    """Where the joints of a standing figure are that wears the tracked pose, metres."""
    tracked = None if character.figure is None else character.figure.tracked
    assert tracked is not None
    numbers = unpack_pose(tracked.pose, len(SKELETON.names))
    bones = tuple(region_bones(SKELETON).values())
    mixed = mix_poses(FIGURES.poses, {"stand": 1.0}, {}, {})
    return pose_figure(FIGURES.space, RESTING, with_tracked(mixed, tuple(tracked.shares), numbers, bones)).joints


def test_a_body_is_worn_by_the_figure_and_its_arms_are_where_the_performer_has_them(stage: Stage) -> None:
    stage.play(2.5, STAND)
    character = stage.play(3.0, PRESENT)["one"]
    assert shares(character) == pytest.approx(
        {"head": 0, "stance": 0, "trunk": 1, "arm_left": 1, "arm_right": 1}, abs=0.01
    )
    found = worn(character)
    for side in "LR":
        for bone in ("lowerarm01", "wrist"):
            place = SKELETON.places[f"{bone}.{side}"]
            assert np.linalg.norm(found[place] - PRESENT[place]) < 0.06, (bone, side)
    choice = stage.bodies.choice("Ada")
    assert choice.known
    assert [each.played for each in choice.characters] == [True]


def test_an_arm_out_of_the_picture_goes_back_to_what_is_called_and_nobody_gives_all_back(stage: Stage) -> None:
    stage.play(2.5, STAND)
    stage.play(2.0, PRESENT)
    character = stage.play(3.0, PRESENT, hidden=(ELBOW, WRIST))["one"]
    assert shares(character)["arm_left"] == pytest.approx(0.0, abs=0.01)
    assert shares(character)["arm_right"] == pytest.approx(1.0, abs=0.01)
    assert all(share < FADED for share in shares(stage.play(4.0, None)["one"]).values())


def test_a_body_plays_whom_its_face_plays_until_it_is_told_another(stage: Stage) -> None:
    stage.session.receive("console", AddCharacter("1", "two", "Two", "man"), 0.0)
    assert not shares(stage.play(2.5, STAND)["one"]), "of two characters neither is taken"
    route = RouteSource("2", stage.faces.title("", "Ada"), ["one"], "tracker", [])
    stage.session.receive("console", route, stage.now)
    stage.play(0.5, STAND)
    characters = stage.play(1.0, PRESENT)
    assert shares(characters["one"])["arm_left"] > 0.5
    assert shares(characters["two"]) == {}
    stage.bodies.obey("Ada", wire.PlayBody(["two"]))
    characters = stage.play(4.0, PRESENT)
    assert all(share < FADED for share in shares(characters["one"]).values())
    assert shares(characters["two"])["arm_left"] > 0.9
    with pytest.raises(ValueError, match="nobody"):
        stage.bodies.obey("Ada", wire.PlayBody(["nobody"]))


def test_a_face_of_one_performer_and_a_body_of_another_play_one_character(stage: Stage) -> None:
    stage.session.receive("console", RouteSource("1", stage.faces.title("", "Bo"), ["one"], "tracker", []), 0.0)
    stage.bodies.obey("Ada", wire.PlayBody(["one"]))
    stage.play(2.5, STAND)
    for _ in range(40):
        stage.faces.note("", TrackerFrame({"jawOpen": 0.6}, (0.3, 0.0, 0.0), subject="Bo"))
        stage.faces.play(stage.now)
        character = stage.play(TICK, PRESENT)["one"]
    assert character.channels["jawOpen"] > 0.3
    assert character.head[0] > 0.15
    assert shares(character)["arm_left"] > 0.9
    assert shares(character)["head"] == 0.0


def test_rest_is_measured_again_and_damage_is_said(stage: Stage) -> None:
    stage.play(2.5, STAND)
    assert stage.bodies.choice("Ada").known
    stage.bodies.obey("Ada", wire.RestBody())
    assert not stage.bodies.choice("Ada").known
    assert "bytes" in stage.bodies.receive("Ada", b"OMBL", stage.now)
    stage.play(2.5, STAND)
    assert stage.bodies.choice("Ada").known
    stage.bodies.end("Ada")
    assert stage.bodies.choice("Ada").heard == 0
