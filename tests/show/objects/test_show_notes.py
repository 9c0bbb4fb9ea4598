"""Notes of the crew: a line that every console shows, and when the show began; kept with the show."""

import msgspec
import pytest

from omote.model.cast import Cast
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello, Refused
from omote.show.objects.show_notes import LONGEST_NOTE, BeginShow, SetNote
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot, read_session_snapshot


@pytest.fixture
def session(cast: Cast) -> ShowSession:
    """A console at a show that has run for 50 seconds."""
    session = ShowSession(cast)
    session.receive("a", Hello("console", PROTOCOL_VERSION, "a"), 0.0)
    session.tick(100.0)
    session.tick(150.0)
    return session


def test_it_is_told_to_all_and_lies_in_the_show(session: ShowSession, cast: Cast) -> None:
    assert session.receive("a", SetNote("1", " Ana late,\nscene  4 first "), 150.0) == []
    assert session.receive("a", BeginShow("2"), 160.0) == []
    state = session.tick(170.0)
    assert (state.note, state.began, state.time) == ("Ana late, scene 4 first", 60.0, 70.0)
    saved = msgspec.msgpack.decode(msgspec.msgpack.encode(session.snapshot()))
    restored = ShowSession.restored(cast, read_session_snapshot(saved)[0], epoch=2).tick(0.0)
    assert (restored.note, restored.began) == (state.note, state.began)
    del saved["notes"]
    assert msgspec.convert(saved, SessionSnapshot).notes.note == "", "a file of before has none"


def test_a_beginning_is_put_back_where_it_was_and_no_other_is_taken(session: ShowSession) -> None:
    session.receive("a", BeginShow("1"), 150.0)
    session.receive("a", BeginShow("2", 20.0), 150.0)
    assert session.tick(150.0).began == 20.0
    for number, at in enumerate((-1.0, 51.0, float("nan"))):
        (answer,) = session.receive("a", BeginShow(f"x{number}", at), 150.0)
        assert isinstance(answer.message, Refused)
        assert "give 0 to 50" in answer.message.reason
    assert session.tick(150.0).began == 20.0


def test_a_note_that_is_too_long_is_rejected(session: ShowSession) -> None:
    long = msgspec.msgpack.encode({"type": "set_note", "id": "1", "text": "x" * (LONGEST_NOTE + 1)})
    (answer,) = session.receive_bytes("a", long, 150.0)
    assert isinstance(answer.message, Refused)
    assert session.tick(150.0).note == ""
