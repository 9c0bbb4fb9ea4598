"""Previews of scans go with their folders: in time, in number, at the end, and after a show that was killed."""

import asyncio
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from omote.server.process.fork import fork_process
from omote.server.scans.scan_previews import MOST_PREVIEWS, PREFIX, SECONDS_KEPT, ScanPreviews, remove_left_over


class FalseTimers:
    """Timers that a test lets run out."""

    def __init__(self) -> None:
        self.running: list[FalseTimer] = []

    def __call__(self, seconds: float, act: Callable[[], None]) -> Any:
        assert seconds == SECONDS_KEPT
        timer = FalseTimer(self, act)
        self.running.append(timer)
        return timer


class FalseTimer:
    """One of them."""

    def __init__(self, all_timers: FalseTimers, act: Callable[[], None]) -> None:
        self._all = all_timers
        self.act = act

    def cancel(self) -> None:
        """It never runs out."""
        if self in self._all.running:
            self._all.running.remove(self)


@pytest.fixture(autouse=True)
def _temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder for temporary files that no other test has."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))


def test_what_nobody_touches_is_thrown_away() -> None:
    timers = FalseTimers()
    previews = ScanPreviews(timers)
    untouched = previews.add()
    touched = previews.add()
    first = timers.running[0]
    assert previews.find(touched.token) is touched
    assert len(timers.running) == 2, "a touch begins the time anew, in the place of the old"
    first.act()
    assert (untouched.folder.exists(), touched.folder.exists()) == (False, True)
    with pytest.raises(ValueError, match="bring the file again"):
        previews.find(untouched.token)


def test_of_too_many_the_longest_untouched_goes() -> None:
    previews = ScanPreviews(FalseTimers())
    first, *others = [previews.add() for _ in range(MOST_PREVIEWS)]
    previews.find(first.token)
    previews.add()
    assert first.folder.exists()
    assert [each.folder.exists() for each in others] == [False, *[True] * (MOST_PREVIEWS - 2)]


def test_at_the_end_all_go_and_a_token_is_never_given_twice(tmp_path: Path) -> None:
    previews = ScanPreviews(FalseTimers())
    tokens = {previews.add().token for _ in range(MOST_PREVIEWS)}
    assert len(tokens) == MOST_PREVIEWS
    previews.close()
    assert [*tmp_path.iterdir()] == []


def test_what_a_killed_show_left_goes_when_the_next_begins_and_nothing_else(tmp_path: Path) -> None:
    dead = fork_process(lambda: None)
    os.waitpid(dead, 0)
    left = tmp_path / f"{PREFIX}{dead}-abc"
    ours = tmp_path / f"{PREFIX}{os.getpid()}-abc"
    others = [ours, tmp_path / f"{PREFIX}1-abc", tmp_path / f"{PREFIX}name-abc", tmp_path / "omote-other"]
    for folder in (left, *others):
        folder.mkdir()
        (folder / "scan.ply").write_bytes(b"scan")
    remove_left_over()
    assert not left.exists()
    assert [each.exists() for each in others] == [True] * len(others)


@pytest.mark.asyncio
async def test_in_a_loop_its_timers_are_used() -> None:
    previews = ScanPreviews()
    preview = previews.add()
    assert isinstance(preview.timer, asyncio.TimerHandle)
    previews.drop(preview.token)
    assert preview.timer.cancelled()
