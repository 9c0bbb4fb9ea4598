"""What older versions wrote becomes a scene of one character, and what is no snapshot is rejected."""

from typing import Any

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.state import state_of
from tests.conftest import random_moves


@pytest.mark.parametrize("seed", range(5))
def test_a_performer_alone_plays_on_as_the_first_character(cast: Cast, seed: int) -> None:
    performer = Performer(cast)
    performer.call_light("flat", seconds=100.0)
    for command in random_moves(seed, 30):
        command.play(performer)
        performer.advance(command.wait)
    written = msgspec.msgpack.encode({"performer": performer.snapshot(), "calls": ["a", "b"]})
    snapshot, limited = read_session_snapshot(msgspec.msgpack.decode(written))
    session = ShowSession.restored(cast, snapshot, epoch=2)
    frame = session.scene.advance(0.3)
    assert (limited, session.snapshot().executed) == (False, {})
    alone = performer.advance(0.3)
    assert frame.characters["one"].frame == alone
    assert (frame.light, frame.light_call, frame.time) == (alone.light, alone.light_call, alone.time)
    state = state_of(cast, frame, epoch=1, number=1, revision=1)
    assert (state.characters["one"].label, state.characters["one"].presence) == ("One", 1.0)


def test_what_this_version_writes_it_reads(cast: Cast) -> None:
    session = ShowSession(cast)
    written = msgspec.msgpack.encode(session.snapshot())
    assert read_session_snapshot(msgspec.msgpack.decode(written)) == (session.snapshot(), False)


@pytest.mark.parametrize("saved", [None, 3, [], {}, {"performer": 3, "calls": []}, {"performer": {}}, {"scene": {}}])
def test_what_is_none_is_rejected(saved: Any) -> None:
    with pytest.raises((ValueError, TypeError)):
        read_session_snapshot(saved)
