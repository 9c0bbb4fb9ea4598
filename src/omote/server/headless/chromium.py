"""Finds, starts and ends a headless Chromium, driven over a DevTools pipe; it never outlives this process."""

from __future__ import annotations

import asyncio
import os
import shutil
import socket
import sys
import tempfile
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from pathlib import Path

from omote.server.headless.devtools import DevTools

COMMANDS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge")
MAC_APPLICATIONS = (
    Path("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"),
    Path("/Applications/Chromium.app/Contents/MacOS/Chromium"),
    Path("/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge"),
)
NO_BROWSER = (
    "there is no browser to draw with: install Chromium or Chrome (Debian, Ubuntu: sudo apt-get install chromium "
    "libegl1 libegl-mesa0 libgl1-mesa-dri), or set OMOTE_BROWSER to the path of one"
)
QUIET_FLAGS = (
    "--headless --no-first-run --no-default-browser-check --disable-background-networking --disable-component-update "
    "--disable-sync --disable-quic --disable-extensions --hide-scrollbars --mute-audio --force-color-profile=srgb"
).split()
# Nothing foreign is ever loaded, and the sandbox needs what containers and root do not have.
NO_SANDBOX_FLAGS = ["--no-sandbox", "--disable-dev-shm-usage"]
# A picture may take long on a machine without a graphics processor: that is no hang.
NO_TIMEOUT_FLAGS = ["--disable-gpu-watchdog", "--disable-gpu-process-crash-limit", "--disable-hang-monitor"]
# Mesa draws three times as fast as Chromium's own software renderer, which stays the way out where there is no Mesa.
LINUX_RENDERER = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--enable-unsafe-swiftshader"]
LONGEST_ANSWER = 1 << 30
"""Bytes: a picture comes as one message."""
# A watchdog process between us and the browser: it puts our pipe on descriptors 3 and 4, where DevTools expect it (ours
# may be in use), and kills the browser with its children when this process ends, for whatever reason.
WATCHDOG = """
import os, shutil, signal, subprocess, sys
line, profile, *command = int(sys.argv[1]), *sys.argv[2:]
os.dup2(line, 3)
os.dup2(line, 4)
browser = subprocess.Popen(command, stdin=subprocess.DEVNULL, pass_fds=(3, 4))
for end in {line, 3, 4}:
    os.close(end)
sys.stdin.read()
browser.kill()
browser.wait()
shutil.rmtree(profile, ignore_errors=True)
os.killpg(0, signal.SIGKILL)
"""


def find_chromium(environment: Mapping[str, str] = os.environ) -> Path:
    """The path of a Chromium: OMOTE_BROWSER, else the PATH, else an application.

    FileNotFoundError with what to do where there is none, or where OMOTE_BROWSER names no file: a setting that
    cannot be met is not silently replaced.
    """
    wish = environment.get("OMOTE_BROWSER")
    if wish:
        if not Path(wish).is_file():
            raise FileNotFoundError(f"OMOTE_BROWSER is {wish!r}, which is no file; give the path of a Chromium")
        return Path(wish)
    paths = (shutil.which(command, path=environment.get("PATH", os.defpath)) for command in COMMANDS)
    for path in (*(Path(path) for path in paths if path), *MAC_APPLICATIONS):
        if path.is_file():
            return path
    raise FileNotFoundError(NO_BROWSER)


@asynccontextmanager
async def open_chromium(path: Path) -> AsyncIterator[DevTools]:
    """Starts a browser and yields its DevTools; the browser ends with the block, or when this process is killed."""
    with tempfile.TemporaryDirectory(prefix="omote-", ignore_cleanup_errors=True) as profile:
        ours, theirs = socket.socketpair()
        with theirs:
            watchdog = await _launch(path, profile, theirs.fileno())
        tools = DevTools(*await asyncio.open_connection(sock=ours, limit=LONGEST_ANSWER))
        try:
            yield tools
        finally:
            await tools.close()
            await watchdog.communicate(b"")  # closes its input, at which it ends everything


async def _launch(path: Path, profile: str, line: int) -> asyncio.subprocess.Process:
    renderer = LINUX_RENDERER if sys.platform == "linux" else []
    options = [
        *QUIET_FLAGS,
        *NO_SANDBOX_FLAGS,
        *NO_TIMEOUT_FLAGS,
        *renderer,
        "--remote-debugging-pipe",
        f"--user-data-dir={profile}",
    ]
    watchdog = (sys.executable, "-I", "-S", "-c", WATCHDOG, str(line), profile)
    nothing = asyncio.subprocess.DEVNULL
    return await asyncio.create_subprocess_exec(
        *watchdog, str(path), *options, "about:blank",
        pass_fds=(line,), stdin=asyncio.subprocess.PIPE, stdout=nothing, stderr=nothing, start_new_session=True,
    )  # fmt: skip
