"""A flood of packets harms nothing: ticks stay on time, memory flat, the terminal readable; no packet breaks a decoder.

First a show hears 40,000 packets of OSC a second from another process, half of them wrong, in turns with seconds
without any. Printed for both: how much processor time a tick takes and how late it begins, memory before and after, and
lines on the terminal. What a tick does for devices is bounded in time, so that the comparison is with the same run
without the flood: a busy machine delays both. Then packets of OSC, MIDI, sACN and Art-Net are damaged at random and
played, and what one pair of hands sends (`hand_packets.py`); exceptions and numbers on air that are none are counted.
`--packets N` (of all together), `--seed N`, `--rounds N` for others, `--only OSC --only messages` for some kinds alone.
"""

from __future__ import annotations

import argparse
import asyncio
import gc
import math
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

import msgspec
import numpy as np

from benchmarks.hand_packets import CALL, MAPPINGS, message_packets, not_numbers, osc_packets, setup_documents
from benchmarks.pace import measure_pace
from omote.builtin import load_cast
from omote.inputs.bindings.binding_changes import EditableBindings
from omote.inputs.bindings.binding_file import read_bindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.dmx.dmx_input import DmxInput
from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import encode_bundle, encode_message
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.inputs.page_devices.setup_commands import SetupCommands
from omote.model.cast import Cast
from omote.server.devices.osc_listener import OscListener
from omote.server.devices.rejection_log import RejectionLog
from omote.server.supervision.early_tick import EarlyTicks
from omote.server.supervision.listening_socket import listen_for_osc
from omote.server.supervision.tick_loop import run_ticks
from omote.show.messages import PROTOCOL_VERSION, STATE_RATE
from omote.show.objects.hand.macros import SetMappings
from omote.show.objects.hand.setups import CallSetup, KeepSetup
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetMotion
from omote.show.objects.state import State
from omote.show.session import ShowSession

RATE = 40_000
LATEST = 0.008
PHASE_SECONDS = 5.0
"""Packets a second; processor seconds that a tick of a flood may take where the pace is
1 (issue 11, item 6); seconds of a phase."""
GROWTH = 4.0
"""Megabytes by which memory may move between the second flood and the last: what the allocator keeps."""
PACKETS = 3_000_000
SEED = 1
ROUNDS = 4
HOST = "127.0.0.1"
DESK = "10.0.0.5"
PAGE = "page"
SENDER = """
import socket, sys, time
port, rate, seconds = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
packets = [bytes.fromhex(line) for line in sys.argv[4].split(",")]
out = socket.socket(type=socket.SOCK_DGRAM)
start, sent = time.perf_counter(), 0
while (passed := time.perf_counter() - start) < seconds:
    while sent < passed * rate:
        out.sendto(packets[sent % len(packets)], ("127.0.0.1", port))
        sent += 1
    time.sleep(0.0005)
print(sent)
"""
BOUND = """
binding = [
  { device = "sACN", control = "1/1", to = "/omote/one/channel/jawOpen" },
  { device = "sACN", control = "1/2", to = "/omote/one/head", axis = "yaw" },
  { device = "Art-Net", control = "0/1", to = "/omote/one/fade/face" },
  { device = "Art-Net", control = "0/2", to = "/omote/one/face", arguments = ["dog", "hand"] },
  { device = "pad", control = "1/cc1+33", to = "/omote/one/gaze", axis = "pitch", pick_up = false },
  { device = "pad", control = "1/cc2", to = "/omote/one/channel/smile", relative = "sign_magnitude" },
  { device = "pad", control = "1/note60", to = "/omote/panic" },
  { device = "Hand one right", control = "opening", to = "/omote/one/macro/stick" },
  { device = "Hand one right", control = "yaw", to = "/omote/one/head", axis = "yaw" },
]
"""


@dataclass
class Phase:
    """Ticks of one phase: processor seconds of each, seconds by which each came later than the rate; lines said."""

    spent: list[float] = field(default_factory=list)
    late: list[float] = field(default_factory=list)
    sent: int = 0
    seconds: float = 0.0
    lines: int = 0
    megabytes: float = 0.0


def memory() -> float:
    """Megabytes of memory that this process has now."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096 / 1e6


def flood_packets() -> list[bytes]:
    """What the flood consists of: half of it wrong."""
    good = [encode_message("/omote/one/channel/jawOpen", n / 16) for n in range(8)]
    bad = [encode_message("/omote/one/face", "nobody"), b"/omote", encode_message("/omote/one/channel/jawOpen", 9.0)]
    return [packet for n, each in enumerate(good) for packet in (each, bad[n % len(bad)])]


async def measure_phase(
    listener: OscListener, session: ShowSession, said: list[str], early: EarlyTicks, *, flooded: bool
) -> Phase:
    """Ticks for some seconds, with a flood or without."""
    phase = Phase()
    lines = len(said)
    port = str(listener._sockets.datagrams.getsockname()[1])
    words = [port, str(RATE if flooded else 0), str(PHASE_SECONDS), ",".join(p.hex() for p in flood_packets())]
    sender = await asyncio.create_subprocess_exec(sys.executable, "-c", SENDER, *words, stdout=subprocess.PIPE)
    started = before = time.monotonic()

    def tick(_: int | None) -> None:
        nonlocal before
        spent = time.thread_time()
        now = time.monotonic()
        phase.late.append(now - before - 1.0 / STATE_RATE)
        before = now
        listener.hear(now)
        listener.tell(session.tick(now), now)
        phase.spent.append(time.thread_time() - spent)

    ticking = asyncio.create_task(run_ticks(tick, early=early))
    printed, _ = await sender.communicate()
    ticking.cancel()
    phase.sent = int(printed)
    phase.seconds = time.monotonic() - started
    phase.lines = len(said) - lines
    phase.megabytes = memory()
    return phase


async def measure_flood(cast: Cast, rounds: int) -> tuple[list[Phase], list[Phase]]:
    """Phases without a flood and with one, in turns."""
    session = ShowSession(cast)
    said = list[str]()
    sockets = listen_for_osc(HOST, 0)
    early = EarlyTicks()
    early.watch(sockets.datagrams)
    listener = OscListener(OscInput(lambda: session), sockets, RejectionLog(said.append))
    quiet = []
    flooded = []
    gc.freeze()
    for _ in range(rounds):
        quiet.append(await measure_phase(listener, session, said, early, flooded=False))
        flooded.append(await measure_phase(listener, session, said, early, flooded=True))
    await listener.close()
    return quiet, flooded


def report_flood(quiet: list[Phase], flooded: list[Phase]) -> bool:
    """Prints both kinds of phases; whether the flood did no harm."""
    for name, phases in (("without", quiet), ("flood", flooded)):
        spent = np.concatenate([phase.spent for phase in phases]) * 1e3
        late = np.concatenate([phase.late for phase in phases]) * 1e3
        sent = sum(phase.sent for phase in phases) / (PHASE_SECONDS * len(phases))
        print(
            f"{name:8} {sent:8.0f} packets/s, {len(spent)} ticks: processor ms {percentiles(spent)}; "
            f"ms late {percentiles(late)}"
        )
    worst = max(max(phase.spent) for phase in flooded)
    most = LATEST * measure_pace()
    growth = flooded[-1].megabytes - flooded[min(1, len(flooded) - 1)].megabytes
    lines = sum(phase.lines for phase in flooded) / sum(phase.seconds for phase in flooded)
    print(
        f"dearest tick of the flood {worst * 1e3:.1f} ms (at most {most * 1e3:.0f}); "
        f"memory {growth:+.1f} MB; {lines:.2f} lines/s on the terminal"
    )
    return worst <= most and growth <= GROWTH and lines <= 1.0 + len(flooded) / sum(phase.seconds for phase in flooded)


def percentiles(values: np.ndarray[tuple[int], np.dtype[np.float64]]) -> str:
    """Median, 99th percentile and maximum, for people."""
    return "50 % {:.2f}, 99 % {:.2f}, most {:.2f}".format(*np.percentile(values, [50, 99, 100]))


def golden() -> dict[str, list[bytes]]:
    """Packets that are whole, by protocol."""
    levels = bytes(range(8))
    osc = [
        *flood_packets(),
        encode_message("/omote/one/head", 10.0, -5, "3"),
        encode_message("/omote/one/gaze", 10.0, True),
        encode_message("/omote/one/face", "dog", "hand"),
        encode_message("/omote/light", "warm"),
        encode_message("/omote/panic"),
        encode_message("/omote/subscribe", 9001),
    ]
    head = struct.pack(">HH12sHI16s", 16, 0, b"ASC-E1.17\0\0\0", 0x7000 | 118, 4, bytes(16))
    framing = struct.pack(">HI64sBHBBH", 0x7000 | 96, 2, b"Desk", 100, 0, 0, 0, 1)
    sacn = head + framing + struct.pack(">HBBHHHB", 0x7000 | 19, 2, 0xA1, 0, 1, 9, 0) + levels
    artnet = b"Art-Net\0\x00\x50\x00\x0e\x00\x00\x00\x00\x00\x08" + levels
    midi = [
        bytes.fromhex(text) for text in ("b0 01 40 21 7f", "b0 02 41", "90 3c 7f 80 3c 00", "f0 01 02 f7", "e0 01 02")
    ]
    return {
        "OSC": [*osc, encode_bundle(osc[:4])],
        "MIDI": midi,
        "sACN": [sacn],
        "Art-Net": [artnet, b"Art-Net\0\x00\x20\x00\x0e\x00\x00"],
        "hands": [*osc_packets(), *not_numbers()],
        "messages": message_packets(),
        "set-ups": setup_documents(),
    }


def mutate(packets: list[bytes], count: int, seed: int) -> Iterator[bytes]:
    """Packets with up to four bytes changed, some cut, some grown; every tenth is whole."""
    generator = np.random.default_rng(seed)
    for _ in range(0, count, 4096):
        draws = generator.integers(0, 2**31, (min(4096, count), 12)).tolist()
        for kind, which, *rest in draws[: count - _]:
            data = bytearray(packets[which % len(packets)])
            for place, value in zip(rest[0:4:1], rest[4:8], strict=True) if kind % 10 else ():
                if place % 3:
                    data[place % len(data)] = value & 0xFF
            if kind % 10 == 1:
                del data[rest[8] % (len(data) + 1) :]
            elif kind % 10 == 2:
                data += bytes(data[: rest[8] % len(data)])
            yield bytes(data)


def is_sound(state: State) -> bool:
    """Whether a state holds numbers alone."""
    text = msgspec.to_builtins(state)
    waiting = [text]
    while waiting:
        each = waiting.pop()
        waiting += each.values() if isinstance(each, dict) else each if isinstance(each, list | tuple) else ()
        if isinstance(each, float) and not math.isfinite(each):
            return False
    return True


class Show:
    """A session that every protocol plays, without a socket. It is begun anew with each kind of packets."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.devices = BindingInput(Bindings(read_bindings(BOUND)), lambda: self.session)
        commands = BindingCommands(EditableBindings(), self.devices.bindings, {}, lambda _: None)
        setups = SetupCommands(lambda: self.session, commands)
        self.page = PageDevices(lambda: self.session, self.devices, commands, setups=setups)
        self.dmx = DmxInput([1])
        self.osc = OscInput(lambda: self.session)
        self.midi = MidiDecoder("pad")
        self.dmx.watch(self.devices.bindings.controls)
        self.calls = 0
        self.session.receive(PAGE, Hello("console", PROTOCOL_VERSION, "page"), 0.0)
        for message in (
            SetMappings("one", "set", MAPPINGS),
            SetMotion("one", liveliness=0.5),
            KeepSetup("keep", "left-handed"),
        ):
            self.session.receive(PAGE, message, 0.0)
        self.play: dict[str, Callable[[bytes, float], object]] = {
            "OSC": lambda data, now: self.osc.receive((DESK, 9000), data, now),
            "MIDI": lambda data, now: self.devices.hear(self.midi.feed(data), now),
            "sACN": lambda data, now: self.dmx.receive_sacn(DESK, data, now),
            "Art-Net": lambda data, now: self.dmx.receive_artnet(DESK, data, now, DESK),
            "hands": lambda data, now: self.osc.receive((DESK, 9000), data, now),
            "messages": self.hear_page,
            "set-ups": self.call_setup,
        }

    def hear_page(self, data: bytes, now: float) -> None:
        """A message of a page, under an id of its own. data: its bytes; now: seconds."""
        self.calls += 1
        self.session.receive_bytes(PAGE, data.replace(CALL.encode(), b"%08d" % self.calls), now)

    def call_setup(self, data: bytes, now: float) -> None:
        """A set-up of a show file is called, if it can be read. data: its document; now: seconds."""
        self.calls += 1
        commands = BindingCommands(EditableBindings(), self.devices.bindings, {}, lambda _: None)
        setups = SetupCommands(lambda: self.session, commands, {"damaged": data})
        with suppress(ValueError):
            setups.carry_out(PAGE, CallSetup(f"{self.calls:08d}", "damaged"), now)

    def tick(self, now: float) -> State:
        """Plays what slots read, does what pages ask of devices, and tells all sides what is on air."""
        self.devices.hear(self.dmx.take_readings(now), now)
        for who, message in self.session.take_device_messages():
            self.page.receive(who, message, now)
        self.page.play_hands(self.osc.hands.take(), now)
        state = self.session.tick(now)
        self.page.tick(state, now)
        self.devices.note_state(state)
        self.osc.news(state, now)
        return state


def play_mutated(cast: Cast, protocol: str, count: int, seed: int) -> tuple[int, int]:
    """Plays mutated packets; returns how many raised an exception, and how many states held what is no number."""
    show = Show(cast)
    raised = unsound = 0
    for number, data in enumerate(mutate(golden()[protocol], count, seed)):
        try:
            show.play[protocol](data, number / 4096)
            if number % 64 == 0:
                unsound += not is_sound(show.tick(number / 4096))
        except Exception as error:  # what the claim is about
            raised += 1
            print(f"{protocol}: {type(error).__name__} {error} by {data.hex()}")
    return raised, unsound


def main() -> int:
    """Both halves of the claim; exit status 1 where one fails."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name, value in (("--packets", PACKETS), ("--seed", SEED), ("--rounds", ROUNDS)):
        parser.add_argument(name, type=int, default=value)
    parser.add_argument("--only", action="append", choices=[*golden()], help="kinds of packets; all of them without")
    options = parser.parse_args()
    cast = load_cast()
    good = report_flood(*asyncio.run(measure_flood(cast, options.rounds))) if options.rounds else True
    kinds = options.only or [*golden()]
    count = options.packets // len(kinds)
    for protocol in kinds:
        started = time.process_time()
        raised, unsound = play_mutated(cast, protocol, count, options.seed)
        seconds = time.process_time() - started
        print(
            f"{protocol:8} {count} packets, seed {options.seed}, {seconds:.0f} s: "
            f"{raised} exceptions, {unsound} states with what is no number",
            flush=True,
        )
        good = good and raised == unsound == 0
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
