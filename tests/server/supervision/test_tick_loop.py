"""Sixty ticks a second without drift, and the journal, the heartbeat and the crew's broadcast on them."""

import asyncio
import itertools
import os

import pytest

from omote.model.cast import Cast
from omote.server.http.app import ShowServer
from omote.server.process.notice_board import NoticeBoard
from omote.server.process.process_messages import PULSE_TICKS, TICK, read_pulse
from omote.server.supervision.tick_loop import APART, LATE_TICKS, RESTING_TICKS, ShowTick, run_ticks, send_pulse
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Bus, Hello
from omote.show.session import ShowSession
from omote.showfile.show_file import JournalEntry
from tests.server.synthetic_server import PAGES, material


class Clock:
    """A clock that sleeping moves; the tick loop waits on it instead of on the world's."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 0.0
        self.slept = 0.0
        self.late: dict[int, float] = {}
        monkeypatch.setattr("omote.server.supervision.tick_loop.asyncio.sleep", self.sleep)

    async def sleep(self, seconds: float) -> None:
        self.now += seconds
        self.slept += seconds


class Devices:
    """Devices that speak at some times, by the same clock."""

    def __init__(self, clock: Clock, times: list[float]) -> None:
        self.clock = clock
        self.times = times

    def forget(self) -> None:
        self.times = [each for each in self.times if each > self.clock.now]

    async def spoke_within(self, seconds: float) -> bool:
        spoken = [each for each in self.times if each <= self.clock.now + seconds]
        self.clock.now = max(self.clock.now, min(spoken)) if spoken else self.clock.now + seconds
        return bool(spoken)


def beaten(
    monkeypatch: pytest.MonkeyPatch, ticks: int, work: dict[int, float], spoken: list[float] | None = None
) -> list[float]:
    """The times of so many ticks, each as long as `work` says (else 1 ms); spoken: when devices speak."""
    clock = Clock(monkeypatch)
    times = list[float]()
    early = None if spoken is None else Devices(clock, spoken)

    def tick(_: int | None) -> None:
        if len(times) == ticks:
            raise KeyboardInterrupt
        times.append(clock.now)
        clock.now += work.get(len(times) - 1, 0.001)

    with pytest.raises(KeyboardInterrupt):
        asyncio.run(run_ticks(tick, clock=lambda: clock.now, early=early))
    return times


def test_ticks_do_not_drift(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 6000, {})
    assert times == pytest.approx([number / 60 for number in range(6000)], abs=1e-6)


def test_a_short_delay_is_made_up_for(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 60, {10: 2.5 / 60})
    assert times[20:] == pytest.approx([number / 60 for number in range(20, 60)], abs=1e-6)


def test_after_a_long_sleep_no_burst_follows(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 60, {10: 1800.0})
    steps = [after - before for before, after in itertools.pairwise(times[11:])]
    assert steps == pytest.approx([1 / 60] * len(steps), abs=1e-6)
    assert times[11] == pytest.approx(times[10] + 1800.0)


def test_a_delay_at_the_limit_is_the_longest_that_is_made_up_for(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 60, {10: (LATE_TICKS + 0.9) / 60})
    assert times[-1] == pytest.approx(59 / 60, abs=1e-6)


def test_silent_devices_change_no_tick(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 600, {}, spoken=[])
    assert times == pytest.approx([number / 60 for number in range(600)], abs=1e-6)


def test_a_device_is_on_air_as_soon_as_it_speaks(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 60, {}, spoken=[10.5 / 60])
    assert times == pytest.approx(sorted([10.5 / 60, *(number / 60 for number in range(59))]), abs=1e-6)


@pytest.mark.parametrize(("part", "expected"), [(0.0625, APART), (0.9, 1.0)])
def test_what_comes_near_a_tick_waits_a_part_of_a_beat(
    monkeypatch: pytest.MonkeyPatch, part: float, expected: float
) -> None:
    spoken = (10 + part) / 60
    times = beaten(monkeypatch, 60, {10: 0.0}, spoken=[spoken])
    assert min(each for each in times if each >= spoken) == pytest.approx((10 + expected) / 60, abs=1e-6)


def test_devices_that_never_rest_have_every_second_beat_and_move_none(monkeypatch: pytest.MonkeyPatch) -> None:
    times = beaten(monkeypatch, 900, {}, spoken=[number / 1000 for number in range(20_000)])
    assert len([each for each in times if each < 8.0]) == pytest.approx(8 * 90, abs=2)
    beats = {round(each * 60) for each in times if abs(each * 60 - round(each * 60)) < 1e-6}
    assert set(range(480)) <= beats, "every beat is kept"
    assert min(after - before for before, after in itertools.pairwise(times)) >= APART / 60 - 1e-9


class Kept:
    """A journal that keeps what it is offered."""

    def __init__(self) -> None:
        self.entries: list[JournalEntry] = []

    def offer(self, entry: JournalEntry) -> None:
        self.entries.append(entry)


@pytest.fixture
def played(cast: Cast) -> tuple[ShowServer, Kept, ShowTick, int]:
    """A server at rest, its journal, its ticks, and the far end of its pulse."""
    session = ShowSession(cast)
    session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    steps = iter(range(100_000))
    show = ShowServer(session, material().documents, PAGES, clock=lambda: next(steps) / 60)
    far, near = os.pipe()
    os.set_blocking(far, False)
    os.set_blocking(near, False)
    journal = Kept()
    return show, journal, ShowTick(show, [journal], near, NoticeBoard()), far


@pytest.mark.asyncio
async def test_a_moving_show_is_kept_thirty_times_a_second(played: tuple[ShowServer, Kept, ShowTick, int]) -> None:
    show, journal, playing, _ = played
    show.session.receive("a", CallFace("one", "1", "broad", 10.0, "smooth"), 0.0)
    for number in range(300):
        playing.tick(number)
    assert len(journal.entries) == 150


@pytest.mark.asyncio
async def test_a_resting_show_is_kept_once_a_second(played: tuple[ShowServer, Kept, ShowTick, int]) -> None:
    _, journal, playing, _ = played
    for number in range(10 * RESTING_TICKS):
        playing.tick(number)
    assert len(journal.entries) == 10


@pytest.mark.asyncio
async def test_ticks_that_come_early_are_not_counted(played: tuple[ShowServer, Kept, ShowTick, int]) -> None:
    _, journal, playing, far = played
    for number in range(2 * RESTING_TICKS):
        playing.tick(number)
        playing.tick(None)
    assert len(journal.entries) == 2
    assert os.read(far, 1000) == TICK * (2 * RESTING_TICKS // PULSE_TICKS)


@pytest.mark.asyncio
@pytest.mark.parametrize("bus", ["air", "preview"])
async def test_what_a_hand_does_is_kept_at_once(played: tuple[ShowServer, Kept, ShowTick, int], bus: Bus) -> None:
    show, journal, playing, _ = played
    show.session.receive("a", Hello("console", PROTOCOL_VERSION, bus=bus), 0.0)
    for number in range(30):
        playing.tick(number)
    before = len(journal.entries)
    show.session.receive("a", SetChannel("one", "jawOpen", 0.5), 0.5)
    for number in range(30, 36):
        playing.tick(number)
    assert len(journal.entries) == before + 1


@pytest.mark.asyncio
async def test_ten_pulses_a_second(played: tuple[ShowServer, Kept, ShowTick, int]) -> None:
    _, _, playing, far = played
    for number in range(60):
        playing.tick(number)
    assert os.read(far, 100) == TICK * (60 // PULSE_TICKS)


def test_a_supervisor_that_does_not_listen_holds_up_no_tick() -> None:
    far, near = os.pipe()
    os.set_blocking(near, False)
    for _ in range(70_000):
        send_pulse(near, TICK)
    os.close(far)
    send_pulse(near, TICK)
    os.close(near)


@pytest.mark.asyncio
async def test_a_show_without_a_journal_plays(cast: Cast) -> None:
    session = ShowSession(cast)
    far, near = os.pipe()
    show = ShowServer(session, material().documents, PAGES)
    for number in range(5):
        ShowTick(show, [], near, NoticeBoard()).tick(number)
    assert session.number == 5
    os.close(far)
    os.close(near)


@pytest.mark.asyncio
async def test_a_preview_that_was_lost_is_said(cast: Cast) -> None:
    board = NoticeBoard()
    far, near = os.pipe()
    show = ShowServer(ShowSession(cast), material().documents, PAGES)
    show.session.lost.append("what was built up in preview is forgotten.")
    ShowTick(show, [], near, board).tick(1)
    assert [notice.text for notice in show.session.notices] == ["What was built up in preview is forgotten."]
    os.close(far)
    os.close(near)


@pytest.mark.asyncio
async def test_notices_go_to_the_session_and_to_the_supervisor(cast: Cast) -> None:
    board = NoticeBoard()
    far, near = os.pipe()
    show = ShowServer(ShowSession(cast), material().documents, PAGES)
    playing = ShowTick(show, [], near, board)
    playing.tick(1)
    board.post("the disk is full.")
    playing.tick(2)
    playing.tick(3)
    assert show.session.notices == board.notices
    assert read_pulse(os.read(far, 4096)) == (board.notices, b"")  # once, for the next server
