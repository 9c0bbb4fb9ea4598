"""What a recorder notes: all that changes what is on air, and nothing else; it changes nothing itself."""

from __future__ import annotations

from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello, Ping
from omote.show.recording.entries import Joined, Left, Sent, SnapshotTaken, Ticked
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession, Unrecorded
from tests import synthetic
from tests.show.recording.random_show import RandomShow

CAST = synthetic.cast()


def test_a_recorder_changes_nothing() -> None:
    show = RandomShow(10, {CAST.digest: CAST})
    show.play(5.0)
    plain = RandomShow(10, {CAST.digest: CAST})
    plain.session.recorder = Unrecorded()
    plain.play(5.0)
    assert plain.states == show.states


def test_what_is_refused_or_only_asks_is_not_noted() -> None:
    session = ShowSession(CAST)
    recorder = Recorder(session)
    call = CallFace("one", "same", "broad", 1.0)
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    for message in (call, call, Ping(1.0), CallFace("one", "2", "nobody", 1.0)):
        session.receive("ana", message, 0.0)
    session.tick(0.5)
    session.leave("ana")
    kinds = [type(entry) for entry in recorder.take(7)]
    assert kinds == [SnapshotTaken, Joined, Sent, Ticked, Left]


def test_a_tick_has_the_check_of_the_state_that_was_sent() -> None:
    session = ShowSession(CAST)
    recorder = Recorder(session)
    session.tick(0.0)
    first = recorder.take(7)
    session.tick(1.0)
    session.tick(1.1)  # nobody took the one before: its state was not sent
    second = recorder.take(8)
    checks = [entry.check for entry in (*first, *second) if isinstance(entry, Ticked)]
    assert checks == [7, None, 8]
