"""A state says all that a frame says, and what the gaze makes of it."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Frame, Gaze, Head
from omote.perform.performer import Performer
from omote.show.state import call_state, gaze_lids, names_on_air, state_of
from tests.conftest import Command, shows


@given(show=shows)
def test_a_state_is_its_frame(cast: Cast, show: list[Command]) -> None:
    performer = Performer(cast)
    for command in show:
        command.play(performer)
        frame = performer.advance(command.wait)
        state = state_of(cast, frame, epoch=3, number=7, revision=2)
        assert (state.epoch, state.number, state.revision, state.time) == (3, 7, 2, frame.time)
        assert state.light == frame.light
        assert (state.faces, state.expressions, state.channels) == (frame.faces, frame.expressions, frame.channels)
        assert all(math.isfinite(angle) for angle in (*state.eyes, *state.head, *state.gaze))
        assert (state.face_call is None) == (frame.face_call is None)
        assert (state.light_call is None) == (frame.light_call is None)


def test_head_and_gaze_keep_their_order(cast: Cast) -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, head=Head(0.1, 0.2, 0.3), gaze=Gaze(0.2, -0.1))
    state = state_of(cast, frame, epoch=1, number=1, revision=1)
    assert state.head == (0.1, 0.2, 0.3)
    assert state.gaze == (0.2, -0.1)


@given(yaw=st.floats(-0.5, 0.5), pitch=st.floats(-0.4, 0.4))
def test_the_eyes_follow_the_gaze(cast: Cast, yaw: float, pitch: float) -> None:
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, gaze=Gaze(yaw, pitch))
    state = state_of(cast, frame, epoch=1, number=1, revision=1)
    assert state.eyes == pytest.approx((yaw, pitch, yaw, pitch), abs=2e-3)


@given(
    st.dictionaries(st.sampled_from("abcd"), st.floats(-0.5, 1.5)),
    st.dictionaries(st.sampled_from("abcd"), st.floats(-0.5, 1.5)),
)
def test_channels_and_lids_together_are_what_acts(channels: dict[str, float], more: dict[str, float]) -> None:
    effective = {**channels, **more}
    added = gaze_lids(channels, effective)
    for name, weight in effective.items():
        assert channels.get(name, 0.0) + added.get(name, 0.0) == pytest.approx(weight)
    assert 0.0 not in added.values()


def test_no_call_is_no_state() -> None:
    assert call_state(None) is None


def test_names_on_air_are_those_with_weight_and_those_called(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=math.inf)
    performer.call_expression("smile", seconds=math.inf)
    performer.set_channel("jawOpen", 0.5)
    faces, expressions = names_on_air(state_of(cast, performer.advance(0.0), epoch=1, number=1, revision=1))
    assert faces == {"generic", "broad"}
    assert expressions == {"neutral", "smile", "jawOpen"}
