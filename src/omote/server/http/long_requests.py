"""Requests of pages that take long (imports, exports): their progress goes to the pages, and a page may end its own."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from typing import TypeVar

from aiohttp import web

from omote.server.workers.job_server import Follow
from omote.show.objects.link import Progress

LONGEST_ID = 64
PAUSE = 0.1
"""Seconds between two messages of one request: people read no more."""

T = TypeVar("T")


class CancelledRequestError(Exception):
    """The page that made a request has ended it; nothing has changed."""


class LongRequests:
    """The long requests under way, by the ids that their pages gave them; tell: sends progress to the pages."""

    def __init__(self, tell: Callable[[Progress], None]) -> None:
        self._tell = tell
        self._tasks: dict[str, asyncio.Task[object]] = {}
        self._turns: dict[str, asyncio.Lock] = {}

    @asynccontextmanager
    async def turn(self, kind: str, follow: Follow, waiting: str) -> AsyncIterator[None]:
        """Lets one job of a kind run at a time; `waiting` is what a page reads until its own may.

        follow: told of the progress.
        """
        lock = self._turns.setdefault(kind, asyncio.Lock())
        if lock.locked():
            follow(0, 0, waiting)
        async with lock:
            yield

    async def run(self, request: str, work: Callable[[Follow], Coroutine[object, object, T]]) -> T:
        """Runs `work`, which is cancelled where a page ends the request; CancelledRequestError then.

        request: "" for one that nobody follows. ValueError for an id that is under way or too long.
        """
        if len(request) > LONGEST_ID or request in self._tasks:
            raise ValueError(f"the request {request[:LONGEST_ID]!r} is under way already; give each its own id.")
        news = _News(request, self._tell)
        task = asyncio.get_running_loop().create_task(work(news.put))
        if request:
            self._tasks[request] = task
        try:
            return await asyncio.shield(task)  # whoever closes the page has not cancelled it
        except asyncio.CancelledError:
            if task.cancelled():
                raise CancelledRequestError("cancelled; nothing has changed.") from None
            raise
        finally:
            self._tasks.pop(request, None)
            news.close()

    def cancel(self, request: str) -> None:
        """Ends a request; one that has ended is left as it is."""
        task = self._tasks.get(request)
        if task is not None:
            task.cancel()


class _News:
    """Tells of one request at most every PAUSE seconds, and always of the newest."""

    def __init__(self, request: str, tell: Callable[[Progress], None]) -> None:
        self._request = request
        self._tell = tell
        self._newest: Progress | None = None
        self._timer: asyncio.TimerHandle | None = None

    def put(self, done: int, total: int, what: str) -> None:
        self._newest = Progress(self._request, done, total, what)
        if self._timer is None and self._request:
            self._send()

    def close(self) -> None:
        self._newest = None
        if self._timer is not None:
            self._timer.cancel()

    def _send(self) -> None:
        newest = self._newest
        self._newest = None
        self._timer = None
        if newest is not None:
            self._timer = asyncio.get_running_loop().call_later(PAUSE, self._send)
            self._tell(newest)


def request_id(request: web.Request) -> str:
    """The id that a page gave its request; "" where it follows nothing."""
    return request.query.get("request", "")
