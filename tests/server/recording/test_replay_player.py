"""A player of recordings shows the state of where it is, however it came there."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.server.recording.recorded_show import RecordedShow
from omote.server.recording.replay_player import ReplayPlayer, TransportRequest
from omote.show.wire import encode
from omote.showfile.recording_file import open_recording, recording_path
from tests import synthetic
from tests.server.recording.test_recorded_show import record

CAST = synthetic.cast()
SECONDS = 6.0


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[RecordedShow, list[bytes], list[float]]]:
    """A recording, its states and their times from its beginning."""
    path = recording_path(tmp_path_factory.mktemp("played") / "show.omote")
    show = record(path, 6, SECONDS)
    file = open_recording(path)
    reading = RecordedShow(file, CAST)
    span = reading.find_span()
    times = [tick.now - span.first for tick in reading.replay(span)]
    yield reading, show.states, times
    reading.close()
    file.close()


@settings(max_examples=15)
@given(
    st.lists(
        st.one_of(
            st.floats(0.0, 0.4),
            st.builds(TransportRequest, position=st.floats(0.0, 5.0)),
            st.builds(TransportRequest, rate=st.sampled_from([0.25, 1.0, 2.0])),
            st.builds(TransportRequest, playing=st.booleans()),
            st.builds(TransportRequest, loop=st.sampled_from([[], [1.0, 2.0], [3.0, 3.6]])),
        ),
        max_size=15,
    )
)
def test_whatever_is_asked_the_state_of_the_position_shows(
    played: tuple[RecordedShow, list[bytes], list[float]], acts: list[float | TransportRequest]
) -> None:
    reading, states, times = played
    player = ReplayPlayer(reading, reading.find_span())
    for act in acts:
        if isinstance(act, TransportRequest):
            player.obey(act)
        shown = player.advance(act if isinstance(act, float) else 0.0)
        told = player.transport()
        assert 0.0 <= told.position <= told.seconds
        assert told.different is None
        assert shown is not None
        place = states.index(encode(shown))
        assert abs(times[place] - told.position) <= 0.35  # a late tick of the show that was recorded


def test_it_pauses_at_its_end_and_plays_again_from_the_beginning(
    played: tuple[RecordedShow, list[bytes], list[float]],
) -> None:
    reading, states, _ = played
    player = ReplayPlayer(reading, reading.find_span())
    player.obey(TransportRequest(position=player.transport().seconds - 0.1))
    for _ in range(3):
        shown = player.advance(0.4)
    assert shown is not None
    assert encode(shown) == states[-1]
    assert not player.transport().playing
    player.obey(TransportRequest(playing=True))
    assert player.transport().position == 0.0


@pytest.mark.parametrize(
    "asked",
    [TransportRequest(position=1e6), TransportRequest(rate=50.0), TransportRequest(loop=[2.0, 2.1]),
     TransportRequest(loop=[1.0, 1e6]), TransportRequest(rate=float("nan"))],
)  # fmt: skip
def test_what_is_out_of_range_is_refused_and_changes_nothing(
    played: tuple[RecordedShow, list[bytes], list[float]], asked: TransportRequest
) -> None:
    player = ReplayPlayer(played[0], played[0].find_span())
    before = player.transport()
    with pytest.raises(ValueError, match=r"position|rate|loop"):
        player.obey(asked)
    assert player.transport() == before
