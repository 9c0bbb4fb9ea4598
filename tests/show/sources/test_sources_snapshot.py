"""What stays with the show is plain values; a show from before has none of it."""

import msgspec

from omote.model.cast import Cast
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.sources.calibration import Calibration
from omote.show.sources.sources_snapshot import Route, SourcesSnapshot


def test_it_is_written_and_read_exactly() -> None:
    snapshot = SourcesSnapshot(
        {"face": Route(("one",), "lips", ("mouth",))},
        {"Aki": Calibration({"jawOpen": 0.1}, {"jawOpen": 0.9}, mirror=True)},
    )
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(snapshot), type=SourcesSnapshot) == snapshot


def test_a_show_from_before_has_no_routes(cast: Cast) -> None:
    saved = msgspec.to_builtins(ShowSession(cast).snapshot())
    del saved["sources"]
    assert read_session_snapshot(saved)[0].sources == SourcesSnapshot()
