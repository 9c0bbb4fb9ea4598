"""Long requests tell their progress, at most ten times a second, and end when their page says so."""

import asyncio

import pytest

from omote.server.http.long_requests import CancelledRequestError, LongRequests
from omote.server.workers.job_server import Follow
from omote.show.objects.link import Progress

pytestmark = pytest.mark.asyncio


async def test_progress_goes_to_the_pages_under_the_id_of_the_request_and_the_newest_always_comes() -> None:
    told = list[Progress]()
    last = asyncio.Event()

    def tell(progress: Progress) -> None:
        told.append(progress)
        if progress.done == 99:
            last.set()

    async def work(follow: Follow) -> str:
        for done in range(100):
            follow(done, 100, "smile")
        await last.wait()
        return "done"

    requests = LongRequests(tell)
    assert await requests.run("a", work) == "done"
    assert told == [Progress("a", 0, 100, "smile"), Progress("a", 99, 100, "smile")]
    assert await requests.run("", work) == "done"
    assert len(told) == 2, "nobody follows a request without an id"


async def test_a_cancelled_request_ends_and_others_go_on() -> None:
    requests = LongRequests(lambda _: None)
    begun = asyncio.Event()
    end = asyncio.Event()

    async def work(_: Follow) -> str:
        begun.set()
        await end.wait()
        return "done"

    cancelled, other = (asyncio.create_task(requests.run(each, work)) for each in ("a", "b"))
    await begun.wait()
    with pytest.raises(ValueError, match="under way already"):
        await requests.run("a", work)
    requests.cancel("a")
    requests.cancel("nobody's")
    with pytest.raises(CancelledRequestError, match="nothing has changed"):
        await cancelled
    end.set()
    assert await other == "done"
    requests.cancel("b")  # it has ended
    assert await requests.run("a", work) == "done", "the id is free again"


async def test_jobs_of_one_kind_take_turns_and_a_page_reads_for_what_it_waits() -> None:
    requests = LongRequests(lambda _: None)
    told = list[str]()
    begun = asyncio.Event()
    end = asyncio.Event()
    running = list[str]()

    def follow(_done: int, _total: int, what: str) -> None:
        told.append(what)

    async def work(name: str, kind: str) -> None:
        async with requests.turn(kind, follow, f"{name} waits"):
            running.append(name)
            begun.set()
            await end.wait()
            running.remove(name)

    first = asyncio.create_task(work("first", "export"))
    await begun.wait()
    others = [asyncio.create_task(work(name, kind)) for name, kind in (("second", "export"), ("other", "import"))]
    while len(running) < 2:
        await asyncio.sleep(0)
    assert running == ["first", "other"], "another kind does not wait"
    end.set()
    await asyncio.gather(first, *others)
    assert (told, running) == (["second waits"], [])
