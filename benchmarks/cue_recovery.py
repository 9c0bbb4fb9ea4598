"""A night of cues goes on after `kill -9`: cue, standby, waits, what follows, and a clip that plays.

Starts `omote show` as a user does, with a list of cues that follow each other by themselves, with moves that wait, and
a clip that plays in a loop; kills the server at random moments. Of the state that comes back is asked that it is at
most .1 s older than the last that was seen, and that in it the list is where its own clock says: the same cue with the
same standby, or the one that was due since; each wait, what follows and the clip as far on as the show's time is.

`python -m benchmarks.cue_recovery [--kills N]`, 20 without it, 100 asked.
"""

from __future__ import annotations

import argparse
import asyncio
import os
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
from benchmarks.recovery import AGE_LIMIT, BLACKOUT_LIMIT, COMMAND, Follower, processes_of, read_address
from omote.show.declaration import ClientMessage
from omote.show.messages import LINK_PATH, STATE_RATE
from omote.show.objects.clips import KeepPass, PlayClip, RecordClip
from omote.show.objects.cues import CueListStatus, Go
from omote.show.objects.state import ClipState, State
from omote.show.wire import encode

CUES = 600
FOLLOW_SECONDS = 1.4
BLEND_SECONDS = 0.2
"""In which the loop of the clip goes over into its beginning: by that it is shorter than the clip."""
APART = 0.03
"""Seconds that a wait, what follows or a clip may be off the show's time: two ticks, where what is due is called."""


@dataclass(frozen=True)
class Recovery:
    """One kill: seconds of blackout, seconds that the show went back, and what of the list was not where it should
    be."""

    blackout: float
    age: float
    wrong: tuple[str, ...]


class CueFollower(Follower):
    """A client that plays cues and stays with a show through everything."""

    async def send(self, message: ClientMessage, http: aiohttp.ClientSession) -> None:
        """Sends a message."""
        await self._connect(http)
        assert self._socket is not None
        await self._socket.send_bytes(encode(message))


def evening() -> str:
    """The list as text: each cue is followed by the next, and one of its moves waits."""
    cues = []
    for number in range(1, CUES + 1):
        face = ("old", "child", "round", "kaori")[number % 4]
        cues.append(
            f'[[cue]]\nnumber = "{number}"\ngoes_on = "follow"\npost_wait = {FOLLOW_SECONDS}\n[cue.moves]\n'
            f'"one/face" = {{ to = "{face}", seconds = 1.0 }}\n'
            f'"*/light" = {{ to = "{("flat", "theatre")[number % 2]}", seconds = 1.0, delay = 1.1 }}\n'
        )
    return "\n".join(cues)


async def begin(follower: CueFollower, http: aiohttp.ClientSession, address: str) -> None:
    """Brings the list and a clip into the show, and begins both."""
    response = await http.post(f"{address}/cue_lists/main", data=evening())
    if response.status != 200:
        raise RuntimeError(await response.text())
    await follower.state(http)
    await follower.send(RecordClip("clip 1", "one", "turn"), http)
    begun = (await follower.state(http)).time
    while (await follower.state(http)).time < begun + 2.0:
        pass
    await follower.send(KeepPass("clip 2", "one"), http)
    await follower.send(PlayClip("one", "clip 3", "turn", BLEND_SECONDS, loop=True), http)
    await follower.send(Go("go 1"), http)
    while (state := await follower.state(http)).cues is None or state.cues.lists["main"].current is None:
        pass


def faults(before: State, after: State) -> tuple[str, ...]:
    """What of the state that came back is not as far on as its time says. before: the last that was seen."""
    passed = after.time - before.time
    if before.cues is None or after.cues is None:
        return ("no cues",)
    was = before.cues.lists["main"]
    came = after.cues.lists["main"]
    found = [] if _has_gone_on(was, came, passed) else [f"cue {_number(was)} is {_number(came)} after {passed:.3f} s"]
    if _number(was) == _number(came):
        left = {wait.part: wait.seconds for wait in was.waits}
        found += [
            f"{wait.part} waits {wait.seconds:.3f} of {left.get(wait.part, -1.0):.3f} s after {passed:.3f}"
            for wait in came.waits
            if abs(left.get(wait.part, -1.0) - passed - wait.seconds) > APART
        ]
        if abs(was.follows_in - passed - came.follows_in) > APART:
            found.append(f"what follows in {was.follows_in:.3f} s does in {came.follows_in:.3f} after {passed:.3f}")
    clips = [state.characters["one"].clips for state in (before, after)]
    if [clip.name for clip in clips[1]] != ["turn"]:
        found.append(f"the clip is {[clip.name for clip in clips[1]]}")
    elif (
        clips[0]
        and abs(off := _around(clips[1][0].elapsed - clips[0][0].elapsed - passed, _loop_of(clips[1][0]))) > APART
    ):
        found.append(f"the clip is {off:.3f} s off")
    return tuple(found)


def _has_gone_on(was: CueListStatus, came: CueListStatus, passed: float) -> bool:
    if _number(was) == _number(came):
        return was.follows_in > passed - APART and was.standby == came.standby
    due = was.follows is not None and abs(was.follows_in - passed) < FOLLOW_SECONDS
    return due and came.current == was.follows


def _loop_of(clip: ClipState) -> float:
    """Seconds from one beginning of a loop to the next."""
    return clip.seconds - BLEND_SECONDS


def _around(seconds: float, length: float) -> float:
    """The shortest way to a time of a loop."""
    return (seconds + length / 2.0) % length - length / 2.0


def _number(status: CueListStatus) -> str:
    return "" if status.current is None else status.current.number


async def kill_once(follower: Follower, http: aiohttp.ClientSession, show: Path, wait: float) -> Recovery:
    """Kills the server `wait` seconds from now, and waits for the picture."""
    state = await follower.state(http)
    begun = time.monotonic()
    while time.monotonic() - begun < wait:
        state = await follower.state(http)
    _, server = processes_of(show)
    killed = time.monotonic()
    os.kill(server, signal.SIGKILL)
    while state.epoch == (first := await follower.state(http)).epoch:
        state = first
    came_back = first.time - (first.number - 1) / STATE_RATE
    return Recovery(follower.received - killed, state.time - came_back, faults(state, first))


async def measure(url: str, show: Path, kills: int) -> list[Recovery]:
    """As many kills as asked for, at seeded random moments."""
    waits = np.random.default_rng(31).uniform(0.6, 3.0, kills)
    follower = CueFollower(url)
    async with aiohttp.ClientSession() as http:
        await begin(follower, http, url.removesuffix(LINK_PATH))
        return [await kill_once(follower, http, show, float(wait)) for wait in waits]


def verdict(recoveries: list[Recovery]) -> bool:
    """Prints the figures beside their limits; whether they hold."""
    pace = measure_waiting_pace()
    good = True
    print(f"{len(recoveries)} x kill -9 while cues follow each other")
    for name, values, limit in (
        ("blackout    ", [each.blackout for each in recoveries], BLACKOUT_LIMIT),
        ("age of state", [each.age for each in recoveries], AGE_LIMIT),
    ):
        most = limit * pace
        print(f"  {name}  median {np.median(values):6.3f} s   max {max(values):6.3f} s   limit {most:.2f} s")
        good = good and max(values) <= most
    wrong = [fault for each in recoveries for fault in each.wrong]
    print(f"  cue, standby, waits, what follows and clip went on in {sum(not each.wrong for each in recoveries)}")
    for fault in wrong[:10]:
        print(f"    {fault}")
    good = good and not wrong
    print("holds" if good else "DOES NOT HOLD")
    return good


def main() -> int:
    """Runs the show, kills it, prints; exit status 1 when a limit is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=20)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        show = Path(folder) / "show.omote"
        command = [*COMMAND, str(show), "--port", "0", "--no-open", "--no-announce", "--osc", "off"]
        with (Path(folder) / "said").open("w+") as said:
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said, text=True)
            try:
                recoveries = asyncio.run(measure(read_address(process), show, options.kills))
            finally:
                process.terminate()
                process.wait(10.0)
    return 0 if verdict(recoveries) else 1


if __name__ == "__main__":
    sys.exit(main())
