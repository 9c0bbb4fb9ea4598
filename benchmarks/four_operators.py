"""Four operators play one show: four consoles in Chromium, two of them with a gamepad, a desk of OSC, one stage.

Starts `omote show` as a user does with a show file of its own, adds two characters, turns leases on, and plays for some
minutes: two operators by clicks and keys, two by gamepads (`navigator.getGamepads` is replaced; the preset of their
name plays), a desk of OSC at 30 messages a second from a library that is not ours. In the middle the server is killed
with `kill -9`. Printed: states a second and the longest gap between two as a program sees them, frames of the stage a
second, errors that pages reported, what was rejected, memory of the show's processes at the beginning and the end.
Screenshots of all pages, at the beginning, before and after the kill and at the end, lie in `--pictures`.
`--minutes N`, `--seed N` for others.
"""

from __future__ import annotations

import argparse
import contextlib
import math
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from threading import Event, Thread

import numpy as np
from playwright.sync_api import Browser, Error, Page, sync_playwright
from pythonosc.udp_client import SimpleUDPClient

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import omote
from benchmarks.pace import measure_waiting_pace
from benchmarks.recovery import children
from benchmarks.stage import CHROMIUM
from tools.browser import SENTENCE, find_browser

COMMAND = (sys.executable, "-c", "from omote.cli import main; main()", "show")
PAUSE = 0.25
"""Seconds between two actions of an operator, as a quick hand takes."""
LONGEST_GAP = 1.0
"""Seconds for which a stage may be without a state while a server is replaced, where the pace is 1 (issue 2, item
8)."""
GROWTH = 1.3
"""By how much memory may grow: the caches fill."""
PAD = """
window.pad = {
    id: "Xbox Wireless Controller (STANDARD GAMEPAD Vendor: 045e Product: 0b13)", index: 0, connected: true,
    mapping: "standard", axes: [0, 0, 0, 0], timestamp: 0,
    buttons: Array.from({ length: 17 }, () => ({ value: 0, pressed: false, touched: false })),
};
navigator.getGamepads = () => [window.pad];
"""
STICKS = "(axes) => { pad.axes = axes; pad.timestamp += 1; }"
BUTTON = """([at, value]) => {
    pad.buttons[at] = { value, pressed: value > 0, touched: value > 0 };
    pad.timestamp += 1;
}"""
SIZES = (1440, 900), (1024, 768), (768, 1024), (1280, 800)
STORE = "document.querySelector('omote-console')?.context?.store"
FRAMES = """() => { window.drawnFrames = 0;
const count = () => { window.drawnFrames += 1; requestAnimationFrame(count); }; requestAnimationFrame(count); }"""


@dataclass
class Trial:
    """What is seen while it runs: when states came, errors of pages, orders that were rejected."""

    arrivals: list[float] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    done: Counter[str] = field(default_factory=Counter)
    over: Event = field(default_factory=Event)


@contextlib.contextmanager
def running_show(folder: Path, port: int) -> Iterator[tuple[str, int]]:
    """A show as a user starts it: its address, and the process that supervises it."""
    words = [str(folder / "trial.omote"), "--no-open", "--no-announce", "--port", "0", "--osc", str(port)]
    environment = {**os.environ, "PYTHONUNBUFFERED": "1", "OPENBLAS_NUM_THREADS": "1"}
    with subprocess.Popen([*COMMAND, *words], env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        address = next(found[0] for line in process.stdout if (found := re.findall(r"http://[\d.]+:\d+", line)))
        Thread(target=process.stdout.read, daemon=True).start()
        try:
            yield address, process.pid
        finally:
            process.send_signal(signal.SIGINT)
            process.wait()


def free_port() -> int:
    """A port of datagrams that nobody has."""
    with socket.socket(type=socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def megabytes(pid: int) -> float:
    """Memory that a show's processes have of their own (proportional set size)."""
    total = 0
    processes = [pid]
    for each in processes:
        processes += children(each)
        with contextlib.suppress(OSError):
            text = Path(f"/proc/{each}/smaps_rollup").read_text()
            total += int(re.findall(r"^Pss:\s+(\d+)", text, re.MULTILINE)[0])
    return total / 1024


# --- who plays --------------------------------------------------------------------------------------------------------


def play_osc(port: int, trial: Trial) -> None:
    """A desk of OSC: a jaw that talks, a head that sways, now and then a call; 30 messages a second."""
    desk = SimpleUDPClient("127.0.0.1", port)
    began = time.monotonic()
    while not trial.over.wait(1 / 30):
        now = time.monotonic() - began
        desk.send_message("/omote/three/channel/jawOpen", 0.3 + 0.3 * math.sin(9 * now))
        desk.send_message("/omote/three/head", [20 * math.sin(now), 5 * math.sin(1.7 * now), 0.0])
        if int(now * 30) % 150 == 0:
            desk.send_message("/omote/three/expression", ["joy" if int(now) % 2 else "sad", 0.5])
        trial.done["OSC"] += 1


def watch(address: str, trial: Trial) -> None:
    """A program that hears every state and notes when it came."""
    with omote.connect(address, name="watch") as show:
        while not trial.over.is_set():
            try:
                show.wait()
            except ConnectionError:
                continue
            trial.arrivals.append(time.monotonic())


def play_keys(page: Page, dice: np.random.Generator) -> None:
    """One action of an operator with mouse and keyboard: a call by key, or a touch of a face or an expression."""
    if dice.random() < 0.5:
        page.keyboard.press(str(dice.choice(list("1234qwetycx"))))
        return
    tiles = page.locator(".tile[data-name]").filter(visible=True)
    tiles.nth(int(dice.integers(min(12, max(1, tiles.count()))))).click(timeout=4000)


def play_pad(page: Page, dice: np.random.Generator) -> None:
    """One movement of a pad: both sticks somewhere, and a button pressed and let go."""
    page.evaluate(STICKS, dice.uniform(-1, 1, 4).round(3).tolist())
    button = int(dice.integers(12))
    for value in (1, 0):
        page.evaluate(BUTTON, [button, value])
        page.wait_for_timeout(40)


def open_page(browser: Browser, address: str, size: tuple[int, int], trial: Trial, *scripts: str) -> Page:
    """A page at a browser of its own, whose errors are noted."""
    context = browser.new_context(viewport={"width": size[0], "height": size[1]})
    for script in scripts:
        context.add_init_script(script)
    page = context.new_page()
    page.on("pageerror", lambda error: trial.errors.append(f"{address}: {error}"))
    page.goto(address)
    return page


def open_consoles(browser: Browser, address: str, trial: Trial) -> list[Page]:
    """Four consoles; the last two have a pad, and play the first and the second character."""
    pages = []
    for number, size in enumerate(SIZES):
        page = open_page(browser, f"{address}/console", size, trial, *([PAD] if number >= 2 else []))
        while not page.evaluate(f"Boolean({STORE}?.online && {STORE}.faces.length > 0)"):
            page.wait_for_timeout(100)
        pages.append(page)
    return pages


def set_up(address: str) -> None:
    """Three characters side by side in one shot."""
    with omote.connect(address, name="stage hand") as show:
        for name, face in (("two", "kaori"), ("three", "dog")):
            show.add(name, face=face)
            show.enter(name, seconds=0.5)
        show.call_framing(seconds=0.5)
        show.set_leases(True)


# --- the evening ------------------------------------------------------------------------------------------------------


def play(consoles: list[Page], seconds: float, trial: Trial, dice: np.random.Generator) -> None:
    """All four play in turns for some time; what cannot be clicked at the moment is counted, not forced."""
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        for number, page in enumerate(consoles):
            try:
                (play_pad if number >= 2 else play_keys)(page, dice)
                trial.done[f"console {number + 1}"] += 1
            except Error:
                trial.done["not to be clicked"] += 1
        consoles[0].wait_for_timeout(1000 * PAUSE)


def take_pictures(pages: dict[str, Page], folder: Path, when: str) -> None:
    """Screenshots of all pages."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, page in pages.items():
        page.screenshot(path=folder / f"{when}-{name}.png")


def run_evening(browser: Browser, place: tuple[str, int], trial: Trial, options: argparse.Namespace) -> list[str]:
    """The whole show, with the kill in its middle; the lines that are printed."""
    address, pid = place
    consoles = open_consoles(browser, address, trial)
    stage = open_page(browser, f"{address}/stage", (640, 360), trial)
    stage.evaluate(FRAMES)
    pages = {f"console-{number + 1}": page for number, page in enumerate(consoles)} | {"stage": stage}
    dice = np.random.default_rng(options.seed)
    began = time.monotonic()
    before = megabytes(pid)
    for part in ("first", "second"):
        play(consoles, 30 * options.minutes, trial, dice)
        take_pictures(pages, options.pictures, part)
        if part == "first":
            (standby,) = children(pid)
            os.kill(max(children(standby)), signal.SIGKILL)
    seconds = time.monotonic() - began
    drawn = int(stage.evaluate("window.drawnFrames"))
    after = megabytes(pid)
    take_pictures(pages, options.pictures, "end")
    return [
        f"{seconds:.0f} s; {dict(trial.done)}",
        f"stage: {drawn / seconds:.1f} frames a second; memory {before:.0f} MB, {after:.0f} MB at the end",
        f"{'holds' if after < GROWTH * before else 'MISSED'}: memory grows by less than {GROWTH:g}",
    ]


def report(trial: Trial) -> list[str]:
    """What a program saw of the states, and what the pages reported."""
    gaps = np.diff(trial.arrivals)
    lines = [f"states: {len(gaps) / gaps.sum():.1f} a second; gap 99 % {1e3 * np.percentile(gaps, 99):.0f} ms"]
    most = LONGEST_GAP * measure_waiting_pace()
    for words, kept in (
        (f"longest gap between two states, over a kill -9: {gaps.max():.2f} s of {most:.2f}", gaps.max() < most),
        (f"errors that pages reported: {len(trial.errors)} {trial.errors[:5]}", not trial.errors),
    ):
        lines.append(f"{'holds' if kept else 'MISSED'}: {words}")
    return lines


def main() -> int:
    """Plays and prints; exit status 1 when something was missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--pictures", type=Path, default=Path("build/four_operators"))
    options = parser.parse_args()
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    trial = Trial()
    port = free_port()
    with tempfile.TemporaryDirectory() as folder, running_show(Path(folder), port) as place, sync_playwright() as play:
        set_up(place[0])
        hands = [Thread(target=play_osc, args=(port, trial)), Thread(target=watch, args=(place[0], trial))]
        for hand in hands:
            hand.start()
        browser = play.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=list(CHROMIUM))
        try:
            lines = run_evening(browser, place, trial, options)
        finally:
            trial.over.set()
            for hand in hands:
                hand.join()
            browser.close()
    lines += report(trial)
    print("\n".join(lines))
    return int(any(line.startswith("MISSED") for line in lines))


if __name__ == "__main__":
    sys.exit(main())
