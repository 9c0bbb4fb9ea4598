"""A tick of a show with four characters, four trackers at 60 Hz and 100 moving faders: how long it takes, and who needs
how much of it.

Each character has a tracker of 52 channels with head and gaze on its own layer, 25 bound faders of its own that move in
each tick, and is called an expression and a face twice a second; two consoles are there. What is timed is all that the
server does once a tick: what devices read is played, the show advances, hands are told, the state is encoded, and what
is on air is noted for devices. Beside it stand the same show without devices, with trackers alone and with faders
alone, ticks of all four by turns; shares are ratios of medians to the show without devices. Times are of the processor,
of one thread; those of the clock, which a busy machine makes longer, stand beside.

* the tick with all of it at the 99th percentile: at most 2 ms at the pace of the machine (`benchmarks/pace.py`), whose
  pieces of work are done by turns with the ticks;
* the messages of four trackers, decoding included: at most 3 % of a core at that pace;
* beside: the same where each frame of a tracker is 52 messages of a channel, as before there were layers.

`python -m benchmarks.tick [--seconds S]`.
"""

from __future__ import annotations

import os

from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.characters import AddCharacter
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello
from omote.show.objects.sources import Drive, Source

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import gc
import math
import sys
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

import omote
from benchmarks.pace import Pace
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.reading import Reading
from omote.show.session import ShowSession
from omote.show.wire import encode

CHARACTERS = 4
FADERS = 100
RATE = 60
SECONDS = 30.0
BAR_TICK = 2e-3
BAR_CORE = 0.03
"""Processor seconds of a tick, and share of a core, where the pace is 1 (issue 11, item 1)."""
CONSOLES = ("phone", "tablet")
VARIANTS = {"alone": (False, False), "trackers": (True, False), "faders": (False, True), "all": (True, True)}
"""Whether there are trackers, and whether there are faders."""

Values = NDArray[np.float64]
Send = Callable[[ShowSession, int, Values, float], None]


def begin(cast: omote.Cast) -> ShowSession:
    """A session with four characters and two consoles."""
    session = ShowSession(cast)
    for who in CONSOLES:
        session.receive(who, Hello("console", PROTOCOL_VERSION, who), 0.0)
    for number in range(1, CHARACTERS):
        session.receive("phone", AddCharacter(f"add{number}", f"c{number}", f"C{number}", "generic"), 0.0)
    return session


def by_frame(session: ShowSession, index: int, values: Values, now: float) -> None:
    """A frame of a tracker as one message; sources have the indices 1, 2, ... as they were opened."""
    frame = Drive(index + 1, values.astype("<f4").tobytes(), (0.1, 0.05, 0.0), (0.1, -0.1))
    receive(session, encode(frame), now)


def by_channel(names: list[str]) -> Send:
    """A frame of a tracker as a message for each channel."""

    def send(session: ShowSession, index: int, values: Values, now: float) -> None:
        who = list(session.scene)[index]
        for name, value in zip(names, values.tolist(), strict=True):
            receive(session, encode(SetChannel(who, name, value)), now)

    return send


def receive(session: ShowSession, data: bytes, now: float) -> None:
    """Has a message received; RuntimeError where it is not obeyed."""
    answers = session.receive_bytes("phone", data, now)
    if answers:
        raise RuntimeError(str(answers))


def bind_faders(session: ShowSession, names: list[str]) -> BindingInput:
    """Faders of one device, each for a channel of its own; they act once they have crossed what is on air."""
    who = list(session.scene)
    targets = [(who[n % CHARACTERS], names[n // CHARACTERS]) for n in range(FADERS)]
    bound = [Binding("desk", f"1/cc{n}", read_target(f"/omote/{c}/channel/{u}")) for n, (c, u) in enumerate(targets)]
    return BindingInput(Bindings(bound), lambda: session)


def move_faders(now: float) -> list[Reading]:
    """Where all faders have been moved to."""
    return [Reading("desk", f"1/cc{n}", 0.5 + 0.5 * math.sin(2.0 * now + n)) for n in range(FADERS)]


class Show:
    """One of the shows that are compared, and the times of its ticks. sent: processor seconds of trackers' messages."""

    def __init__(self, cast: omote.Cast, names: list[str], send: Send | None, *, faders: bool) -> None:
        self.session = begin(cast)
        self.send = send
        self.devices = bind_faders(self.session, names) if faders else None
        self.faces = list(cast.faces)
        self.worn = [n for n, title in cast.titles.items() if title.kind == "performed"]
        self.rng = np.random.default_rng(11)
        self.sent = 0.0
        self.processor = list[float]()
        self.clock = list[float]()
        for who in self.session.scene if send is by_frame else ():
            self.session.receive("phone", Source(f"tracker {who}", "tracker", names, [who]), 0.0)

    def play(self, frame: int, tracked: Values) -> None:
        """One tick, after what has come since the last. tracked: the trackers' values, (4, channels)."""
        now = frame / RATE
        start = time.thread_time()
        for index, values in enumerate(tracked if self.send else ()):
            self.send(self.session, index, values, now)  # type: ignore[misc]
        self.sent += time.thread_time() - start
        self.call(frame, now)
        readings = move_faders(now)
        clock = time.perf_counter()
        processor = time.thread_time()
        self.tick(readings, now)
        self.processor.append(time.thread_time() - processor)
        self.clock.append(time.perf_counter() - clock)

    def tick(self, readings: list[Reading], now: float) -> None:
        """All that the server does once a tick."""
        if self.devices:
            self.devices.hear(readings, now)
        state = self.session.tick(now)
        for each in self.session.hands_now(now):
            encode(each.message)
        encode(state)
        if self.devices:
            self.devices.note_state(state)

    def call(self, frame: int, now: float) -> None:
        """Calls an expression and a face of each character twice a second."""
        for index, who in enumerate(self.session.scene):
            if frame % 30 == 7 * index:
                face = str(self.rng.choice(self.faces))
                expression = str(self.rng.choice(self.worn))
                self.session.receive("phone", CallFace(who, f"f{frame}{who}", face, 0.4, "smooth"), now)
                self.session.receive("tablet", CallExpression(who, f"e{frame}", expression, 0.4, "smooth"), now)


def play(shows: list[Show], channels: int, seconds: float) -> Pace:
    """Plays all shows, tick by tick and by turns with pieces of the machine's work, whose times it gives."""
    pace = Pace()
    rng = np.random.default_rng(11)
    gc.collect()
    gc.freeze()
    for frame in range(round(seconds * RATE)):
        phase = frame / RATE * 3.0 + np.arange(channels)[None, :] + np.arange(CHARACTERS)[:, None]
        tracked = 0.45 + 0.4 * np.sin(phase) + 0.03 * rng.random((CHARACTERS, channels))
        for turn in range(len(shows)):
            shows[(frame + turn) % len(shows)].play(frame, tracked)
        pace.measure()
    return pace


def tell(console: Console, shows: dict[str, Show]) -> None:
    """Prints the times of each show's ticks, and each show's share beside the one without devices."""
    table = Table("tick, ms", "processor: median", "99 %", "clock: median", "99 %", "beside alone")
    alone = float(np.median(shows["alone"].processor))
    for name, show in shows.items():
        times = [each * 1e3 for spent in (show.processor, show.clock) for each in np.quantile(spent, [0.5, 0.99])]
        share = np.median(show.processor) / alone
        table.add_row(name, *(f"{each:.2f}" for each in times), f"{share:.2f}")
    console.print(table)


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=SECONDS)
    seconds = parser.parse_args().seconds
    cast = omote.load_cast()
    names = [name for name, title in cast.titles.items() if title.kind == "arkit"]
    shows = {
        name: Show(cast, names, by_frame if tracked else None, faders=faders)
        for name, (tracked, faders) in VARIANTS.items()
    }
    shows["channel by channel"] = Show(cast, names, by_channel(names), faders=False)
    pace = play(list(shows.values()), len(names), seconds)
    console = Console()
    console.print(f"{CHARACTERS} characters, {len(names)} channels each, {RATE} Hz, {FADERS} faders, {seconds:g} s")
    tell(console, shows)
    core = shows["trackers"].sent / seconds
    plain = shows["channel by channel"].sent / seconds
    console.print(f"trackers' messages: {core:.2%} of a core; channel by channel {plain:.2%}: 1/{plain / core:.1f}")
    late = float(np.quantile(shows["all"].processor, 0.99)) / (BAR_TICK * pace.ratio(0.99))
    core /= BAR_CORE * pace.ratio()
    console.print(f"pace {pace.ratio():.2f}, at 99 % {pace.ratio(0.99):.2f}; of what is asked: {late:.2f}, {core:.2f}")
    claims = (("tick", late <= 1.0), ("trackers", core <= 1.0))
    for told, holds in claims:
        console.print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
