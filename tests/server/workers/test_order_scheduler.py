"""Compounds are made one at a time, once each, in the order in which the show needs them."""

import asyncio
from collections.abc import Awaitable, Callable

import pytest

from omote.edit.store.content_store import PASSING_BYTES
from omote.server.http.cast_documents import CACHED_FACES
from omote.server.workers.order_scheduler import MEMORY, Key, OrderScheduler

EXPRESSIONS = ("neutral", "smile", "cry", "wink")
NOTHING: frozenset[str] = frozenset()


class Maker:
    """Makes what is told, and writes down in which order."""

    def __init__(self) -> None:
        self.made: list[Key] = []

    async def __call__(self, face: str, expression: str) -> bytes:
        """Two letters, after others had their turn."""
        await asyncio.sleep(0)
        self.made.append((face, expression))
        if face == "nobody":
            raise LookupError(face)
        return (face[0] + expression[0]).encode()


def played(show: Callable[[OrderScheduler], Awaitable[object]], *, memory: int = 1000) -> list[Key]:
    """What was computed, in its order, in a show with a scheduler."""
    maker = Maker()

    async def to_the_end() -> None:
        scheduler = OrderScheduler(maker, EXPRESSIONS, memory=memory)
        await show(scheduler)
        while scheduler._working is not None and not scheduler._working.done():
            await asyncio.sleep(0)
        scheduler.close()

    asyncio.run(to_the_end())
    return maker.made


def test_what_many_ask_for_is_made_once() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        answers = await asyncio.gather(*(scheduler.get(("kaori", "smile")) for _ in range(5)))
        assert answers == [b"ks"] * 5
        assert await scheduler.get(("kaori", "smile")) == b"ks"

    assert played(show) == [("kaori", "smile")]


def test_a_called_face_is_made_in_full_what_is_on_air_first() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        scheduler.set_on_air(frozenset({"dog"}), frozenset({"cry", "wink"}))

    assert played(show) == [("dog", "cry"), ("dog", "wink"), ("dog", "neutral"), ("dog", "smile")]


def test_who_asks_comes_before_what_is_made_ahead_and_what_is_on_air_before_all() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        scheduler.set_on_air(frozenset({"dog"}), frozenset({"cry"}))
        await asyncio.gather(*(scheduler.get(key) for key in (("old", "smile"), ("dog", "wink"), ("dog", "cry"))))

    order = [("dog", "cry"), ("old", "smile"), ("dog", "wink"), ("dog", "neutral"), ("dog", "smile")]
    assert played(show) == order


def test_the_rest_of_a_face_that_left_is_not_made() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        scheduler.set_on_air(frozenset({"dog"}), NOTHING)
        scheduler.set_on_air(frozenset({"old"}), NOTHING)
        scheduler.set_on_air(frozenset({"old"}), frozenset({"wink"}))

    assert played(show) == [("old", "wink"), ("old", "neutral"), ("old", "smile"), ("old", "cry")]


def test_a_face_that_comes_back_is_not_made_again() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        for faces in ({"dog"}, {"old"}, {"dog"}):
            scheduler.set_on_air(frozenset(faces), NOTHING)
            await asyncio.gather(*(scheduler.get((face, name)) for face in faces for name in EXPRESSIONS))

    made = played(show)
    assert len(made) == len(set(made)) == 2 * len(EXPRESSIONS)


def test_what_cannot_be_made_is_raised_for_who_asks_and_for_nobody_else() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        scheduler.set_on_air(frozenset({"nobody"}), NOTHING)
        with pytest.raises(LookupError):
            await scheduler.get(("nobody", "smile"))
        assert await scheduler.get(("old", "smile")) == b"os"
        with pytest.raises(LookupError):
            await scheduler.get(("nobody", "smile"))

    played(show)


def test_who_goes_takes_nothing_from_others() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        gone, stays = (asyncio.create_task(scheduler.get(("old", "smile"))) for _ in range(2))
        await asyncio.sleep(0)
        gone.cancel()
        assert await stays == b"os"

    assert played(show) == [("old", "smile")]


def test_memory_is_bounded_and_what_was_dropped_is_made_again() -> None:
    keys = [(face, name) for face in ("dog", "old") for name in EXPRESSIONS]

    async def show(scheduler: OrderScheduler) -> None:
        for _ in range(2):
            for key in keys:
                assert len(await scheduler.get(key)) == 2
                assert sum(map(len, scheduler._made.values())) == scheduler._size <= 6

    assert played(show, memory=6) == [*keys, *keys]


def test_editors_come_before_all_but_what_is_on_air() -> None:
    done: list[str] = []

    async def show(scheduler: OrderScheduler) -> None:
        async def make() -> bytes:
            done.extend(key[1] for key in scheduler._made)
            return b"made"

        scheduler.set_on_air(frozenset({"dog"}), frozenset({"cry"}))
        orders = [scheduler.order(make), scheduler.get(("old", "smile")), scheduler.order(make)]
        assert await asyncio.gather(*orders) == [b"made", b"os", b"made"]

    assert played(show) == [("dog", "cry"), ("old", "smile"), ("dog", "neutral"), ("dog", "smile"), ("dog", "wink")]
    assert done == ["cry", "cry"]


def test_what_an_order_raises_comes_to_who_ordered_and_the_next_is_made() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        async def refuse() -> bytes:
            raise LookupError("no such muscle")

        with pytest.raises(LookupError, match="no such muscle"):
            await scheduler.order(refuse)
        assert await scheduler.get(("old", "smile")) == b"os"

    assert played(show) == [("old", "smile")]


def test_an_order_of_who_has_gone_is_not_made() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        async def make() -> bytes:
            raise AssertionError

        gone = asyncio.create_task(scheduler.order(make))
        await asyncio.sleep(0)
        gone.cancel()
        assert await scheduler.get(("old", "smile")) == b"os"

    assert played(show) == [("old", "smile")]


def test_an_expression_that_comes_is_made_ahead_and_one_that_goes_is_not() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        scheduler.set_on_air(frozenset({"dog"}), NOTHING)
        scheduler.set_expressions(("neutral", "cry", "#1"))

    assert played(show) == [("dog", "neutral"), ("dog", "cry"), ("dog", "#1")]


def test_who_still_waits_when_the_show_ends_is_let_go() -> None:
    async def show(scheduler: OrderScheduler) -> None:
        waiting, ordered = (
            asyncio.create_task(each)
            for each in (scheduler.get(("old", "smile")), scheduler.order(lambda: scheduler.get(("old", "cry"))))
        )
        await asyncio.sleep(0)
        scheduler.close()
        for each in (waiting, ordered):
            with pytest.raises(asyncio.CancelledError):
                await each

    assert played(show) == []


def test_what_a_server_caches_is_bounded_in_all() -> None:
    """Compounds, contents of drafts and documents of own faces, 60 KB each; each bound has its own test."""
    assert MEMORY + PASSING_BYTES + CACHED_FACES * 60_000 <= 80 << 20
