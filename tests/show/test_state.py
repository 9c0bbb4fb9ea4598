"""A state says all that a frame says, and what the gaze makes of it."""

import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import Frame, Gaze, Head
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import CharacterFrame, Place, SceneFrame
from omote.show.objects.state import State
from omote.show.state import EyeOffset, added_to, call_state, names_on_air, state_of
from tests.conftest import Command, shows


@given(show=shows)
def test_a_state_is_its_frame(cast: Cast, show: list[Command]) -> None:
    scene = Scene.begun(cast)
    scene.place("one", x=0.2, depth=0.5, size=2.0, turn=-0.1, seconds=3.0)
    scene.call_black(0.75, seconds=3.0)
    for command in show:
        command.play(scene["one"])
        whole = scene.advance(command.wait)
        character = whole.characters["one"]
        frame = whole.characters["one"].frame
        state = state_of(cast, whole, epoch=3, number=7, revision=2)
        place = state.characters["one"].place
        assert Place(place.x, place.depth, place.size, place.turn) == character.place
        assert (state.characters["one"].presence, state.characters["one"].label) == (1.0, "One")
        assert (state.framing, state.framing_call) == (whole.framing, None)
        assert (state.epoch, state.number, state.revision, state.time) == (3, 7, 2, frame.time)
        assert state.light == frame.light
        assert (state.black, state.black_goal) == (whole.black, 0.75)
        assert (
            state.characters["one"].faces,
            state.characters["one"].expressions,
            state.characters["one"].channels,
        ) == (frame.faces, frame.expressions, frame.channels)
        assert all(
            math.isfinite(angle)
            for angle in (*state.characters["one"].eyes, *state.characters["one"].head, *state.characters["one"].gaze)
        )
        assert (state.characters["one"].face_call is None) == (frame.face_call is None)
        assert (state.light_call is None) == (frame.light_call is None)


def test_head_and_gaze_keep_their_order(cast: Cast) -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, head=Head(0.1, 0.2, 0.3), gaze=Gaze(0.2, -0.1))
    state = alone(cast, frame)
    assert state.characters["one"].head == (0.1, 0.2, 0.3)
    assert state.characters["one"].gaze == (0.2, -0.1)


@given(yaw=st.floats(-0.5, 0.5), pitch=st.floats(-0.4, 0.4))
def test_the_eyes_follow_the_gaze(cast: Cast, yaw: float, pitch: float) -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, gaze=Gaze(yaw, pitch))
    state = alone(cast, frame)
    assert state.characters["one"].eyes == pytest.approx((yaw, pitch, yaw, pitch), abs=2e-3)


@given(
    st.dictionaries(st.sampled_from("abcd"), st.floats(-0.5, 1.5)),
    st.dictionaries(st.sampled_from("abcd"), st.floats(-0.5, 1.5)),
)
def test_channels_and_lids_together_are_what_acts(channels: dict[str, float], more: dict[str, float]) -> None:
    effective = {**channels, **more}
    added = added_to(channels, effective)
    for name, weight in effective.items():
        assert channels.get(name, 0.0) + added.get(name, 0.0) == pytest.approx(weight)
    assert 0.0 not in added.values()


def test_no_call_is_no_state() -> None:
    assert call_state(None) is None


def test_names_on_air_are_those_with_weight_and_those_called(cast: Cast) -> None:
    scene = Scene.begun(cast)
    two = scene.add("two", face="long")
    scene["one"].call_face("broad", seconds=math.inf)
    scene["one"].call_expression("smile", seconds=math.inf)
    two.set_channel("jawOpen", 0.5)
    faces, expressions = names_on_air(state_of(cast, scene.advance(0.0), epoch=1, number=1, revision=1))
    assert faces == {"generic", "broad", "long"}
    assert expressions == {"neutral", "smile", "jawOpen"}


def test_names_on_air_in_a_region_alone_and_those_called_there_count(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene["one"].call_expression("smile", seconds=0.0, region="mouth")
    scene["one"].call_expression("jawOpen", seconds=1.0, region="brows")
    state = state_of(cast, scene.advance(0.0), epoch=1, number=1, revision=1)
    one = state.characters["one"]
    assert (one.expressions, one.regions["mouth"]) == ({"neutral": 1.0}, {"smile": 1.0})
    assert {region: call.target for region, call in one.region_calls.items()} == {"brows": "jawOpen"}
    assert names_on_air(state)[1] == {"neutral", "smile", "jawOpen"}


def test_eyeballs_stand_as_the_region_of_the_eyes_has_them(cast: Cast) -> None:
    looking = {"eyeLookOutLeft": 1.0}
    away = alone(cast, Frame({"generic": 1.0}, looking)).characters["one"].eyes
    frames = {region: Frame({"generic": 1.0}, {"neutral": 1.0}, regions={region: looking}) for region in PLAY_REGIONS}
    eyes = {region: alone(cast, frame).characters["one"].eyes for region, frame in frames.items()}
    assert any(away)
    assert eyes == {**dict.fromkeys(PLAY_REGIONS, (0.0, 0.0, 0.0, 0.0)), "eyes": away}


def test_what_eases_at_the_eyes_of_one_character_is_its_own(cast: Cast) -> None:
    scene = Scene.begun(cast)
    scene.add("two")
    offsets = {"two": EyeOffset((0.1, 0.2, 0.3, 0.4), 0.0)}
    characters = state_of(cast, scene.advance(0.0), offsets, epoch=1, number=1, revision=1).characters
    assert characters["one"].eyes == (0.0, 0.0, 0.0, 0.0)
    assert characters["two"].eyes == (0.1, 0.2, 0.3, 0.4)


def test_a_record_without_black_has_the_picture_up(cast: Cast) -> None:
    record = msgspec.to_builtins(state_of(cast, Scene.begun(cast).advance(0.0), epoch=1, number=1, revision=1))
    del record["black"], record["black_goal"]
    assert msgspec.convert(record, State).black == 0.0


def alone(cast: Cast, frame: Frame) -> State:
    """The state of one character that shows a frame."""
    characters = {"one": CharacterFrame(frame, Place(), 1.0, "One")}
    return state_of(cast, SceneFrame(characters, frame.light, {"*": 1.0}), epoch=1, number=1, revision=1)
