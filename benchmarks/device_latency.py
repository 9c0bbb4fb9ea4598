"""How soon a hand on a device is seen (issue 11, must hold 5): MIDI at a browser to a picture, OSC to the state.

Starts `omote show`, opens a stage and a devices page in Chromium (llvmpipe, 640x360, `lowest`) whose MIDI is a fake of
the standard's interface, and binds a controller to the jaw:

* a controller moves until the first frame of the stage whose pixels have changed, median, in milliseconds and in frames
  of that stage (its own median interval in this run): at most two frames and 10 ms at the pace of the machine
  (benchmarks/pace.py);
* a packet of OSC is sent until the first state that holds its value reaches a link, median: at most one tick, 16.7 ms.

`--moves N` for another count.
"""

from __future__ import annotations

import argparse
import asyncio
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import aiohttp
import msgspec
import numpy as np
from playwright.async_api import Page, async_playwright

from benchmarks.pace import measure_waiting_pace
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.bindings import Bind, BindingDocument
from omote.show.objects.link import Hello

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.stage import CHROMIUM, COMMAND, FIRST_CHANGE, HEIGHT, INTERVALS, READY, WIDTH, read_address
from omote.inputs.osc_packet import encode_message
from omote.show.wire import encode
from tools.browser import SENTENCE, find_browser

FRAMES = 2.0
EXTRA_MS = 10.0
TICK_MS = 1000 / 60
FAKE_MIDI = Path(__file__).parents[1] / "web" / "node_modules" / "web-midi-test" / "wmt.js"
DEVICES = """
navigator.requestMIDIAccess = WMT.requestMIDIAccess;
localStorage.setItem("omote devices", JSON.stringify({ midi: true }));
window.dial = new WMT.MidiSrc("Dial");
dial.connect();
"""
# The clock of all pages of one browser: milliseconds since 1970, by the same monotonic clock.
MOVE = (
    "(value) => { const sent = performance.timeOrigin + performance.now(); dial.emit([0xb0, 7, value]); return sent; }"
)
CHANGED = "async () => performance.timeOrigin + await window.changed"
PLUGGED = "() => document.querySelector('omote-devices-page')?.context.devices.store.device('Dial')?.plugged === true"


async def midi_latency(stage: Page, hand: Page, moves: int) -> list[float]:
    """Milliseconds from each move of the controller to the first changed frame."""
    rng = np.random.default_rng(7)
    waits = []
    for move in range(moves):
        await stage.evaluate(FIRST_CHANGE)
        await asyncio.sleep(0.25 + float(rng.uniform(0, 1 / 60)))  # at any phase of the server's beat
        sent = await hand.evaluate(MOVE, 100 if move % 2 == 0 else 10)
        waits.append(await stage.evaluate(CHANGED) - sent)
        await asyncio.sleep(0.2)
    return waits


async def osc_latency(link: aiohttp.ClientWebSocketResponse, port: int, moves: int) -> list[float]:
    """Milliseconds from each packet of OSC to the state that holds its value."""
    rng = np.random.default_rng(8)
    waits = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        for move in range(moves):
            end = time.monotonic() + 0.1
            while time.monotonic() < end:  # states that came before are not kept
                await link.receive()
            await asyncio.sleep(float(rng.uniform(0, 1 / 60)))  # a state has just come: to any phase of the beat
            value = 0.125 if move % 2 == 0 else 0.5
            sent = time.monotonic()
            out.sendto(encode_message("/omote/one/channel/browInnerUp", value), ("127.0.0.1", port))
            while not await _holds(link, value):
                pass
            waits.append(1000 * (time.monotonic() - sent))
    return waits


async def _holds(link: aiohttp.ClientWebSocketResponse, value: float) -> bool:
    message = msgspec.msgpack.decode((await link.receive()).data)
    return bool(message["type"] == "state" and message["characters"]["one"]["channels"].get("browInnerUp") == value)


async def measure(url: str, port: int, moves: int) -> tuple[list[float], float, list[float]]:
    """MIDI to picture, the stage's frame, OSC to state; milliseconds."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    async with aiohttp.ClientSession() as http, async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        stage = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
        await stage.goto(f"{url}/stage?quality=lowest")
        hand = await browser.new_page(viewport={"width": 400, "height": 400})
        await hand.add_init_script(FAKE_MIDI.read_text() + DEVICES)
        await hand.goto(f"{url}/devices")
        for page, ready in ((stage, READY), (hand, PLUGGED)):
            while not await page.evaluate(ready):
                await asyncio.sleep(0.1)
        async with http.ws_connect(url + LINK_PATH, max_msg_size=0) as link:
            await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
            binding = BindingDocument("Dial", "1/cc7", "/omote/one/channel/jawOpen", pick_up=False)
            await link.send_bytes(encode(Bind("latency", binding)))
            osc = await osc_latency(link, port, moves)
        await hand.evaluate(MOVE, 10)
        await asyncio.sleep(1.0)
        midi = await midi_latency(stage, hand, moves)
        frame = float(np.median(await stage.evaluate(INTERVALS, 2.0)))
        await browser.close()
    return midi, frame, osc


def main() -> int:
    """Runs the show, moves, prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--moves", type=int, default=40)
    moves = parser.parse_args().moves
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with tempfile.TemporaryDirectory() as folder:
        command = [*COMMAND, str(Path(folder) / "show.omote"), "--port", "0", "--no-open", "--no-announce"]
        process = subprocess.Popen([*command, "--osc", str(port)], stdout=subprocess.PIPE, text=True)
        try:
            midi, frame, osc = asyncio.run(measure(read_address(process), port, moves))
        finally:
            process.terminate()
            process.wait(20.0)
    seen = float(np.median(midi))
    heard = float(np.median(osc))
    extra = EXTRA_MS * measure_waiting_pace()
    most = FRAMES * frame + extra
    print(
        f"MIDI to the first changed frame: median {seen:.1f} ms = {seen / frame:.1f} frames of {frame:.1f} ms", end=""
    )
    print(f" (at most {FRAMES:g} frames and {extra:.0f} ms: {most:.1f}); 90th percentile {np.percentile(midi, 90):.1f}")
    print(f"OSC to the state: median {heard:.1f} ms (at most a tick, {TICK_MS:.1f}); 90th {np.percentile(osc, 90):.1f}")
    return 0 if seen <= most and heard <= TICK_MS else 1


if __name__ == "__main__":
    sys.exit(main())
