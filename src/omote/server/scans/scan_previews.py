"""Keeps the scans that editors look at, each in a folder of this machine that goes with it: when its face is taken or
thrown away, when nobody has touched it for a while, when too many others have come, when the show ends.
"""

from __future__ import annotations

import asyncio
import os
import secrets
import shutil
import tempfile
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

MOST_PREVIEWS = 4
SECONDS_KEPT = 1800.0
"""After so long without a request a preview is thrown away."""
PREFIX = "omote-scan-"

Schedule = Callable[[float, Callable[[], None]], asyncio.TimerHandle]


@dataclass(eq=False)
class Preview:
    """A scan under way: its token, the folder with what was sent, and the name of the scan's own file in it."""

    token: str
    folder: Path
    file: str = ""
    timer: asyncio.TimerHandle | None = None


class ScanPreviews:
    """The scans under way, the one touched last at the end; schedule: calls something after seconds."""

    def __init__(self, schedule: Schedule | None = None) -> None:
        self._previews: dict[str, Preview] = {}
        self._schedule: Schedule = schedule or (
            lambda seconds, act: asyncio.get_running_loop().call_later(seconds, act)
        )
        remove_left_over()

    def add(self) -> Preview:
        """A new preview with an empty folder that nobody else may read; the longest untouched go where there are too
        many. OSError where there is no room."""
        folder = Path(tempfile.mkdtemp(prefix=f"{PREFIX}{os.getpid()}-"))
        preview = Preview(secrets.token_urlsafe(16), folder)
        self._previews[preview.token] = preview
        self.touch(preview)
        while len(self._previews) > MOST_PREVIEWS:
            self.drop(next(iter(self._previews)))
        return preview

    def find(self, token: str) -> Preview:
        """The preview of a token, which is touched; ValueError with a sentence where it has gone."""
        preview = self._previews.get(token)
        if preview is None:
            raise ValueError(
                "this scan was thrown away, for nobody had looked at it for long, or others came: bring the file again."
            )
        self.touch(preview)
        return preview

    def touch(self, preview: Preview) -> None:
        """Keeps a preview for another while."""
        if preview.timer is not None:
            preview.timer.cancel()
        self._previews[preview.token] = self._previews.pop(preview.token, preview)
        preview.timer = self._schedule(SECONDS_KEPT, lambda: self.drop(preview.token))

    def drop(self, token: str) -> None:
        """Removes a scan with its folder; one that has gone stays away."""
        preview = self._previews.pop(token, None)
        if preview is None:
            return
        if preview.timer is not None:
            preview.timer.cancel()
        shutil.rmtree(preview.folder, ignore_errors=True)

    def close(self) -> None:
        """Removes all."""
        for token in [*self._previews]:
            self.drop(token)


def remove_left_over() -> None:
    """Removes what shows left that ended without a word."""
    for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*-*"):
        owner = folder.name.removeprefix(PREFIX).partition("-")[0]
        if owner.isdigit() and not _is_running(int(owner)):
            shutil.rmtree(folder, ignore_errors=True)


def _is_running(pid: int) -> bool:
    with suppress(PermissionError):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return False
    return True
