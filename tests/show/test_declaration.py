"""Every command reaches the scene and its characters, as it declares."""

import math

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show.access.access_role import HIGHEST
from omote.show.declaration import CharacterCommand, ClientMessage, SceneCommand, characters_of
from omote.show.messages import CLIENT_MESSAGES, PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace, FadeFace
from omote.show.objects.characters import (
    AddCharacter,
    EnterCharacter,
    LeaveCharacter,
    PlaceCharacter,
    RemoveCharacter,
    RestoreCharacter,
)
from omote.show.objects.faders import SetChannel
from omote.show.objects.gaze_points import DeleteGazePoint, SetGazePoint
from omote.show.objects.link import Hello
from omote.show.objects.motion import LookAt
from omote.show.objects.pictures import CallFraming, CallLight
from omote.show.objects.stages import Drawing, StageReport
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.validation import Refusal


def carry_out(scene: Scene, message: ClientMessage) -> None:
    """What a command does to a scene alone."""
    if isinstance(message, CharacterCommand):
        for name in characters_of(scene, message.character):
            message.play(scene[name])
    elif isinstance(message, SceneCommand):
        message.change(scene)


def test_a_call_in_seconds_runs_and_one_by_hand_waits(cast: Cast) -> None:
    scene = Scene.begun(cast)
    carry_out(scene, CallFace("one", "1", "broad", 1.0, "smooth"))
    carry_out(scene, CallExpression("one", "2", "smile", None, "smooth"))
    frame = scene.advance(1.0).characters["one"].frame
    assert (frame.faces, frame.expressions) == ({"broad": 1.0}, {"neutral": 1.0})


def test_a_call_in_a_region_runs_there_alone_and_has_no_t_bar(cast: Cast) -> None:
    scene = Scene.begun(cast)
    carry_out(scene, CallExpression("one", "1", "smile", 1.0, "smooth", "mouth"))
    frame = scene.advance(1.0).characters["one"].frame
    assert (frame.expressions, frame.regions) == ({"neutral": 1.0}, {"mouth": {"smile": 1.0}})
    with pytest.raises(Refusal, match="a region of a face has no T-bar: give the seconds"):
        carry_out(scene, CallExpression("one", "2", "jawOpen", None, "smooth", "mouth"))


@pytest.mark.parametrize(
    "call",
    [
        CallFace("one", "1", "broad", math.inf, "smooth"),
        CallExpression("one", "1", "smile", math.inf, "smooth"),
        CallLight("1", "flat", math.inf, "smooth"),
        CallFraming("1", ["one"], math.inf, "smooth"),
        EnterCharacter("1", "one", math.inf),
        LeaveCharacter("1", "one", math.inf),
        PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, math.inf),
    ],
    ids=lambda call: type(call).__name__,
)
def test_infinite_seconds_are_no_word_of_the_wire(cast: Cast, call: ClientMessage) -> None:
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
    carry_out(scene, FadeFace("*", 0.5))
    carry_out(scene, SetChannel("two", "jawOpen", 0.25))
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
        carry_out(scene, RemoveCharacter("1", "one"))
    scene.add("two")
    carry_out(scene, RemoveCharacter("2", "one"))
    with pytest.raises(Refusal, match="two is the last character"):
        carry_out(scene, RemoveCharacter("3", "two"))
    assert list(scene.advance(2.0).characters) == ["two"]


def test_every_message_says_what_it_does_and_who_may_send_it() -> None:
    silent = {kind for kind in CLIENT_MESSAGES if kind.act is ClientMessage.act}
    silent |= {
        kind
        for kind in CLIENT_MESSAGES
        if issubclass(kind, CharacterCommand)
        if (kind.play, kind.act) == (CharacterCommand.play, CharacterCommand.act)
    }
    silent |= {
        kind
        for kind in CLIENT_MESSAGES
        if issubclass(kind, SceneCommand)
        if (kind.change, kind.act) == (SceneCommand.change, SceneCommand.act)
    }
    assert silent == set()
    assert {kind.__name__ for kind in CLIENT_MESSAGES if kind.access == HIGHEST} == {
        "SetLeases",
        "AppointManager",
        "DeleteRecording",
        "SetShowMode",
    }


def test_a_removed_character_comes_back_by_its_key_or_its_name(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two", face="broad")
    for key, found in (("", "two"), ("a-7", "a-7")):
        carry_out(scene, RemoveCharacter("1", "two", key=key))
        assert "two" not in scene.advance(5.0).characters
        carry_out(scene, RestoreCharacter("2", found, 0.5))
        assert scene.advance(5.0).characters["two"].frame.faces == {"broad": 1.0}
    with pytest.raises(ValueError, match="there is no removed character 'two'"):
        carry_out(scene, RestoreCharacter("3", "two", 0.5))


def test_all_look_at_one_but_that_one_itself(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("c", Hello("console", PROTOCOL_VERSION, "c"), 0.0)
    session.receive("c", AddCharacter("1", "two", "Two", "generic"), 0.0)
    session.receive("c", LookAt("two", "direction", yaw=0.5), 0.0)
    assert session.receive("c", LookAt("*", "character", "two"), 0.0) == []
    characters = session.tick(0.0).characters
    motions = [each.motion for each in characters.values()]
    assert [None if each is None else each.target.kind for each in motions] == ["character", "direction"]
    (refused,) = session.receive("c", LookAt("two", "character", "two"), 0.0)
    assert "cannot look at itself" in str(refused.message)


def test_gaze_points_are_kept_with_the_show_and_an_order_executes_once(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("c", Hello("console", PROTOCOL_VERSION, "c"), 0.0)
    assert session.receive("c", SetGazePoint("1", "box", 1.0, 2.0, 3.0), 0.0) == []
    session.receive("c", SetGazePoint("1", "box", 9.0, 9.0, 9.0), 0.0)
    session.receive("c", LookAt("one", "gaze_point", "box"), 0.0)
    session.tick(0.0)
    saved = msgspec.msgpack.decode(msgspec.msgpack.encode(session.snapshot()))
    restored = ShowSession.restored(cast, read_session_snapshot(saved)[0], epoch=2)
    state = restored.tick(0.0)
    assert state.gaze_points == {"box": (1.0, 2.0, 3.0)}
    assert state.characters["one"].motion is not None
    assert state.characters["one"].motion.target.name == "box"
    restored.receive("c", Hello("console", PROTOCOL_VERSION, "c"), 0.0)
    assert restored.receive("c", DeleteGazePoint("2", "box"), 0.0) == []
    assert restored.tick(0.0).gaze_points == {}
    (refused,) = restored.receive("c", DeleteGazePoint("3", "box"), 0.0)
    assert "gaze point" in str(refused.message)


def test_a_stage_says_where_its_camera_is(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert session.receive("s", Drawing(60.0, "high", "left", (-0.5, 0.1, 1.5)), 0.0) == []
    session.receive("s", Drawing(60.0, "high", "left"), 0.0)
    assert session.snapshot().scene.cameras == {"left": (-0.5, 0.1, 1.5)}
    assert session.crew_now(0.0).stages == [StageReport(60.0, "high", "left")]
    (refused,) = session.receive("s", Drawing(60.0, "high", "left", (0.0, 0.0, 1e9)), 0.0)
    assert "camera of the stage" in str(refused.message)
