"""The line to a browser: answers find their calls, and whoever waits learns that nobody answers any more."""

import asyncio
import json
import socket
from collections.abc import AsyncIterator
from dataclasses import dataclass
from typing import Any

import pytest
import pytest_asyncio

from omote.server.headless.devtools import BrowserError, DevTools


@dataclass
class Line:
    """Our end of a line, and the browser's, held by the test."""

    tools: DevTools
    reader: asyncio.StreamReader
    writer: asyncio.StreamWriter

    async def heard(self) -> dict[str, Any]:
        """What the browser is asked next."""
        message: dict[str, Any] = json.loads((await self.reader.readuntil(b"\0"))[:-1])
        return message

    def say(self, **message: Any) -> None:
        """The browser says something."""
        self.writer.write(json.dumps(message).encode() + b"\0")


@pytest_asyncio.fixture
async def line() -> AsyncIterator[Line]:
    ours, theirs = socket.socketpair()
    tools = DevTools(*await asyncio.open_connection(sock=ours))
    line = Line(tools, *await asyncio.open_connection(sock=theirs))
    yield line
    await tools.close()
    line.writer.close()


@pytest.mark.asyncio
async def test_answers_find_their_calls_in_any_order(line: Line) -> None:
    first = asyncio.create_task(line.tools.call("A", session="s", x=1))
    second = asyncio.create_task(line.tools.call("B"))
    asked = [await line.heard(), await line.heard()]
    assert asked[0] | {"id": 0} == {"id": 0, "method": "A", "params": {"x": 1}, "sessionId": "s"}
    line.say(id=asked[1]["id"], result={"value": "b"})
    line.say(method="Some.event", params={})
    line.say(id=asked[0]["id"], result={"value": "a"})
    assert (await first, await second) == ({"value": "a"}, {"value": "b"})


@pytest.mark.asyncio
async def test_a_refusal_is_a_sentence(line: Line) -> None:
    call = asyncio.create_task(line.tools.call("A"))
    line.say(id=(await line.heard())["id"], error={"message": "no such method"})
    with pytest.raises(BrowserError, match="the browser refuses: no such method"):
        await call


@pytest.mark.asyncio
async def test_what_a_script_gives_and_throws(line: Line) -> None:
    call = asyncio.create_task(line.tools.evaluate("s", "1 + 1"))
    asked = await line.heard()
    assert asked["params"]["expression"] == "1 + 1"
    line.say(id=asked["id"], result={"result": {"value": 2}})
    assert await call == 2
    call = asyncio.create_task(line.tools.evaluate("s", "boom()"))
    thrown = {"exception": {"description": "Error: There is no boom.\n    at line 1"}}
    line.say(id=(await line.heard())["id"], result={"result": {}, "exceptionDetails": thrown})
    with pytest.raises(BrowserError, match=r"^There is no boom\.$"):
        await call


@pytest.mark.asyncio
async def test_whoever_waits_learns_that_the_browser_ended(line: Line) -> None:
    call = asyncio.create_task(line.tools.call("A"))
    await line.heard()
    line.writer.close()
    with pytest.raises(BrowserError, match="the browser ended"):
        await call
    with pytest.raises(BrowserError, match="the browser has ended"):
        await line.tools.call("B")


@pytest.mark.asyncio
async def test_whoever_waits_learns_that_the_page_crashed(line: Line) -> None:
    call = asyncio.create_task(line.tools.call("A"))
    await line.heard()
    line.say(method="Inspector.targetCrashed", params={})
    with pytest.raises(BrowserError, match="crashed"):
        await call


@pytest.mark.asyncio
async def test_a_page_that_crashed_is_asked_no_more_and_others_are(line: Line) -> None:
    call = asyncio.create_task(line.tools.call("A", session="s"))
    await line.heard()
    line.say(method="Inspector.targetCrashed", params={}, sessionId="s")
    with pytest.raises(BrowserError, match="crashed"):
        await call
    with pytest.raises(BrowserError, match="crashed"):
        await asyncio.wait_for(line.tools.call("B", session="s"), 60.0)  # nobody would answer it
    other = asyncio.create_task(line.tools.call("C", session="t"))
    line.say(id=(await line.heard())["id"], result={"value": "c"})
    assert await other == {"value": "c"}
