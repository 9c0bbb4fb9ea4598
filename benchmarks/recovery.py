"""The show never stops: `kill -9` of the server in the middle of a fade, and what a stage sees of it.

Starts `omote show` as a user does, follows it as a browser does (a link that is tried again every 50 ms), and kills the
server at random moments of a fade. Printed: the blackout from the kill to the next state that a stage receives, and the
age of the state that came back: how much older it is than the last that the stage had seen. `--kills N` for another
count; `--both` kills the standby with each server.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import aiohttp
import numpy as np

from benchmarks.pace import measure_waiting_pace
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION, STATE_RATE
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello
from omote.show.objects.state import State
from omote.show.wire import decode_answer, encode

BLACKOUT_LIMIT = 1.0
AGE_LIMIT = 0.1
"""Seconds where the pace is 1 (issue 2, item 8)."""
RETRY_SECONDS = 0.05
FADE_SECONDS = 4.0
COMMAND = (sys.executable, "-c", "from omote.cli import main; main()", "show")
FACES = ("old", "child", "round", "kaori")


@dataclass(frozen=True)
class Recovery:
    """One kill: seconds of blackout, seconds that the show went back, whether it was the fade that went on."""

    blackout: float
    age: float
    same_fade: bool


class Follower:
    """A client that stays with a show through everything, like a page."""

    def __init__(self, url: str) -> None:
        self._url = url
        self._socket: aiohttp.ClientWebSocketResponse | None = None
        self.received = 0.0

    async def call(self, number: int, http: aiohttp.ClientSession) -> None:
        """Calls the next face."""
        await self._connect(http)
        assert self._socket is not None
        name = FACES[number % len(FACES)]
        await self._socket.send_bytes(encode(CallFace("one", f"{os.getpid()} {number}", name, FADE_SECONDS, "smooth")))

    async def state(self, http: aiohttp.ClientSession) -> State:
        """The next state, however often the link must be opened for it."""
        while True:
            await self._connect(http)
            assert self._socket is not None
            message = await self._socket.receive()
            if message.type is not aiohttp.WSMsgType.BINARY:
                self._socket = None
                continue
            answer = decode_answer(message.data)
            if isinstance(answer, State):
                self.received = time.monotonic()
                return answer

    async def _connect(self, http: aiohttp.ClientSession) -> None:
        while self._socket is None:
            try:
                opening = http.ws_connect(self._url, max_msg_size=0)
                self._socket = await asyncio.wait_for(opening, timeout=10.0)
                await self._socket.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
            except (aiohttp.ClientError, OSError, TimeoutError):
                self._socket = None
                await asyncio.sleep(RETRY_SECONDS)


def children(pid: int) -> list[int]:
    """The child processes of a process (Linux)."""
    return [int(word) for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def processes_of(show: Path) -> tuple[int, int]:
    """The standby and the server that plays (Linux): the one with workers, and its parent."""
    while True:
        for entry in Path("/proc").iterdir():
            with contextlib.suppress(OSError, ValueError):
                if os.fsencode(show) in (entry / "cmdline").read_bytes() and len(children(int(entry.name))) > 1:
                    return int((entry / "stat").read_text().rpartition(")")[2].split()[1]), int(entry.name)


async def kill_once(
    follower: Follower, http: aiohttp.ClientSession, show: Path, number: int, wait: float, *, both: bool
) -> Recovery:
    """Calls a face, kills the server, or both it and the standby, `wait` seconds into the fade; waits for the
    picture."""
    await follower.call(number, http)
    state = await follower.state(http)
    begun = time.monotonic()
    while time.monotonic() - begun < wait or state.characters["one"].face_call is None:
        state = await follower.state(http)
    called = state.characters["one"].face_call.target
    seen = state.time
    standby, server = processes_of(show)
    killed = time.monotonic()
    for pid in (standby, server) if both else (server,):
        os.kill(pid, signal.SIGKILL)
    while state.epoch == (first := await follower.state(http)).epoch:
        seen = first.time
    came_back = first.time - (first.number - 1) / STATE_RATE
    same = first.characters["one"].face_call is not None and first.characters["one"].face_call.target == called
    return Recovery(follower.received - killed, seen - came_back, same)


async def measure(url: str, show: Path, kills: int, *, both: bool) -> list[Recovery]:
    """As many kills as asked for, at seeded random moments of a fade."""
    waits = np.random.default_rng(8).uniform(0.3, FADE_SECONDS - 0.7, kills)
    follower = Follower(url)
    async with aiohttp.ClientSession() as http:
        return [await kill_once(follower, http, show, n, float(wait), both=both) for n, wait in enumerate(waits)]


def read_address(process: subprocess.Popen[str]) -> str:
    """The address of the link, once the show says where it is."""
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"http://(\S+)/stage", line):
            return f"http://{found[1]}{LINK_PATH}"
    raise RuntimeError("the show did not open")


def verdict(recoveries: list[Recovery]) -> bool:
    """Prints the figures beside their limits; whether they hold."""
    blackouts = np.array([each.blackout for each in recoveries])
    ages = np.array([each.age for each in recoveries])
    print(f"{len(recoveries)} x kill -9 in mid-fade")
    pace = measure_waiting_pace()
    good = all(r.same_fade for r in recoveries)
    for name, values, limit in (("blackout    ", blackouts, BLACKOUT_LIMIT), ("age of state", ages, AGE_LIMIT)):
        most = limit * pace
        print(f"  {name}  median {np.median(values):6.3f} s   max {values.max():6.3f} s   limit {most:.2f} s")
        good = good and bool(values.max() <= most)
    print(f"  the same fade went on in {sum(each.same_fade for each in recoveries)} of {len(recoveries)}")
    print("holds" if good else "DOES NOT HOLD")
    return good


def main() -> int:
    """Runs the show, kills it, prints; exit status 1 when a limit is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--both", action="store_true", help="kill the standby with each server, at one instant")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        show = Path(folder) / "show.omote"
        command = [*COMMAND, str(show), "--port", "0", "--no-open", "--no-announce", "--osc", "off"]
        with (Path(folder) / "said").open("w+") as said:
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said, text=True)
            try:
                recoveries = asyncio.run(measure(read_address(process), show, options.kills, both=options.both))
            finally:
                process.terminate()
                process.wait(10.0)
            said.seek(0)
            print("".join(line for line in said if "another" not in line and "spare" not in line), end="")
    return 0 if verdict(recoveries) else 1


if __name__ == "__main__":
    sys.exit(main())
