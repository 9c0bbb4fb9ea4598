"""What cues send and have said, as a session plays it."""

from __future__ import annotations

from functools import partial
from itertools import pairwise

import msgspec

from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import encode_message
from omote.perform.cues.cue_action import CueAction, OscSend
from omote.perform.cues.cue_state import GAP_SECONDS
from omote.show.cues.cue_lines import CUES
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import cues as wire
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from tests import synthetic


def session_with(*cues: tuple[CueAction, ...]) -> ShowSession:
    """A session whose list has cues with actions, numbered from 1."""
    session = ShowSession(synthetic.cast())
    session.receive("ana", Hello("console", PROTOCOL_VERSION), 0.0)
    for place, actions in enumerate(cues):
        assert session.receive("ana", wire.PutCue(f"p{place}", actions=[*actions]), 0.0) == []
    session.tick(0.0)
    return session


def test_a_go_that_comes_twice_sends_once() -> None:
    session = session_with((CueAction("osc", "desk:9000", "/cue 1"),))
    for _ in range(2):
        session.receive("ana", wire.Go("g1"), 1.0)
    session.tick(1.1)
    assert session.cues.take_sends() == [("cue 1", OscSend("desk", 9000, "/cue", (1,)))]
    assert session.cues.take_sends() == []


def test_what_waits_to_be_sent_is_sent_after_a_restart_and_nothing_that_was_sent() -> None:
    session = session_with((CueAction("osc", "desk:9000", "/now"), CueAction("osc", "desk:9000", "/later", 1.0)))
    session.receive("ana", wire.Go("g1"), 0.0)
    session.tick(0.5)
    session.cues.take_sends()
    kept, _ = read_session_snapshot(msgspec.to_builtins(session.snapshot()))
    again = ShowSession.restored(session.cast, kept, epoch=2)
    again.cues.load(session.cues.book)
    again.tick(0.0)
    again.tick(0.4)
    assert again.cues.take_sends() == []
    again.tick(0.6)
    assert [send.address for _, send in again.cues.take_sends() if isinstance(send, OscSend)] == ["/later"]


def test_a_line_is_said_by_the_cues_and_one_that_cannot_be_is_read_at_consoles() -> None:
    session = session_with((CueAction("say", "one", "Good evening"), CueAction("say", "gone", "Ho")))
    session.receive("ana", wire.Go("g1"), 1.0)
    session.tick(1.1)
    state = session.tick(1.2)
    assert state.characters["one"].layers["lips"].source == "speech"
    assert state.cues is not None
    (said,) = state.cues.rejected
    assert said.startswith("cue 1: there is no character 'gone'")


def test_a_line_with_a_voice_is_asked_for_as_every_other() -> None:
    session = session_with((CueAction("say", "*", "Guten Abend", voice="de"),))
    session.receive("ana", wire.Go("g1"), 1.0)
    session.tick(1.1)
    (text,) = session.texts.take()
    assert (text.who, text.message.text, text.message.voice, text.characters) == (CUES, "Guten Abend", "de", ("one",))


def test_a_line_by_a_sound_has_lips_where_it_has_a_text() -> None:
    session = session_with(
        (CueAction("say", "one", "Good evening", sound="bell"),),
        (CueAction("say", "one", "", sound="bell"),),
        (CueAction("say", "one", "", sound="gong"),),
    )
    session.set_sounds({"bell": 2.0})
    for place, lips in enumerate((True, False)):
        begun = 1.0 + 10.0 * place
        session.tick(begun)
        session.receive("ana", wire.Go(f"g{place}"), begun)
        session.tick(begun + 0.1)
        session.tick(begun + 1.1)
        state = session.tick(begun + 1.2)
        speech = state.characters["one"].speech
        assert speech is not None
        assert (speech.sound, speech.seconds) == ("bell", 2.0)
        assert ("lips" in state.characters["one"].layers) == lips
        for later in (4.0, 6.0, 8.0):
            session.tick(begun + later)
    session.receive("ana", wire.Go("g3"), 30.0)
    session.tick(30.1)
    state = session.tick(30.2)
    assert state.cues is not None
    assert "there is no sound 'gong'" in state.cues.rejected[-1]


def test_a_cue_that_presses_go_at_its_own_show_runs_no_faster_than_a_finger() -> None:
    """Two cues call each other by OSC: what comes back within the gap is ignored, and what waits longer goes on."""
    for delay, most in ((0.0, 1), (0.05, 1), (0.5, 20)):
        back = tuple(CueAction("osc", "127.0.0.1:9000", f"/omote/go_to {number}", delay) for number in (2, 1))
        session = session_with((back[0],), (back[1],))
        osc = OscInput(partial(lambda of: of, session))
        session.receive("ana", wire.Go("g1"), 1.0)
        now = 1.0
        called = list[float]()
        for _ in range(600):
            before = session.cues._players["main"].state.current
            for _, send in session.cues.take_sends():
                assert isinstance(send, OscSend)
                osc.receive(("127.0.0.1", 4711), encode_message(send.address, *send.arguments), now)
            if session.cues._players["main"].state.current != before:
                called.append(now)
            now += 1 / 60
            session.tick(now)
        assert len(called) <= most
        assert all(later - earlier >= GAP_SECONDS for earlier, later in pairwise(called))
