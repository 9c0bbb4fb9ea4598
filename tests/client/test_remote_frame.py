"""Frames read from the wire are the engine's own."""

from hypothesis import given

from omote.client.remote_frame import frame_in
from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.show.objects.state import State
from omote.show.state import state_of
from omote.show.wire import decode_answer, encode
from tests.conftest import Command, shows


@given(shows)
def test_a_frame_comes_through_the_wire_as_the_performer_gave_it(cast: Cast, show: list[Command]) -> None:
    scene = Scene.begun(cast)
    for command in show:
        command.play(scene["one"])
        frame = scene.advance(command.wait)
        state = decode_answer(encode(state_of(cast, frame, epoch=1, number=1, revision=1)))
        assert isinstance(state, State)
        assert frame_in(state, state.characters["one"]) == frame.characters["one"].frame
