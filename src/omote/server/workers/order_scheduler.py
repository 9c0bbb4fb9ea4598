"""Schedules computations one at a time, by priority: what is on air, editors' orders, what pages asked for, then what
they may ask for next. Compounds are cached."""

from __future__ import annotations

import asyncio
from collections import OrderedDict, deque
from collections.abc import Awaitable, Callable, Collection

MEMORY = 48 << 20
"""Bytes of compounds kept: 26 faces with all expressions. What is dropped is computed again, in milliseconds."""

Key = tuple[str, str]
"""The sources of a face and of an expression."""
Order = tuple[Callable[[], Awaitable[bytes]], "asyncio.Future[bytes]"]


class OrderScheduler:
    """Computes one order at a time; caches compounds (LRU); precomputes `all_expressions` of the faces on air."""

    def __init__(
        self, make: Callable[[str, str], Awaitable[bytes]], all_expressions: Collection[str], *, memory: int = MEMORY
    ) -> None:
        self._make = make
        self._expressions = tuple(all_expressions)
        self._memory = memory
        self._made: OrderedDict[Key, bytes] = OrderedDict()
        self._size = 0
        self._asked: dict[Key, asyncio.Future[bytes]] = {}
        self._ahead: dict[Key, None] = {}
        self._orders: deque[Order] = deque()
        self._on_air: tuple[frozenset[str], frozenset[str]] = (frozenset(), frozenset())
        self._working: asyncio.Task[None] | None = None

    async def get(self, key: Key) -> bytes:
        """Waits for a compound and returns it; raises what computing it raises."""
        if key in self._made:
            self._made.move_to_end(key)
            return self._made[key]
        if key not in self._asked:
            self._asked[key] = asyncio.get_running_loop().create_future()
            self._work()
        return await asyncio.shield(self._asked[key])  # others may wait for the same

    async def order(self, make: Callable[[], Awaitable[bytes]]) -> bytes:
        """Runs `make` in its turn, before all but what is on air, and returns the result; raises what it raises."""
        waiting: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()
        self._orders.append((make, waiting))
        self._work()
        return await waiting

    def set_on_air(self, faces: frozenset[str], expressions: frozenset[str]) -> None:
        """Sets what is on air or coming: it is computed first; a new face is precomputed with all expressions.

        faces, expressions: by their sources.
        """
        if (faces, expressions) == self._on_air:
            return
        new = faces - self._on_air[0]
        self._on_air = faces, expressions
        coming = [(face, name) for face in sorted(new) for name in self._expressions]
        stays = [key for key in self._ahead if key[0] in faces]
        self._ahead = dict.fromkeys(key for key in (*coming, *stays) if key not in self._made)
        if self._ahead:
            self._work()

    def set_expressions(self, all_expressions: Collection[str]) -> None:
        """Sets which expressions there are now: faces on air are precomputed with the new ones."""
        new = [name for name in all_expressions if name not in self._expressions]
        self._expressions = tuple(all_expressions)
        ahead = {key: None for key in self._ahead if key[1] in all_expressions}
        more = ((face, name) for face in sorted(self._on_air[0]) for name in new)
        self._ahead = ahead | {key: None for key in more if key not in self._made}
        if self._ahead:
            self._work()

    def close(self) -> None:
        """Stops computing and cancels all waiting calls."""
        if self._working is not None:
            self._working.cancel()
        for waiting in (*self._asked.values(), *(waiting for _, waiting in self._orders)):
            if not waiting.done():
                waiting.cancel()

    def _work(self) -> None:
        if self._working is None or self._working.done():
            self._working = asyncio.get_running_loop().create_task(self._make_all())

    async def _make_all(self) -> None:
        while True:
            key = self._next_on_air()
            if key is None and self._orders:
                await _carry_out(*self._orders.popleft())
            elif (key := key or self._next_wanted()) is not None:
                await self._make_one(key)
            else:
                return

    async def _make_one(self, key: Key) -> None:
        self._ahead.pop(key, None)
        if key in self._made:
            return
        try:
            result = await self._make(*key)
        except Exception as error:
            _answer(self._asked.pop(key, None), error)
        else:
            self._keep(key, result)
            _answer(self._asked.pop(key, None), result)

    def _next_on_air(self) -> Key | None:
        """The next compound that is on air and not computed: those asked for first, then in order of arrival."""
        for waiting in (self._asked, self._ahead):
            for key in waiting:
                if key[0] in self._on_air[0] and key[1] in self._on_air[1]:
                    return key
        return None

    def _next_wanted(self) -> Key | None:
        return next(iter(self._asked), None) or next(iter(self._ahead), None)

    def _keep(self, key: Key, data: bytes) -> None:
        self._size += len(data) - len(self._made.get(key, b""))
        self._made[key] = data
        while self._size > self._memory and len(self._made) > 1:
            _, old = self._made.popitem(last=False)
            self._size -= len(old)


async def _carry_out(make: Callable[[], Awaitable[bytes]], waiting: asyncio.Future[bytes]) -> None:
    if waiting.done():  # whoever ordered it has gone
        return
    try:
        result = await make()
    except Exception as error:
        _answer(waiting, error)
    else:
        _answer(waiting, result)


def _answer(waiting: asyncio.Future[bytes] | None, result: bytes | Exception) -> None:
    if waiting is None or waiting.done():
        return
    if isinstance(result, bytes):
        waiting.set_result(result)
    else:
        waiting.set_exception(result)
        waiting.exception()  # read, even if whoever asked has gone
