"""A program waits for what it said: blocking and under asyncio, to its end, for a time, and when it is interrupted."""

import asyncio

import pytest

import omote
from omote.server.client.connect import ConnectedShow
from omote.server.client.utterance import explain_end
from tests.inputs.sounds.test_sound_file import wav
from tests.server.client.link.test_program_link import ticking
from tests.server.conftest import ShowHarness


@pytest.mark.asyncio
async def test_a_program_under_asyncio_waits_until_it_has_spoken(show_harness: ShowHarness) -> None:
    async with ticking(show_harness), await omote.connect_async(str(show_harness.client.make_url("/"))) as show:
        one = show["one"]
        first, second = await one.say("Papa", sound=wav(0.5)), await one.say("Mama", queue=True)
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
