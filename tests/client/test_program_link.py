"""A program's link: obeyed or rejected before a call returns, alone in its turn, linked again when it breaks."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

import pytest

from omote.client import program_link
from omote.client.program_link import ProgramLink
from omote.server.http import app
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallFace, ReleaseFace
from omote.show.objects.sources import MeasureSource
from omote.show.objects.speech import Say
from tests.server.conftest import ShowHarness


@asynccontextmanager
async def ticking(harness: ShowHarness) -> AsyncIterator[None]:
    """The show plays while the body runs."""

    async def tick() -> None:
        while True:
            harness.tick()
            await asyncio.sleep(0)

    task = asyncio.create_task(tick())
    try:
        yield
    finally:
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task


@asynccontextmanager
async def linked(harness: ShowHarness, timeout: float = 60.0) -> AsyncIterator[ProgramLink]:
    """An open link to a show that plays."""
    link = ProgramLink(str(harness.client.make_url(LINK_PATH)), "robot", timeout)
    async with ticking(harness):
        await link.open()
        yield link
        await link.close()


def call(link: ProgramLink, face: str) -> CallFace:
    return CallFace("one", link.next_id(), face, 0.0, "smooth")


@pytest.mark.asyncio
async def test_a_call_is_on_air_when_it_returns(show_harness: ShowHarness) -> None:
    async with linked(show_harness) as link:
        await link.send(call(link, "broad"))
        assert link.state is not None
        assert link.state.characters["one"].faces == {"broad": 1.0}
        assert [member.name for member in show_harness.show.session.crew.values()] == ["robot"]


@pytest.mark.asyncio
async def test_what_is_rejected_raises_the_reason_at_its_own_call(show_harness: ShowHarness) -> None:
    async with linked(show_harness) as link:
        done = await asyncio.gather(
            *(link.send(call(link, face)) for face in ("broad", "nobody", "generic", "nobody")), return_exceptions=True
        )
        assert [type(each) for each in done] == [type(None), ValueError, type(None), ValueError]
        assert "there is no face 'nobody'" in str(done[1])


@pytest.mark.asyncio
async def test_a_broken_link_comes_back_and_a_call_waits_for_it(show_harness: ShowHarness) -> None:
    async with linked(show_harness) as link:
        for _ in range(3):
            await show_harness.show.links.close_all()
            await link.send(call(link, "broad"))
        assert link.state is not None
        assert link.state.characters["one"].faces == {"broad": 1.0}


@pytest.mark.asyncio
async def test_a_show_that_does_not_come_back_is_told(show_harness: ShowHarness) -> None:
    async with linked(show_harness, timeout=0.3) as link:
        await show_harness.client.server.close()
        with suppress(ConnectionError):  # it may still be obeyed
            await link.send(ReleaseFace("one"))
        with pytest.raises(ConnectionError, match=r"for 0\.3 s.*start it with omote show"):
            await link.send(ReleaseFace("one"))
        await link.close()
        with pytest.raises(ConnectionError, match="the connection is closed"):
            await link.send(ReleaseFace("one"))


@pytest.mark.asyncio
async def test_where_no_show_is_nothing_opens() -> None:
    link = ProgramLink("http://127.0.0.1:1/link", "robot", 0.2)
    with pytest.raises(ConnectionError, match=r"no show at http://127.0.0.1:1 for 0.2 s"):
        await link.open()


@pytest.mark.asyncio
async def test_a_show_of_another_version_says_so(show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch) -> None:
    link = ProgramLink(str(show_harness.client.make_url(LINK_PATH)), "robot", 60.0)
    async with ticking(show_harness):
        monkeypatch.setattr(program_link, "PROTOCOL_VERSION", PROTOCOL_VERSION - 1)
        greeting = link._greet

        async def greet(socket: object) -> None:
            await greeting(socket)  # type: ignore[arg-type]
            monkeypatch.undo()

        monkeypatch.setattr(link, "_greet", greet)
        with pytest.raises(ConnectionError, match="takes no program in: the page speaks version"):
            await link.open()


def _say(link: ProgramLink, text: str, marks: int = 0) -> Say:
    if marks == 0:
        return Say("one", link.next_id(), text)
    return Say("one", link.next_id(), text, "words", ["Straßenbahnen"] * marks, bytes(4 * marks))


@pytest.mark.asyncio
@pytest.mark.parametrize(("text", "marks"), [("ä" * 2000, 0), ("words " * 300, 300)])
async def test_a_long_speech_is_said(show_harness: ShowHarness, text: str, marks: int) -> None:
    async with linked(show_harness, timeout=20.0) as link:
        await link.send(_say(link, text, marks))


@pytest.mark.asyncio
async def test_a_message_longer_than_a_show_reads_is_rejected_before_it_is_sent(show_harness: ShowHarness) -> None:
    async with linked(show_harness, timeout=20.0) as link:
        with pytest.raises(ValueError, match=r"text is 'aaa.* at most 2000 characters: say it .* queue=True"):
            await link.send(_say(link, "a" * 40_000))
        marks = ["ä" * 80] * 300
        with pytest.raises(ValueError, match=r"takes \d+ bytes.*at most 32768.*queue=True"):
            await link.send(Say("one", link.next_id(), "a", "words", marks, bytes(1200)))
        measure = MeasureSource(link.next_id(), "a", {"n" * 5000: 0.0}, {})
        with pytest.raises(ValueError, match=r"at most 4096 of one message: send less at once"):
            await link.send(measure)
        await link.send(call(link, "broad"))


@pytest.mark.asyncio
async def test_a_show_that_reads_less_says_so_at_the_call(
    show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(app, "SPEECH_LIMIT", 4096)
    async with linked(show_harness, timeout=20.0) as link:
        with pytest.raises(ValueError, match="longer than 4096 bytes"):
            await link.send(_say(link, "ä" * 2000))
        await link.send(call(link, "broad"))


@pytest.mark.asyncio
async def test_no_call_waits_longer_than_its_time_for_an_answer(
    show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with linked(show_harness, timeout=0.5) as link:
        monkeypatch.setattr(show_harness.show.session, "receive_bytes", lambda *_: [])
        with pytest.raises(ConnectionError, match=r"no answer of the show .* for 0\.5 s: it does not answer"):
            await asyncio.wait_for(link.send(call(link, "nobody")), 20.0)
        monkeypatch.undo()
        await link.send(ReleaseFace("one"))
