"""Speaks the Chrome DevTools Protocol over a pipe: JSON messages, each ended by a zero byte; no port is opened."""

from __future__ import annotations

import asyncio
import itertools
from typing import Any

import msgspec

END = b"\0"
CRASHED = "the browser's page crashed; try a smaller picture or a lower quality"

Answer = dict[str, Any]


class BrowserError(RuntimeError):
    """The browser failed; the message says why in one sentence."""


class DevTools:
    """A connection to a browser; every call waits for its own answer, and calls may overlap."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader = reader
        self._writer = writer
        self._numbers = itertools.count(1)
        self._waiting: dict[int, asyncio.Future[Answer]] = {}
        self._crashed: set[str | None] = set()
        """Sessions of pages that will not answer any more."""
        self._listening = asyncio.create_task(self._listen())

    async def call(self, method: str, *, session: str | None = None, **parameters: Any) -> Answer:
        """Calls a DevTools method and returns the result; BrowserError when the browser rejects it, or ends.

        method: as the protocol has it; session: of the page, None for the browser; parameters: of the method.
        """
        if self._listening.done():
            raise BrowserError("the browser has ended; try again")
        if session is not None and session in self._crashed:
            raise BrowserError(CRASHED)
        number = next(self._numbers)
        message: Answer = {"id": number, "method": method, "params": parameters}
        if session is not None:
            message["sessionId"] = session
        answer: asyncio.Future[Answer] = asyncio.get_running_loop().create_future()
        self._waiting[number] = answer
        self._writer.write(msgspec.json.encode(message) + END)
        return await answer

    async def evaluate(self, session: str, script: str) -> Any:
        """Evaluates a script on a page, awaits its promise and returns the value; BrowserError with what it throws.

        session: of the page; script: JavaScript.
        """
        answer = await self.call(
            "Runtime.evaluate", session=session, expression=script, awaitPromise=True, returnByValue=True
        )
        if "exceptionDetails" in answer:
            thrown = answer["exceptionDetails"].get("exception", {})
            reason = str(thrown.get("value") or thrown.get("description") or "a script failed")
            raise BrowserError(reason.split("\n")[0].removeprefix("Error: "))
        return answer["result"].get("value")

    async def close(self) -> None:
        """Closes the connection."""
        self._listening.cancel()
        self._writer.close()
        await asyncio.gather(self._listening, return_exceptions=True)

    async def _listen(self) -> None:
        try:
            while True:
                self._handle_message(msgspec.json.decode((await self._reader.readuntil(END))[:-1]))
        except (asyncio.IncompleteReadError, ConnectionError):
            self._fail_all("the browser ended before it had drawn; try again")

    def _handle_message(self, message: Answer) -> None:
        if message.get("method") == "Inspector.targetCrashed":
            self._crashed.add(message.get("sessionId"))
            self._fail_all(CRASHED)
        answer = self._waiting.pop(message.get("id", 0), None)
        if answer is None or answer.done():
            return
        if "error" in message:
            answer.set_exception(BrowserError(f"the browser refuses: {message['error'].get('message', '')}"))
        else:
            answer.set_result(message.get("result", {}))

    def _fail_all(self, reason: str) -> None:
        for answer in self._waiting.values():
            if not answer.done():
                answer.set_exception(BrowserError(reason))
        self._waiting.clear()
