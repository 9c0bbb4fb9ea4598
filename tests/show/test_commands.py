"""Every command of a console reaches the scene and its characters, by the tables."""

import math
from typing import get_args

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show import messages as wire
from omote.show.commands import ACTIONS, SCENE_ACTIONS, carry_out, characters_of, refuse_unknown
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.sources.open_sources import SOURCE_CHANGES
from omote.show.validation import Refusal


def test_a_call_in_seconds_runs_and_one_by_hand_waits(cast: Cast) -> None:
    scene = Scene.begun(cast)
    carry_out(scene, wire.CallFace("one", "1", "broad", 1.0, "smooth"))
    carry_out(scene, wire.CallExpression("one", "2", "smile", None, "smooth"))
    frame = scene.advance(1.0).characters["one"].frame
    assert (frame.faces, frame.expressions) == ({"broad": 1.0}, {"neutral": 1.0})


def test_a_call_in_a_region_runs_there_alone_and_has_no_t_bar(cast: Cast) -> None:
    scene = Scene.begun(cast)
    carry_out(scene, wire.CallExpression("one", "1", "smile", 1.0, "smooth", "mouth"))
    frame = scene.advance(1.0).characters["one"].frame
    assert (frame.expressions, frame.regions) == ({"neutral": 1.0}, {"mouth": {"smile": 1.0}})
    with pytest.raises(Refusal, match="a region of a face has no T-bar: give the seconds"):
        carry_out(scene, wire.CallExpression("one", "2", "jawOpen", None, "smooth", "mouth"))


@pytest.mark.parametrize(
    "call",
    [
        wire.CallFace("one", "1", "broad", math.inf, "smooth"),
        wire.CallExpression("one", "1", "smile", math.inf, "smooth"),
        wire.CallLight("1", "flat", math.inf, "smooth"),
        wire.CallFraming("1", ["one"], math.inf, "smooth"),
        wire.EnterCharacter("1", "one", math.inf),
        wire.LeaveCharacter("1", "one", math.inf),
        wire.PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, math.inf),
    ],
    ids=lambda call: type(call).__name__,
)
def test_infinite_seconds_are_no_word_of_the_wire(cast: Cast, call: wire.FromClient) -> None:
    with pytest.raises(ValueError, match="seconds"):
        carry_out(Scene.begun(cast), call)


def test_a_message_is_for_one_character_or_for_all_of_them(cast: Cast) -> None:
    scene = Scene.begun(cast)
    for name in ("two", "three"):
        scene.add(name)
    assert characters_of(scene, "*") == ("one", "two", "three")
    assert characters_of(scene, "two") == ("two",)
    with pytest.raises(ValueError, match="there is no character 'tow'"):
        characters_of(scene, "tow")
    for nobody in ("*", "tow"):
        with pytest.raises(Refusal, match="there is no character"):
            refuse_unknown(scene, nobody)
    carry_out(scene, wire.FadeFace("*", 0.5))
    carry_out(scene, wire.SetChannel("two", "jawOpen", 0.25))
    frames = {name: character.frame for name, character in scene.advance(0.0).characters.items()}
    assert {frame.face_fader for frame in frames.values()} == {0.5}
    assert {name: dict(frame.channels) for name, frame in frames.items()} == {
        "one": {},
        "two": {"jawOpen": 0.25},
        "three": {},
    }


def test_the_last_character_stays(cast: Cast) -> None:
    scene = Scene.begun(cast)
    with pytest.raises(Refusal, match="One is the last character"):
        carry_out(scene, wire.RemoveCharacter("1", "one"))
    scene.add("two")
    carry_out(scene, wire.RemoveCharacter("2", "one"))
    with pytest.raises(Refusal, match="two is the last character"):
        carry_out(scene, wire.RemoveCharacter("3", "two"))
    assert list(scene.advance(2.0).characters) == ["two"]


def test_every_message_that_plays_has_an_action() -> None:
    asked = {*get_args(wire.KeepMessage), *get_args(wire.DeviceMessage), *get_args(wire.LeaseMessage)}
    others = {*wire.CLIENT_MESSAGES} - {*ACTIONS, *SCENE_ACTIONS}
    assert others == asked | {
        *SOURCE_CHANGES,
        wire.Source,
        wire.Drive,
        wire.LeaveSource,
        wire.WatchSource,
        wire.Hello,
        wire.Cancel,
        wire.Ping,
        wire.Drawing,
    }


def test_a_removed_character_comes_back_by_its_key_or_its_name(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two", face="broad")
    for key, found in (("", "two"), ("a-7", "a-7")):
        carry_out(scene, wire.RemoveCharacter("1", "two", key))
        assert "two" not in scene.advance(5.0).characters
        carry_out(scene, wire.RestoreCharacter("2", found, 0.5))
        assert scene.advance(5.0).characters["two"].frame.faces == {"broad": 1.0}
    with pytest.raises(ValueError, match="there is no removed character 'two'"):
        carry_out(scene, wire.RestoreCharacter("3", "two", 0.5))


def test_all_look_at_one_but_that_one_itself(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("c", wire.Hello("console", wire.PROTOCOL_VERSION, "c"), 0.0)
    session.receive("c", wire.AddCharacter("1", "two", "Two", "generic"), 0.0)
    session.receive("c", wire.LookAt("two", "direction", yaw=0.5), 0.0)
    assert session.receive("c", wire.LookAt("*", "character", "two"), 0.0) == []
    characters = session.tick(0.0).characters
    motions = [each.motion for each in characters.values()]
    assert [None if each is None else each.target.kind for each in motions] == ["character", "direction"]
    (refused,) = session.receive("c", wire.LookAt("two", "character", "two"), 0.0)
    assert "cannot look at itself" in str(refused.message)


def test_gaze_points_are_kept_with_the_show_and_an_order_executes_once(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("c", wire.Hello("console", wire.PROTOCOL_VERSION, "c"), 0.0)
    assert session.receive("c", wire.SetGazePoint("1", "box", 1.0, 2.0, 3.0), 0.0) == []
    session.receive("c", wire.SetGazePoint("1", "box", 9.0, 9.0, 9.0), 0.0)
    session.receive("c", wire.LookAt("one", "gaze_point", "box"), 0.0)
    session.tick(0.0)
    saved = msgspec.msgpack.decode(msgspec.msgpack.encode(session.snapshot()))
    restored = ShowSession.restored(cast, read_session_snapshot(saved)[0], epoch=2)
    state = restored.tick(0.0)
    assert state.gaze_points == {"box": (1.0, 2.0, 3.0)}
    assert state.characters["one"].motion is not None
    assert state.characters["one"].motion.target.name == "box"
    restored.receive("c", wire.Hello("console", wire.PROTOCOL_VERSION, "c"), 0.0)
    assert restored.receive("c", wire.DeleteGazePoint("2", "box"), 0.0) == []
    assert restored.tick(0.0).gaze_points == {}
    (refused,) = restored.receive("c", wire.DeleteGazePoint("3", "box"), 0.0)
    assert "gaze point" in str(refused.message)


def test_a_stage_says_where_its_camera_is(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("s", wire.Hello("stage", wire.PROTOCOL_VERSION), 0.0)
    assert session.receive("s", wire.Drawing(60.0, "high", "left", (-0.5, 0.1, 1.5)), 0.0) == []
    session.receive("s", wire.Drawing(60.0, "high", "left"), 0.0)
    assert session.snapshot().scene.cameras == {"left": (-0.5, 0.1, 1.5)}
    assert session.crew_now(0.0).stages == [wire.StageReport(60.0, "high", "left")]
    (refused,) = session.receive("s", wire.Drawing(60.0, "high", "left", (0.0, 0.0, 1e9)), 0.0)
    assert "camera of the stage" in str(refused.message)
