"""What must not hold up a show: a disk that stalls, a terminal that nobody reads, busy programs, editors that send rot.

Starts `omote show` as a user does, each time with a stage that follows it, and prints the longest time between two
ticks (by the show's clock, which the states carry), what the show said, and how far behind the journal would have been
at a loss of power at the worst instant. The disk is `stalled_disk.c` before the show's own calls (needs `cc`, Linux).
`--seconds N` for another length of each; names of disturbances for some of them only.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import pty
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Callable, Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

import aiohttp
import numpy as np
from pythonosc.udp_client import SimpleUDPClient

from benchmarks.recovery import COMMAND, FACES, RETRY_SECONDS, processes_of
from omote.edit.protocol.messages import EDITING_PATH
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION, STATE_RATE
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello
from omote.show.objects.state import State
from omote.show.wire import decode_answer, encode

SOURCE = Path(__file__).with_name("stalled_disk.c")
BUSY = "while True: pass"
LOOPS = 4
LINKS = 60
ROT = (b"\xc1", b"", b"\x80", b"\x81\xa4type\xa4save", b"\xff" * 4096)
"""What no editor sends."""


@dataclass
class Stage:
    """What a stage has seen: times of states on the show's clock, and when they came, by epoch."""

    ticks: list[tuple[int, float, float]] = field(default_factory=list)

    def longest(self, since: float, until: float) -> float:
        """Seconds between two ticks of one server that came between two moments (s, monotonic)."""
        seen = [tick for tick in self.ticks if since <= tick[2] <= until]
        gaps = [b[1] - a[1] for a, b in pairwise(seen) if a[0] == b[0]]
        return max(gaps, default=float("inf"))

    def servers(self) -> int:
        """How many servers have played."""
        return len({tick[0] for tick in self.ticks})


@dataclass(frozen=True)
class Show:
    """A show that plays; disk: stalls while `stalls` is a file; said: what it printed."""

    file: Path
    url: str
    osc: int
    stalls: Path
    record: Path
    said: Path
    stage: Stage
    http: aiohttp.ClientSession

    def processes(self) -> tuple[int, int]:
        """The standby and the server."""
        return processes_of(self.file)


async def follow(stage: Stage, url: str, http: aiohttp.ClientSession) -> None:
    """Follows a show through everything, and calls a face every two seconds: something always moves."""
    number = 0
    while True:
        with contextlib.suppress(aiohttp.ClientError, OSError, TimeoutError):
            async with http.ws_connect(url + LINK_PATH, max_msg_size=0) as link:
                await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
                async for message in link:
                    answer = decode_answer(message.data)
                    if not isinstance(answer, State):
                        continue
                    stage.ticks.append((answer.epoch, answer.time, time.monotonic()))
                    if len(stage.ticks) % int(2 * STATE_RATE) == 0:
                        number += 1
                        name = FACES[number % len(FACES)]
                        await link.send_bytes(encode(CallFace("one", f"bench {number}", name, 2.5, "smooth")))
        await asyncio.sleep(RETRY_SECONDS)


def build_disk(folder: Path) -> Path:
    """The library that stalls a disk."""
    library = folder / "disk.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", str(library), str(SOURCE), "-ldl"], check=True)
    return library


@contextlib.asynccontextmanager
async def playing(library: Path, port: int, *, terminal: int | None = None) -> AsyncIterator[Show]:
    """A show in a folder of its own; terminal: where it prints after its start, None for a file."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "disk").mkdir()
        file = folder / "disk" / "show.omote"
        said = folder / "said"
        disk = {"LD_PRELOAD": str(library), "DISK_FOLDER": str(folder / "disk"), "DISK_STALLS": str(folder / "stalls")}
        environment = {**os.environ, **disk, "DISK_RECORD": str(folder / "record")}
        words = [str(file), "--port", str(port), "--osc", str(port + 1), "--no-open", "--no-announce"]
        with said.open("w") as output:
            where = output if terminal is None else terminal
            process = subprocess.Popen([*COMMAND, *words], stdout=where, stderr=where, env=environment)
        url = f"http://127.0.0.1:{port}"
        async with aiohttp.ClientSession() as http:
            stage = Stage()
            following = asyncio.create_task(follow(stage, url, http))
            while len(stage.ticks) < 3 * STATE_RATE:
                await asyncio.sleep(0.1)
            try:
                yield Show(file, url, port + 1, folder / "stalls", folder / "record", said, stage, http)
            finally:
                (folder / "stalls").unlink(missing_ok=True)
                following.cancel()
                process.terminate()
                process.wait(20.0)


async def lose_power(show: Show, seconds: float) -> str:
    """How far the journal would be behind, were the power cut at the worst instant."""
    since = time.monotonic()
    await asyncio.sleep(seconds)
    lines = [line.split() for line in show.record.read_text().splitlines()]
    lines = [line for line in lines if float(line[1]) > since]
    writes = np.array([float(line[2]) for line in lines if line[0] == "write"])
    written = sum(int(line[3]) for line in lines if line[0] == "write")
    syncs = sorted((float(line[2]), float(line[1])) for line in lines if line[0] == "sync")
    ages = list[float]()
    for (_, begun), (next_done, _) in pairwise(syncs):
        kept = writes[writes <= begun]
        ages += [next_done - kept.max()] if len(kept) else []
    minutes = (writes.max() - writes.min()) / 60.0
    most = max(ages)
    usual = float(np.median(ages))
    slowest = max(done - begun for done, begun in syncs)
    pause = float(np.diff(writes).max())
    return (
        f"journal at most {most:.2f} s behind (median of the worst between two syncs {usual:.2f} s; slowest sync of "
        f"this disk {slowest:.2f} s, longest time between two writes {pause:.2f} s); "
        f"{60 * len(syncs) / minutes / 3600:.1f} syncs a second, {written / minutes / 1e4:.0f} MB to the log in 100 min"
    )


async def stall_disk(show: Show, seconds: float) -> str:
    """A disk that does not answer."""
    return await _measure(show, seconds, _stalling(show))


async def kill_beside_stalled_disk(show: Show, seconds: float) -> str:
    """The server is killed while the disk does not answer; after some seconds it does."""
    with _stalling(show):
        await asyncio.sleep(1.0)
        _, server = show.processes()
        killed = time.monotonic()
        os.kill(server, signal.SIGKILL)
        await asyncio.sleep(seconds)
    await asyncio.sleep(2.0)
    pauses = [b[2] - a[2] for a, b in pairwise(show.stage.ticks) if a[0] != b[0] and b[2] > killed]
    away = show.stage.longest(killed + 1.0, killed + seconds)
    return (
        f"blackout {pauses[0]:.2f} s; while the disk is away longest time between two ticks {1000 * away:.0f} ms; "
        f"pauses when it is back {', '.join(f'{pause:.2f} s' for pause in pauses[1:]) or 'none'}"
    )


async def hang_server(show: Show, seconds: float) -> str:
    """The server stops (SIGSTOP) five times."""
    pauses = list[float]()
    for _ in range(5):
        await asyncio.sleep(seconds / 5)
        _, server = show.processes()
        seen = len(show.stage.ticks)
        stopped = time.monotonic()
        epoch = show.stage.ticks[-1][0]
        os.kill(server, signal.SIGSTOP)
        while not (back := [tick[2] for tick in show.stage.ticks[seen:] if tick[0] != epoch]):
            await asyncio.sleep(0.01)
        pauses.append(back[0] - stopped)
    return f"pauses {', '.join(f'{pause:.2f}' for pause in pauses)} s"


async def unread_terminal(show: Show, seconds: float) -> str:
    """Nobody reads the terminal, and unknown OSC is said there."""
    client = SimpleUDPClient("127.0.0.1", show.osc)

    @contextlib.contextmanager
    def talking() -> Iterator[None]:
        for number in range(5000):
            client.send_message(f"/omote/nonsense/{number}", [1.0])
        yield

    return await _measure(show, seconds, talking())


async def busy_programs(show: Show, seconds: float) -> str:
    """Four loops that take every processor."""

    @contextlib.contextmanager
    def busy() -> Iterator[None]:
        loops = [subprocess.Popen([sys.executable, "-c", BUSY]) for _ in range(LOOPS)]
        try:
            yield
        finally:
            for loop in loops:
                loop.kill()
                loop.wait()

    return await _measure(show, seconds, busy())


async def rotten_editors(show: Show, seconds: float) -> str:
    """Sixty editing links that send what no editor sends."""

    async def rot() -> None:
        while True:
            with contextlib.suppress(aiohttp.ClientError, OSError):
                async with show.http.ws_connect(show.url + EDITING_PATH, max_msg_size=0) as link:
                    while not link.closed:
                        for message in ROT:
                            await link.send_bytes(message)
                        await asyncio.sleep(0.01)

    @contextlib.contextmanager
    def rotting() -> Iterator[None]:
        links = [asyncio.create_task(rot()) for _ in range(LINKS)]
        try:
            yield
        finally:
            for link in links:
                link.cancel()

    return await _measure(show, seconds, rotting())


@contextlib.contextmanager
def _stalling(show: Show) -> Iterator[None]:
    show.stalls.touch()
    try:
        yield
    finally:
        show.stalls.unlink()


async def _measure(show: Show, seconds: float, disturbance: contextlib.AbstractContextManager[None]) -> str:
    since = time.monotonic()
    with disturbance:
        await asyncio.sleep(seconds)
        until = time.monotonic()
    await asyncio.sleep(2.0)
    longest = show.stage.longest(since, until)
    return f"longest time between two ticks {1000 * longest:.0f} ms; servers replaced: {show.stage.servers() - 1}"


DISTURBANCES: dict[str, Callable[[Show, float], object]] = {
    "power": lose_power,
    "disk": stall_disk,
    "kill": kill_beside_stalled_disk,
    "hang": hang_server,
    "terminal": unread_terminal,
    "busy": busy_programs,
    "editors": rotten_editors,
}


async def measure(names: list[str], seconds: float, port: int) -> None:
    """Prints what each disturbance does."""
    with tempfile.TemporaryDirectory() as folder:
        library = build_disk(Path(folder))
        for name in names:
            near, far = pty.openpty() if name == "terminal" else (None, None)
            print(f"{name}: load {os.getloadavg()[0]:.1f}, ", end="", flush=True)
            async with playing(library, port, terminal=far) as show:
                print(await DISTURBANCES[name](show, seconds))  # type: ignore[misc]
                said = show.said.read_text() if show.said.exists() else ""
                for line in re.findall(r"omote: (.*)", said)[2:]:
                    print(f"    {line}")
            for end in filter(None, (near, far)):
                os.close(end)


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help=f"of {', '.join(DISTURBANCES)}; all without any")
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--port", type=int, default=8310)
    options = parser.parse_args()
    asyncio.run(measure(options.names or list(DISTURBANCES), options.seconds, options.port))


if __name__ == "__main__":
    main()
