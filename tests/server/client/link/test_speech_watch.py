"""Whether what was said is over: by states, some of which were never seen."""

import pytest
from msgspec import structs

from omote.model.cast import Cast
from omote.server.client.link.speech_watch import SpeechWatch
from omote.show import messages as wire
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot

TICK = 1.0 / 60.0


class Show:
    """A session in this process with two characters, and what a program says in it."""

    def __init__(self, cast: Cast) -> None:
        self.cast, self.session, self.now = cast, ShowSession(cast), 0.0
        self.session.receive("p", wire.Hello("console", wire.PROTOCOL_VERSION, "program"), 0.0)
        self.session.receive("p", wire.AddCharacter("two", "two", "Two", "generic"), 0.0)
        self.session.receive("p", wire.EnterCharacter("enter", "two", 0.0), 0.0)

    def send(self, message: wire.FromClient) -> wire.State:
        assert self.session.receive("p", message, self.now) == []
        return self.session.tick(self.now)

    def say(self, key: str, who: str = "one", *, queue: bool = False) -> SpeechWatch:
        message = wire.Say(who, key, "Ah", seconds=0.5, queue=queue, key=key)
        return SpeechWatch(key, who, self.send(message))

    def later(self, seconds: float) -> wire.State:
        for _ in range(round(seconds / TICK)):
            self.now += TICK
            state = self.session.tick(self.now)
        return state


def test_a_speech_is_over_once_it_was_said(cast: Cast) -> None:
    show = Show(cast)
    watch = show.say("a")
    for _ in range(40):
        watch.note(show.later(TICK))
    assert watch.spoken is None
    watch.note(show.later(0.5))
    assert watch.spoken is True


@pytest.mark.parametrize(
    "message",
    [
        wire.Say("one", "b", "Oh", key="b"),
        wire.StopSpeaking("one", "b"),
        wire.Panic("one"),
        wire.RemoveCharacter("b", "one", "", 0.0),
    ],
)
def test_a_speech_is_interrupted(cast: Cast, message: wire.FromClient) -> None:
    show = Show(cast)
    watches = show.say("a"), show.say("waits", queue=True)
    show.send(message)
    state = show.later(5.0)
    for watch in watches:
        watch.note(state)
        assert watch.spoken is False


def test_speeches_that_wait_are_said_in_turn_though_states_are_lost(cast: Cast) -> None:
    show = Show(cast)
    watches = [show.say(key, queue=True) for key in "abc"]
    for watch in watches:
        watch.note(show.session.tick(show.now))
    state = show.later(10.0)
    for watch in watches:
        watch.note(state)
    assert [watch.spoken for watch in watches] == [True, True, True]


def test_one_of_two_programs_is_interrupted_by_the_other(cast: Cast) -> None:
    show = Show(cast)
    mine, theirs = show.say("mine"), show.say("theirs")
    state = show.later(2.0)
    mine.note(state)
    theirs.note(state)
    assert (mine.spoken, theirs.spoken) == (False, True)


def test_all_have_said_it_once_the_last_has(cast: Cast) -> None:
    show = Show(cast)
    both = show.say("all", "*")
    show.send(wire.StopSpeaking("two", "b"))
    both.note(show.later(0.2))
    assert both.spoken is None
    both.note(show.later(2.0))
    assert both.spoken is False


def test_a_speech_goes_on_after_a_restart_of_the_show(cast: Cast) -> None:
    show = Show(cast)
    watch = show.say("a")
    snapshot = show.session.snapshot()
    assert isinstance(snapshot, SessionSnapshot)
    show.session = ShowSession.restored(cast, snapshot, epoch=2)
    watch.note(show.later(0.2))
    assert watch.spoken is None
    watch.note(show.later(2.0))
    assert watch.spoken is True


def test_a_show_that_knows_nothing_of_it_has_interrupted_it(cast: Cast) -> None:
    show = Show(cast)
    watch = show.say("a")
    state = Show(cast).session.tick(0.0)
    watch.note(structs.replace(state, epoch=2))
    assert watch.spoken is False
