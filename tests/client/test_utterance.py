"""A program waits for what it said: blocking and under asyncio, to its end, for a time, and when it is interrupted."""

import asyncio

import pytest
from msgspec import structs

import omote
from omote.client.connect import ConnectedShow
from omote.client.utterance import SpeechWatch, explain_end
from omote.model.cast import Cast
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.characters import AddCharacter, EnterCharacter, RemoveCharacter
from omote.show.objects.link import Hello
from omote.show.objects.speech import Say, StopSpeaking
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from tests.client.test_program_link import ticking
from tests.inputs.sounds.test_sound_file import wav
from tests.server.conftest import ShowHarness


@pytest.mark.asyncio
async def test_a_program_under_asyncio_waits_until_it_has_spoken(show_harness: ShowHarness) -> None:
    async with ticking(show_harness), await omote.connect_async(str(show_harness.client.make_url("/"))) as show:
        one = show["one"]
        first = await one.say("Papa", sound=wav(0.5))
        second = await one.say("Mama", queue=True)
        assert (first.spoken, second.spoken) == (None, None)
        assert await second.wait(60) is True
        assert (first.spoken, repr(first)) == (True, "<utterance that was said to its end>")
        third = await one.say("Oh", seconds=600)
        waiting = asyncio.create_task(third.wait())
        await one.stop_speaking()
        assert await waiting is False


@pytest.mark.asyncio
async def test_a_blocking_program_waits_and_goes_on_after_its_time(show_harness: ShowHarness) -> None:
    def play(url: str) -> None:
        with omote.connect(url) as show:
            assert show["one"].say("Papa").wait() is True
            said = show["one"].say("Mama", seconds=600)
            with pytest.raises(TimeoutError, match=r"after 0.05 s it is still said.* stop_speaking\(\) ends it"):
                said.wait(0.05)
            with pytest.raises(TypeError, match=r"the time to wait \(seconds\) must be a number"):
                said.wait("long")  # type: ignore[arg-type]
            assert said.spoken is None
            assert show["one"].say("Oh").wait(60) is True
            assert said.wait(0) is False
            _refused(show)

    async with ticking(show_harness):
        await asyncio.to_thread(play, str(show_harness.client.make_url("/")))


def _refused(show: ConnectedShow) -> None:
    with pytest.raises(TypeError, match="text is 42; give text"):
        show["one"].say(42)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="is no WAV, MP3 or Ogg"):
        show["one"].say("Hi", sound=b"nothing")


@pytest.mark.parametrize(("spoken", "words"), [(None, "not over"), (True, "to its end"), (False, "interrupted")])
def test_an_end_has_words(spoken: bool | None, words: str) -> None:
    assert words in explain_end(spoken)


TICK = 1.0 / 60.0


class Show:
    """A session in this process with two characters, and what a program says in it."""

    def __init__(self, cast: Cast) -> None:
        self.cast = cast
        self.session = ShowSession(cast)
        self.now = 0.0
        self.session.receive("p", Hello("console", PROTOCOL_VERSION, "program"), 0.0)
        self.session.receive("p", AddCharacter("two", "two", "Two", "generic"), 0.0)
        self.session.receive("p", EnterCharacter("enter", "two", 0.0), 0.0)

    def send(self, message: ClientMessage) -> State:
        assert self.session.receive("p", message, self.now) == []
        return self.session.tick(self.now)

    def say(self, key: str, who: str = "one", *, queue: bool = False) -> SpeechWatch:
        message = Say(who, key, "Ah", seconds=0.5, queue=queue, key=key)
        return SpeechWatch(key, who, self.send(message))

    def later(self, seconds: float) -> State:
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
        Say("one", "b", "Oh", key="b"),
        StopSpeaking("one", "b"),
        Panic("one"),
        RemoveCharacter("b", "one", 0.0),
    ],
)
def test_a_speech_is_interrupted(cast: Cast, message: ClientMessage) -> None:
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
    mine = show.say("mine")
    theirs = show.say("theirs")
    state = show.later(2.0)
    mine.note(state)
    theirs.note(state)
    assert (mine.spoken, theirs.spoken) == (False, True)


def test_all_have_said_it_once_the_last_has(cast: Cast) -> None:
    show = Show(cast)
    both = show.say("all", "*")
    show.send(StopSpeaking("two", "b"))
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
