"""One source that fails costs its own input alone."""

import errno

import pytest

from omote.server.devices.device_source import DeviceSource
from omote.server.devices.guarded_source import AGAIN_SECONDS, GuardedSource
from omote.show.objects.state import State
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio


class Failing(DeviceSource):
    """A source that finds no descriptor left."""

    def hear(self, now: float) -> None:
        raise OSError(errno.EMFILE, f"Too many open files at {now}")

    def tell(self, state: State, now: float) -> None:
        raise RuntimeError(f"a fault of ours in {state} at {now}")


class Counting(DeviceSource):
    """A source that counts what it is asked."""

    def __init__(self) -> None:
        self.heard = list[float]()
        self.told = list[tuple[State, float]]()

    def hear(self, now: float) -> None:
        self.heard.append(now)

    def tell(self, state: State, now: float) -> None:
        self.told.append((state, now))


async def test_a_tick_survives_what_one_source_does_and_says_it_now_and_then(show_harness: ShowHarness) -> None:
    said = list[str]()
    counting = Counting()
    show_harness.show.sources.extend(GuardedSource(source, said.append) for source in (Failing(), counting))
    for _ in range(100):
        show_harness.tick()
    assert len(counting.heard) == len(counting.told) == 100
    assert len(said) == 1
    assert "Failing: " in said[0]
    show_harness.clock.now += AGAIN_SECONDS
    show_harness.tick()
    assert len(said) == 2
